// SPDX-License-Identifier: BSD-3-Clause
// hfrac sweep, hfrac match: studies of many runs. They are Python over this very program (bindings/python/hfrac/study), so all
// that is done here is to find the interpreter and the package and to become it.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "command/commands.hpp"

namespace hfrac::command {
namespace {

namespace fs = std::filesystem;

/** The folder of the package `hfrac`: that of the installation, or of the source tree, this program lies in. Empty: Python's own. */
std::string package_folder(const fs::path& program) {
  const fs::path top = program.parent_path().parent_path();
  for (const fs::path& folder : {top / HFRAC_PYTHON_FOLDER, top.parent_path() / "bindings/python"})
    if (fs::exists(folder / "hfrac/study/__main__.py")) return folder.string();
  return {};
}

/** Debian's own interpreter, which has Debian's scipy; another one may stand first on the PATH. */
std::string interpreter() {
  const char* named = std::getenv("HFRAC_PYTHON");
  if (named != nullptr) return named;
  return fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
}

ExitCode become_python(const std::string& name, const std::vector<std::string>& words) {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  ::setenv("HFRAC_COMMAND", program.c_str(), 1);
  const std::string folder = package_folder(program);
  const char* before = std::getenv("PYTHONPATH");
  if (!folder.empty())
    ::setenv("PYTHONPATH", before == nullptr ? folder.c_str() : (folder + ":" + before).c_str(), 1);
  std::vector<std::string> all = {interpreter(), "-B", "-m", "hfrac.study", name};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(all.size() + 1);
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execvp(arguments.front(), arguments.data());
  throw std::runtime_error(fmt::format(
      "hfrac {} needs Python, and '{}' cannot be started: {}; apt-get install python3 python3-scipy, or name "
      "an interpreter in HFRAC_PYTHON",
      name, all.front(), std::strerror(errno)));
}

void add(CLI::App& program, Action& action, const char* name, const char* about) {
  auto* command = program.add_subcommand(name, about);
  command->prefix_command();  // all words are Python's,
  command->set_help_flag();   // --help too
  command->callback([command, name, &action] {
    action = [words = command->remaining(), name] { return become_python(name, words); };
  });
}

}  // namespace

void add_studies(CLI::App& program, Action& action) {
  add(program, action, "sweep", "Run a case with many values: percentiles, tornado chart, Sobol indices");
  add(program, action, "match", "Find the parameters that explain a record, and how far it tells them");
}

}  // namespace hfrac::command

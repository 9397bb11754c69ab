// SPDX-License-Identifier: BSD-3-Clause
// hfrac verify: runs cases of docs/verification and prints measured, analytic, error and verdict; draws their curves.
//
// The cases are the project's own tests, in a program of their own that is built with HFRAC_TESTS: nothing here computes or
// judges, so what is printed is what the tests saw. With --pictures they write the curves behind each page's figure as tables, and
// the renderer draws them as it does those of `hfrac plot --compare`.
#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <regex>

#include "command/commands.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/compare.hpp"
#endif

namespace hfrac::command {
namespace {

struct VerifyRequest {
  std::vector<std::string> cases;
  std::string program, pictures;
  bool all = false, full = false, smoke = false;
};

constexpr int picture_width = 1000;  ///< [pixel]

/** One case as far as its tests have run. */
struct CaseRecord {
  int passed = 0, failed = 0, skipped = 0, figures = 0;
  double worst = 0.0;  // error over tolerance
};

std::filesystem::path program_of(const VerifyRequest& request) {
  std::filesystem::path file = request.program;
  if (file.empty())
    file = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "hfrac_verification_tests";
  if (std::filesystem::exists(file)) return file;
  throw BadInput(
      fmt::format("{} is not there; build the project with -DHFRAC_TESTS=ON, or name the program with "
                  "--program",
                  file.string()));
}

std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

/** V7Sneddon.Width belongs to V7; a case without a number is called by its suite. */
std::string case_of(const std::string& test) {
  static const std::regex number("(^|/)(V[0-9]+).*");
  std::smatch part;
  return std::regex_match(test, part, number) ? part[2].str() : test.substr(0, test.find('.'));
}

std::string filter_of(const VerifyRequest& request) {
  std::string filter;
  for (const auto& name : request.cases) {
    if (!std::regex_match(name, std::regex("V[0-9]{1,2}")))
      throw BadInput(fmt::format("'{}' is no case; cases are called V1, V2, ...: docs/verification", name));
    // V1 is not V10: a digit after the number is refused, one pattern a letter.
    for (char c = 'A'; c <= 'Z'; ++c) filter += fmt::format("{}{}*:*/{}{}*:", name, c, name, c);
  }
  if (request.smoke) {
    std::string quick;
    for (const auto& name : request.cases) {
      for (char c = 'A'; c <= 'Z'; ++c) quick += fmt::format("{}{}*Smoke.*:", name, c);
    }
    return quick.empty() ? "*Smoke.*" : quick;
  }
  if (request.cases.empty()) filter = "*";
  if (!request.full) filter += "-*Long.*";
  return filter;
}

/** Pictures of the curves the cases wrote: by the file's name, what stands above it. */
void draw(const std::filesystem::path& folder, const std::map<std::string, std::string>& curves) {
#ifdef HFRAC_WITH_RENDERER
  for (const auto& [name, title] : curves) {
    CompareRequest one;
    one.sources = {(folder / name).string()};
    one.target = (folder / name).replace_extension(".png").string();
    one.title = title;
    Paper paper;
    paper.width = picture_width;
    draw_comparison(one, paper);
    fmt::print("  {}\n", one.target);
  }
#else
  (void)folder;
  (void)curves;
#endif
}

void print_table(const std::map<std::string, CaseRecord>& records) {
  fmt::print("\n  {:12} {:>7} {:>16} {:>7} {:>7} {:>8}  {}\n", "case", "figures", "error/tolerance", "passed",
             "failed", "skipped", "verdict");
  for (const auto& [name, r] : records) {
    fmt::print("  {:12} {:>7} {:>16.2f} {:>7} {:>7} {:>8}  {}\n", name, r.figures, r.worst, r.passed,
               r.failed, r.skipped, r.failed > 0 ? "FAILED" : (r.passed > 0 ? "good" : "not run"));
  }
}

ExitCode verify(const VerifyRequest& request) {
  if (request.all == !request.cases.empty()) throw BadInput("name cases (V7 V8), or give --all");
  if (request.smoke && request.full) throw BadInput("--smoke and --full exclude each other");
  if (!request.pictures.empty()) {
#ifndef HFRAC_WITH_RENDERER
    throw BadInput("--pictures needs the renderer; build with -DHFRAC_VIZ=ON");
#endif
    std::filesystem::create_directories(request.pictures);
    setenv("HFRAC_CURVES", request.pictures.c_str(), 1);
  }
  const std::string line =
      quoted(program_of(request).string()) + " --gtest_color=no --gtest_filter=" + quoted(filter_of(request));
  FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the verification program cannot be started");
  const std::regex figure(
      R"(\s*(.*?)\s+measured\s+(\S+)\s+analytic\s+(\S+)\s+error\s+(\S+)\s+tolerance\s+(\S+)\s*)");
  const std::regex curve(R"(\s*curves (\S+\.csv): (.*))");
  std::map<std::string, CaseRecord> records;
  std::map<std::string, std::string> curves;
  std::string now;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    std::string text(buffer.data());
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const auto name = [&] { return text.substr(13, text.find_first_of(" (", 13) - 13); };
    std::smatch part;
    if (text.rfind("[ RUN      ]", 0) == 0) {
      now = case_of(name());
      fmt::print("{}\n", name());
    } else if (text.rfind("[       OK ]", 0) == 0) {
      ++records[now].passed;
      fmt::print("  good\n");
      now.clear();
    } else if (text.rfind("[  SKIPPED ]", 0) == 0 && !now.empty()) {
      ++records[now].skipped;
      now.clear();
    } else if (text.rfind("[  FAILED  ]", 0) == 0 && !now.empty()) {
      ++records[now].failed;
      fmt::print("  FAILED\n");
      now.clear();
    } else if (!now.empty()) {
      if (std::regex_match(text, part, curve)) {
        curves[part[1]] = part[2];
        continue;
      }
      if (std::regex_match(text, part, figure)) {
        auto& record = records[now];
        ++record.figures;
        record.worst = std::max(record.worst, std::abs(std::stod(part[4])) / std::stod(part[5]));
      }
      fmt::print("{}\n", text);
    }
    std::fflush(stdout);
  }
  const int status = pclose(pipe);
  if (records.empty())
    throw BadInput("no such case is a test yet; docs/verification/README.md lists those that are");
  print_table(records);
  if (!request.pictures.empty()) draw(request.pictures, curves);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? kGood : kRunFailed;
}

}  // namespace

void add_verify(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("verify", "Run verification cases: measured, analytic, error, verdict");
  auto request = std::make_shared<VerifyRequest>();
  command->add_option("CASE", request->cases, "V1, V2, ... of docs/verification");
  command->add_flag("--all", request->all, "Every case");
  command->add_flag("--smoke", request->smoke, "Only what takes a second or two a case");
  command->add_flag("--full", request->full, "The long ones too, minutes each");
  command->add_option("--pictures", request->pictures, "Write curves (CSV) and their pictures (PNG) there")
      ->type_name("DIR");
  command->add_option("--program", request->program, "The verification program; else the one beside this one")
      ->type_name("FILE");
  command->callback([request, &action] { action = [request] { return verify(*request); }; });
}

}  // namespace hfrac::command

// SPDX-License-Identifier: BSD-3-Clause
// hfrac new: a commented case file for a purpose, to begin with.
//
// The files are those of examples/, copied into the program by the assembler, so that what is written is what the tests run.
// HFRAC_EXAMPLES is their folder.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "command/commands.hpp"

// NOLINTBEGIN: symbols of the assembler
#define HFRAC_CASE_TEXT(symbol, file)                                                              \
  __asm__(                                                                                         \
      ".pushsection .rodata\n"                                                                     \
      "hfrac_case_" #symbol ":\n.incbin \"" HFRAC_EXAMPLES "/" file "\"\n.byte 0\n.popsection\n"); \
  extern "C" const char hfrac_case_##symbol[];

HFRAC_CASE_TEXT(fracture, "field/fracture.toml")
HFRAC_CASE_TEXT(minifrac, "field/minifrac.toml")
HFRAC_CASE_TEXT(record, "field/record.toml")
HFRAC_CASE_TEXT(record_study, "field/record-study.toml")
HFRAC_CASE_TEXT(hour, "field/hour.toml")
HFRAC_CASE_TEXT(crossing, "field/crossing-angles.toml")
HFRAC_CASE_TEXT(shadow, "field/stress-shadow.toml")
HFRAC_CASE_TEXT(cold, "thermal/cold-water.toml")
HFRAC_CASE_TEXT(paper, "paper/injection-45MPa.toml")
HFRAC_CASE_TEXT(smoke, "paper/smoke.toml")
// NOLINTEND

namespace hfrac::command {
namespace {

struct Purpose {
  std::string_view name;
  const char* text;
  std::string_view about;
};
const std::array<Purpose, 10> purposes = {
    {{"fracture", hfrac_case_fracture, "granite at depth, a perforated well at a constant rate, shut-in"},
     {"minifrac", hfrac_case_minifrac, "injection, shut-in, and closure read from the pressure"},
     {"record", hfrac_case_record, "a field's record of rates into a fracture zone"},
     {"record-study", hfrac_case_record_study,
      "record.toml in many runs, for hfrac sweep: P10, P50, P90 (docs/studies.md)"},
     {"hour", hfrac_case_hour, "an hour at a constant rate in a model of 600 m"},
     {"crossing", hfrac_case_crossing, "a fracture meets a natural fracture at an angle"},
     {"stress-shadow", hfrac_case_shadow, "two wells side by side, a fracture at each"},
     {"cold-water", hfrac_case_cold, "cold water into hot rock: temperature and thermal stress"},
     {"paper", hfrac_case_paper, "the paper's main case, 45 MPa in the well"},
     {"smoke", hfrac_case_smoke, "the same, small"}}};

std::string all_purposes() {
  std::string text;
  for (const Purpose& one : purposes) text += fmt::format("  {:14} {}\n", one.name, one.about);
  return text;
}

const Purpose& purpose_of(const std::string& name) {
  for (const Purpose& one : purposes)
    if (one.name == name) return one;
  throw BadInput(fmt::format("no case for '{}'; the purposes are\n{}", name, all_purposes()));
}

ExitCode write_case(const std::string& name, const std::string& file, bool overwrite) {
  const Purpose& one = purpose_of(name);
  if (file.empty()) {
    fmt::print("{}", one.text);
    return kGood;
  }
  if (!overwrite && std::filesystem::exists(file))
    throw BadInput(fmt::format("'{}' is there already; choose another name or say --overwrite", file));
  std::ofstream stream(file, std::ios::binary);
  stream << one.text;
  stream.close();
  if (!stream) throw BadInput(fmt::format("'{}' cannot be written", file));
  return kGood;
}

}  // namespace

void add_new(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("new", "Write a commented case file to begin with");
  command->footer("Purposes:\n" + all_purposes() + "Then: hfrac run case.toml -o DIR && hfrac render DIR");
  struct Request {
    std::string purpose, file;
    bool overwrite = false;
  };
  auto request = std::make_shared<Request>();
  command->add_option("PURPOSE", request->purpose, "What the case is for; the list is below")->required();
  command->add_option("-o,--output", request->file, "File to write; without it the text goes to the output");
  command->add_flag("--overwrite", request->overwrite, "Replace a file that is there");
  command->callback([request, &action] {
    action = [request] { return write_case(request->purpose, request->file, request->overwrite); };
  });
}

}  // namespace hfrac::command

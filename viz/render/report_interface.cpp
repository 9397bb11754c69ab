// SPDX-License-Identifier: BSD-3-Clause
// The C interface of the report and of the script for ParaView.
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "paraview_script.h"
#include "report.h"
#include "run_folder.h"
#include "whole_file.h"

using namespace hfrac::viz;

namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  write_whole(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace

extern "C" {

int32_t hfrac_viz_write_report(const char* run_dir, const char* path, char* error, int32_t capacity,
                               int32_t* needed) {
  return call(error, capacity, needed, [&] {
    const std::filesystem::path folder = required_text(run_dir, "run_dir");
    const std::filesystem::path target = path != nullptr && path[0] != 0 ? path : folder / "report.html";
    write_text(target, report_page(folder));
  });
}

int32_t hfrac_viz_write_paraview_script(const char* run_dir, char* error, int32_t capacity, int32_t* needed) {
  return call(error, capacity, needed, [&] {
    const RunFolder run = open_run(required_text(run_dir, "run_dir"));
    write_text(run.path / "paraview_state.py", paraview_script(run));
  });
}

}  // extern "C"

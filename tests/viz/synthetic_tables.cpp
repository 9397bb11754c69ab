// SPDX-License-Identifier: BSD-3-Clause
// The text files of a synthetic run: the lists of its series, the case, the summary, the history, the crack log.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "synthetic_run.h"

namespace hfrac::viz_test {

namespace fs = std::filesystem;

namespace {

void write_collection(const fs::path& folder, const std::string& kind, const SyntheticRun& run) {
  std::ofstream file(folder / (kind + ".pvd"));
  file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n"
          "  <Collection>\n";
  for (int i = 0; i < run.snapshots; ++i) {
    char number[16];
    std::snprintf(number, sizeof number, "%05d", i);
    file << "    <DataSet timestep=\"" << 2.5 * i << "\" part=\"0\" file=\"" << kind << '_' << number
         << ".vtu\"/>\n";
  }
  file << "  </Collection>\n</VTKFile>\n";
}

}  // namespace

void write_tables(const fs::path& folder, const SyntheticRun& run) {
  for (const char* kind : {"discs", "bonds", "cracks"}) write_collection(folder, kind, run);
  if (run.with_flow) write_collection(folder, "flow", run);
  if (run.with_joints) write_collection(folder, "joints", run);
  std::ofstream summary(folder / "summary.json");
  summary << "{\"title\": \"" << run.title
          << "\", \"stress_convention\": \"effective\", \"ended\": \"all steps taken\", "
          << "\"model\": {\"width_m\": " << run.width << ", \"height_m\": " << run.height
          << "}, \"wells\": [{\"x_m\": " << run.well_x() << ", \"y_m\": " << run.well_y()
          << ", \"radius_m\": " << run.well_radius << ", \"pressure_Pa\": 4.5e7}], "
          << "\"state\": {\"crack_count\": 12, \"disc_count\": 560}, "
          << "\"fractures\": [{\"crack_count\": 12, \"length_m\": 5.75, \"azimuth_rad\": 0}], "
          << "\"balance\": {\"injected_volume_m2\": 0.25}, \"versions\": {\"hfrac\": \"0.1.0\"}, "
          << "\"state_hash\": \"0123456789abcdef\"}\n";
  std::ofstream(folder / "case.toml")
      << "title = \"" << run.title << "\"\n[model]\nwidth = " << run.width << "\n";
  if (!run.with_tables) return;

  std::ofstream history(folder / "history.csv");
  history << "step,time_s,well_pressure_Pa,well_rate_m2_per_s,injected_volume_m2,crack_count,tensile_cracks,"
             "shear_cracks,fracture_length_m,fracture_width_m,fracture_volume_m2,leaked_volume_m2,"
             "fluid_work_J_per_m,bond_elastic_J_per_m,damping_J_per_m,fracture_J_per_m\n";
  for (int step = 0; step <= 100; ++step) {
    const double share = step / 100.0;
    history << step << ',' << 0.05 * step << ',' << 45e6 * std::sqrt(share) << ',' << 1 + share << ','
            << share << ',' << 12 * step / 100 << ',' << 10 * step / 100 << ',' << 2 * step / 100 << ','
            << 6 * share << ',' << 2e-3 * share << ',' << 0.1 * share << ',' << 1e-4 * share
            << ",1e6,2e5,3e5,1e5\n";
  }
  // One crack per column of discs along y = well_y, as in the VTU files.
  std::ofstream cracks(folder / "cracks.csv");
  cracks << "crack_id,time_s,mode,x_m,y_m,normal_x,normal_y,length_m,aperture_m,energy_J_per_m\n";
  int id = 0;
  for (int i = 0; i < run.columns; ++i) {
    const double x = (i + 0.5) * run.spacing();
    const double distance = std::fabs(x - run.well_x());
    if (distance < run.well_radius || distance > run.half_length) continue;
    cracks << id << ',' << 0.1 * id << ',' << (id % 5 == 4 ? "shear" : "tension") << ',' << x << ','
           << run.well_y() << ",0,1," << run.spacing() << ','
           << 2e-3 * std::sqrt(1 - distance / run.half_length) << ',' << 1e4 * (1 + id) << '\n';
    ++id;
  }
  std::ofstream events(folder / "events.csv");
  events << "event,crack_count,time_s,x_m,y_m,moment_N_m,magnitude,isotropic_fraction,kind\n";
  for (int event = 0; event < 40; ++event) {
    const double moment = 1e6 / (1 + event);
    events << event << ",1," << 0.1 * event << ',' << run.well_x() + 0.1 * (event - 20) << ',' << run.well_y()
           << ',' << moment << ',' << 2.0 / 3.0 * std::log10(moment) - 6.0333 << ',' << 0.5 - event % 3 * 0.5
           << (event % 7 == 5 ? ",slip\n" : ",cracks\n");
  }
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "hfrac_viz_XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  fs::remove_all(path_, ignored);
}

}  // namespace hfrac::viz_test

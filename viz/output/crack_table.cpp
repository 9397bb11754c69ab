// SPDX-License-Identifier: BSD-3-Clause
// cracks.csv and fractures.csv. Positions and apertures are those of now, so both files are written anew each
// time.
#include <fmt/format.h>

#include <iterator>

#include "output/tables.hpp"

namespace hfrac::output {

std::string crack_table(const std::vector<hfrac_crack>& cracks) {
  std::string table =
      "crack_id,step,cycle,time_s,mode,bond_id,disc_0,disc_1,x_m,y_m,normal_x,normal_y,length_m,aperture_m,"
      "normal_force_N,shear_force_N,energy_J_per_m,fracture,distance_m\n";
  for (const auto& crack : cracks) {
    auto out = std::back_inserter(table);
    fmt::format_to(out, "{},{},{},{},{}", crack.id, crack.step, crack.cycle, crack.time,
                   crack.mode == HFRAC_CRACK_SHEAR ? "shear" : "tension");
    fmt::format_to(out, ",{},{},{}", crack.bond, crack.disc[0], crack.disc[1]);
    fmt::format_to(out, ",{},{},{},{}", crack.position[0], crack.position[1], crack.normal[0],
                   crack.normal[1]);
    fmt::format_to(out, ",{},{},{},{}", crack.length, crack.aperture, crack.normal_force, crack.shear_force);
    fmt::format_to(out, ",{},{},{}\n", crack.energy, crack.fracture, crack.distance);
  }
  return table;
}

std::string fracture_table(const std::vector<hfrac_fracture>& fractures) {
  std::string table =
      "fracture,crack_count,tensile_cracks,length_m,extent_m,reach_m,azimuth_rad,mean_aperture_m,"
      "largest_aperture_m,volume_m2,mean_pressure_Pa,well,wings\n";
  for (const auto& fracture : fractures) {
    auto out = std::back_inserter(table);
    fmt::format_to(out, "{},{},{}", fracture.index, fracture.crack_count, fracture.tensile_cracks);
    fmt::format_to(out, ",{},{},{},{}", fracture.length, fracture.extent, fracture.reach, fracture.azimuth);
    fmt::format_to(out, ",{},{},{}", fracture.mean_aperture, fracture.largest_aperture, fracture.volume);
    fmt::format_to(out, ",{},{},{}\n", fracture.mean_pressure, fracture.well, fracture.wings);
  }
  return table;
}

}  // namespace hfrac::output

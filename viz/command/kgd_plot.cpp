// SPDX-License-Identifier: BSD-3-Clause
#include "command/kgd_plot.hpp"

#include <fmt/format.h>
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "command/exit_code.hpp"
#include "command/kgd.hpp"
#include "run/engine_call.hpp"
#include "run/grid_file.hpp"
#include "run/json_file.hpp"
#include "run/series.hpp"
#include "run/table_file.hpp"

namespace hfrac::command {
namespace {

namespace fs = std::filesystem;

/** The longest fracture that the first well feeds, from tip to tip. */
struct Line {
  std::vector<double> place, part, opening, pressure;  ///< [m], [m], [m], [Pa]

  [[nodiscard]] double first() const { return place.front() - 0.5 * part.front(); }
  [[nodiscard]] double last() const { return place.back() + 0.5 * part.back(); }

  /** [m2], with the hole between the wings as open as they are at its wall. */
  [[nodiscard]] double volume() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      sum += opening[i] * part[i];
      if (i > 0 && place[i - 1] < 0.0 && place[i] > 0.0) {
        const double hole = place[i] - place[i - 1] - 0.5 * (part[i] + part[i - 1]);
        sum += 0.5 * (opening[i] + opening[i - 1]) * std::max(0.0, hole);
      }
    }
    return sum;
  }
};

Line longest_line(const run::GridFile& grid) {
  const auto well = grid.cell_array("well"), place = grid.point_array("distance_m"),
             part = grid.point_array("length_m"), opening = grid.point_array("aperture_m"),
             pressure = grid.point_array("pressure_Pa");
  const auto cells = grid.cells();
  Line best;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    if (well[cell] != 0.0) continue;
    Line line;
    for (const auto k : cells.of(cell)) {
      line.place.push_back(place[k]);
      line.part.push_back(part[k]);
      line.opening.push_back(opening[k]);
      line.pressure.push_back(pressure[k]);
    }
    if (line.place.size() < 2) continue;
    if (best.place.empty() || line.last() - line.first() > best.last() - best.first()) best = line;
  }
  return best;
}

/** E' at the tips, as given or as the run measured it [Pa]. */
double plane_modulus_of(const fs::path& folder) {
  const auto modulus = run::read_json(folder / "summary.json")
                           .value(nlohmann::ordered_json::json_pointer("/setup/plane_modulus_Pa"), 0.0);
  if (modulus > 0.0) return modulus;
  throw BadInput(
      fmt::format("--kgd compares with a solution that needs E', and the run in '{}' has none: set "
                  "fracture.law = \"facet\" and "
                  "bond.fracture_toughness, or fracture.plane_modulus",
                  folder.string()));
}

Definition case_of(const fs::path& file) {
  Definition definition;
  if (hfrac_sim_def_load(&definition, file.string().c_str()) < 0)
    throw BadInput(run::error_text(-1, nullptr));
  const auto need = [&](double value, const char* key) {
    if (value > 0.0) return;
    throw BadInput(fmt::format("--kgd compares with a solution that needs {}, which '{}' does not set", key,
                               file.string()));
  };
  need(definition.bond_fracture_toughness, "bond.fracture_toughness");
  need(definition.fluid_viscosity, "fluid.viscosity");
  return definition;
}

/** The last snapshot with a fracture of two points or more while the first well was driven, its line and rate [m2/s]. */
struct Driven {
  Line line;
  double rate = 0.0, time = 0.0;
};

Driven last_driven(const fs::path& folder) {
  const run::TableFile history(folder / "history.csv");
  const auto rate = history.numbers("well_rate_m2_per_s"), step = history.numbers("step");
  const auto series = run::read_series(folder, "fractures");
  for (auto snapshot = series.rbegin(); snapshot != series.rend(); ++snapshot) {
    const auto row = std::find(step.begin(), step.end(), static_cast<double>(snapshot->first));
    if (row == step.end() || !(rate[static_cast<std::size_t>(row - step.begin())] > 0.0)) continue;
    Driven found{longest_line(run::GridFile(snapshot->second)),
                 rate[static_cast<std::size_t>(row - step.begin())], snapshot->second.time};
    if (!found.line.place.empty()) return found;
  }
  throw BadInput(fmt::format("'{}' has no snapshot with a fracture of the first well while fluid went in",
                             folder.string()));
}

}  // namespace

std::string kgd_table(const fs::path& folder) {
  const Definition definition = case_of(folder / "case.toml");
  const Driven driven = last_driven(folder);
  const Line& line = driven.line;
  const KgdCase given{plane_modulus_of(folder), definition.bond_fracture_toughness,
                      definition.fluid_viscosity, driven.rate};
  const double across = definition.stress_sigma_hmin, middle = 0.5 * (line.first() + line.last());
  const KgdFracture wanted = kgd_fracture(given, line.volume());
  std::string table = "series,distance_m,aperture_m,net_pressure_Pa\n";
  const auto add = [&](const char* series, double place, double opening, double pressure) {
    // Where the fluid has only arrived, a tip's pore is far below the stress and off the chart.
    const bool shown = pressure > -0.5 * wanted.pressure.front();
    fmt::format_to(std::back_inserter(table), "{},{},{},{}\n", series, place, opening,
                   shown ? fmt::format("{}", pressure) : std::string());
  };
  const std::string here = fmt::format("this run at {} s", driven.time);
  for (std::size_t i = 0; i < line.place.size(); ++i)
    add(here.c_str(), line.place[i], line.opening[i], line.pressure[i] - across);
  const auto count = KgdFracture::places.size();
  for (std::size_t k = 0; k + 1 < 2 * count; ++k) {
    const std::size_t i = k < count ? count - 1 - k : k - count + 1;
    const double side = k < count ? -1.0 : 1.0;
    add("KGD of the same volume", middle + side * KgdFracture::places[i] * wanted.half_length,
        wanted.opening[i], wanted.pressure[i]);
  }
  return table;
}

}  // namespace hfrac::command

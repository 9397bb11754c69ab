// SPDX-License-Identifier: BSD-3-Clause
// GRDECL: keywords with one value per cell, i fastest, then j, then layers; "n*value" repeats; "/" ends; "--" comments.
// Lines of at most 128 characters, names of at most 8, as every reader of the format accepts.
#include "grdecl.hpp"

#include <charconv>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "byte_file.hpp"
#include "core/error.hpp"
#include "hfrac/grid.h"

namespace hfrac::capi {
namespace {

constexpr double millidarcy = 9.869233e-16;  // m2

// Six digits, whatever the locale.
std::string six_digits(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 5);
  return {text, end.ptr};
}

void put_keyword(std::string& text, const char* name, const std::vector<double>& values,
                 std::int64_t layers) {
  text += name;
  text += '\n';
  std::string line;
  const auto put = [&](const std::string& word) {
    if (line.size() + word.size() + 1 > 100) {
      text += line + '\n';
      line.clear();
    }
    line += ' ';
    line += word;
  };
  for (std::int64_t layer = 0; layer < layers; ++layer) {
    for (std::size_t k = 0; k < values.size();) {
      std::size_t run = 1;
      while (k + run < values.size() && values[k + run] == values[k]) ++run;
      const std::string value = six_digits(values[k]);
      put(run > 1 ? std::to_string(run).append("*").append(value) : value);
      k += run;
    }
  }
  text += line + " /\n\n";
}

void require_range(double value, double high, const char* name, const char* range) {
  if (value >= 0.0 && value <= high) return;
  throw Error(ErrorKind::argument,
              std::string(name) + " = " + std::to_string(value) + " is out of range; " + range + ".");
}

// Permeability of the rock and of rock and cracks together along i and j.
struct Rock {
  std::vector<double> matrix, i, j, porosity, whole_porosity;
};

Rock rock_of(const Simulation& s, Upscaling rule, const GrdeclRequest& request) {
  const std::vector<CellReport> cells = report_cells(s, rule);
  double k_sum = 0.0, porosity_sum = 0.0, covered = 0.0;
  for (const auto& cell : cells) {
    k_sum += cell.area * cell.coverage * cell.matrix_permeability;
    porosity_sum += cell.area * cell.coverage * cell.matrix_porosity;
    covered += cell.area * cell.coverage;
  }
  if (covered <= 0.0) {
    throw Error(
        ErrorKind::argument,
        "no cell of the grid covers any of the model, so there is nothing to write; see hfrac_set_grid.");
  }
  Rock rock;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto& cell = cells[c];
    const bool own = cell.coverage > 0.0 && cell.matrix_permeability > 0.0;
    const double k = request.permeability > 0.0 ? request.permeability
                     : own                      ? cell.matrix_permeability
                                                : k_sum / covered;
    const double pores = request.porosity > 0.0       ? request.porosity
                         : cell.matrix_porosity > 0.0 ? cell.matrix_porosity
                                                      : porosity_sum / covered;
    const auto along = [&](Vec2 e) {
      return k + cell.permeability[0] * e.x * e.x + cell.permeability[1] * e.y * e.y +
             2.0 * cell.permeability[2] * e.x * e.y;
    };
    rock.matrix.push_back(k);
    rock.i.push_back(std::max(k, along(s.grid().i_direction(static_cast<std::int64_t>(c)))));
    rock.j.push_back(std::max(k, along(s.grid().j_direction(static_cast<std::int64_t>(c)))));
    rock.porosity.push_back(pores);
    rock.whole_porosity.push_back(std::min(1.0, pores + cell.fracture_porosity));
  }
  return rock;
}

// How far cracks raise the flow between a cell and its next: both halves in series (harmonic mean), with and without. Cells
// are taken as of equal length along the way.
std::vector<double> multipliers(const std::vector<double>& matrix, const std::vector<double>& whole,
                                const std::function<std::int64_t(std::int64_t)>& next) {
  std::vector<double> factor(matrix.size(), 1.0);
  for (std::size_t c = 0; c < matrix.size(); ++c) {
    const std::int64_t other = next(static_cast<std::int64_t>(c));
    if (other < 0) continue;
    const auto o = static_cast<std::size_t>(other);
    if (!(matrix[c] > 0.0) || !(matrix[o] > 0.0)) continue;
    factor[c] = (1.0 / matrix[c] + 1.0 / matrix[o]) / (1.0 / whole[c] + 1.0 / whole[o]);
  }
  return factor;
}

}  // namespace

void write_grdecl(const Simulation& s, const std::string& path, Upscaling rule,
                  const GrdeclRequest& request) {
  if (request.kind != HFRAC_GRDECL_PERM && request.kind != HFRAC_GRDECL_MULT) {
    throw Error(ErrorKind::argument, "kind = " + std::to_string(request.kind) +
                                         " is unknown; give HFRAC_GRDECL_PERM (0) or HFRAC_GRDECL_MULT (1).");
  }
  if (request.layers < 1 || request.layers > 10000)
    throw Error(ErrorKind::argument,
                "layers = " + std::to_string(request.layers) + " is out of range; give 1 to 10000.");
  require_range(request.porosity, 1.0, "porosity", "give 0 (the network's) to 1");
  require_range(request.permeability, 1e-6, "permeability", "give 0 (the network's) to 1e-6 m2");
  const HostGrid& grid = s.grid();
  const Rock rock = rock_of(s, rule, request);

  std::string text = "-- Written by hfrac " + std::to_string(HFRAC_VERSION_MAJOR) + "." +
                     std::to_string(HFRAC_VERSION_MINOR) + "." + std::to_string(HFRAC_VERSION_PATCH) +
                     " (ABI " + std::to_string(HFRAC_ABI_VERSION) + "); include in the GRID section.\n";
  text += "-- Step " + std::to_string(s.model().clock.step) + ", " + six_digits(s.time()) + " s; " +
          std::to_string(s.cracks().size()) + " cracks; state " + std::to_string(s.state_hash()) + ".\n";
  text += "-- " + std::to_string(grid.nx()) + " x " + std::to_string(grid.ny()) + " x " +
          std::to_string(request.layers) + " cells, i fastest.\n";
  text +=
      rule == Upscaling::oda
          ? "-- Cracks by the crack tensor (Oda 1985): all taken as connected, an upper bound.\n"
          : "-- Cracks by flow through each cell's network, linear boundary pressures (Durlofsky 1991).\n";
  text += "-- Along each cell's i and j; off-diagonal parts of the tensor are left out.\n\n";
  if (request.kind == HFRAC_GRDECL_PERM) {
    const auto in_millidarcy = [](std::vector<double> k) {
      for (double& value : k) value /= millidarcy;
      return k;
    };
    put_keyword(text, "PERMX", in_millidarcy(rock.i), request.layers);
    put_keyword(text, "PERMY", in_millidarcy(rock.j), request.layers);
    put_keyword(text, "PORO", rock.whole_porosity, request.layers);
  } else {
    const std::int64_t nx = grid.nx(), cells = grid.count();
    put_keyword(
        text, "MULTX",
        multipliers(rock.matrix, rock.i, [&](std::int64_t c) { return (c + 1) % nx != 0 ? c + 1 : -1; }),
        request.layers);
    put_keyword(
        text, "MULTY",
        multipliers(rock.matrix, rock.j, [&](std::int64_t c) { return c + nx < cells ? c + nx : -1; }),
        request.layers);
    std::vector<double> volume;
    for (std::size_t c = 0; c < rock.porosity.size(); ++c)
      volume.push_back(rock.porosity[c] > 0.0 ? rock.whole_porosity[c] / rock.porosity[c] : 1.0);
    put_keyword(text, "MULTPV", volume, request.layers);
  }
  write_whole_file(path, std::as_bytes(std::span(text)));
}

}  // namespace hfrac::capi

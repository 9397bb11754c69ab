// SPDX-License-Identifier: BSD-3-Clause
#include "output/piece_files.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "run/files.hpp"
#include "run/series.hpp"

namespace hfrac::output {
namespace {

using run::Part;
using run::VtuGrid;

/** Writes the pieces of a series that are this process's; returns the list of all. */
template <class GridOf>
std::string write_series(const std::filesystem::path& folder, const Writers& writers,
                         const SnapshotFrame& frame, const char* name, const GridOf& grid_of) {
  const auto definition = run::definition_of(frame.sim);
  const int64_t pieces = definition.output_pieces;
  const auto packing = static_cast<run::Compression>(definition.output_compression);
  std::vector<std::string> files;
  for (int64_t k = 0; k < pieces; ++k) files.push_back(run::piece_name(name, frame.state.step, k));
  VtuGrid heads;
  for (int64_t k = writers.rank; k < pieces; k += writers.count) {
    VtuGrid grid = grid_of(frame, Part{k, pieces});
    run::write_whole(folder / files[static_cast<size_t>(k)],
                     encode(grid, frame.moment, packing, static_cast<int>(definition.run_workers)));
    if (k == 0) heads = std::move(grid);
  }
  return encode_list(heads, files, packing);
}

}  // namespace

PieceFiles::PieceFiles(std::filesystem::path folder, Writers writers)
    : folder_(std::move(folder)), writers_(std::move(writers)) {}

bool PieceFiles::agree(bool due) const {
  return writers_.count == 1 ? due : writers_.sum(due ? 1 : 0) > 0;
}

PieceFiles::Lists PieceFiles::write_own(const SnapshotFrame& frame) const {
  return {write_series(folder_, writers_, frame, "discs", run::disc_grid),
          write_series(folder_, writers_, frame, "bonds", run::bond_grid),
          write_series(folder_, writers_, frame, "flow", run::flow_grid)};
}

PieceFiles::Lists PieceFiles::write(const SnapshotFrame& frame, bool due) {
  if (!agree(due)) return {};
  Lists lists;
  std::string failure;
  try {
    lists = write_own(frame);
  } catch (const run::FileError& error) {
    failure = error.what();
  }
  if (!agree(!failure.empty())) return lists;
  throw run::WriteError(failure.empty() ? fmt::format("another process of this run could not write its "
                                                      "pieces of the snapshot after step {} into '{}'",
                                                      frame.state.step, folder_.string())
                                        : failure);
}

void PieceFiles::follow(hfrac_sim* sim) {
  if (run::definition_of(sim).output_pieces == 1 || !agree(false)) return;
  const SnapshotFrame frame(sim);
  bool failed = false;
  try {
    write_own(frame);
  } catch (const run::FileError&) {
    failed = true;
  }
  if (agree(failed)) throw run::WriteError("a process of this run could not write its pieces of a snapshot");
}

}  // namespace hfrac::output

// SPDX-License-Identifier: BSD-3-Clause
#include "command/run_size.hpp"

#include <fmt/format.h>
#include <sys/statvfs.h>

#include <array>
#include <cmath>

#include "command/exit_code.hpp"

namespace hfrac::command {
namespace {

// Measured on runs of 300 to 10 000 discs: bytes per disc of a snapshot's VTU files packed as output.compression says, those of a
// state, and the fixed part of a snapshot.
constexpr std::array<double, 3> kSnapshotBytes = {210.0, 260.0, 480.0};  // zlib, lz4, none
constexpr double kStateBytes = 210.0;
constexpr double kSnapshotHead = 9000.0;
constexpr double kHistoryLine = 400.0;
constexpr double kSeriesLine = 5.0 * 95.0;  // in the lists of the five series
constexpr double kFilesOfSnapshot = 5.0;
constexpr double kOtherFiles = 14.0;  // lists, tables, case, summary, state, two checkpoints
constexpr double kPlainly = 2.0;      // the estimate's factor

// Of the whole process. Explicit per disc, without and with fluid (bench_memory, and a snapshot in hand); quasi-static per disc and
// log2 of their number, as a factor of a plane's equations fills (bench_petsc tangent, tests/mpi/million.py).
constexpr double kProcess = 30e6, kDry = 650.0, kWet = 1250.0, kSolvedDry = 310.0, kSolvedWet = 550.0;

double memory_of(const hfrac_sim_def& definition, double discs) {
  constexpr int64_t off = 2, quasi_static = 1;  // of flow.scheme, solver.kind
  const bool dry = definition.flow_scheme == off;
  const double per_disc = definition.solver_kind == quasi_static
                              ? (dry ? kSolvedDry : kSolvedWet) * std::log2(discs)
                              : (dry ? kDry : kWet);
  return kProcess + per_disc * discs;
}

double steps_of(const hfrac_sim_def& definition, int64_t steps) {
  if (steps >= 0) return static_cast<double>(steps);
  if (definition.stepping_end_time > 0.0)
    return std::ceil(definition.stepping_end_time / definition.stepping_flow_step);
  return static_cast<double>(definition.stepping_steps);
}

std::string bytes_text(double bytes) {
  constexpr std::array<const char*, 7> units = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  size_t unit = 0;
  for (; bytes >= 1000.0 && unit + 1 < units.size(); ++unit) bytes /= 1000.0;
  return fmt::format("{:.{}f} {}", bytes, bytes < 10.0 && unit > 0 ? 1 : 0, units[unit]);
}

std::string count_text(double count) {
  return count < 1e6 ? fmt::format("{:.0f}", count) : fmt::format("{:.2g}", count);
}

}  // namespace

RunSize size_of_run(const hfrac_sim_def& definition, int64_t steps) {
  const double all = steps_of(definition, steps);
  const auto discs = static_cast<double>(definition.given_discs != nullptr ? definition.given_disc_count
                                                                           : definition.packing_disc_count);
  const auto packing = static_cast<size_t>(definition.output_compression);
  RunSize size;
  size.snapshots = 1.0 + std::ceil(all / static_cast<double>(definition.output_every));
  size.files = kFilesOfSnapshot * size.snapshots + kOtherFiles;
  size.bytes = size.snapshots * (kSnapshotHead + kSeriesLine + discs * kSnapshotBytes.at(packing)) +
               all * kHistoryLine + 3.0 * discs * kStateBytes;
  size.memory = memory_of(definition, discs);
  return size;
}

std::string memory_text(const RunSize& size) {
  return bytes_text(size.memory);
}

std::string size_text(const RunSize& size) {
  return fmt::format("{} snapshots, about {} files and {}", count_text(size.snapshots),
                     count_text(size.files), bytes_text(size.bytes));
}

void require_room(const RunSize& size, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path place = fs::absolute(folder, error).lexically_normal();
  while (!fs::exists(place, error) && place != place.parent_path()) place = place.parent_path();
  struct statvfs disk {};
  if (::statvfs(place.c_str(), &disk) != 0 || disk.f_blocks == 0) return;  // it does not tell
  const double room = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  const bool no_bytes = size.bytes > kPlainly * room;
  const bool no_files = disk.f_files > 0 && size.files > kPlainly * static_cast<double>(disk.f_favail);
  if (!no_bytes && !no_files) return;
  throw BadInput(
      fmt::format("the run would write {}, but the disk of '{}' has room for {}{}; raise output.every, take "
                  "fewer steps, or say "
                  "--no-space-check if it will end earlier",
                  size_text(size), folder.string(),
                  no_bytes ? bytes_text(room) : count_text(static_cast<double>(disk.f_favail)),
                  no_bytes ? "" : " files"));
}

}  // namespace hfrac::command

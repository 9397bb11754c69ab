// SPDX-License-Identifier: BSD-3-Clause
// bench_traffic DISCS RANKS: what ranks tell each other in a cycle of a sheet of hexagonally packed discs, counted, not timed: messages,
// bytes, discs received over own ones, bonds done twice, and bonds that are done while messages travel. Dry, and with pores that answer.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "sheet_model.hpp"
#include "solid/shared_tiles.hpp"

int main(int count, char** arguments) {
  using namespace hfrac;
  if (count != 3) {
    std::fprintf(stderr, "usage: bench_traffic DISCS RANKS\n");
    return 2;
  }
  const auto discs = std::atoll(arguments[1]);
  const auto ranks = static_cast<std::int32_t>(std::atoi(arguments[2]));
  for (const bool wet : {false, true}) {
    Options options = bench::sheet_options(ContactMode::parallel);
    if (wet) options.flow_scheme = static_cast<std::int64_t>(FlowScheme::implicit_scheme);
    const bench::Sheet sheet(discs, options);
    double messages = 0.0, bytes = 0.0, foreign = 0.0, shared = 0.0, meanwhile = 0.0;
    std::int64_t most = 0;
    for (std::int32_t rank = 0; rank < ranks; ++rank) {
      TilePlan plan = plan_tiles(sheet.assembly, sheet.network, wet, false);
      const SharedTiles tiles(Ranks({rank, ranks}), sheet.assembly, sheet.network, plan);
      const auto t = tiles.traffic();
      messages += static_cast<double>(t.messages);
      most = std::max(most, t.messages);
      bytes += static_cast<double>(t.bytes);
      foreign += static_cast<double>(t.foreign_discs);
      shared += static_cast<double>(t.shared_bonds);
      for (std::int64_t item = 0; item < tiles.inner_count(); ++item) {
        const CrossPart& part = plan.cross_parts[static_cast<std::size_t>(tiles.part(item))];
        for (auto p = part.first_pair; p < part.last_pair; ++p) {
          const TilePair& pair = plan.pairs[static_cast<std::size_t>(p)];
          meanwhile += static_cast<double>(pair.last_bond - pair.first_bond);
        }
      }
    }
    std::printf(
        "%s: %lld discs a rank, %.1f messages a cycle (%lld at most), %.1f kB received, foreign discs %.2f "
        "%%, bonds done twice "
        "%.2f %%, while messages travel %.1f %%\n",
        wet ? "wet" : "dry", static_cast<long long>(sheet.assembly.disc_count() / ranks), messages / ranks,
        static_cast<long long>(most), 1e-3 * bytes / ranks,
        100.0 * foreign / static_cast<double>(sheet.assembly.disc_count()),
        100.0 * shared / static_cast<double>(sheet.assembly.bond_count()),
        100.0 * meanwhile / static_cast<double>(sheet.assembly.bond_count()));
  }
  return 0;
}

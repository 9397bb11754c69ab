// SPDX-License-Identifier: BSD-3-Clause
// Which tiles a rank moves, and what it hears of the others' discs (core/ranks.hpp).
//
// Every rank holds the whole model and moves a run of tiles along the Hilbert curve; nothing migrates. Bonds and pores across tiles of
// two ranks are done by both, by the same instructions from the same displacements, so forces never travel and both find the same
// breakage in the same cycle; whose tile comes first logs it and counts its work. After each cycle a rank sends the displacements of
// the discs that its neighbours' bonds and pores need, one message a neighbour. Discs whose motion all ranks need (at walls, non-bonded
// contacts, facets: few) go to all, with their velocities. What else changes in cycles is gathered where it is asked for: at their end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "core/ranks.hpp"
#include "model/assembly.hpp"
#include "model/network.hpp"
#include "solid/tiles.hpp"

namespace hfrac {

class SharedTiles {
 public:
  // Alone, all tiles are its own. Otherwise what of other ranks' parts touches them is put at the end of the plan's.
  SharedTiles(const Ranks& ranks, const Assembly& assembly, const Network& network, TilePlan& plan);

  [[nodiscard]] const Ranks& ranks() const { return ranks_; }
  [[nodiscard]] std::int64_t first_tile() const { return begin_[static_cast<std::size_t>(ranks_.rank())]; }
  [[nodiscard]] std::int64_t last_tile() const { return begin_[static_cast<std::size_t>(ranks_.rank()) + 1]; }
  [[nodiscard]] std::int64_t tile_count() const { return last_tile() - first_tile(); }
  // Parts across tiles to do in a cycle: first own ones that need no other rank's discs, then the other own ones, then those shared.
  [[nodiscard]] std::int64_t inner_count() const { return inner_; }
  [[nodiscard]] std::int64_t part_count() const { return tile_count() + last_shared_ - first_shared_; }
  [[nodiscard]] bool is_own(std::int64_t item) const { return item < tile_count(); }
  [[nodiscard]] std::int64_t part(std::int64_t item) const {
    return is_own(item) ? own_part_[static_cast<std::size_t>(item)] : first_shared_ + item - tile_count();
  }

  // Discs whose motion all ranks need, ascending. The same on all.
  void show_everywhere(std::vector<std::int32_t> discs);
  // After a cycle: what others moved of the discs that this rank needs. What needs none of them can be done between the two.
  void start_exchange(const Assembly& assembly);
  void finish_exchange(Assembly& assembly);
  // Displacements, slips, breakage and pressures of the whole model.
  void gather(Assembly& assembly, Network& network) const;
  // Sums of the parts across tiles.
  void gather(const Assembly& assembly, TileSums* of_pairs) const;

  // Calls visit(disc) for every disc whose motion this rank knows.
  template <class Visit>
  void for_each_known(const Assembly& a, const Visit& visit) const {
    const auto last = std::min(a.disc_count(), last_tile() * tile_size);
    for (auto i = first_tile() * tile_size; i < last; ++i) visit(i);
    for (const auto i : foreign_) visit(i);
  }
  // Messages and bytes of a cycle that this rank receives, and bonds that it does though another rank counts them.
  struct Traffic {
    std::int64_t messages, bytes, shared_bonds, foreign_discs;
  };
  [[nodiscard]] Traffic traffic() const;

 private:
  struct Neighbour {
    std::int32_t rank;
    std::vector<std::int32_t> send, receive;                        // discs: displacements
    std::vector<std::int32_t> send_everywhere, receive_everywhere;  // discs: displacements and velocities
    Array<double> out, in;
  };
  [[nodiscard]] std::size_t rank_of(std::int32_t disc) const;
  template <class Place>
  [[nodiscard]] std::vector<std::int64_t> by_rank(const Place& place) const;
  void find_shared(const Assembly& assembly, const Network& network);
  void lay_messages();

  Ranks ranks_;
  TilePlan& plan_;
  std::vector<std::int64_t> begin_;  // first tile of each rank, and last their number
  std::int64_t first_shared_, last_shared_, shared_bonds_ = 0;
  std::vector<std::int64_t> own_part_;  // inner ones first
  std::int64_t inner_;
  std::vector<Neighbour> neighbours_;  // by rank; all but this one's
  std::vector<std::int32_t> everywhere_, foreign_;
  std::vector<Message> messages_;  // those that are not empty
};

}  // namespace hfrac

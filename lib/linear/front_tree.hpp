// SPDX-License-Identifier: BSD-3-Clause
// What a sparse factor knows before it sees a number: its fronts, where their entries come from and where what they leave goes.
//
// Each part of a nested dissection becomes a front: a dense matrix of its own unknowns (pivots) and of those later ones that
// they or its children touch (boundary). Fronts are numbered children before parents, so those below a front are the ones
// just before it. The tree is cut into subtrees of like work, which workers take as they come, and the few large fronts
// above them, whose columns workers share. Where it is cut follows from the model alone.
//
// Of several ranks each has whole subtrees and whole fronts above them, about as many numbers as any other: what those of others hold has
// no place in its arrays, but for what they leave over to a front of its own.
//
// Unknowns come in nodes (a disc has three, a domain one). Entries of the matrix are given as a list whose places stay the
// same from factor to factor; entries for the same place add up.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/array.hpp"
#include "linear/dense_kernels.hpp"
#include "linear/dissection.hpp"

namespace hfrac {

struct MatrixPlace {
  std::int32_t row, column;
};

struct FrontTree {
  struct Front {
    std::int32_t pivots = 0, size = 0;  // unknowns of its own, and with its boundary
    std::int32_t parent = -1, child[2] = {-1, -1};
    std::int32_t owner = 0;  // rank
    bool kept = false;       // what it leaves over is kept, not stacked
    std::int64_t unknowns =
        0;  // where in unknowns: size of them, pivots first; of another rank's front no more than those
    std::int64_t columns = 0, rows = 0, swaps = 0, into_parent = 0,
                 carried = 0;   // where its parts of the factor begin
    std::int64_t leftover = 0;  // in what is kept, or on a worker's stack
    std::int64_t first_entry = 0, last_entry = 0;
  };
  struct Subtree {
    std::int32_t first, last;  // fronts [first, last)
  };
  std::vector<Front> fronts;
  std::vector<Subtree> subtrees;          // most work first; this rank's
  std::vector<std::int32_t> top;          // fronts above them, children before parents
  std::vector<std::int32_t> unknowns;     // of the fronts
  std::vector<std::int32_t> into_parent;  // place of each boundary unknown in the parent's front
  // Entries by front: number among this rank's, place in the front as it is worked on (row + height * column).
  std::vector<std::int32_t> entry;
  std::vector<std::uint32_t> entry_place;
  std::vector<bool>
      wanted;  // by number among all entries: whether it is this rank's; one rank alone: empty, all are
  std::int64_t columns = 0, rows = 0, swaps = 0, carried = 0, kept = 0, stacked = 0;  // sizes
  std::int64_t largest = 0, largest_above = 0,
               largest_below = 0;    // front of all, above subtrees, within them
  std::vector<std::int64_t> solved;  // by rank: unknowns that those before it eliminate
  std::int64_t unknown_count = 0;
  double operations = 0.0;  // of a factor

  // Rows of a front as it is worked on: vectors may run over the last ones.
  static std::int64_t height(std::int64_t size) { return (size + dense_slack + 15) / 16 * 16; }

  // Calls visit for the place of every entry, in the order of entries, the same each time.
  using EachPlace = std::function<void(const std::function<void(MatrixPlace)>& visit)>;
  // node_start[k]: first unknown of node k; graph: nodes that share an entry. Of several ranks: the part of one, the same owners on all.
  void analyse(const std::vector<std::int32_t>& node_start, const std::vector<Vec2>& position,
               const Adjacency& graph, const std::vector<char>& late, const EachPlace& each_place,
               int rank = 0, int ranks = 1);
  // Whether ranks share it: below, one makes a factor sooner.
  [[nodiscard]] bool worth_sharing() const { return !top.empty(); }

 private:
  void share_out(int rank, int ranks);
  void find_owners(int ranks);
  void cut(const std::vector<double>& work);
  void place_leftovers(int rank);
  void share_entries(const EachPlace& each_place, const std::vector<std::int32_t>& front_of,
                     const std::vector<std::int32_t>& turn_of, int rank);
};

}  // namespace hfrac

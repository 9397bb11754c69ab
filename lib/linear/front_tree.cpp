// SPDX-License-Identifier: BSD-3-Clause
#include "linear/front_tree.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace hfrac {
namespace {

constexpr double fewest_to_share = 2e7;  // operations: a factor of less is made by one worker sooner
constexpr double share_of_subtree = 1.0 / 24.0;

std::size_t at(std::int64_t k) {
  return static_cast<std::size_t>(k);
}

// Room in an array for parts that come and go: the first gap that is large enough, or at its end.
class Room {
 public:
  std::int64_t take(std::int64_t size) {
    for (auto gap = gaps_.begin(); gap != gaps_.end(); ++gap) {
      if (gap->second < size) continue;
      const auto [place, length] = *gap;
      gaps_.erase(gap);
      if (length > size) gaps_[place + size] = length - size;
      return place;
    }
    size_ += size;
    return size_ - size;
  }
  void give_back(std::int64_t place, std::int64_t size) {
    if (size == 0) return;
    const auto gap = gaps_.emplace(place, size).first;
    if (const auto next = std::next(gap); next != gaps_.end() && gap->first + gap->second == next->first) {
      gap->second += next->second;
      gaps_.erase(next);
    }
    if (gap == gaps_.begin()) return;
    const auto before = std::prev(gap);
    if (before->first + before->second != gap->first) return;
    before->second += gap->second;
    gaps_.erase(gap);
  }
  [[nodiscard]] std::int64_t size() const { return size_; }

 private:
  std::map<std::int64_t, std::int64_t> gaps_;  // place, length
  std::int64_t size_ = 0;
};

// Boundary of every part, as nodes in order of elimination: later neighbours of its own, and its children's boundaries.
std::vector<std::vector<std::int32_t>> boundaries(const Dissection& cuts, const Adjacency& graph,
                                                  const std::vector<std::int32_t>& turn) {
  std::vector<std::vector<std::int32_t>> boundary(cuts.parts.size());
  const auto earlier = [&](std::int32_t a, std::int32_t b) { return turn[at(a)] < turn[at(b)]; };
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    auto& list = boundary[f];
    const auto& part = cuts.parts[f];
    for (auto k = part.first; k < part.last; ++k) {
      const auto node = at(cuts.order[at(k)]);
      for (auto q = graph.start[node]; q < graph.start[node + 1]; ++q) {
        const auto other = graph.neighbour[at(q)];
        if (turn[at(other)] >= part.last) list.push_back(other);
      }
    }
    std::sort(list.begin(), list.end(), earlier);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (part.parent < 0) continue;
    auto& above = boundary[at(part.parent)];
    const auto& parent = cuts.parts[at(part.parent)];
    for (const auto node : list) {
      if (turn[at(node)] >= parent.last) above.push_back(node);
    }
  }
  return boundary;
}

}  // namespace

void FrontTree::analyse(const std::vector<std::int32_t>& node_start, const std::vector<Vec2>& position,
                        const Adjacency& graph, const std::vector<char>& late, const EachPlace& each_place,
                        int rank, int ranks) {
  std::vector<std::int32_t> weight;
  for (std::size_t k = 0; k < position.size(); ++k) weight.push_back(node_start[k + 1] - node_start[k]);
  const Dissection cuts = dissect(position, graph, weight, late);
  const auto nodes = position.size(), parts = cuts.parts.size();
  std::vector<std::int32_t> turn(nodes), part_of(nodes);
  for (std::size_t k = 0; k < nodes; ++k) turn[at(cuts.order[k])] = static_cast<std::int32_t>(k);
  for (std::size_t f = 0; f < parts; ++f) {
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k)
      part_of[at(cuts.order[at(k)])] = static_cast<std::int32_t>(f);
  }
  const auto boundary = boundaries(cuts, graph, turn);

  *this = {};
  unknown_count = node_start.back();
  fronts.resize(parts);
  std::vector<double> work(parts, 0.0);
  const auto add_node = [&](std::int32_t node) {
    for (auto u = node_start[at(node)]; u < node_start[at(node) + 1]; ++u) unknowns.push_back(u);
  };
  for (std::size_t f = 0; f < parts; ++f) {
    Front& front = fronts[f];
    front.unknowns = static_cast<std::int64_t>(unknowns.size());
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k) add_node(cuts.order[at(k)]);
    front.pivots = static_cast<std::int32_t>(static_cast<std::int64_t>(unknowns.size()) - front.unknowns);
    for (const auto node : boundary[f]) add_node(node);
    front.size = static_cast<std::int32_t>(static_cast<std::int64_t>(unknowns.size()) - front.unknowns);
    front.parent = cuts.parts[f].parent;
    front.columns = columns;
    front.rows = rows;
    front.swaps = swaps;
    front.carried = carried;
    const std::int64_t m = front.size, p = front.pivots, b = m - p;
    columns += m * p;
    rows += p * b;
    swaps += p;
    carried += b + dense_slack;
    largest = std::max(largest, m);
    for (std::int64_t k = 0; k < p; ++k) work[f] += 2.0 * static_cast<double>((m - k) * (m - k));
    operations += work[f];
    if (front.parent < 0) continue;
    auto* child = fronts[at(front.parent)].child;
    child[child[0] < 0 ? 0 : 1] = static_cast<std::int32_t>(f);
  }
  std::vector<std::int32_t> local(at(unknown_count), -1);
  for (auto& front : fronts) {
    front.into_parent = static_cast<std::int64_t>(into_parent.size());
    if (front.parent < 0) continue;
    const Front& parent = fronts[at(front.parent)];
    for (std::int32_t k = 0; k < parent.size; ++k) local[at(unknowns[at(parent.unknowns + k)])] = k;
    for (std::int32_t k = front.pivots; k < front.size; ++k)
      into_parent.push_back(local[at(unknowns[at(front.unknowns + k)])]);
  }
  std::vector<std::int32_t> front_of(at(unknown_count)), turn_of(front_of.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    for (auto u = node_start[node]; u < node_start[node + 1]; ++u) {
      front_of[at(u)] = part_of[node];
      turn_of[at(u)] = turn[node];
    }
  }
  cut(work);
  if (ranks > 1 && worth_sharing()) {
    share_out(rank, ranks);
  } else {
    rank = 0;
  }
  share_entries(each_place, front_of, turn_of, rank);
  place_leftovers(rank);
}

// The largest first, each to the rank that has least so far.
void FrontTree::find_owners(int ranks) {
  struct Item {
    std::int32_t first, last;
    std::int64_t numbers;
  };
  std::vector<Item> items;
  const auto add = [&](std::int32_t first, std::int32_t last) {
    Item item{first, last, 0};
    for (auto f = first; f < last; ++f) {
      const std::int64_t m = fronts[at(f)].size, p = fronts[at(f)].pivots;
      item.numbers += m * p + p * (m - p);
    }
    items.push_back(item);
  };
  for (const auto& subtree : subtrees) add(subtree.first, subtree.last);
  for (const auto f : top) add(f, f + 1);
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.numbers > b.numbers; });
  std::vector<std::int64_t> load(at(ranks), 0);
  for (const auto& item : items) {
    const auto least = std::min_element(load.begin(), load.end());
    *least += item.numbers;
    for (auto f = item.first; f < item.last; ++f)
      fronts[at(f)].owner = static_cast<std::int32_t>(least - load.begin());
  }
}

void FrontTree::share_out(int rank, int ranks) {
  find_owners(ranks);
  columns = rows = swaps = carried = 0;
  solved.assign(at(ranks) + 1, 0);
  std::int64_t unknowns_kept = 0, places_kept = 0;
  const auto keep = [](std::vector<std::int32_t>& list, std::int64_t& from, std::int64_t count,
                       std::int64_t& listed) {
    std::copy_n(list.begin() + from, count, list.begin() + listed);
    from = listed;
    listed += count;
  };
  for (auto& front : fronts) {
    const std::int64_t m = front.size, p = front.pivots;
    solved[at(front.owner) + 1] += p;
    front.columns = columns;
    front.rows = rows;
    front.swaps = swaps;
    front.carried = carried;
    const bool handed_up = front.parent >= 0 && fronts[at(front.parent)].owner == rank;
    if (front.owner == rank || handed_up) carried += m - p + dense_slack;
    // Of others' fronts all it takes are the pivots, whose solution they tell, and where what they hand over goes.
    keep(unknowns, front.unknowns, front.owner == rank ? m : p, unknowns_kept);
    keep(into_parent, front.into_parent, handed_up ? m - p : 0, places_kept);
    if (front.owner != rank) continue;
    columns += m * p;
    rows += p * (m - p);
    swaps += p;
  }
  for (auto* list : {&unknowns, &into_parent}) {
    list->resize(at(list == &unknowns ? unknowns_kept : places_kept));
    list->shrink_to_fit();
  }
  for (std::size_t r = 0; r < at(ranks); ++r) solved[r + 1] += solved[r];
  subtrees.erase(
      std::remove_if(subtrees.begin(), subtrees.end(),
                     [&](const Subtree& subtree) { return fronts[at(subtree.first)].owner != rank; }),
      subtrees.end());
}

// Every entry belongs to the front that eliminates the earlier of its two unknowns.
void FrontTree::share_entries(const EachPlace& each_place, const std::vector<std::int32_t>& front_of,
                              const std::vector<std::int32_t>& turn_of, int rank) {
  std::vector<std::int64_t> count(fronts.size() + 1, 0);
  const auto front_at = [&](MatrixPlace place) {
    const auto r = at(place.row), c = at(place.column);
    return at(turn_of[r] < turn_of[c] ? front_of[r] : front_of[c]);
  };
  const bool alone = solved.empty();
  each_place([&](MatrixPlace place) {
    const std::size_t f = front_at(place);
    const bool own = fronts[f].owner == rank;
    count[f + 1] += own ? 1 : 0;
    if (!alone) wanted.push_back(own);
  });
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    count[f + 1] += count[f];
    fronts[f].first_entry = count[f];
    fronts[f].last_entry = count[f + 1];
  }
  const auto own = at(count.back());
  entry.resize(own);
  entry_place.resize(own);
  // Where an unknown stands in the front at hand: entries come in no order of fronts, so first by front, then front by front.
  std::vector<MatrixPlace> by_front(own);
  std::int32_t so_far = 0;
  each_place([&](MatrixPlace place) {
    const std::size_t f = front_at(place);
    if (fronts[f].owner != rank) return;
    const auto k = at(count[f]++);
    entry[k] = so_far++;
    by_front[k] = place;
  });
  std::vector<std::int32_t> local(at(unknown_count), -1);
  for (const Front& front : fronts) {
    if (front.owner != rank) continue;
    for (std::int32_t k = 0; k < front.size; ++k) local[at(unknowns[at(front.unknowns + k)])] = k;
    const std::int64_t ld = height(front.size);
    for (auto k = at(front.first_entry); k < at(front.last_entry); ++k)
      entry_place[k] =
          static_cast<std::uint32_t>(local[at(by_front[k].row)] + ld * local[at(by_front[k].column)]);
  }
}

void FrontTree::cut(const std::vector<double>& work) {
  const auto count = static_cast<std::int32_t>(fronts.size());
  std::vector<double> below = work;  // with all that is beneath
  std::vector<std::int32_t> first(fronts.size());
  for (std::int32_t f = 0; f < count; ++f) {
    first[at(f)] = f;
    for (const auto child : fronts[at(f)].child) {
      if (child < 0) continue;
      below[at(f)] += below[at(child)];
      first[at(f)] = std::min(first[at(f)], first[at(child)]);
    }
  }
  const double most = operations < fewest_to_share ? operations : share_of_subtree * operations;
  for (std::int32_t f = 0; f < count; ++f) {
    const auto parent = fronts[at(f)].parent;
    if (below[at(f)] > most)
      top.push_back(f);
    else if (parent < 0 || below[at(parent)] > most)
      subtrees.push_back({first[at(f)], f + 1});
  }
  std::stable_sort(subtrees.begin(), subtrees.end(), [&](const Subtree& a, const Subtree& b) {
    return below[at(a.last - 1)] > below[at(b.last - 1)];
  });
}

// Within a subtree what fronts leave over is stacked, and a front's children are the last ones on the stack. Above, it is kept until the
// parent has taken it: what the parent leaves over then may stand in its place.
void FrontTree::place_leftovers(int rank) {
  stacked = largest_above = largest_below = 0;
  Room room;
  const auto left_over = [](const Front& front) {
    const std::int64_t b = front.size - front.pivots;
    return b * b;
  };
  const auto keep = [&](Front& front) {
    front.kept = true;
    front.leftover = room.take(left_over(front));
  };
  for (const auto& subtree : subtrees) keep(fronts[at(subtree.last - 1)]);
  for (const auto f : top) {
    Front& front = fronts[at(f)];
    const bool own = front.owner == rank;
    for (const auto number : front.child) {
      if (number < 0 || !own || fronts[at(number)].owner == rank) continue;
      keep(fronts[at(number)]);  // another rank's, which hands it over
    }
    for (const auto number : front.child) {
      if (number < 0 || !(own || fronts[at(number)].owner == rank)) continue;
      room.give_back(fronts[at(number)].leftover, left_over(fronts[at(number)]));
    }
    if (!own) continue;
    largest_above = std::max<std::int64_t>(largest_above, front.size);
    keep(front);
  }
  kept = room.size();
  for (const auto& subtree : subtrees) {
    std::int64_t height = 0;
    for (auto f = subtree.first; f < subtree.last; ++f) {
      Front& front = fronts[at(f)];
      largest_below = std::max<std::int64_t>(largest_below, front.size);
      if (f + 1 == subtree.last) continue;
      for (const auto child : front.child)
        if (child >= 0) height -= left_over(fronts[at(child)]);
      front.leftover = height;
      height += left_over(front);
      stacked = std::max(stacked, height);
    }
  }
}

}  // namespace hfrac

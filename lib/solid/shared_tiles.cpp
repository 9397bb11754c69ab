// SPDX-License-Identifier: BSD-3-Clause
#include "solid/shared_tiles.hpp"

#include <algorithm>

namespace hfrac {
namespace {

void sort_out(std::vector<std::int32_t>& discs) {
  std::sort(discs.begin(), discs.end());
  discs.erase(std::unique(discs.begin(), discs.end()), discs.end());
}

// The values of discs one after the other, into or out of a message; returns where it ends.
template <std::size_t Count>
double* put(const std::vector<std::int32_t>& discs, const std::array<const double*, Count>& of, double* to) {
  for (const auto i : discs) {
    for (const double* values : of) *to++ = values[i];
  }
  return to;
}

template <std::size_t Count>
const double* take(const std::vector<std::int32_t>& discs, const std::array<double*, Count>& of,
                   const double* from) {
  for (const auto i : discs) {
    for (double* values : of) values[i] = *from++;
  }
  return from;
}

}  // namespace

SharedTiles::SharedTiles(const Ranks& ranks, const Assembly& a, const Network& n, TilePlan& plan)
    : ranks_(ranks), plan_(plan) {
  const auto tiles = static_cast<std::int64_t>(plan.tiles.size());
  for (int r = 0; r <= ranks.size(); ++r) begin_.push_back(tiles * r / ranks.size());
  first_shared_ = last_shared_ = tiles + 1;
  for (auto t = first_tile(); t < last_tile(); ++t) own_part_.push_back(t);
  inner_ = tile_count();
  if (ranks.alone()) return;
  neighbours_.resize(static_cast<std::size_t>(ranks.size()));
  for (std::size_t r = 0; r < neighbours_.size(); ++r) neighbours_[r].rank = static_cast<std::int32_t>(r);
  find_shared(a, n);
  last_shared_ = static_cast<std::int64_t>(plan.cross_parts.size());
  for (auto& other : neighbours_) {
    sort_out(other.send);
    sort_out(other.receive);
  }
  lay_messages();
}

std::size_t SharedTiles::rank_of(std::int32_t disc) const {
  return static_cast<std::size_t>(std::upper_bound(begin_.begin(), begin_.end(), disc / tile_size) -
                                  begin_.begin()) -
         1;
}

template <class Place>
std::vector<std::int64_t> SharedTiles::by_rank(const Place& place) const {
  std::vector<std::int64_t> begin;
  for (const auto tile : begin_) begin.push_back(place(static_cast<std::size_t>(tile)));
  return begin;
}

// Everything across tiles that touches an own one: whose discs it needs, and what of other ranks' parts has to be done here, too.
void SharedTiles::find_shared(const Assembly& a, const Network& n) {
  const auto here = static_cast<std::size_t>(ranks_.rank());
  std::vector<std::int32_t> discs;
  // Of discs that one item joins: whether this rank is one of several that do it; then who needs what.
  const auto join = [&] {
    const auto is_own = [&](std::int32_t i) { return rank_of(i) == here; };
    const auto own = std::count_if(discs.begin(), discs.end(), is_own);
    if (own == 0 || own == static_cast<std::ptrdiff_t>(discs.size())) return false;
    for (const auto i : discs) {
      if (!is_own(i)) neighbours_[rank_of(i)].receive.push_back(i);
    }
    for (const auto j : discs) {
      if (is_own(j)) continue;
      auto& send = neighbours_[rank_of(j)].send;
      std::copy_if(discs.begin(), discs.end(), std::back_inserter(send), is_own);
    }
    return true;
  };
  const auto tiles = plan_.tiles.size();
  const auto first = static_cast<std::size_t>(first_tile()), last = static_cast<std::size_t>(last_tile());
  std::vector<std::int32_t> domains;
  std::vector<char> needs_others(tiles, 0);
  for (std::size_t t = 0; t < tiles; ++t) {
    const CrossPart part = plan_.cross_parts[t];
    const bool own_part = t >= first && t < last;
    for (auto p = part.first_pair; p < part.last_pair; ++p) {
      const TilePair& pair = plan_.pairs[static_cast<std::size_t>(p)];
      const auto other = static_cast<std::size_t>(a.second[pair.first_bond] / tile_size);
      const bool own_other = other >= first && other < last;
      if (own_part == own_other) continue;
      needs_others[t] = 1;
      for (auto e = pair.first_bond; e < pair.last_bond; ++e) {
        discs = {a.first[e], a.second[e]};
        join();
      }
      if (own_part) continue;
      plan_.cross_parts.push_back({p, p + 1, 0, 0});
      shared_bonds_ += pair.last_bond - pair.first_bond;
    }
    for (auto q = part.first_domain; q < part.last_domain; ++q) {
      const auto d = plan_.cross_domain[static_cast<std::size_t>(q)];
      discs.assign(n.corner_disc.begin() + n.corner_start[d], n.corner_disc.begin() + n.corner_start[d + 1]);
      if (!join()) continue;
      needs_others[t] = 1;
      if (!own_part) domains.push_back(static_cast<std::int32_t>(q));
    }
  }
  const auto outer = std::stable_partition(own_part_.begin(), own_part_.end(), [&](std::int64_t t) {
    return needs_others[static_cast<std::size_t>(t)] == 0;
  });
  inner_ = outer - own_part_.begin();
  // The shared pores at the end of the list of pores across.
  constexpr std::int64_t together = 64;
  for (std::size_t k = 0; k < domains.size(); ++k) {
    const auto q = static_cast<std::size_t>(domains[k]);
    const auto listed = static_cast<std::int64_t>(plan_.cross_domain.size());
    if (k % together == 0) plan_.cross_parts.push_back({0, 0, listed, listed});
    ++plan_.cross_parts.back().last_domain;
    plan_.cross_domain.push_back(plan_.cross_domain[q]);
  }
}

void SharedTiles::show_everywhere(std::vector<std::int32_t> discs) {
  if (ranks_.alone()) return;
  sort_out(discs);
  if (discs == everywhere_) return;
  everywhere_ = std::move(discs);
  const auto here = static_cast<std::size_t>(ranks_.rank());
  std::vector<std::int32_t> own;
  for (auto& other : neighbours_) other.receive_everywhere.clear();
  for (const auto i : everywhere_)
    (rank_of(i) == here ? own : neighbours_[rank_of(i)].receive_everywhere).push_back(i);
  for (auto& other : neighbours_)
    if (static_cast<std::size_t>(other.rank) != here) other.send_everywhere = own;
  lay_messages();
}

void SharedTiles::lay_messages() {
  messages_.clear();
  foreign_.clear();
  const auto bytes = [](std::size_t values) { return static_cast<std::int64_t>(values * sizeof(double)); };
  for (auto& other : neighbours_) {
    other.out.resize(3 * other.send.size() + 6 * other.send_everywhere.size());
    other.in.resize(3 * other.receive.size() + 6 * other.receive_everywhere.size());
    foreign_.insert(foreign_.end(), other.receive.begin(), other.receive.end());
    foreign_.insert(foreign_.end(), other.receive_everywhere.begin(), other.receive_everywhere.end());
    if (other.out.empty() && other.in.empty()) continue;
    messages_.push_back(
        {other.rank, 0, bytes(other.out.size()), bytes(other.in.size()), other.out.data(), other.in.data()});
  }
  sort_out(foreign_);
}

void SharedTiles::start_exchange(const Assembly& a) {
  for (auto& other : neighbours_) {
    double* to = put<3>(other.send, {a.ux.data(), a.uy.data(), a.rotation.data()}, other.out.data());
    put<6>(other.send_everywhere,
           {a.ux.data(), a.uy.data(), a.rotation.data(), a.vx.data(), a.vy.data(), a.spin.data()}, to);
  }
  ranks_.start(messages_);
}

void SharedTiles::finish_exchange(Assembly& a) {
  ranks_.finish();
  for (auto& other : neighbours_) {
    const double* from =
        take<3>(other.receive, {a.ux.data(), a.uy.data(), a.rotation.data()}, other.in.data());
    take<6>(other.receive_everywhere,
            {a.ux.data(), a.uy.data(), a.rotation.data(), a.vx.data(), a.vy.data(), a.spin.data()}, from);
  }
}

void SharedTiles::gather(Assembly& a, Network& n) const {
  if (ranks_.alone()) return;
  const auto tiles = plan_.tiles.size();
  const auto discs = by_rank(
      [&](std::size_t t) { return std::min(a.disc_count(), static_cast<std::int64_t>(t) * tile_size); });
  for (auto* values : {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin})
    ranks_.gather(values->data(), discs);
  const auto inside = by_rank([&](std::size_t t) { return a.part_first_bond[t]; });
  const auto across = by_rank(
      [&](std::size_t t) { return a.part_first_bond[static_cast<std::size_t>(a.tile_first_pair[t])]; });
  for (const auto& bonds : {inside, across}) {
    ranks_.gather(a.slip.data(), bonds);
    ranks_.gather(a.intact.data(), bonds);
    if (a.softening.empty()) continue;
    ranks_.gather(a.softening.start.data(), bonds);
    ranks_.gather(a.softening.worst.data(), bonds);
  }
  if (plan_.cross_domain.empty()) return;
  const auto within = by_rank([&](std::size_t t) {
    return t < tiles ? plan_.tiles[t].first_domain : plan_.tiles[tiles - 1].last_domain;
  });
  const auto listed = by_rank([&](std::size_t t) { return plan_.cross_parts[t].first_domain; });
  Array<double> of_listed(static_cast<std::size_t>(listed.back()));
  for (auto* values : {&n.pressure, &n.volume_change}) {
    ranks_.gather(values->data(), within);
    for (std::size_t q = 0; q < of_listed.size(); ++q) of_listed[q] = (*values)[plan_.cross_domain[q]];
    ranks_.gather(of_listed.data(), listed);
    for (std::size_t q = 0; q < of_listed.size(); ++q) (*values)[plan_.cross_domain[q]] = of_listed[q];
  }
}

void SharedTiles::gather(const Assembly& a, TileSums* of_pairs) const {
  if (ranks_.alone()) return;
  const auto tiles = static_cast<std::int32_t>(plan_.tiles.size());
  ranks_.gather(of_pairs, by_rank([&](std::size_t t) {
                  return static_cast<std::int64_t>(a.tile_first_pair[t] - tiles);
                }));
}

SharedTiles::Traffic SharedTiles::traffic() const {
  Traffic t{static_cast<std::int64_t>(messages_.size()), 0, shared_bonds_,
            static_cast<std::int64_t>(foreign_.size())};
  for (const auto& message : messages_) t.bytes += message.receive_bytes;
  return t;
}

}  // namespace hfrac

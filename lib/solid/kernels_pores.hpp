// SPDX-License-Identifier: BSD-3-Clause
// Pores in the kernels (kernels_body.hpp): what discs do to their volumes, what their pressures do to the discs.
//
// Most pores have three to six corners, in no order, and a loop over each one's costs more for its end, which no processor foresees, than for
// what it does. So chunks of pores are done in passes that do not ask how many corners a pore has: products of all corners in a row; sums of
// eight to a pore, of which those that are not its own count nothing; pressures; the pressure of each corner's pore, put down eight times
// from the pore's first corner on and overwritten by the next one's; pushes of all corners in a row. Pores of more corners go alone.
// Every sum is made in the order of corners, as if there were no passes.
#pragma once

#include "solid/kernels_chunk.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// NOLINTBEGIN(modernize-use-using): attribute form
typedef double Pair __attribute__((vector_size(16), may_alias));
typedef double Quad8 __attribute__((vector_size(32), aligned(8), may_alias));  // anywhere in an array
typedef int64_t Mask __attribute__((vector_size(32), aligned(8), may_alias));
// NOLINTEND(modernize-use-using)

constexpr int64_t most_corners = 8;  // of a pore of a chunk
constexpr int64_t pore_chunk = 32;   // pores at a time
constexpr int64_t ahead = 192;       // corners by which memory is asked for what comes

// Of eight numbers the first `count`, and zeros.
struct FirstOfEight {
  int64_t of[most_corners + 1][most_corners];
};
constexpr FirstOfEight make_masks() {
  FirstOfEight masks{};
  for (int64_t count = 0; count <= most_corners; ++count) {
    for (int64_t k = 0; k < most_corners; ++k) masks.of[count][k] = k < count ? -1 : 0;
  }
  return masks;
}
alignas(64) constexpr FirstOfEight masks = make_masks();

// Pores and their corners, as pointers that nothing written here changes.
struct Corners {
  const int32_t* __restrict start;
  const int32_t* __restrict disc;
  const Pair* __restrict weight;
  const double* __restrict turn;
  explicit Corners(const KernelArrays& a)
      : start(a.domain_corner_start),
        disc(a.domain_corner_disc),
        weight(reinterpret_cast<const Pair*>(a.domain_corner_weight)),
        turn(a.domain_corner_turn) {}
};

struct alignas(64) PoreChunk {
  double of_corner[(pore_chunk + 1) * most_corners];  // a product, or the pressure of its pore
  double change[pore_chunk], pressure[pore_chunk], work[pore_chunk];
};

// Adds to the changes of four pores what their corners contribute, from corner start[k] on `in`.
inline __attribute__((always_inline)) void add_corners(Quad& change, const int32_t* start, const double* in) {
  Quad low[4], high[4];
  for (int64_t k = 0; k < 4; ++k) {
    const int64_t* mask = masks.of[start[k + 1] - start[k]];
    const double* of = in + (start[k] - start[0]);
    low[k] =
        reinterpret_cast<Quad>(*reinterpret_cast<const Mask*>(of) & *reinterpret_cast<const Mask*>(mask));
    high[k] = reinterpret_cast<Quad>(*reinterpret_cast<const Mask*>(of + 4) &
                                     *reinterpret_cast<const Mask*>(mask + 4));
  }
  transpose(low[0], low[1], low[2], low[3]);
  transpose(high[0], high[1], high[2], high[3]);
  for (const Quad& of : low) change += of;
  for (const Quad& of : high) change += of;
}

// Volumes of n pores from d on.
template <bool turns>
inline void change_volumes(const Corners& corners, int64_t d, int64_t n, const Quad* at, PoreChunk& c) {
  const int64_t begin = corners.start[d], count = corners.start[d + n] - begin;
  const Pair* __restrict weight = corners.weight + begin;
  const int32_t* __restrict disc = corners.disc + begin;
  const auto moved = [&](int64_t k) { return *reinterpret_cast<const Pair*>(at + disc[k]); };
  const int64_t in_fours = count & ~int64_t{3};
  for (int64_t k = 0; k < in_fours; k += 4) {
    const Quad by01 = *reinterpret_cast<const Quad8*>(weight + k) *
                      __builtin_shufflevector(moved(k), moved(k + 1), 0, 1, 2, 3),
               by23 = *reinterpret_cast<const Quad8*>(weight + k + 2) *
                      __builtin_shufflevector(moved(k + 2), moved(k + 3), 0, 1, 2, 3);
    const Quad sum =
        __builtin_shufflevector(by01, by23, 0, 4, 2, 6) + __builtin_shufflevector(by01, by23, 1, 5, 3, 7);
    *reinterpret_cast<Quad*>(c.of_corner + k) = __builtin_shufflevector(sum, sum, 0, 2, 1, 3);
  }
  for (int64_t k = in_fours; k < count; ++k) {
    const Pair by = weight[k] * moved(k);
    c.of_corner[k] = by[0] + by[1];
  }
  const auto add_up = [&](bool from_nothing) __attribute__((always_inline)) {
    for (int64_t q = 0; q < n; q += 4) {
      // The last pores of a chunk may be fewer than four: empty ones stand in for those missing.
      int32_t start[5];
      for (int64_t k = 0; k < 5; ++k) start[k] = corners.start[d + (q + k < n ? q + k : n)];
      Quad& change = *reinterpret_cast<Quad*>(c.change + q);
      if (from_nothing) change = Quad{0.0, 0.0, 0.0, 0.0};
      add_corners(change, start, c.of_corner + (start[0] - begin));
    }
  };
  add_up(true);
  if constexpr (turns) {
    for (int64_t k = 0; k < count; ++k) c.of_corner[k] = corners.turn[begin + k] * at[disc[k]][2];
    add_up(false);
  }
}

// Pressures of pores d to d + n - 1, whose volumes have changed by c.change.
inline void answer_pores(const KernelArrays& a, int64_t d, int64_t n, PoreChunk& c) {
  double* __restrict pressure = a.pressure + d;
  double* __restrict volume_change = a.volume_change + d;
  const double* __restrict stiffness = a.stiffness + d;
  const double* __restrict content = a.content + d;
  const double reference = a.reference_pressure, floor = a.floor_pressure;
#pragma GCC ivdep
  for (int64_t k = 0; k < n; ++k) {
    const double before = pressure[k], change = c.change[k];
    const double p = pore_pressure(reference, floor, stiffness[k], content[k], change, before);
    c.work[k] = 0.5 * (before + p) * (change - volume_change[k]);
    c.pressure[k] = pressure[k] = p;
    volume_change[k] = change;
  }
}

// Adds to the discs' forces what the corners of n pores from d on push with, and up what the fluid did (null: nothing).
template <bool turns>
inline void push_discs(const Corners& corners, int64_t d, int64_t n, const double* pressure, Quad* to,
                       PoreChunk& c, double* work) {
  const int64_t begin = corners.start[d], count = corners.start[d + n] - begin;
  for (int64_t q = 0; q < n; ++q) {
    const int64_t first = corners.start[d + q];
    __builtin_prefetch(corners.weight + first + ahead);  // by and by, as of bonds (kernels_body.hpp)
    if (q % 4 == 0) __builtin_prefetch(corners.disc + first + ahead);
    double* from_first = c.of_corner + (first - begin);
    if (work != nullptr) *work += c.work[q];
    const double p = pressure[q];
    for (int64_t k = 0; k < most_corners; k += 4)
      *reinterpret_cast<Quad8*>(from_first + k) = Quad8{p, p, p, p};
  }
  for (int64_t k = 0; k < count; ++k) {
    const double p = c.of_corner[k];
    const Pair push = Pair{p, p} * corners.weight[begin + k];
    Quad& force = to[corners.disc[begin + k]];
    force += __builtin_shufflevector(push, Pair{0.0, 0.0}, 0, 1, 2, 3);
    if constexpr (turns) force += Quad{0.0, 0.0, p * corners.turn[begin + k], 0.0};
  }
}

// A pore of many corners, a hole. Returns the work of its fluid.
template <bool turns>
double large_pore(const KernelArrays& a, const Corners& corners, int64_t d, const Quad* at, Quad* to) {
  const int32_t begin = corners.start[d], end = corners.start[d + 1];
  double p = a.pressure[d], work = 0.0;
  if (a.undrained != 0) {
    double change = 0.0;
    for (int32_t k = begin; k < end; ++k) {
      const Quad& u = at[corners.disc[k]];
      change += corners.weight[k][0] * u[0] + corners.weight[k][1] * u[1];
    }
    for (int32_t k = begin; turns && k < end; ++k) change += corners.turn[k] * at[corners.disc[k]][2];
    work = undrained_pressure(a, d, change, p);
  }
  for (int32_t k = begin; k < end; ++k) {
    const Pair push = Pair{p, p} * corners.weight[k];
    to[corners.disc[k]] += Quad{push[0], push[1], turns ? p * corners.turn[k] : 0.0, 0.0};
  }
  return work;
}

// Motion and forces of the tile's discs as records. Returns the work of the fluid.
// turns: whether turning discs change volumes, too (domain_corner_turn is there). Asked once a tile, not once a pore.
template <bool turns>
double tile_domains(const KernelArrays& a, const Tile& t, const Quad* motion, Quad* force) {
  const Corners corners(a);
  const Quad* at = motion - t.first_disc;
  Quad* to = force - t.first_disc;
  PoreChunk c;
  double work = 0.0;
  for (int64_t d = t.first_domain; d < t.last_domain;) {
    int64_t n = 0;
    while (n < pore_chunk && d + n < t.last_domain &&
           corners.start[d + n + 1] - corners.start[d + n] <= most_corners)
      ++n;
    if (n == 0) {
      const double of_large = large_pore<turns>(a, corners, d++, at, to);
      if (a.undrained != 0) work += of_large;
      continue;
    }
    if (a.undrained != 0) {
      change_volumes<turns>(corners, d, n, at, c);
      answer_pores(a, d, n, c);
      push_discs<turns>(corners, d, n, c.pressure, to, c, &work);
    } else {
      push_discs<turns>(corners, d, n, a.pressure + d, to, c, nullptr);
    }
    d += n;
  }
  return work;
}

// Pressures of pores across tiles, if they answer. What these push with, each tile takes for itself.
template <bool turns>
void cross_domains_with(const KernelArrays& a, int64_t part) {
  if (a.undrained == 0) return;
  const Corners corners(a);
  const double* __restrict ux = a.ux;
  const double* __restrict uy = a.uy;
  double work = 0.0;
  for (int64_t q = a.cross_parts[part].first_domain; q < a.cross_parts[part].last_domain; ++q) {
    const int64_t d = a.cross_domain[q];
    double p = 0.0, change = 0.0;
    for (int32_t k = corners.start[d]; k < corners.start[d + 1]; ++k) {
      const int32_t disc = corners.disc[k];
      change += corners.weight[k][0] * ux[disc] + corners.weight[k][1] * uy[disc];
      if constexpr (turns) change += corners.turn[k] * a.rotation[disc];
    }
    work += undrained_pressure(a, d, change, p);
  }
  a.domain_sums[a.tile_count + part].work += work;
}

// Adds to the forces of the tile's discs, as records, what pores across tiles push them with.
inline void push_across(const KernelArrays& a, const Tile& t, Quad* force) {
  const Corners corners(a);
  for (int64_t m = t.first_corner; m < t.last_corner; ++m) {
    const CrossCorner& at = a.cross_corner[m];
    const double p = a.pressure[at.domain];
    const Pair push = Pair{p, p} * corners.weight[at.corner];
    const double moment = corners.turn != nullptr ? p * corners.turn[at.corner] : 0.0;
    force[at.disc - t.first_disc] += Quad{push[0], push[1], moment, 0.0};
  }
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac

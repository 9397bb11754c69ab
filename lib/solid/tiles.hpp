// SPDX-License-Identifier: BSD-3-Clause
// In which order a cycle goes through memory.
//
// Discs are numbered along a Hilbert curve, so `tile_size` discs in a row are a patch of the plane. Bonds and pores are
// numbered so that those inside a patch follow each other, tile by tile, and those across patches, some tenths of all, come
// last (contact_graph.hpp, faces.hpp): they belong to the first tile they touch. A cycle has two phases with a barrier after each:
//
//   1  bonds and pores across tiles, part by part: forces of bonds go into the inter-tile force buffer of the tiles they touch, pores find
//      their pressures
//   2  tile after tile: displacements in, buffered forces, what pores across tiles push with, bonds and pores inside, forces add up in the
//      cache, discs move
//
// Inside phase 2 no tile looks at another one's discs, so tiles may go to any worker in any order. Every force a disc
// gets is added in a fixed order: any number of workers gives the same bits. Forces of bonds never go to memory.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "geom/contact_graph.hpp"
#include "model/assembly.hpp"
#include "model/network.hpp"
#include "solid/kernels.hpp"

namespace hfrac {

struct TilePlan {
  std::vector<Tile> tiles;
  std::vector<TilePair> pairs;
  std::vector<CrossPart> cross_parts;  // by tile, and the last of the outside's pore alone
  std::vector<std::int32_t> cross_domain;
  std::vector<CrossCorner> cross_corner;  // by tile of the disc, in the order of cross_domain
  std::vector<std::int32_t> bond_slot;    // places in `force_buffer`
  Array<BufferedForce> force_buffer;      // by disc
};

// fluid: pores push discs at all; outside_pushes: so does the pressure outside on the outermost discs (walled models).
TilePlan plan_tiles(const Assembly& assembly, const Network& network, bool fluid, bool outside_pushes);

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
// A fracture as a graph: domains are the nodes, cracks the edges, each as long as the way from pore to pore through its contact. At a
// hole or the outside the way begins at the contact. Pores lie to either side of a joint, which is straight: along one that conducts an edge
// is as long as its piece of the joint.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "model/network.hpp"

namespace hfrac {

class FractureGraph {
 public:
  // Way over a crack at `middle` from a domain's middle, as far as the crack's [m].
  static double leg(const Network& network, std::int32_t domain, std::int64_t bond, Vec2 middle);
  void add(const Network& network, std::int64_t bond, Vec2 middle);
  [[nodiscard]] bool holds(std::int32_t domain) const { return edges_.count(domain) > 0; }

  struct Way {
    double length = -1.0;    // m
    std::int32_t from = -1;  // domain before
    std::int64_t bond = -1;  // that leads here from it
  };
  using Ways = std::map<std::int32_t, Way>;  // by domain
  [[nodiscard]] Ways shortest_from(std::int32_t start) const;
  // The domain that is farthest from the start in each part that hangs together without it (a wing), farthest first.
  [[nodiscard]] std::vector<std::int32_t> wings(const Ways& ways, std::int32_t start) const;
  // Two domains that are farthest from each other: the far end of the far end, exact on trees.
  [[nodiscard]] std::pair<std::int32_t, std::int32_t> ends() const;
  // In order from the start.
  static std::vector<std::int64_t> bonds_to(const Ways& ways, std::int32_t domain);

 private:
  struct Edge {
    std::int32_t to;
    std::int64_t bond;
    double length;
  };
  std::map<std::int32_t, std::vector<Edge>> edges_;  // ordered: results do not depend on hashing
  std::int32_t first_ = -1;
};

}  // namespace hfrac

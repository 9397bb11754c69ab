// SPDX-License-Identifier: BSD-3-Clause
#include "model/joint_pores.hpp"

#include <algorithm>

#include "options/choices.hpp"

namespace hfrac {
namespace {

constexpr double shortest_pipe = 0.05;  // mean radii
// Share of the mean disc's square below which a joint's pore is taken larger where motion is followed explicitly: it would be
// stiffer than the rock and rule the stable step, as in network.cpp.
constexpr double smallest_explicit = 0.05;

// Calls use(corner of the disc before it, corner of the disc after it, bond) for every bond around a domain.
template <class Use>
void each_bond_around(const Network& n, const Assembly& a, std::int32_t domain, const Use& use) {
  const auto begin = n.corner_start[domain], end = n.corner_start[domain + 1];
  for (auto k = begin; k < end; ++k) {
    const auto next = k + 1 < end ? k + 1 : begin;
    const auto bond = a.bond_between(n.corner_disc[k], n.corner_disc[next]);
    if (bond >= 0) use(k, next, static_cast<std::size_t>(bond));
  }
}

// Where two joints cross, either's fluid passes the other's contact: that is no way of its own.
bool at_crossing(const Assembly& a, std::int64_t bond) {
  return std::binary_search(a.smooth.shared.begin(), a.smooth.shared.end(), bond);
}

// Makes the pipes of a joint together as long as the joint: where it runs through a void of the packing between two pieces (none of a
// well) they share the way, but for one that another joint's fluid passes, and what short pieces count too much is taken from all.
void stretch_pipes(Network& n, const Assembly& a) {
  const auto& contacts = a.smooth.contacts;
  std::vector<std::vector<std::size_t>> on(a.smooth.law_number.size());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (n.joint_length[static_cast<std::size_t>(contacts[k].bond)] > 0.0)
      on[static_cast<std::size_t>(contacts[k].joint)].push_back(k);
  const auto at_well = [&](const SmoothContact& c) {
    return n.kind[n.left[c.bond]] == DomainKind::well || n.kind[n.right[c.bond]] == DomainKind::well;
  };
  for (auto& joint : on) {
    if (joint.empty()) continue;
    const Vec2 normal = contacts[joint[0]].normal, along{normal.y, -normal.x};
    const auto at = [&](std::size_t k) {
      const auto i = a.first[contacts[k].bond];
      return dot(Vec2{a.x[i], a.y[i]} + contacts[k].first_arm(), along);
    };
    std::sort(joint.begin(), joint.end(), [&](std::size_t p, std::size_t q) { return at(p) < at(q); });
    double wanted = 0.0, sum = 0.0;
    for (std::size_t m = 0; m < joint.size(); ++m) {
      const SmoothContact& c = contacts[joint[m]];
      wanted += c.area;
      sum += n.joint_length[static_cast<std::size_t>(c.bond)];
      if (m + 1 == joint.size()) break;
      const SmoothContact& next = contacts[joint[m + 1]];
      const double gap = at(joint[m + 1]) - at(joint[m]) - 0.5 * (c.area + next.area);
      if (gap <= 0.0 || at_well(c) || at_well(next)) continue;
      wanted += gap;
      const bool here = !at_crossing(a, c.bond), there = !at_crossing(a, next.bond);
      const double share = here && there ? 0.5 * gap : gap;
      if (there) n.joint_length[static_cast<std::size_t>(next.bond)] += share;  // summed up with it
      if (!here) continue;
      n.joint_length[static_cast<std::size_t>(c.bond)] += share;
      sum += share;
    }
    for (const auto k : joint) n.joint_length[static_cast<std::size_t>(contacts[k].bond)] *= wanted / sum;
  }
}

}  // namespace

bool joint_passes(const Network& n, const Assembly& a, std::int32_t domain) {
  bool found = false;
  if (a.smooth.empty()) return found;
  each_bond_around(n, a, domain, [&](std::int32_t, std::int32_t, std::size_t bond) {
    const auto e = static_cast<std::int64_t>(bond);
    found = found || (a.intact[e] == 0 && a.smooth.of(e) != nullptr);
  });
  return found;
}

void add_face_weights(Network& n, const Assembly& a, std::int32_t domain) {
  each_bond_around(n, a, domain, [&](std::int32_t k, std::int32_t next, std::size_t bond) {
    const SmoothContact* c = a.smooth.of(static_cast<std::int64_t>(bond));
    if (n.joint_length[bond] <= 0.0 || c == nullptr) return;
    const bool forward = n.corner_disc[k] == a.first[bond];
    const auto first = forward ? k : next, second = forward ? next : k;
    const Vec2 half = 0.5 * c->area * c->normal;
    n.corner_weight[2 * first] -= half.x;
    n.corner_weight[2 * first + 1] -= half.y;
    n.corner_weight[2 * second] += half.x;
    n.corner_weight[2 * second + 1] += half.y;
    n.corner_turn[first] += 0.5 * c->area * c->opens_by_first;
    n.corner_turn[second] += 0.5 * c->area * c->opens_by_second;
  });
}

void begin_joint_pores(Network& n, const Assembly& a, const Options& o) {
  const auto& smooth = a.smooth;
  const bool conducts = std::any_of(smooth.contacts.begin(), smooth.contacts.end(),
                                    [&](const SmoothContact& c) { return smooth.law_of(c).conducts(); });
  if (!conducts || n.aperture.empty()) return;
  const bool moves = SolverKind{o.solver_kind} == SolverKind::explicit_solver;
  n.joint_length.assign(n.left.size(), 0.0);
  n.joint_pore.assign(n.kind.size(), 0);
  n.corner_turn.assign(n.corner_disc.size(), 0.0);
  std::vector<double> stored(n.kind.size(), 0.0), beside(n.kind.size(), 0.0);
  const auto take = [&](std::int32_t d, const SmoothContact& contact, double length) {
    const JointLaw& law = smooth.law_of(contact);
    beside[d] += 0.5 * length * law.storage * o.fluid_bulk_modulus;  // a hole's share, too
    if (n.kind[d] != DomainKind::rock) return;
    n.joint_pore[d] = 1;
    stored[d] += 0.5 * length * std::max(law.aperture, law.residual_aperture);
  };
  for (const auto& contact : smooth.contacts) {
    const auto e = static_cast<std::size_t>(contact.bond);
    if (!smooth.law_of(contact).conducts() || n.left[e] == n.right[e]) continue;
    n.joint_length[e] = std::max(at_crossing(a, contact.bond) ? 0.0 : contact.area,
                                 shortest_pipe * a.mean_radius_of(static_cast<std::int64_t>(e)));
    for (const auto d : {n.left[e], n.right[e]}) take(d, contact, contact.area);
  }
  stretch_pipes(n, a);
  for (const auto& bridge : smooth.bridges) {
    const SmoothContact& contact = smooth.contacts[static_cast<std::size_t>(bridge.contact)];
    const auto e = static_cast<std::size_t>(bridge.bond);
    if (!smooth.law_of(contact).conducts()) continue;
    n.joint_length[e] = shortest_pipe * a.mean_radius_of(static_cast<std::int64_t>(e));
    // A pore between two of them is passed, too, and must not swallow what passes: those beside contacts are the joint's already.
    for (const auto d : {n.left[e], n.right[e]})
      if (n.joint_pore[d] == 0) take(d, contact, n.joint_length[e]);
  }
  for (std::size_t d = 1; d < n.kind.size(); ++d) {
    if (n.kind[d] == DomainKind::well) {
      add_face_weights(n, a, static_cast<std::int32_t>(d));
      n.storing[d] += beside[d];
    }
    if (n.joint_pore[d] == 0) continue;
    const double size = a.mean_radius_at(n.centroid[d]);
    n.storing[d] = (moves ? std::max(stored[d], smallest_explicit * size * size) : stored[d]) + beside[d];
    for (auto k = 2 * n.corner_start[d]; k < 2 * n.corner_start[d + 1]; ++k) n.corner_weight[k] = 0.0;
    add_face_weights(n, a, static_cast<std::int32_t>(d));
  }
}

}  // namespace hfrac

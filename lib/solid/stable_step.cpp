// SPDX-License-Identifier: BSD-3-Clause
#include "solid/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <tuple>

#include "options/choices.hpp"

namespace hfrac {

namespace {

struct Rows {
  std::span<double> x, y, rotation;
};

// Those of the discs of tiles [first_tile, last_tile), each summed up in the order of bonds and pores.
class RowsOfTiles {
 public:
  RowsOfTiles(const Assembly& a, const Options& o, const Rows& rows, std::int64_t first_tile,
              std::int64_t last_tile)
      : a_(a),
        o_(o),
        rows_(rows),
        first_tile_(static_cast<std::size_t>(first_tile)),
        last_tile_(static_cast<std::size_t>(last_tile)),
        first_(static_cast<std::int32_t>(first_tile * tile_size)),
        last_(static_cast<std::int32_t>(std::min(a.disc_count(), last_tile * tile_size))) {
    for (const auto of : {rows.x, rows.y, rows.rotation})
      std::fill(of.begin() + first_, of.begin() + last_, 0.0);
    const bool parallel = ContactMode{o.contact_mode} == ContactMode::parallel;
    // The stiffer of intact and broken: breakage then never asks for a shorter step.
    normal_ = parallel ? o.bond_normal_stiffness + o.contact_normal_stiffness
                       : std::max(o.bond_normal_stiffness, o.contact_normal_stiffness);
    shear_ = parallel ? o.bond_shear_stiffness + o.contact_shear_stiffness
                      : std::max(o.bond_shear_stiffness, o.contact_shear_stiffness);
    // A flat contact that is partly open is nowhere stiffer than when all of it is pressed.
    bending_ = ContactShape{o.contact_shape} == ContactShape::flat ? normal_ : o.bond_normal_stiffness;
  }

  void add_bonds(bool facets) {
    for (auto tile = first_tile_; tile < last_tile_; ++tile) add_part(tile, facets);
    for (auto pair = a_.tile_count(); pair + 1 < a_.part_first_bond.size(); ++pair) add_part(pair, facets);
  }

  void add_pores(const Network& n, const Array<double>& corner_weight) {
    const bool turns = !n.corner_turn.empty();
    for (std::int64_t d = 1; d < n.domain_count(); ++d) {
      if (n.kind[d] == DomainKind::outside) continue;
      const auto begin = n.corner_start[d], end = n.corner_start[d + 1];
      const auto* corner = n.corner_disc.data();
      if (std::none_of(corner + begin, corner + end, [this](std::int32_t disc) { return is_own(disc); }))
        continue;
      double weight = 0.0;
      for (auto k = begin; k < end; ++k) {
        weight += std::abs(corner_weight[2 * k]) + std::abs(corner_weight[2 * k + 1]);
        if (turns) weight += std::abs(n.corner_turn[k]) / a_.radius[corner[k]];
      }
      const double per_weight = weight * o_.fluid_bulk_modulus / n.least_storing(d);
      for (auto k = begin; k < end; ++k) {
        const auto disc = corner[k];
        if (!is_own(disc)) continue;
        rows_.x[disc] += std::abs(corner_weight[2 * k]) * per_weight;
        rows_.y[disc] += std::abs(corner_weight[2 * k + 1]) * per_weight;
        if (turns) rows_.rotation[disc] += a_.radius[disc] * std::abs(n.corner_turn[k]) * per_weight;
      }
    }
  }

 private:
  [[nodiscard]] bool is_own(std::int32_t disc) const { return disc >= first_ && disc < last_; }

  void add_part(std::size_t part, bool facets) {
    for (auto e = a_.part_first_bond[part]; e < a_.part_first_bond[part + 1]; ++e) {
      const auto i = a_.first[e], j = a_.second[e];
      if (!is_own(i) && !is_own(j)) continue;
      if (a_.smooth.of(e) != nullptr) continue;  // its contact answers in place of it
      const auto value = [&](std::int64_t row) { return a_.geometry.at(part, e, row); };
      const double share = facets ? 1.0 : a_.factors.stiffness_of(e), kn = normal_ * share,
                   ks = shear_ * share;
      const double length = value(block_length), radius = value(block_radius);
      double nx = value(block_dx) / length, ny = value(block_dy) / length;
      double xx = kn * nx * nx + ks * ny * ny, yy = kn * ny * ny + ks * nx * nx,
             xy = std::abs((kn - ks) * nx * ny);
      if (facets) {  // the largest that xx + xy, |nx| + |ny| and |nx| get
        xx = yy = 0.5 * (kn + ks);
        xy = std::abs(kn - ks) * std::numbers::sqrt2 / 2.0;
        nx = ny = 1.0;
      }
      const double arm_i = value(block_arm), arm_j = length - arm_i;
      const double lever = arm_i / a_.radius[i] + arm_j / a_.radius[j];
      const double bending = bending_ * share * radius * radius / 3.0;
      for (const auto& [d, arm, other] : {std::tuple{i, arm_i, j}, std::tuple{j, arm_j, i}}) {
        if (!is_own(d)) continue;
        rows_.x[d] += 2.0 * (xx + xy) + ks * std::abs(ny) * lever;
        rows_.y[d] += 2.0 * (yy + xy) + ks * std::abs(nx) * lever;
        // times radius: the row belongs to rotation * radius, and inertia / radius^2 is its mass.
        rows_.rotation[d] +=
            a_.radius[d] * (2.0 * ks * arm * (std::abs(nx) + std::abs(ny)) + ks * arm * lever +
                            bending * (1.0 / a_.radius[d] + 1.0 / a_.radius[other]));
      }
    }
  }

  const Assembly& a_;
  const Options& o_;
  const Rows& rows_;
  std::size_t first_tile_, last_tile_;
  std::int32_t first_, last_;        // discs
  double normal_, shear_, bending_;  // N/m, of the stiffest pair
};

}  // namespace

void stiffness_rows(const Assembly& a, const Network& n, const Options& o, const Array<double>* rock_weight,
                    std::span<double> row_x, std::span<double> row_y, std::span<double> row_rotation,
                    Workers* workers) {
  constexpr std::int64_t worth_sharing = 8;  // tiles
  const Rows rows{row_x, row_y, row_rotation};
  const bool facets = rock_weight != nullptr, wet = FlowScheme{o.flow_scheme} != FlowScheme::off;
  const auto add = [&](std::int64_t first_tile, std::int64_t last_tile) {
    RowsOfTiles mine(a, o, rows, first_tile, last_tile);
    mine.add_bonds(facets);
    if (wet) mine.add_pores(n, facets ? *rock_weight : n.corner_weight);
  };
  const auto tiles = static_cast<std::int64_t>(a.tile_count());
  share_items(workers, tiles, add, worth_sharing, 1);
}

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
// A straight hydraulic fracture in plane strain (Khristianovic, Geertsma and de Klerk: KGD), for V11 and V12.
//
// A hexagonal sheet of equal discs, elastic and isotropic, under total stresses with a seed of a well in the middle. Only the
// bonds that cross the well's own line along sigma_Hmax may break, so the fracture is straight. The sheet's moduli follow from
// its springs: C11 = sqrt(3)/4 (3 k_n + k_s), C12 = sqrt(3)/4 (k_n - k_s), and E' = C11 - C12^2 / C11 where pores are drained. In
// the time a fracture takes they are not: their fluid stiffens the bulk modulus K = (C11 + C12) / 2 to K + K_f / phi (Biot
// coefficient 1, phi the porosity), the shear modulus G = (C11 - C12) / 2 stays, and E'_u = 4 G K_u / (K_u + G).
//
// What the sheet makes of a slit of width w: its bonds lie at 30 degrees to the slit's normal, so their gap is w cos 30, and
// on a length of 2 R fluid passes two pipes of length 2 R. It resists like a slit with fluid of viscosity
// eta_slit = 2 eta / cos^3 30 = 3.08 eta, and analytic formulas are taken with that.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "options/choices.hpp"
#include "step/simulation.hpp"

namespace verification {

struct KgdCase {
  int columns = 40;
  double side = 80.0;       // m
  double viscosity = 0.1;   // Pa s
  double rate = 0.01;       // m2/s, both wings
  double strength = 0.2e6;  // Pa, of the line
  double stress = 10e6;     // Pa, across the line
  double formation = 6e6;   // Pa
  double step = 0.5;        // s
};

class KgdModel {
 public:
  static constexpr double fluid_modulus = 1e10;  // Pa
  static constexpr double slit = 2.0 / (0.8660254037844386 * 0.8660254037844386 * 0.8660254037844386);

  explicit KgdModel(const KgdCase& c) : case_(c), radius_(0.5 * c.side / c.columns) {
    using namespace hfrac;
    CaseDefinition definition;
    Options& o = definition.options;
    const double R = radius_, rise = std::sqrt(3.0) * R;
    std::vector<double> discs;
    int rows = 0;
    for (double y = R; y < c.side - R; y += rise, ++rows) {
      for (int k = 0; k < c.columns - rows % 2; ++k) {
        discs.push_back(R * (1.0 + 2.0 * k + rows % 2));
        discs.push_back(y);
        discs.push_back(R);
      }
    }
    o.model_width = c.side;
    o.model_height = discs[discs.size() - 2] + R;
    line_ = R + rise * (rows / 2 - 0.5);
    o.packing_disc_count = static_cast<std::int64_t>(discs.size() / 3);
    o.stress_sigma_Hmax = c.stress + 2e6;
    o.stress_sigma_hmin = c.stress;
    o.fluid_formation_pressure = c.formation;
    o.fluid_viscosity = c.viscosity;
    o.fluid_bulk_modulus = fluid_modulus;
    o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
    o.bond_normal_stiffness = o.contact_normal_stiffness = 16e9;
    o.bond_shear_stiffness = o.contact_shear_stiffness = 5.6e9;
    o.bond_tensile_strength = o.bond_shear_strength = 1e12;
    o.flow_zero_stress_aperture = 2e-5;
    o.flow_aperture_limit = 0.1;
    o.flow_outer = static_cast<std::int64_t>(OuterPores::closed);
    o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
    o.stepping_mode = static_cast<std::int64_t>(SteppingMode::coupled);
    o.stepping_flow_step = c.step;
    o.solver_strength_overshoot = 0.2;
    WellOptions well;
    well.x = 0.5 * c.side;
    well.y = line_;
    well.radius = 2.2 * R;
    well.control = WellControl::rate;
    well.rate = c.rate;
    definition.wells.push_back(well);
    sim_ = std::make_unique<hfrac::Simulation>(std::move(definition), discs, Progress{});
    // Strengths along the line, through the model's own arrays, since no option describes a line of weakness: strength goes
    // with a bond's radius, and bonds that thin bear no moment.
    auto& a = const_cast<Assembly&>(sim_->assembly());
    for (std::int64_t e = 0; e < a.bond_count(); ++e) {
      if (!on_line(e) || std::abs(along(e)) > 0.42 * c.side) continue;
      a.geometry.put_radius(a.part_of(e), e, a.bond_radius(e) * (c.strength / 1e12));
    }
  }

  hfrac::Simulation& simulation() { return *sim_; }
  [[nodiscard]] double disc_radius() const { return radius_; }
  // E' of the sheet [Pa] with drained pores, and with pores that keep their fluid.
  struct Moduli {
    double drained, undrained, porosity;
  };
  [[nodiscard]] Moduli moduli() const {
    const double kn = 16e9, ks = 5.6e9, s = std::sqrt(3.0) / 4.0;
    const double c11 = s * (3.0 * kn + ks), c12 = s * (kn - ks);
    const double bulk = 0.5 * (c11 + c12), shear = 0.5 * (c11 - c12);
    // Every pore lies between three discs; one in the middle of the list stands for all.
    const auto& volume = sim_->network().volume;
    const double porosity = volume[volume.size() / 4] / (std::sqrt(3.0) * radius_ * radius_);
    const double stiff = bulk + fluid_modulus / porosity;
    return {c11 - c12 * c12 / c11, 4.0 * shear * stiff / (stiff + shear), porosity};
  }
  // Half length: the farthest bond that is open and has fluid beside it.
  [[nodiscard]] double half_length() const {
    double farthest = 0.0;
    for (const auto& crack : sim_->cracks()) {
      if (hfrac::view_bond(sim_->assembly(), sim_->options(), crack.bond).gap > 0.0)
        farthest = std::max(farthest, std::abs(along(crack.bond)));
    }
    return farthest;
  }
  // Width of the slit at the well.
  [[nodiscard]] double width() const {
    double nearest = 1e300, width = 0.0;
    for (const auto& crack : sim_->cracks()) {
      if (std::abs(along(crack.bond)) >= nearest) continue;
      nearest = std::abs(along(crack.bond));
      width = hfrac::view_bond(sim_->assembly(), sim_->options(), crack.bond).gap / 0.8660254037844386;
    }
    return width;
  }
  [[nodiscard]] double net_pressure() const {
    return sim_->network().pressure[static_cast<std::size_t>(sim_->wells()[0].place.domain)] - case_.stress;
  }

 private:
  [[nodiscard]] bool on_line(std::int64_t e) const {
    const auto& a = sim_->assembly();
    return (a.y[a.first[e]] - line_) * (a.y[a.second[e]] - line_) < 0.0;
  }
  [[nodiscard]] double along(std::int64_t e) const {
    const auto& a = sim_->assembly();
    return 0.5 * (a.x[a.first[e]] + a.x[a.second[e]]) - 0.5 * case_.side;
  }

  KgdCase case_;
  double radius_, line_ = 0.0;
  std::unique_ptr<hfrac::Simulation> sim_;
};

}  // namespace verification

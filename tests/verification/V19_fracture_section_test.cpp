// SPDX-License-Identifier: BSD-3-Clause
// V19  The fracture section of the model, eq. 4 and 5 of the paper, each term by itself.
//
// Formula    eq. 4  U_n = (sigma_n - p) / k_n and U_s = sigma_s / k_s: a closed fracture gives way as its contacts do; k per area is the
//                   contact's stiffness over 2 R.
//            eq. 5  S_f dp/dt - d/ds (k_f / eta dp/ds) + d eps_vf/dt + k_f / (d_f eta) dp/dn = 0, term by term:
//                   storage    a fracture that leaks nowhere and does not open takes dp = K_f dV / V;
//                   opening    one that opens by w with nothing flowing in loses dp = K_f w 2R / V in each of its pores;
//                   flow       q = w^3 dp / (12 eta L) along it;
//                   leak-off   held at p it loses 2 k / eta p sqrt(t / (pi D)) through an area of either face, D = k K_f / (eta phi).
// Source     The paper, eq. 4 and 5; Witherspoon et al. (1980) for the flow along; Carter (1957) and Carslaw and Jaeger, section
//            2.5, for the leak-off.
// Set-up     Discs in rows and columns (R = 0.5 m), cut along a row from side to side: a smooth fracture whose terms are exact.
//            Compliance: the specimen of the laboratory between platens, its pores along the fracture at 0 to 6 MPa. Storage, opening, flow: pores
//            and pipes of that lattice. Leak-off: the rigid random network of 4 000 and 8 000 discs, the pores along y = 50 m held
//            at 1 MPa, as in V5.
// Tolerance  1e-6, compliance 2e-5; leak-off 5 %, 10 % with 1 000 discs.
#include <cmath>
#include <numeric>

#include "flow/flow_solver.hpp"
#include "lab/laboratory.hpp"
#include "rigid_network.hpp"
#include "support.hpp"

namespace V19_fracture_section {

using namespace hfrac;
using verification::Curves;
using verification::pi;
using verification::report;
using verification::RigidNetwork;

constexpr double normal_stiffness = 11.2e9, shear_stiffness = 6e9, radius = 0.5;  // N/m, N/m, m

Options lattice_options() {
  Options o;
  o.packing_method = static_cast<std::int64_t>(PackingMethod::square);
  o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
  o.contact_normal_stiffness = normal_stiffness;
  o.contact_shear_stiffness = shear_stiffness;
  return o;
}

// Between platens, since a fracture from side to side leaves two pieces of rock. The outermost discs bear half as much: the load
// goes by the way between the centres, n - 1 diameters for n contacts.
TEST(V19FractureSectionSmoke, ClosesByItsContactsCompliance) {
  constexpr double width = 20.0;
  const Options o = lattice_options();
  const Packing packing = pack_specimen(o, LabTest::elastic, width, 400, 1);
  Specimen rock(
      packing, o,
      {.width = width, .height = width, .wet = true, .slit_begin = -width, .slit_end = 2.0 * width});
  rock.grip_ends();
  rock.make_unbreakable();
  Curves curves("V19-compliance", "How far a closed fracture gives way",
                "stress less fluid pressure (MPa),closure (mm)");
  const auto contacts = static_cast<double>(rock.opening().size());
  const double way = (contacts - 1.0) * 2.0 * radius,
               stiffness = contacts * normal_stiffness / way;  // m, Pa/m: k_n over 2 R
  for (const auto& [shortening, pressure] :
       {std::pair{0.02, 0.0}, {0.06, 0.0}, {0.06, 2e6}, {0.06, 4e6}, {0.06, 6e6}}) {
    rock.lead_ends(-shortening);
    rock.pressurise(pressure);
    ASSERT_EQ(rock.solve(1e300).end, EquilibriumSolver::End::rest);
    double closure = 0.0;
    for (const auto& at : rock.opening()) closure -= at.y / contacts;
    const double stress = -rock.pull() / way;
    report("closure, m", closure, (stress - pressure) / stiffness, 1e-5);
    curves.point(pressure > 0.0 ? "with fluid" : "without fluid",
                 {1e-6 * (stress - pressure), 1e3 * closure});
  }
  curves.line("eq. 4", 0.0, 15.0,
              [&](double effective) { return std::vector<double>{1e9 * effective / stiffness}; });
}

// Two rows of two discs, pressed together and slid past each other.
TEST(V19FractureSectionSmoke, SlidesByItsContactsComplianceUntilFrictionYields) {
  Options o = lattice_options();
  o.contact_friction = 0.5;
  o.flow_scheme = static_cast<std::int64_t>(FlowScheme::off);
  testing_unit::TestModel m(o, testing_unit::square_lattice(2, 2, radius));
  auto& a = m.assembly;
  std::vector<std::int64_t> fracture;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    if (std::abs(a.y[a.first[e]] - a.y[a.second[e]]) < radius) continue;
    a.intact[e] = 0;
    fracture.push_back(e);
  }
  ASSERT_EQ(fracture.size(), 2U);
  constexpr double pressed = 1e-6;  // m
  const double yields = 0.5 * normal_stiffness * pressed;
  for (const double slid : {2e-7, 6e-7, 5e-6}) {
    for (std::int64_t i = 0; i < a.disc_count(); ++i) {
      if (a.y[i] < 2.0 * radius) continue;
      a.ux[i] = slid;
      a.uy[i] = -pressed;
    }
    m.solver->evaluate();
    const double stress = std::abs(view_bond(a, m.options, fracture[0]).contact_shear) / (2.0 * radius);
    report("shear stress of a fracture that slid, Pa", stress,
           std::min(slid * shear_stiffness, yields) / (2.0 * radius), 2e-5);
  }
}

// Pores and pipes of the lattice, 12 rows of 20; the fracture is the row of pores between the sixth row of discs and the next.
class Fracture {
 public:
  static constexpr double aperture = 1e-3, viscosity = 0.1;  // m, Pa s
  Fracture() : model_(options(), testing_unit::square_lattice(20, 12, radius)) {
    model_.fill_pores();
    auto& n = model_.network;
    std::fill(n.conductance.begin(), n.conductance.end(), 0.0);
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      const auto i = static_cast<std::size_t>(model_.assembly.first[e]),
                 j = static_cast<std::size_t>(model_.assembly.second[e]);
      if ((model_.assembly.y[i] - line) * (model_.assembly.y[j] - line) >= 0.0) continue;
      for (const auto d : {n.left[e], n.right[e]}) {
        if (d != 0 && std::find(pores_.begin(), pores_.end(), d) == pores_.end()) pores_.push_back(d);
      }
      if (n.left[e] == 0 || n.right[e] == 0) continue;
      n.conductance[e] = std::pow(aperture, 3) / (12.0 * viscosity * 2.0 * radius);
    }
    std::sort(pores_.begin(), pores_.end(),
              [&](auto a, auto b) { return n.centroid[a].x < n.centroid[b].x; });
    for (auto& p : n.pressure) p = n.reference_pressure;
  }
  static constexpr double line = 6.0;  // m

  testing_unit::TestModel& model() { return model_; }
  Network& network() { return model_.network; }
  [[nodiscard]] const std::vector<std::int32_t>& pores() const { return pores_; }  // from left to right

 private:
  static Options options() {
    Options o = lattice_options();
    o.model_width = 20.0;
    o.model_height = 12.0;
    o.stress_convention = static_cast<std::int64_t>(StressConvention::effective);
    o.fluid_viscosity = viscosity;
    return o;
  }
  testing_unit::TestModel model_;
  std::vector<std::int32_t> pores_;
};

TEST(V19FractureSectionSmoke, StoresWhatItsFluidIsCompressedBy) {
  Fracture f;
  Network& n = f.network();
  ASSERT_EQ(f.pores().size(), 19U);
  constexpr double rate = 1e-6, time = 1e5;  // m2/s, s: long enough to be even along the fracture
  std::vector<double> source(static_cast<std::size_t>(n.domain_count()), 0.0);
  source[static_cast<std::size_t>(f.pores().front())] = rate;
  FlowSolver flow(n, f.model().options);
  flow.advance(n, time, source);
  source.assign(source.size(), 0.0);
  flow.advance(n, 1e9, source);
  double volume = 0.0;
  for (const auto d : f.pores()) volume += n.volume[d];
  const double rise = f.model().options.fluid_bulk_modulus * rate * time / volume;
  report("rise of the pressure at the near end, Pa", n.pressure[f.pores().front()] - n.reference_pressure,
         rise, 1e-6);
  report("rise of the pressure at the far end, Pa", n.pressure[f.pores().back()] - n.reference_pressure, rise,
         1e-6);
}

TEST(V19FractureSectionSmoke, LosesPressureAsItOpens) {
  Fracture f;
  auto& m = f.model();
  constexpr double opening = 1e-6;  // m
  for (auto& p : m.network.pressure) p = 20e6;
  for (std::int64_t d = 0; d < m.network.domain_count(); ++d)
    m.network.content[d] = content_at(m.network, d, m.options.fluid_bulk_modulus, 20e6);
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    if (m.assembly.y[i] > Fracture::line) m.assembly.uy[i] = opening;
  }
  m.solver->evaluate();
  for (const std::size_t k : {std::size_t{0}, f.pores().size() / 2}) {
    const auto d = f.pores()[k];
    report("fall of the pressure in a pore that opens, Pa", 20e6 - m.network.pressure[d],
           m.options.fluid_bulk_modulus * opening * 2.0 * radius / m.network.volume[d], 1e-6);
  }
}

TEST(V19FractureSectionSmoke, ConductsAsParallelPlatesDo) {
  Fracture f;
  Network& n = f.network();
  constexpr double drop = 1e5;
  const auto first = f.pores().front(), last = f.pores().back();
  n.stiffness[first] = n.stiffness[last] = 0.0;
  n.pressure[first] = n.reference_pressure + drop;
  n.pressure[last] = n.reference_pressure;
  FlowSolver flow(n, f.model().options);
  for (int step = 0; step < 2; ++step) flow.advance(n, 1e12, {});
  double through = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    if (n.left[e] == first || n.right[e] == first) through += std::abs(n.flow[e]);
  }
  const double length = n.centroid[last].x - n.centroid[first].x;
  report("flow along the fracture, m2/s", through,
         std::pow(Fracture::aperture, 3) * drop / (12.0 * Fracture::viscosity * length), 1e-6);
}

// The volume leaked off against Carter's.
void leak_off(std::int64_t discs, double tolerance) {
  constexpr double permeability = 5.527e-15, held = 1e6, middle = 50.0;
  RigidNetwork rock(discs, 1);
  rock.calibrate(permeability);
  Network& n = rock.network();
  const Assembly& a = rock.assembly();
  double left = 1e300, right = 0.0, imposed = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const auto i = static_cast<std::size_t>(a.first[e]), j = static_cast<std::size_t>(a.second[e]);
    if ((a.y[i] - middle) * (a.y[j] - middle) >= 0.0) continue;
    for (const auto d : {n.left[e], n.right[e]}) {
      if (d != 0) rock.impose(d, held);
    }
    left = std::min({left, a.x[i], a.x[j]});
    right = std::max({right, a.x[i], a.x[j]});
  }
  const double phi = rock.porosity(0.0, 100.0), mobility = permeability / rock.options().fluid_viscosity,
               diffusivity = mobility * rock.options().fluid_bulk_modulus / phi, length = right - left;
  // As in V5 the front lies where the held pores that feed free ones are: what the held ones store beyond it has leaked off.
  double above = 0.0, above_weight = 0.0, below = 0.0, below_weight = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const auto l = n.left[e], r = n.right[e];
    if (n.conductance[e] == 0.0 || (n.stiffness[l] == 0.0) == (n.stiffness[r] == 0.0)) continue;
    const auto fixed = n.stiffness[l] == 0.0 ? l : r, free = fixed == l ? r : l;
    const bool up = n.centroid[free].y > middle;
    (up ? above : below) += n.conductance[e] * n.centroid[fixed].y;
    (up ? above_weight : below_weight) += n.conductance[e];
  }
  for (std::int64_t d = 1; d < n.domain_count(); ++d) imposed += n.stiffness[d] == 0.0 ? n.volume[d] : 0.0;
  const double beyond = imposed - phi * length * (above / above_weight - below / below_weight);
  const auto carter = [&](double time) {
    return 2.0 * length * 2.0 * mobility * held * std::sqrt(time / (pi * diffusivity));
  };
  Curves curves("V19-leak-off", "Fluid leaked off through both faces of a fracture of 100 m held at 1 MPa",
                "square root of time (s^0.5),volume (m2)");
  FlowSolver flow(n, rock.options());
  double time = 0.0;
  for (const double depth : {8.0, 12.0, 16.0, 20.0, 25.0, 30.0}) {
    const double until = 0.25 * depth * depth / diffusivity;
    constexpr int steps = 100;
    for (int k = 0; k < steps; ++k) flow.advance(n, (until - time) / steps, {});
    time = until;
    double leaked = beyond * held / rock.options().fluid_bulk_modulus;
    for (std::int64_t d = 1; d < n.domain_count(); ++d) {
      if (n.stiffness[d] > 0.0) leaked += n.content[d];
    }
    report(std::to_string(discs) +
               " discs: leaked off by 2 sqrt(D t) = " + std::to_string(static_cast<int>(depth)) + " m, m2",
           leaked, carter(time), tolerance);
    curves.point(std::to_string(discs) + " discs", {std::sqrt(time), leaked});
  }
  if (discs == 8000)
    curves.line("Carter", 0.0, std::sqrt(time),
                [&](double root) { return std::vector<double>{carter(root * root)}; });
}

TEST(V19FractureSectionSmoke, LeaksOffIntoTheRock) {
  leak_off(1000, 0.10);
}

TEST(V19FractureSection, LeaksOffMoreExactlyWithSmallerDiscs) {
  leak_off(4000, 0.05);
  leak_off(8000, 0.05);
}

}  // namespace V19_fracture_section

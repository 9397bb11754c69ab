// SPDX-License-Identifier: BSD-3-Clause
#include "lab/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "build/build_model.hpp"
#include "core/error.hpp"
#include "core/plane_fit.hpp"
#include "model/visit_state.hpp"
#include "options/choices.hpp"

namespace hfrac {
using End = EquilibriumSolver::End;

namespace {

constexpr double platen_reach = 0.5;  // mean radii between a disc's rim and a platen that holds it
constexpr double gauge = 0.35;        // half of the sides' share that strain is taken over
constexpr double unbreakable = 1e6;   // times its strength
constexpr double round_cap = 0.35;  // diameters from the middle, beyond which a round specimen does not break
constexpr int most_attempts = 3;
constexpr double relaxed_ratio = 1e-5;  // mean unbalanced over mean contact force
constexpr std::int64_t most_cycles = 40000;

Options bench_options(Options o, const SpecimenShape& shape) {
  o.model_width = shape.width;
  o.model_height = shape.height;
  o.fluid_formation_pressure = 0.0;  // pressures count from the drained rock's
  o.boundary_kind = static_cast<std::int64_t>(BoundaryKind::stress);
  o.flow_scheme = static_cast<std::int64_t>(shape.wet ? FlowScheme::implicit_scheme : FlowScheme::off);
  o.stress_sigma_Hmax = shape.stress_x;
  o.stress_sigma_hmin = shape.stress_y;
  o.solver_factor = static_cast<std::int64_t>(FactorOf::own);
  o.solver_tolerance = std::min(o.solver_tolerance, 1e-6);
  return o;
}

Packing round_out(const Packing& square, double diameter) {
  Packing round;
  round.mean_radius = square.mean_radius;
  for (std::size_t i = 0; i < square.x.size(); ++i) {
    const double x = square.x[i] - 0.5 * diameter, y = square.y[i] - 0.5 * diameter;
    if (std::hypot(x, y) + square.radius[i] > 0.5 * diameter) continue;
    round.x.push_back(square.x[i]);
    round.y.push_back(square.y[i]);
    round.radius.push_back(square.radius[i]);
  }
  return round;
}

}  // namespace

Specimen::Specimen(const Packing& packing, const Options& material, const SpecimenShape& shape)
    : options_(bench_options(material, shape)), shape_(shape) {
  const Packing cut = shape.round ? round_out(packing, shape.width) : Packing{};
  const Packing& taken = shape.round ? cut : packing;
  CaseDefinition definition;
  definition.options = options_;
  SetupReport report;
  model_ = build_model(definition, taken, {}, report);
  boundary_ = std::make_unique<Boundary>(model_, options_);
  workers_.reset(new Workers(1));
  mechanics_ = std::make_unique<ExplicitSolver>(model_, *boundary_, options_, *workers_);
  mechanics_->set_undrained(false);
  cut_slit();
  equilibrium_ =
      std::make_unique<EquilibriumSolver>(model_, facets_, *boundary_, *mechanics_, options_, *workers_);
}

void Specimen::cut_slit() {
  if (!(shape_.slit_end > shape_.slit_begin)) return;
  const auto& a = model_.assembly;
  const double y = 0.5 * shape_.height;
  double before = -1.0, after = 2.0 * shape_.width, first = after, last = before;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const auto i = a.first[e], j = a.second[e];
    if ((a.y[i] - y) * (a.y[j] - y) >= 0.0) continue;
    const double x = a.x[i] + (a.x[j] - a.x[i]) * (y - a.y[i]) / (a.y[j] - a.y[i]);
    if (x < shape_.slit_begin) before = std::max(before, x);
    if (x > shape_.slit_end) after = std::min(after, x);
    if (x < shape_.slit_begin || x > shape_.slit_end) continue;
    model_.assembly.intact[static_cast<std::size_t>(e)] = 0;
    first = std::min(first, x);
    last = std::max(last, x);
    slit_.push_back(e);
  }
  // A tip lies between the last bond cut and the first one that holds.
  tips_ = {before < 0.0 ? 0.0 : 0.5 * (before + first),
           after > shape_.width ? shape_.width : 0.5 * (last + after)};
  if (slit_.size() < 3) {
    throw Error(ErrorKind::model, "the slit of " + std::to_string(shape_.slit_end - shape_.slit_begin) +
                                      " m crosses only " + std::to_string(slit_.size()) +
                                      " bonds; raise the number of discs or the slit's share of the width");
  }
}

void Specimen::grip_ends(double half_angle) {
  const auto& a = model_.assembly;
  const double reach = platen_reach * a.mean_radius, middle = 0.5 * shape_.height;
  auto& grips = boundary_->grips();
  grips.clear();
  const auto collect = [&](double side) {
    for (std::int32_t i = 0; i < a.disc_count(); ++i) {
      const double x = a.x[i] - 0.5 * shape_.width, y = side * (a.y[i] - middle);
      const bool held = half_angle > 0.0
                            ? y > 0.0 && std::abs(std::atan2(x, y)) <= half_angle &&
                                  std::hypot(x, y) + a.radius[i] > 0.5 * shape_.height - 2.0 * a.mean_radius
                            : y + a.radius[i] > middle - reach;
      if (held) grips.push_back({i, {0.0, 1.0}, 0.0});
    }
    return grips.size();
  };
  lower_ = collect(-1.0);
  upper_ = collect(1.0);
  if (lower_ == 0 || upper_ == lower_) {
    throw Error(ErrorKind::model,
                "no disc lies within " + std::to_string(reach) + " m of a platen; raise the number of discs");
  }
  grips.push_back({grips[lower_ / 2].disc, {1.0, 0.0}, 0.0});  // against drifting sideways; bears nothing
  if (model_.assembly.strength_scale.empty()) model_.assembly.strength_scale.assign(a.first.size(), 1.0);
  std::vector<char> held(a.x.size(), 0);
  for (const auto& grip : grips) held[static_cast<std::size_t>(grip.disc)] = 1;
  const double cap = half_angle > 0.0 ? round_cap * shape_.height : 1e300;
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    const double y =
        0.5 * (a.y[static_cast<std::size_t>(a.first[e])] + a.y[static_cast<std::size_t>(a.second[e])]);
    if (std::abs(y - middle) > cap) model_.assembly.strength_scale[e] = unbreakable;
    if (held[static_cast<std::size_t>(a.first[e])] != 0 || held[static_cast<std::size_t>(a.second[e])] != 0)
      model_.assembly.strength_scale[e] = unbreakable;
  }
  combine_factors(model_.assembly, options_);
}

void Specimen::make_unbreakable() {
  model_.assembly.tensile_per_radius = model_.assembly.shear_per_radius = 1e30;
}

void Specimen::lead_ends(double elongation) {
  elongation_ = elongation;
  auto& grips = boundary_->grips();
  for (std::size_t k = 0; k < upper_; ++k) grips[k].target = (k < lower_ ? -0.5 : 0.5) * elongation;
}

double Specimen::pull() const {
  double force = 0.0;
  const auto& grips = boundary_->grips();
  for (std::size_t k = 0; k < upper_; ++k)
    force += (k < lower_ ? -0.5 : 0.5) * boundary_->grip_force(model_.assembly, grips[k]);
  return force;
}

// The slit's pores, and those that broken bonds join to them.
void Specimen::pressurise(double pressure) {
  auto& n = model_.network;
  std::vector<char> reached(n.kind.size(), 0);
  for (const auto e : slit_) {
    reached[static_cast<std::size_t>(n.left[static_cast<std::size_t>(e)])] = 1;
    reached[static_cast<std::size_t>(n.right[static_cast<std::size_t>(e)])] = 1;
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& crack : model_.cracks) {
      auto& l = reached[static_cast<std::size_t>(n.left[static_cast<std::size_t>(crack.bond)])];
      auto& r = reached[static_cast<std::size_t>(n.right[static_cast<std::size_t>(crack.bond)])];
      grew = grew || l != r;
      l = r = static_cast<char>(l | r);
    }
  }
  for (std::size_t d = 1; d < reached.size(); ++d) n.pressure[d] = reached[d] != 0 ? pressure : 0.0;
}

EquilibriumSolver::Outcome Specimen::solve(double most_excess, const std::function<bool()>& interrupt) {
  auto outcome = equilibrium_->solve(0.0, {}, most_excess, model_.cracks, interrupt);
  factors_ += outcome.factors;
  const bool held = !boundary_->grips().empty() && !softens();
  for (int attempt = 0; held && outcome.end == End::not_converged && attempt < most_attempts; ++attempt)
    outcome = settle(interrupt);
  if (outcome.end == EquilibriumSolver::End::rest) mechanics_->search_contacts(model_.cracks);
  return outcome;
}

EquilibriumSolver::Outcome Specimen::settle(const std::function<bool()>& interrupt) {
  ++relaxations_;
  const auto moved = mechanics_->relax(relaxed_ratio, most_cycles, model_.cracks, interrupt);
  EquilibriumSolver::Outcome outcome;
  if (moved.stopped) {
    outcome.end = End::stopped;
    return outcome;
  }
  mechanics_->search_contacts(model_.cracks);
  if (softens()) keep();
  outcome = equilibrium_->solve(0.0, {}, std::numeric_limits<double>::infinity(), model_.cracks, interrupt);
  factors_ += outcome.factors;
  if (outcome.end == End::not_converged && moved.at_rest) {
    if (softens()) go_back();
    outcome.force_ratio = moved.force_ratio;
    outcome.end = End::rest;
  }
  return outcome;
}

Specimen::Account Specimen::account() const {
  const Assembly& a = model_.assembly;
  Account account{0.0, energy_taken(a, options_), boundary_->load_work(a), elongation_, pull()};
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const BondView bond = view_bond(a, options_, e);
    account.stored += bond.bond_energy + bond.contact_energy;
  }
  account.stored += mechanics_->non_bonded_contacts().energy(a);
  for (const auto& grip : boundary_->grips()) {
    const double force = boundary_->grip_force(a, grip);
    account.stored += 0.5 * force * force / options_.contact_normal_stiffness;
  }
  return account;
}

void Specimen::keep() {
  Counter counter(true);
  visit_state(counter, model_, shape_.wet);
  kept_.resize(counter.size());
  Saver saver(kept_, true);
  visit_state(saver, model_, shape_.wet);
}

void Specimen::go_back() {
  Loader loader(kept_, true);
  visit_state(loader, model_, shape_.wet);
}

Strain Specimen::strain() const {
  const auto& a = model_.assembly;
  PlaneFit along_x, along_y;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    const double x = a.x[i] - 0.5 * shape_.width, y = a.y[i] - 0.5 * shape_.height;
    if (std::abs(x) > gauge * shape_.width || std::abs(y) > gauge * shape_.height) continue;
    along_x.add(x, y, a.ux[i]);
    along_y.add(x, y, a.uy[i]);
  }
  return {along_y.plane().by_y, along_x.plane().by_x};
}

double Specimen::largest_excess() const {
  return equilibrium_->find_exceeding();
}

std::vector<Vec2> Specimen::opening() const {
  const auto& a = model_.assembly;
  const double middle = 0.5 * (shape_.slit_begin + shape_.slit_end), y = 0.5 * shape_.height;
  std::vector<Vec2> points;
  for (const auto e : slit_) {
    const auto k = static_cast<std::size_t>(e);
    const bool up = a.y[a.second[k]] > a.y[a.first[k]];
    const auto below = up ? a.first[k] : a.second[k], above = up ? a.second[k] : a.first[k];
    const double x = a.x[below] + (a.x[above] - a.x[below]) * (y - a.y[below]) / (a.y[above] - a.y[below]);
    points.push_back({x - middle, a.uy[above] - a.uy[below]});
  }
  std::sort(points.begin(), points.end(), [](Vec2 p, Vec2 q) { return p.x < q.x; });
  return points;
}

std::int64_t Specimen::cracks_in(CrackMode mode) const {
  return std::count_if(model_.cracks.begin(), model_.cracks.end(),
                       [&](const Crack& crack) { return crack.mode == mode; });
}

double Specimen::coordination() const {
  return 2.0 * static_cast<double>(model_.assembly.bond_count()) /
         static_cast<double>(model_.assembly.disc_count());
}

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/equilibrium_solver.hpp"

#include <algorithm>
#include <cmath>

#include "equilibrium/step_part.hpp"
#include "options/choices.hpp"
#include "solid/bond_law.hpp"

namespace hfrac {
namespace {

constexpr int most_newton = 40;          // iterations of a round
constexpr int most_uphill = 2;           // iterations of a round that lead nowhere
constexpr int patience = 8;              // iterations in which the residual has to fall
constexpr int circle = 6;                // iterations without that: Newton's method goes in a circle
constexpr double fall = 0.7;             // by this factor at least
constexpr int most_rounds = 2000;        // of a solve
constexpr int most_turns = 40;           // between apertures and equilibrium
constexpr double held_tolerance = 0.01;  // of the largest aperture
constexpr int most_krylov = 40;          // iterations of a linear solve
constexpr double renew_rate = 4.5;  // iterations per power of ten gained: a factor that needs more is renewed
constexpr int most_iterations_of_fresh = 12;  // a fresh factor that needs more has too few digits
// What a linear solve leaves of the residual: the first of a round meets kinks all the same, later ones are to be the last.
// Pores of joints are a thousand times stiffer than the rock: what is left in their rows is a large error of pressure.
constexpr double of_joints_tolerance = 1e-8;
constexpr double first_tolerance = 1e-2, later_tolerance = 1e-3, loosest_tolerance = 0.1;
constexpr double longest_move = 0.2;  // of the mean radius (graded: of fine discs), per iteration
constexpr double apart = 6.0;         // mean radii between bonds that break in one round

}  // namespace

EquilibriumSolver::EquilibriumSolver(Model& model, Facets& facets, Boundary& boundary,
                                     ExplicitSolver& mechanics, const Options& options, Workers& workers)
    : assembly_(model.assembly),
      network_(model.network),
      boundary_(boundary),
      mechanics_(mechanics),
      options_(options),
      facets_(facets),
      system_(model.assembly, model.network, boundary, mechanics.non_bonded_contacts(), options, workers,
              facets, &model.wellbores, mechanics.shared_tiles().ranks()),
      factor_(workers, mechanics.shared_tiles().ranks(), FactorOf{options.solver_factor} == FactorOf::petsc),
      krylov_(workers, mechanics.shared_tiles().ranks()) {}

void EquilibriumSolver::begin_step() {
  factor_.forget();
}

EquilibriumSolver::Outcome EquilibriumSolver::solve(double duration, const std::vector<double>& source,
                                                    double most_excess, CrackLog& log,
                                                    const std::function<bool()>& interrupt) {
  Outcome outcome;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (const auto& pair : mechanics_.non_bonded_contacts().pairs())
    pairs.emplace_back(pair.first, pair.second);
  if (pairs != pairs_ || (duration > 0.0) != flowed_) factor_.forget_pattern();
  flowed_ = duration > 0.0;
  pairs_.swap(pairs);
  mechanics_.stop_motion();
  system_.begin(duration, source);
  pressure_start_.assign(network_.pressure.begin(), network_.pressure.end());
  for (outcome.rounds = 1; outcome.rounds <= most_rounds; ++outcome.rounds) {
    const bool found = duration > 0.0 && fractured() ? find_rest_of_fractures(outcome, interrupt)
                                                     : find_rest(outcome, interrupt);
    outcome.force_ratio = system_.force_ratio();
    if (!found) {
      outcome.where = system_.worst_place();
      return outcome;
    }
    const double excess = find_exceeding();
    if (outcome.rounds == 1) outcome.excess = excess;
    outcome.last_excess = excess;
    if (outcome.rounds == 1 && excess > most_excess) {
      outcome.end = End::overshoot;
      return outcome;
    }
    // Before pressures are made to follow the contents: the balance counts what those were moved by.
    if (exceeding_.empty() && duration > 0.0) {
      system_.keep_flow();
      system_.keep_wellbores();
    }
    keep_round();
    if (exceeding_.empty()) {
      boundary_.remove_rigid_motion(assembly_);
      outcome.end = End::rest;
      return outcome;
    }
    break_farthest(log);
  }
  return outcome;
}

bool EquilibriumSolver::rest_unbroken() {
  Outcome outcome;
  begin_step();
  mechanics_.stop_motion();
  system_.begin(0.0, {});
  const bool found = find_rest(outcome, {});
  begin_step();
  return found;
}

// Conductances of facets and joints go with the cube of what the fluid opens, and Newton's method on both runs to and fro. With the apertures
// held the equations are linear but for faces that close or slide; apertures follow in turn (Picard's iteration).
bool EquilibriumSolver::find_rest_of_fractures(Outcome& outcome, const std::function<bool()>& interrupt) {
  system_.release_apertures();
  system_.evaluate();
  system_.hold_apertures(1.0);
  for (int turn = 0; turn < most_turns; ++turn) {
    if (!find_rest(outcome, interrupt)) return false;
    if (system_.hold_apertures(turn < 2 ? 1.0 : 0.5) < held_tolerance) return true;
  }
  return false;
}

bool EquilibriumSolver::find_rest(Outcome& outcome, const std::function<bool()>& interrupt) {
  if (find_rest(outcome, interrupt, Way::by_work)) return true;
  if (!fractured() || outcome.end == End::stopped) return false;
  system_.move(gone_, -1.0);
  return find_rest(outcome, interrupt, Way::by_residual);
}

bool EquilibriumSolver::find_rest(Outcome& outcome, const std::function<bool()>& interrupt, Way way) {
  const double tolerance = options_.solver_tolerance;
  using Vector = CoupledSystem::Vector;
  const Krylov::Apply product = [this](const Vector& x, Vector& y) { system_.product(x, y); };
  const Krylov::Apply precondition = [this](const Vector& right, Vector& x) { factor_.solve(right, x); };
  CoupledSystem::Vector step;
  gone_.setZero(system_.size());
  int uphill = 0, best_at = 0;
  system_.evaluate();
  double best = system_.residual().norm();
  for (int iteration = 0; iteration < most_newton; ++iteration) {
    if (system_.force_ratio() <= tolerance && system_.pressure_error() <= tolerance) return true;
    if (!std::isfinite(system_.residual().squaredNorm())) return false;
    if (interrupt && interrupt()) {
      outcome.end = End::stopped;
      return false;
    }
    ++outcome.newton;
    mechanics_.count_cycles(1);
    const CoupledSystem::Vector right = system_.residual();
    bool fresh = false;
    const double worst = std::max(system_.force_ratio(), system_.pressure_error());
    const double tightest = !network_.joint_pore.empty() ? of_joints_tolerance
                            : iteration == 0             ? first_tolerance
                                                         : later_tolerance;
    const double linear_tolerance = std::clamp(0.3 * tolerance / worst, tightest, loosest_tolerance);
    const auto renew = [&] {
      krylov_.forget();
      factor_.compute(system_);
      ++outcome.factors;
    };
    const auto solve_linear = [&](double to) {
      const auto digits = factor_.single() ? Krylov::Digits::of_single : Krylov::Digits::of_double;
      return krylov_.solve(product, precondition, right, to, most_krylov, step, digits);
    };
    if (!factor_.ready() || krylov_rate_ > renew_rate) {
      renew();
      fresh = true;
    }
    auto linear = solve_linear(linear_tolerance);
    outcome.krylov += linear.iterations;
    if ((!linear.converged && !fresh) ||
        (fresh && linear.iterations > most_iterations_of_fresh && factor_.refine())) {
      renew();
      linear = solve_linear(linear_tolerance);
      outcome.krylov += linear.iterations;
    }
    krylov_rate_ = linear.iterations / -std::log10(linear_tolerance);
    if (!std::isfinite(step.squaredNorm())) return false;

    system_.limit(step, longest_move * assembly_.mean_radius);
    const double before = right.norm(), push = system_.work_along(step);
    const bool whole_steps = fractured();
    const double longest = whole_steps ? 1.0 : system_.share_for_apertures(step, 4.0);
    double share = 0.0;
    // The residual where `part` of the longest step leads.
    const auto go_to = [&](double part) {
      system_.move(step, part * longest - share);
      share = part * longest;
      system_.evaluate();
      return system_.residual().norm();
    };
    double after = go_to(1.0);
    if (whole_steps) {
      const bool circles = iteration - best_at >= circle;
      const double beyond = system_.work_along(step);
      if (way == Way::by_work && !(after < 0.5 * before) && goes_too_far(push, beyond)) {
        after = go_to(part_by_work(push, beyond, [&](double part) {
          go_to(part);
          return system_.work_along(step);
        }));
      } else if (circles) {
        after = go_to(part_that_leaves_least(after, go_to));
      } else if (way == Way::by_residual && iteration >= 4 && iteration % 2 == 0 && !(after < 0.5 * before)) {
        after = go_to(0.5);  // out of a circle that has just begun
      }
    } else {
      // The equations have kinks, where contacts open, close, stick and slide. Where no part of the step leads down, the whole of it
      // is taken all the same, to come out on the other side; every other time half of it, against going to and fro.
      double part = 1.0;
      for (int halving = 0; halving < 4 && !(after < before); ++halving) after = go_to(part *= 0.5);
      if (!(after < before)) {
        if (++uphill > most_uphill) return false;
        after = go_to(uphill % 2 == 1 ? 1.0 : 0.5);
      }
    }
    gone_ += share * step;
    // What goes to and fro between two sides of a kink, or round a fold, finds no rest in this increment; a shorter one may.
    if (after < fall * best) {
      best = after;
      best_at = iteration;
    } else if (iteration - best_at >= (whole_steps ? 2 * patience : patience)) {
      return false;
    }
  }
  return system_.force_ratio() <= tolerance && system_.pressure_error() <= tolerance;
}

double EquilibriumSolver::find_exceeding() {
  exceeding_.clear();
  double largest = 0.0;
  const bool tips = facets_.active() && options_.bond_fracture_toughness > 0.0;
  std::vector<char> at_tip;
  std::vector<Vec2> ends;
  const double zone = tips ? tip_zone(assembly_, options_) : 0.0;
  if (tips) {
    at_tip.assign(network_.kind.size(), 0);
    for (const Tip& tip : find_tips(facets_, assembly_, network_, options_, time_)) {
      at_tip[static_cast<std::size_t>(tip.domain)] = 1;
      ends.push_back(network_.centroid[tip.domain]);
      if (tip.ahead < 0 || mechanics_.stays(tip.ahead)) continue;
      const double excess = tip.excess;
      largest = std::max(largest, excess);
      if (excess >= 1.0) exceeding_.push_back({excess, tip.ahead, true});
    }
  }
  for (std::int64_t e = 0; e < assembly_.bond_count(); ++e) {
    if (assembly_.intact[e] == 0) continue;
    if (tips && (at_tip[network_.left[e]] != 0 || at_tip[network_.right[e]] != 0)) continue;
    const BondView bond = view_bond(assembly_, options_, e);
    const double excess = std::max(bond.tensile_excess, bond.shear_excess);
    if (excess < largest && excess < 1.0) continue;
    if (excess >= 1.0 && mechanics_.stays(e)) continue;
    if (std::any_of(ends.begin(), ends.end(), [&](Vec2 end) { return in_tip_zone(assembly_, zone, end, e); }))
      continue;
    largest = std::max(largest, excess);
    if (excess >= 1.0) exceeding_.push_back({excess, e});
  }
  return largest;
}

void EquilibriumSolver::keep_round() {
  // The kernel's own passes: slip, volumes, pressures from contents, and the fluid's work from the pressure before.
  const Array<double> found = network_.pressure;
  std::copy(pressure_start_.begin(), pressure_start_.end(), network_.pressure.begin());
  const Array<double> change = facets_.active() ? network_.volume_change : Array<double>{};
  mechanics_.evaluate();
  for (std::int64_t d = 0; d < network_.domain_count(); ++d)
    if (facets_.fractured(
            d)) {  // the kernel knows no facets: it counted the work of other pressures and volumes
      double& p = network_.pressure[d];
      double& v = network_.volume_change[d];
      const double counted = (pressure_start_[d] + p) * (v - change[d]);
      p = found[d];
      v = system_.volume_change(d);
      mechanics_.add_fluid_work(0.5 * ((pressure_start_[d] + p) * (v - change[d]) - counted));
    }
  pressure_start_.assign(network_.pressure.begin(), network_.pressure.end());
  for (std::size_t k = 0; k < mechanics_.non_bonded_contacts().pairs().size(); ++k)
    mechanics_.keep_non_bonded_force(k, system_.pair_normal_force(k), system_.pair_shear_force(k));
  system_.keep_pairs();
}

void EquilibriumSolver::break_farthest(CrackLog& log) {
  std::sort(exceeding_.begin(), exceeding_.end(), [](const Exceeding& a, const Exceeding& b) {
    return a.excess != b.excess ? a.excess > b.excess : a.bond < b.bond;
  });
  std::vector<Vec2> broken;
  std::vector<std::int64_t> bonds;
  for (const auto& candidate : exceeding_) {
    const Vec2 middle = 0.5 * (assembly_.position(assembly_.first[candidate.bond]) +
                               assembly_.position(assembly_.second[candidate.bond]));
    const double radius = assembly_.mean_radius_of(candidate.bond);
    const bool near = std::any_of(broken.begin(), broken.end(), [&](Vec2 at) {
      const Vec2 between = middle - at;
      return dot(between, between) < apart * apart * radius * radius;
    });
    // Bonds that soften have let go of what they bore before they break.
    if ((near && assembly_.softening.empty()) || mechanics_.stays(candidate.bond))
      continue;  // some of its discs' other bonds may have broken just now
    broken.push_back(middle);
    bonds.push_back(candidate.bond);
    mechanics_.break_bond(candidate.bond, log);
    if (candidate.at_tip) log.back().mode = CrackMode::tension;
    if (facets_.active()) network_.facet_time[candidate.bond] = time_;
    if (facets_.active()) {
      const auto l = network_.left[candidate.bond], r = network_.right[candidate.bond];
      const bool lw = network_.is_well(l) || facets_.fractured(l),
                 rw = network_.is_well(r) || facets_.fractured(r);
      if (lw != rw) {
        const auto from = lw ? l : r, to = lw ? r : l;
        if (network_.stiffness[to] > 0.0)
          network_.pressure[to] = std::max(network_.pressure[to], network_.pressure[from]);
      }
    }
  }
  facets_.add(assembly_, network_, bonds);
}

}  // namespace hfrac

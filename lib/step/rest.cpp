// SPDX-License-Identifier: BSD-3-Clause
#include "step/rest.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "frac/tip.hpp"
#include "options/number_text.hpp"
#include "solid/softening.hpp"
#include "step/ledger.hpp"
#include "step/snapshot.hpp"

namespace hfrac {
namespace {

using End = EquilibriumSolver::End;

RestOutcome relax(Engine& e, const Interrupt& interrupt) {
  const Options& o = e.options;
  const auto motion = e.mechanics->relax(o.stepping_force_ratio, o.stepping_max_cycles, e.model.cracks,
                                         interrupt, ExplicitSolver::Then::evaluate);
  if (motion.stopped) return {true};
  e.model.clock.force_ratio = motion.force_ratio;
  e.model.clock.at_rest = motion.at_rest;
  return {};
}

RestOutcome solve_for_rest(Engine& e, const Interrupt& interrupt) {
  Model& m = e.model;
  save_state(e, e.before_increment);
  auto rest = solve_soundly(e, 0.0, {}, std::numeric_limits<double>::infinity(), interrupt);
  if (rest.end == End::not_converged) {
    load_state(e, e.before_increment);
    count(e, rest);
    const auto settled = relax_dynamically(e, 0.0, interrupt);
    if (settled.end == End::not_converged) {
      throw Error(ErrorKind::diverged, "no equilibrium was found after " + number_text(m.clock.time) +
                                           " s: the unbalanced-force ratio stayed at " +
                                           rounded_text(rest.force_ratio) + ", farthest from rest near " +
                                           place_text(rest.where) + ", and damped motion left it at " +
                                           rounded_text(settled.force_ratio) +
                                           " (eq. 11, 12); the state before the step stands. Use a shorter "
                                           "stepping.flow_step, or a lower pressure or rate");
    }
    rest = settled;
  }
  if (rest.end == End::stopped) return {true};
  count(e, rest);
  m.clock.force_ratio = rest.force_ratio;
  m.clock.at_rest = true;
  return {};
}

}  // namespace

std::string place_text(Vec2 at) {
  std::string text = "(";  // in two steps: GCC 12 takes a literal plus a temporary for an overlap
  text += rounded_text(at.x) + ", " + rounded_text(at.y) + ") m";
  return text;
}

bool grow_tips(Engine& e, CrackLog& log) {
  constexpr double apart = 6.0;  // mean radii between bonds that break at once
  Model& m = e.model;
  std::vector<Tip> tips = find_tips(e.facets, m.assembly, m.network, e.options, e.mechanics->time());
  std::sort(tips.begin(), tips.end(), [](const Tip& a, const Tip& b) {
    return a.excess != b.excess ? a.excess > b.excess : a.ahead < b.ahead;
  });
  std::vector<std::int64_t> broken;
  const auto near = [&](std::int64_t bond) {
    return std::any_of(broken.begin(), broken.end(), [&](std::int64_t other) {
      const Vec2 between = e.facets.contact(bond) - e.facets.contact(other);
      return dot(between, between) < apart * apart * m.assembly.mean_radius * m.assembly.mean_radius;
    });
  };
  for (const Tip& tip : tips) {
    if (tip.excess < 1.0 || tip.ahead < 0 || near(tip.ahead) || m.assembly.intact[tip.ahead] == 0 ||
        e.mechanics->stays(tip.ahead))
      continue;
    e.mechanics->break_bond(tip.ahead, log);
    log.back().mode = CrackMode::tension;
    m.network.facet_time[tip.ahead] = e.mechanics->time();
    broken.push_back(tip.ahead);
  }
  e.facets.add(m.assembly, m.network, broken);
  return !broken.empty();
}

// Rock that softens has equilibria that no way leads to, which took more energy than came in; Newton's method may find one.
EquilibriumSolver::Outcome solve_soundly(Engine& e, double duration, const std::vector<double>& source,
                                         double most_excess, const Interrupt& interrupt) {
  constexpr double small = 0.05;  // of what softening took
  const Assembly& a = e.model.assembly;
  const bool softens = !a.softening.empty();
  const double taken = energy_taken(a, e.options), work = softens ? unaccounted_work(e) : 0.0;
  auto outcome = e.equilibrium->solve(duration, source, most_excess, e.model.cracks, interrupt);
  if (softens && outcome.end == End::rest &&
      work - unaccounted_work(e) >
          small * (energy_taken(a, e.options) - taken) + 1e-6 * e.model.start.bond_energy)
    outcome.end = End::not_converged;
  return outcome;
}

RestOutcome find_rest(Engine& e, const Interrupt& interrupt) {
  return e.equilibrium ? solve_for_rest(e, interrupt) : relax(e, interrupt);
}

RestOutcome move_rock(Engine& e, double duration, const Interrupt& interrupt) {
  e.mechanics->set_time(e.model.clock.time);
  const auto motion =
      e.mechanics->run_for(duration, e.model.cracks, interrupt, ExplicitSolver::Then::evaluate);
  if (motion.stopped) return {true};
  e.model.clock.force_ratio = motion.force_ratio;
  e.model.clock.at_rest = true;  // not asked for
  return {};
}

// Where Newton's method finds no equilibrium there may be none near: a bond that breaks can make the rock jump. Damped motion from
// the last state leads where the jump ends (dynamic relaxation, Otter, Cassell and Hobbs 1966; damping of Cundall 1987), as the explicit
// solver would; from there equilibrium is solved for to the same tolerance. Fluid flows first, while the rock
// stands still: for as long as the shortest increment, so it hardly does.
EquilibriumSolver::Outcome relax_dynamically(Engine& e, double increment, const Interrupt& interrupt) {
  const Options& o = e.options;
  Model& m = e.model;
  if (e.flow && increment > 0.0) m.clock.flow_rounds = e.flow->advance(m.network, increment, e.source);
  EquilibriumSolver::Outcome outcome;
  auto motion = e.mechanics->relax(o.stepping_force_ratio, o.stepping_max_cycles, m.cracks, interrupt);
  if (motion.at_rest) {
    e.mechanics->evaluate();
    std::vector<std::byte> settled;
    save_state(e, settled);
    outcome = solve_soundly(e, 0.0, {}, std::numeric_limits<double>::infinity(), interrupt);
    if (outcome.end != End::not_converged) return outcome;
    load_state(e, settled);
    motion = e.mechanics->relax(o.solver_tolerance, o.stepping_max_cycles, m.cracks, interrupt);
    e.mechanics->stop_motion();
    e.mechanics->evaluate();
    e.boundary->remove_rigid_motion(m.assembly);
    outcome.last_excess = e.equilibrium->find_exceeding();
  }
  outcome.end = motion.stopped ? End::stopped : (motion.at_rest ? End::rest : End::not_converged);
  outcome.force_ratio = motion.force_ratio;
  return outcome;
}

void count(Engine& e, const EquilibriumSolver::Outcome& outcome) {
  SolverWork& work = e.model.work;
  work.newton += outcome.newton;
  work.krylov += outcome.krylov;
  work.factors += outcome.factors;
  work.rounds += outcome.rounds;
}

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are no numbers are found at the end of the step that made them, and named. The mechanics watch their forces while they move; this looks at all a step leaves behind, by the one list of what a state is
// (visit_state). Only if something is wrong is it asked what, and where.
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "options/number_text.hpp"
#include "solid/smooth_joints.hpp"
#include "step/checks.hpp"
#include "step/ledger.hpp"
#include "step/snapshot.hpp"

namespace hfrac {
namespace {

// Index of the first value that is not finite; -1: none.
std::int64_t first_bad(const Array<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) return static_cast<std::int64_t>(k);
  }
  return -1;
}

}  // namespace

std::string not_finite(const Engine& e) {
  if (is_finite(e)) return {};
  e.mechanics->bring_home();
  const Network& n = e.model.network;
  const std::string end =
      " after " + std::to_string(e.model.clock.time) +
      " s; use a shorter stepping.flow_step or a lower stepping.safety, or smaller loads and rates";
  if (const std::string where = e.mechanics->first_not_finite(); !where.empty())
    return "a number is no longer finite" + where + end;
  struct Named {
    const Array<double>& values;
    const char* what;
    const char* equation;
  };
  std::vector<Named> all = {
      {n.content, "what is held by domain ", " (eq. 8)"},
      {n.volume_change, "the volume of domain ", " (eq. 8)"},
      {n.aperture, "the aperture of pipe ", " (eq. 7)"},
      {n.conductance, "the conductance of pipe ", " (eq. 6)"},
      {n.flow, "the flow in pipe ", " (eq. 6)"},
      {e.model.assembly.slip, "the slip of bond ", " (eq. 18)"},
  };
  if (e.model.heat) {
    all.push_back({e.model.heat->disc, "the temperature of disc ", " (conduction of heat)"});
    all.push_back({e.model.heat->fluid, "the temperature of domain ", " (heat carried by the fluid)"});
  }
  for (const auto& [values, what, equation] : all) {
    if (const auto bad = first_bad(values); bad >= 0)
      return what + std::to_string(bad) + " is no longer finite" + equation + end;
  }
  return "the balances left the range of finite numbers" + end;
}

void require_joints_in_reach(const Engine& e) {
  const Assembly& a = e.model.assembly;
  double slide = 0.0;
  const SmoothContact* contact = farthest_slide(a, slide);
  if (contact == nullptr || slide <= a.mean_radius) return;
  const Vec2 at = a.position(a.first[contact->bond]) + contact->first_arm();
  throw Error(
      ErrorKind::diverged,
      "joint[" + std::to_string(contact->joint) + "] slid by " + rounded_text(slide) + " m near (" +
          rounded_text(at.x) + ", " + rounded_text(at.y) + ") m, farther than the mean disc radius of " +
          rounded_text(a.mean_radius) +
          " m: a smooth joint keeps the pairs of discs that faced each other at first; load it less, hold "
          "it by friction, strength or its length, or set its state to \"broken\"");
}

// A time step too long for the model lets every cycle add energy that no work brought in. What is looked at closely is
// only motion that is worth it: at rest there is none.
void watch_energy(const Engine& e) {
  const Model& m = e.model;
  constexpr double noteworthy = 0.01;    // kinetic energy over all that was ever put in
  constexpr double from_nowhere = 0.25;  // energy no work accounts for, likewise; in sound runs some 1e-3
  const double load_work = e.boundary->load_work(m.assembly) - m.start.boundary_work;
  const double start = m.start.bond_energy + m.start.contact_energy;
  const double put_in = std::abs(m.accounts.energies.fluid) + std::abs(load_work) + start;
  if (e.mechanics->is_slower(noteworthy * put_in)) return;
  const Balance b = balance_of(e);
  const double excess = -b.energy_error;
  if (excess <= from_nowhere * (std::abs(b.fluid_work) + std::abs(b.boundary_work) + start)) return;
  std::size_t fastest = 0;
  const auto speed = [&m](std::size_t i) { return std::hypot(m.assembly.vx[i], m.assembly.vy[i]); };
  for (std::size_t i = 1; i < m.assembly.vx.size(); ++i) {
    if (speed(i) > speed(fastest)) fastest = i;
  }
  const Vec2 at = m.assembly.position(static_cast<std::int64_t>(fastest));
  throw Error(ErrorKind::diverged,
              "the step after " + std::to_string(m.clock.time) + " s made " + number_text(excess) +
                  " J/m of energy that no work accounts for (eq. 11, 12), fastest at disc " +
                  std::to_string(fastest) + " near (" + number_text(at.x) + ", " + number_text(at.y) +
                  ") m; lower stepping.safety, or a host's pressures and stresses");
}

void note_places(Engine& e) {
  const Assembly& a = e.model.assembly;
  e.moved_before.resize(a.ux.size());
  share_items(e.workers.get(), a.disc_count(), [&](std::int64_t first, std::int64_t last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      e.moved_before[i] = {static_cast<float>(a.ux[i]), static_cast<float>(a.uy[i])};
  });
}

void require_discs_in_place(const Engine& e) {
  constexpr double most_diameters = 1.0;
  const Assembly& a = e.model.assembly;
  const auto diameters_moved = [&](std::size_t i) {
    const double x = a.ux[i] - static_cast<double>(e.moved_before[i][0]),
                 y = a.uy[i] - static_cast<double>(e.moved_before[i][1]);
    return std::sqrt(x * x + y * y) / (2.0 * a.radius[i]);
  };
  std::atomic<std::int64_t> all_beyond{0};
  share_items(e.workers.get(), a.disc_count(), [&](std::int64_t first, std::int64_t last) {
    std::int64_t here = 0;
    for (auto i = first; i < last; ++i)
      here += diameters_moved(static_cast<std::size_t>(i)) > most_diameters ? 1 : 0;
    all_beyond += here;
  });
  const std::int64_t beyond = all_beyond;
  if (beyond == 0) return;
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < a.ux.size(); ++i) {
    if (diameters_moved(i) > diameters_moved(farthest)) farthest = i;
  }
  const double most = diameters_moved(farthest);
  const double diameter = 2.0 * a.radius[farthest];
  throw Error(ErrorKind::collapsed,
              "the rock fell apart in step " + std::to_string(e.model.clock.step) + ": disc " +
                  std::to_string(farthest) + ", built at (" + rounded_text(a.x[farthest]) + ", " +
                  rounded_text(a.y[farthest]) + ") m, moved by " + rounded_text(most * diameter) +
                  " m in it, more than its diameter of " + rounded_text(diameter) + " m" +
                  (beyond > 1 ? ", and so did " + std::to_string(beyond - 1) + " more" : std::string()) +
                  "; the state before the step stands. Use a lower pressure or rate, or raise it in smaller "
                  "steps, a smaller hole, more discs around it, or stronger bonds");
}

void check_step(Engine& e) {
  if (const std::string what = not_finite(e); !what.empty()) throw Error(ErrorKind::diverged, what);
  require_joints_in_reach(e);
  require_discs_in_place(e);
  if (!e.equilibrium) watch_energy(e);
}

}  // namespace hfrac

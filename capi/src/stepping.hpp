// SPDX-License-Identifier: BSD-3-Clause
// What the functions that step or take a host's values share: asking the host whether to go on, the rule of the open step, and that
// there is a grid.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "internal.hpp"
#include "sim_handle.hpp"
#include "step/simulation.hpp"

namespace hfrac::capi {

// What only one of several ranks runs into is the end for all; an Error all find alike.
template <class Work>
auto together(const hfrac_sim& sim, const Work& work) {
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (const Stopped&) {
    throw;
  } catch (...) {
    ErrorText text;
    status_of_current_exception(text);
    sim.ranks.fail(text.get().data());
    throw;
  }
}

// What all ranks do at once: if it is refused on one, it is on all; the others say `elsewhere`.
template <class Do>
void all_or_none(const Ranks& ranks, const Error& elsewhere, const Do& act) {
  std::optional<Error> fault;
  try {
    act();
  } catch (const Error& error) {
    fault.emplace(error);
  }
  const bool failed = ranks.any(fault.has_value());
  if (fault) throw Error(*fault);
  if (failed) throw Error(elsewhere);
}

// The host's progress callback, asked about every so many seconds. Once it has said stop it is not asked again. On several ranks
// all stop if one does.
class ProgressPoll {
 public:
  ProgressPoll(hfrac_sim& sim, hfrac_progress_fn progress, void* user, double seconds)
      : sim_(sim), progress_(progress), user_(user), seconds_(seconds), last_(Clock::now()) {}

  bool stop(double fraction, const char* what) {
    if (stopped_) return true;
    const bool here = together(sim_, [&] { return asked_to_stop(fraction, what); });
    return stopped_ = sim_.ranks.alone() ? here : sim_.ranks.any(here);
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool asked_to_stop(double fraction, const char* what) {
    if (progress_ == nullptr) return false;
    const auto now = Clock::now();
    if (std::chrono::duration<double>(now - last_).count() < seconds_) return false;
    last_ = now;
    return call_host(&sim_, [&] { return progress_(user_, fraction, what); }) != 0;
  }

  hfrac_sim& sim_;
  hfrac_progress_fn progress_;
  void* user_;
  double seconds_;
  Clock::time_point last_;
  bool stopped_ = false;
};

inline void require_open_step(const hfrac_sim& sim) {
  if (!sim.simulation->step_open())
    throw Error(ErrorKind::argument, "no step is open; call hfrac_step_prepare first.");
}

// For what takes effect at once: `what` names it.
inline void require_not_between_tries(const hfrac_sim& sim, const char* what) {
  if (!sim.simulation->step_open()) return;
  throw Error(ErrorKind::argument,
              std::string("a step is open, and tries start from where it was opened; set ") + what +
                  " before hfrac_step_prepare.");
}

inline void require_grid(const hfrac_sim& sim) {
  if (!sim.simulation->has_grid())
    throw Error(ErrorKind::argument, "this simulation has no host grid; call hfrac_set_grid first.");
}

inline void require_no_open_step(const hfrac_sim& sim) {
  if (sim.simulation->step_open()) {
    throw Error(ErrorKind::argument,
                "a step is open; end it with hfrac_step_finalize or hfrac_step_reject first.");
  }
}

}  // namespace hfrac::capi

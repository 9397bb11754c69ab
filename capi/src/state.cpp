// SPDX-License-Identifier: BSD-3-Clause
// Images of the state in memory and in files, the three-part step, and what acts from outside, from C.
#include "hfrac/state.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "byte_file.hpp"
#include "internal.hpp"
#include "options/number_text.hpp"
#include "sim_handle.hpp"
#include "step/impose.hpp"
#include "step/simulation.hpp"
#include "stepping.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

// Wells come and go with the state.
void restore(hfrac_sim& sim, std::span<const std::byte> image) {
  const std::size_t before = sim.simulation->wells().size();
  ++sim.epoch;
  sim.simulation->restore(image);
  const std::size_t now = sim.simulation->wells().size();
  if (now < before) {
    tell(sim, HFRAC_LOG_WARNING,
         "the restored state has " + std::to_string(now) +
             " wells: those added since it was saved, from well " + std::to_string(now) + " on, are gone");
  } else if (now > before) {
    tell(sim, HFRAC_LOG_INFO,
         "the restored state has " + std::to_string(now) + " wells: from well " + std::to_string(before) +
             " on they were added before it was saved");
  }
}

}  // namespace

int32_t hfrac_state_size(const hfrac_sim* sim, int64_t* size) {
  return guarded_sim(sim, [&] {
    require_not_null(size, "size");
    *size = static_cast<std::int64_t>(sim->simulation->image_size());
  });
}

int32_t hfrac_state_save(const hfrac_sim* sim, void* buffer, int64_t capacity, int64_t* size) {
  return guarded_sim(sim, [&] {
    require_not_null(buffer, "buffer");
    const std::size_t needed = sim->simulation->image_size();
    if (capacity < static_cast<std::int64_t>(needed)) {
      throw Error(ErrorKind::argument, "capacity = " + std::to_string(capacity) + " is less than the " +
                                           std::to_string(needed) +
                                           " bytes of the image; ask hfrac_state_size.");
    }
    sim->simulation->write_image({static_cast<std::byte*>(buffer), needed});
    if (size != nullptr) *size = static_cast<std::int64_t>(needed);
  });
}

int32_t hfrac_state_restore(hfrac_sim* sim, const void* image, int64_t size) {
  return guarded_sim(sim, [&] {
    require_not_null(image, "image");
    require_no_open_step(*sim);
    if (size < 0) throw Error(ErrorKind::argument, "size = " + std::to_string(size) + " is negative.");
    restore(*sim, {static_cast<const std::byte*>(image), static_cast<std::size_t>(size)});
  });
}

int32_t hfrac_state_save_file(const hfrac_sim* sim, const char* path) {
  return guarded_sim(sim, [&] {
    require_not_null(path, "path");
    std::vector<std::byte> image(sim->simulation->image_size());
    sim->simulation->write_image(image);
    write_whole_file(path, image);
    tell(*sim, HFRAC_LOG_INFO,
         "state after step " + std::to_string(sim->simulation->model().clock.step) + " saved to '" + path +
             "'");
  });
}

int32_t hfrac_state_load_file(hfrac_sim* sim, const char* path) {
  return guarded_sim(sim, [&] {
    require_not_null(path, "path");
    require_no_open_step(*sim);
    // A state of this model is larger than today's by its cracks at most, far below this.
    const std::vector<std::byte> image = read_whole_file(path, 64 * sim->simulation->image_size());
    try {
      restore(*sim, image);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::argument) throw;
      throw Error(ErrorKind::file, "'" + std::string(path) + "': " + error.what());
    }
    tell(*sim, HFRAC_LOG_INFO,
         "state after step " + std::to_string(sim->simulation->model().clock.step) + " loaded from '" + path +
             "'");
  });
}

int32_t hfrac_step_prepare(hfrac_sim* sim) {
  return guarded_sim(sim, [&] {
    require_no_open_step(*sim);
    sim->simulation->begin_step();
  });
}

namespace {

// A step of the host's length: take(interrupt) does it.
template <class Take>
int32_t host_step(hfrac_sim& sim, double duration, const Take& take) {
  if (!(duration > 0.0) || !std::isfinite(duration)) {
    throw Error(ErrorKind::argument,
                "duration = " + std::to_string(duration) + " s must be positive and finite.");
  }
  ++sim.epoch;
  ProgressPoll poll(sim, sim.progress, sim.progress_user, sim.progress_seconds);
  const auto outcome = together(sim, [&] { return take([&] { return poll.stop(0.0, "stepping"); }); });
  ++sim.epoch;  // a callback may have looked at the middle of the step
  if (outcome.stopped) return HFRAC_STOPPED;
  return outcome.at_rest ? HFRAC_OK : HFRAC_NOT_AT_REST;
}

}  // namespace

int32_t hfrac_step_do(hfrac_sim* sim, double duration) {
  return guarded_sim(sim, [&] {
    require_open_step(*sim);
    return host_step(*sim, duration,
                     [&](const auto& interrupt) { return sim->simulation->try_step(duration, interrupt); });
  });
}

int32_t hfrac_step_more(hfrac_sim* sim, double duration) {
  return guarded_sim(sim, [&] {
    require_open_step(*sim);
    return host_step(*sim, duration, [&](const auto& interrupt) {
      return sim->simulation->step(sim->simulation->loads(), duration, interrupt);
    });
  });
}

int32_t hfrac_step_finalize(hfrac_sim* sim) {
  return guarded_sim(sim, [&] {
    require_open_step(*sim);
    sim->simulation->accept_step();
  });
}

int32_t hfrac_step_reject(hfrac_sim* sim) {
  return guarded_sim(sim, [&] {
    require_open_step(*sim);
    sim->simulation->reject_step();
    ++sim->epoch;
  });
}

int32_t hfrac_set_far_field(hfrac_sim* sim, double sigma_Hmax, double sigma_hmin) {
  return guarded_sim(sim, [&] {
    if (!std::isfinite(sigma_Hmax) || !std::isfinite(sigma_hmin))
      throw Error(ErrorKind::argument, "a stress is not a finite number.");
    set_far_field(*sim->simulation, sigma_Hmax, sigma_hmin);
    ++sim->epoch;
    tell(*sim, HFRAC_LOG_INFO,
         "far field: sigma_Hmax = " + number_text(sigma_Hmax) +
             " Pa, sigma_hmin = " + number_text(sigma_hmin) + " Pa");
  });
}

int32_t hfrac_set_formation_pressure(hfrac_sim* sim, double pressure) {
  return guarded_sim(sim, [&] {
    Options any;
    set_real(any, *find_option("fluid.formation_pressure"), "pressure", pressure);  // its range
    set_formation_pressure(*sim->simulation, pressure);
    ++sim->epoch;
    tell(*sim, HFRAC_LOG_INFO, "formation pressure: " + number_text(pressure) + " Pa");
  });
}

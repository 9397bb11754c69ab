// SPDX-License-Identifier: BSD-3-Clause
// A batch of cycles on a device: it goes on by itself until a bond exceeds its strength; the host breaks that, and it goes on from there.
#include "core/error.hpp"
#include "solid/explicit_solver.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {

void ExplicitSolver::use_device(const Device* device) {
  bring_home();
  device_ = device;
  device_cycles_.reset();
}

// What answers in every cycle and has no kernel on a device: facets, joints whose laws follow their slip, grips, rock beyond the boundary.
bool ExplicitSolver::runs_on_device() const {
  return device_ != nullptr && shared_.ranks().alone() && !facets_.active() && boundary_.grips().empty() &&
         boundary_.exterior() == nullptr && (assembly_.smooth.empty() || kernels_know(assembly_));
}

void ExplicitSolver::begin_on_device() {
  arrays_.stiffness = network_.stiffness.data();
  arrays_.undrained = undrained_ ? 1 : 0;
  if (away_) {  // only the fluid has moved since
    device_cycles_->go_on();
    return;
  }
  take_facets();
  begin_smooth_joints();
  mark_left_alone();
  put_loads();
  if (!device_cycles_) {
    device_cycles_ =
        std::make_unique<DeviceCycles>(*device_, arrays_, plan_, assembly_, network_, boundary_, options_);
  }
  std::vector<DeviceCycles::Pushed> pushed;
  for (const auto& disc : pushed_) pushed.push_back({disc.disc, disc.walled, disc.load});
  device_cycles_->begin(pushed, non_bonded_.list());
  away_ = true;
}

void ExplicitSolver::batch_on_device(std::int64_t cycles, std::vector<Found>& found) {
  DeviceCycles& device = *device_cycles_;
  device.begin_batch(energies_.friction);
  const std::int64_t end = 2 * cycles;
  for (std::int64_t stage = device.run(0, end); stage < end; stage = device.run(stage + 1, end)) {
    const std::int64_t now = total_cycles_ + stage / 2;
    for (std::int64_t pair = 0; stage % 2 == 0 && pair < arrays_.pair_count; ++pair) {
      if (bond_sums_[static_cast<std::size_t>(arrays_.tile_count + pair)].flagged == 0) continue;
      device.get_pair(pair);
      if (!break_cross_bonds(pair, now, found[0])) continue;
      device.put_broken(plan_.pairs[static_cast<std::size_t>(pair)].first_bond,
                        plan_.pairs[static_cast<std::size_t>(pair)].last_bond);
      device.repeat_pair(pair);
    }
    for (std::int64_t tile = 0; stage % 2 == 1 && tile < arrays_.tile_count; ++tile) {
      const Tile& t = plan_.tiles[static_cast<std::size_t>(tile)];
      if (bond_sums_[static_cast<std::size_t>(tile)].flagged == 0) continue;
      device.get_tile(tile);
      if (break_bonds(t.first_bond, t.last_bond, now, found[0])) {
        device.put_broken(t.first_bond, t.last_bond);
        device.repeat_tile(tile);
      } else {
        device.move_tile(tile);
      }
    }
  }
  device.end_batch(energies_.friction);
  total_cycles_ += cycles;
}

// All that cycles changed and is not here: on other ranks, or on a device.
void ExplicitSolver::fetch_state() {
  if (on_device_)
    bring_home();
  else
    shared_.gather(assembly_, network_);
}

template <class Fetch>
void ExplicitSolver::fetch_or_lose(const Fetch& fetch) const {
  lost_ = true;
  try {
    fetch();
  } catch (const Error&) {
    bring_home();  // which says what that means
  }
  lost_ = false;
}

void ExplicitSolver::bring_home() const {
  if (lost_)
    throw Error(ErrorKind::device,
                "the device failed, and with it went the state that it held since the last time all of it "
                "was asked for; "
                "restore a saved state, or create the simulation anew, with run.device = \"cpu\" if the "
                "device goes on failing");
  if (!away_) return;
  fetch_or_lose([&] { device_cycles_->get_state(contacts_); });
  away_ = false;
}

void ExplicitSolver::evaluate_on_device() {
  take_contents();
  device_cycles_->evaluate();
  device_cycles_->get_moved();
  arrays_.undrained = 1;
  if (arrays_.with_pressure != 0) kernels_.cross_domains(arrays_, arrays_.tile_count);  // the outside
  take_works();
  if (spoils_) device_cycles_->spoil_host();
}

bool ExplicitSolver::holds_numbers() const {
  return !away_ || device_cycles_->look_over().finite;
}

void ExplicitSolver::keep_for_step() {
  if (lost_) bring_home();
  kept_ = away_;
  if (kept_) device_cycles_->keep();
}

// After the host's arrays were read back: what had been away as the step began comes from its copy.
void ExplicitSolver::take_back() {
  away_ = lost_ = false;
  if (kept_) fetch_or_lose([&] { device_cycles_->get_kept(contacts_); });
}

}  // namespace hfrac

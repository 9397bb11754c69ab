// SPDX-License-Identifier: BSD-3-Clause
// Cycles of the explicit solver on a device (gpu/device_kernels.hpp): its copy of the model, what it is told to do, and what comes back.
//
// What never changes goes there once. Of the state the device may keep what only cycles change (`Travels::kept`) from one step to the next:
// ExplicitSolver::bring_home says who asks for it. While cycles go on the host learns of the sums alone and of bonds that exceed
// their strength: it breaks those itself, by the same code as always.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/device.hpp"
#include "model/assembly.hpp"
#include "model/contact_pairs.hpp"
#include "model/network.hpp"
#include "options/options.hpp"
#include "solid/boundary.hpp"
#include "solid/device_arrays.hpp"
#include "solid/tiles.hpp"

namespace hfrac {

class DeviceCycles {
 public:
  // A disc on which non-bonded contacts push anew in every cycle, and the boundary's load on it where no wall writes that.
  struct Pushed {
    std::int32_t disc;
    bool walled;
    Vec2 load;  // N
  };

  // `arrays`: those of the host, which stay where they are.
  DeviceCycles(const Device& device, const KernelArrays& arrays, const TilePlan& plan, Assembly& assembly,
               Network& network, Boundary& boundary, const Options& options);

  // Cycles follow: the state as it stands goes to the device, or, where that has the newest, what the fluid changed alone.
  void begin(std::span<const Pushed> pushed, const ContactPairs& contacts);
  void go_on();
  // A batch of them follows, whose sums begin at 0. `friction` [J/m]: the ledger's, to which non-bonded contacts add.
  void begin_batch(double friction);
  // Stages from `stage` up to `last`, the end of the batch, two a cycle: bonds across tiles, tiles. Returns the first in which a bond exceeds
  // its strength and after which nothing was done, or `last`. The sums come home; their `flagged` say where that was.
  std::int64_t run(std::int64_t stage, std::int64_t last);
  // Of a tile or a pair of tiles comes home what a look at its bonds needs.
  void get_tile(std::int64_t tile);
  void get_pair(std::int64_t pair);
  // The host broke bonds from `first` up to `last`.
  void put_broken(std::int64_t first, std::int64_t last);
  // After that: forces of a pair of tiles anew; of a tile, which then moves; or motion of a tile by the forces as they were.
  void repeat_pair(std::int64_t pair);
  void repeat_tile(std::int64_t tile);
  void move_tile(std::int64_t tile);

  // After a batch: its sums and the motion of walls are the host's.
  void end_batch(double& friction);
  // Of tiles' discs (Boundary::momenta), and what they come to taken out of all.
  [[nodiscard]] std::vector<Boundary::RigidMotion> momenta();
  void take_out(const Boundary::RigidMotion& motion);
  // Forces, pressures and volumes at the displacements as they stand, of all but the outside (ExplicitSolver::evaluate).
  void evaluate();
  struct Look {
    double kinetic;  // J/m, summed in another order than the host's
    bool finite;     // all that the device keeps
  };
  [[nodiscard]] Look look_over();
  // Displacements; or what the next flow step needs: places, pressures, volumes; or all of the state.
  void get_displacements();
  void get_moved();
  void get_state(ContactPairs& contacts);
  // A copy, on the device, of what is kept there, and that copy to the host.
  void keep();
  void get_kept(ContactPairs& contacts);
  // Tests: the host's copies of what is kept there become worthless.
  void spoil_host() const;

 private:
  // once: never changes. there: the host's own. fluid: the host's own, changed by every flow step. moved: changed by cycles and read by
  // the host after each step. kept: changed by cycles and read when somebody asks. pores: changed by both.
  enum class Travels { once, there, fluid, moved, kept, pores };
  struct Twin {
    void* host;
    std::size_t bytes;
    Travels when;
  };
  template <class T>
  void twin(T* host, std::int64_t count, T*& at, Travels when);
  template <class T>
  void list(const std::vector<T>& values, const T*& at);
  void put(Travels when);
  void get(Travels when);
  void lay_out(const TilePlan& plan);
  void list_forces(const TilePlan& plan);
  void put_smooth_joints();
  void put_walls();
  void put_contacts(std::span<const Pushed> pushed, const ContactPairs& contacts);
  void launch(DeviceKernel kernel, std::int64_t blocks);
  void launch_one(DeviceKernel kernel, std::int64_t item);
  // Items from `first` up to `last` of an array that has a twin.
  template <class T>
  void get(T* host, const T* at, std::int64_t first, std::int64_t last);
  void get_discs(std::int64_t first, std::int64_t last);
  void get_bonds(std::int64_t first, std::int64_t last);
  [[nodiscard]] bool is_pushed() const;
  std::int64_t get_sums();
  void answer_pores_across();
  void take_numbers();
  void clear_sums();
  void get_pores();
  void take_contacts(ContactPairs& contacts) const;

  const Device& device_;
  const KernelArrays& host_;
  Assembly& assembly_;
  Network& network_;
  Boundary& boundary_;
  const Options& options_;
  std::vector<Twin> twins_;
  std::vector<DeviceArray> of_twins_, lists_, copies_;  // copies: of twins that are kept
  DeviceArray item_, sums_, large_works_, held_force_, momenta_, outside_, wall_discs_, wall_force_, pairs_,
      pushed_, pushed_pairs_, pairs_copy_, looked_;
  DeviceArray smooth_contacts_, smooth_settled_, smooth_law_number_, smooth_laws_, smooth_from_;
  std::vector<DevicePair> contacts_;
  std::size_t contacts_kept_ = 0;  // of them, in the copy
  DeviceOutside walls_{};
  DeviceTask task_{};
  std::vector<std::byte> came_;  // what stopped a batch, and its sums
  bool sums_are_home_ = false;
  bool plain_ = false;  // the rock, see gpu/device_kernels.hpp
  std::int64_t most_bonds_ = 0, most_domains_ = 0, most_cross_domains_ = 0, large_pore_count_ = 0;
};

}  // namespace hfrac

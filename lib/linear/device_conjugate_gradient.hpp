// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients on a device: the passes of ConjugateGradient::settle from right-hand side to solution, by the same kernels.
//
// The hierarchy is made on the processor and sent as it stands; what did not change since the last time (the finest level's pattern) is
// there already. Between, the host hears how far the iterations are, once in a few of them, and what a pass came to.
#pragma once

#include <span>
#include <vector>

#include "core/device.hpp"
#include "linear/multigrid.hpp"
#include "linear/multigrid_task.hpp"

namespace hfrac {

struct PassRules;

class DeviceConjugateGradient {
 public:
  explicit DeviceConjugateGradient(const Device& device);
  // b and x in the order of the finest level's rows.
  bool settle(const Multigrid& multigrid, const UnfilledVector& b, UnfilledVector& x, const PassRules& rules,
              double& before);

 private:
  // A level's copy.
  struct Twin {
    explicit Twin(const Device& device);
    DeviceArray start, upper, outer, column, group_colour, colour_start, aggregate, first, member;
    DeviceArray value, diagonal, weight, inverse, right, before, after, rest, more;
    std::int64_t pattern = 0;
    LevelArrays at{};
  };
  void send(const Multigrid& multigrid);
  void send(const Multigrid::Level& level, Twin& twin) const;
  void launch(std::int32_t kernel, std::int64_t blocks);
  void launch_on(std::int32_t kernel, std::size_t level, std::int64_t rows, std::int64_t rows_a_block);
  void cycle(std::size_t level, const double* r, double* z);
  bool iterate(int most);

  const Device& device_;
  std::vector<Twin> twins_;
  std::vector<SymmetricFactor*> factors_;  // by level, of the host; null: none
  std::vector<double> right_;
  std::size_t depth_ = 0;
  DeviceArray levels_, state_;
  std::vector<DeviceArray> vectors_;
  MultigridTask task_{};
  ConjugateState reached_{};  // when it was looked at last
};

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
#include "linear/device_conjugate_gradient.hpp"

#include <cmath>

#include "core/device_kernel.hpp"
#include "linear/conjugate_gradient.hpp"

namespace hfrac {
namespace {

// Iterations between looks at whether they are enough.
constexpr int look_every = 4;

std::int64_t blocks_of(std::int64_t rows, std::int64_t rows_a_block) {
  return (rows + rows_a_block - 1) / rows_a_block;
}

template <class T>
const T* put(DeviceArray& array, const std::vector<T>& values) {
  array.put(values.data(), values.size() * sizeof(T));
  return array.as<T>();
}

double* room_for(DeviceArray& array, std::int64_t count) {
  return static_cast<double*>(array.reserve(static_cast<std::size_t>(count) * sizeof(double)));
}

}  // namespace

DeviceConjugateGradient::Twin::Twin(const Device& device)
    : start(device),
      upper(device),
      outer(device),
      column(device),
      group_colour(device),
      colour_start(device),
      aggregate(device),
      first(device),
      member(device),
      value(device),
      diagonal(device),
      weight(device),
      inverse(device),
      right(device),
      before(device),
      after(device),
      rest(device),
      more(device) {}

DeviceConjugateGradient::DeviceConjugateGradient(const Device& device)
    : device_(device), levels_(device), state_(device) {
  for (int k = 0; k < 10; ++k) vectors_.emplace_back(device);
}

void DeviceConjugateGradient::send(const Multigrid::Level& level, Twin& twin) const {
  LevelArrays& at = twin.at;
  const std::int64_t rows = level.rows();
  if (twin.pattern != level.pattern) {
    twin.pattern = 0;  // until all of it is there
    at.start = put(twin.start, level.start);
    at.upper = put(twin.upper, level.upper);
    at.outer = put(twin.outer, level.outer);
    at.column = put(twin.column, level.column);
    at.group_colour = put(twin.group_colour, level.group_colour);
    at.colour_start = put(twin.colour_start, level.colour_start);
    twin.pattern = level.pattern;
  }
  at.rows = rows;
  at.share = level.share;
  at.value = put(twin.value, level.value);
  at.diagonal = put(twin.diagonal, level.diagonal);
  at.weight = put(twin.weight, level.weight);
  at.aggregate = put(twin.aggregate, level.aggregate);
  at.first = put(twin.first, level.members.first());
  at.member = put(twin.member, level.members.rows());
  at.inverse = level.inverse.empty() ? nullptr : put(twin.inverse, level.inverse);
  at.right = room_for(twin.right, rows);
  at.before = room_for(twin.before, rows);
  at.after = room_for(twin.after, rows);
  at.rest = room_for(twin.rest, rows);
  at.more = room_for(twin.more, rows);
}

void DeviceConjugateGradient::send(const Multigrid& multigrid) {
  depth_ = multigrid.arrays().size();
  while (twins_.size() < depth_) twins_.emplace_back(device_);
  std::vector<LevelArrays> levels;
  factors_.clear();
  for (std::size_t k = 0; k < depth_; ++k) {
    send(multigrid.level(k), twins_[k]);
    levels.push_back(twins_[k].at);
    factors_.push_back(multigrid.level(k).factor.get());
  }
  task_.levels = put(levels_, levels);
  task_.depth = static_cast<std::int64_t>(depth_);
  ConjugateArrays& c = task_.c;
  c.groups = multigrid.groups();
  auto vector = vectors_.begin();
  for (auto of : {&ConjugateArrays::b, &ConjugateArrays::x, &ConjugateArrays::r, &ConjugateArrays::d,
                  &ConjugateArrays::p, &ConjugateArrays::z})
    c.*of = room_for(*vector++, multigrid.rows());
  for (auto of : {&ConjugateArrays::sums, &ConjugateArrays::others, &ConjugateArrays::highest,
                  &ConjugateArrays::lowest})
    c.*of = room_for(*vector++, c.groups);
  c.state = static_cast<ConjugateState*>(state_.reserve(sizeof(ConjugateState)));
}

void DeviceConjugateGradient::launch(std::int32_t kernel, std::int64_t blocks) {
  device_.launch(kernel, blocks, grid_shared_bytes, &task_, sizeof task_);
}

void DeviceConjugateGradient::launch_on(std::int32_t kernel, std::size_t level, std::int64_t rows,
                                        std::int64_t rows_a_block) {
  task_.level = static_cast<std::int64_t>(level);
  launch(kernel, blocks_of(rows, rows_a_block));
}

// As Multigrid::cycle.
void DeviceConjugateGradient::cycle(std::size_t at, const double* r, double* z) {
  const LevelArrays& level = twins_[at].at;
  const auto launch_for = [&](DeviceKernel kernel) {
    task_.r = r;
    task_.z = z;
    launch_on(kernel, at, level.rows, row_group);
  };
  if (SymmetricFactor* factor = factors_[at]) {  // of few unknowns, which go to the host and back
    right_.resize(static_cast<std::size_t>(level.rows));
    device_.download(right_.data(), r, right_.size() * sizeof(double));
    factor->solve(right_.data(), right_.data());
    device_.upload(z, right_.data(), right_.size() * sizeof(double));
    return;
  }
  if (level.rows <= few_rows) {
    task_.r = r;
    task_.z = z;
    launch_on(device_visit_few, at, 1, 1);
    return;
  }
  launch_for(device_smooth_forward);
  if (at + 1 < depth_) {
    const LevelArrays& coarse = twins_[at + 1].at;
    launch_on(device_take_to_coarser, at, coarse.rows, device_threads);
    cycle(at + 1, coarse.right, coarse.after);
    if (coarse.rows > few_rows && factors_[at + 1] == nullptr) {
      launch_on(device_find_rest, at + 1, coarse.rows, row_group);
      cycle(at + 1, coarse.rest, coarse.more);
      launch_on(device_add_more, at + 1, coarse.rows, row_group);
    }
  }
  launch_for(device_smooth_backward);
}

// From the residual's first length on until it is short enough; false if it does not become so.
bool DeviceConjugateGradient::iterate(int most) {
  const std::int64_t groups = task_.c.groups;
  while (reached_.done == 0) {
    if (reached_.iterations > most) return false;
    for (int k = 0; k < look_every; ++k) {
      cycle(0, task_.c.r, task_.c.z);
      launch(device_multiply_residuals, groups);
      launch(device_take_along, 1);
      launch(device_turn_direction, groups);
      launch(device_multiply_direction, groups);
      launch(device_take_step, 1);
      launch(device_go_along, groups);
      launch(device_take_length, 1);
    }
    state_.get(&reached_, sizeof reached_);
  }
  return reached_.iterations <= most && reached_.length <= reached_.target;
}

bool DeviceConjugateGradient::settle(const Multigrid& multigrid, const UnfilledVector& b, UnfilledVector& x,
                                     const PassRules& rules, double& before) {
  send(multigrid);
  const std::int64_t groups = task_.c.groups;
  device_.upload(task_.c.b, b.data(), b.size() * sizeof(double));
  device_.upload(task_.c.x, x.data(), x.size() * sizeof(double));
  task_.pass_tolerance = rules.pass_tolerance;
  const ErrorBound& bound = multigrid.error_bound();
  bool settled = false;
  for (int pass = 0; !settled && pass < rules.most_passes; ++pass) {
    task_.least_target = before > 0.0 ? rules.least_target(bound, reached_.lowest, reached_.highest) : 0.0;
    launch(device_begin_pass, groups);
    launch(device_take_first_length, 1);
    state_.get(&reached_, sizeof reached_);
    settled = !(reached_.length > 0.0);
    if (settled) break;
    if (!iterate(rules.most_iterations)) return false;
    launch(device_end_pass, groups);
    launch(device_take_extremes, 1);
    state_.get(&reached_, sizeof reached_);
    settled = rules.are_there(bound, reached_.length, reached_.lowest, reached_.highest) ||
              rules.are_there(reached_.change, before, reached_.lowest, reached_.highest);
    before = reached_.change;
  }
  device_.download(x.data(), task_.c.x, x.size() * sizeof(double));
  return settled;
}

}  // namespace hfrac

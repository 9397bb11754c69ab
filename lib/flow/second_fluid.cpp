// SPDX-License-Identifier: BSD-3-Clause
#include "flow/second_fluid.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

struct Ends {
  std::int32_t up, down;
};
Ends ends_of(const Network& n, std::size_t pipe) {
  return n.flow[pipe] > 0.0 ? Ends{n.left[pipe], n.right[pipe]} : Ends{n.right[pipe], n.left[pipe]};
}

bool flows(const Network& n, std::size_t pipe) {
  return n.flow[pipe] != 0.0 && n.left[pipe] != n.right[pipe];
}

}  // namespace

SecondFluid::SecondFluid(const Network& n) {
  const auto domains = static_cast<std::size_t>(n.domain_count());
  start_.assign(domains + 1, 0);
  for (std::size_t p = 0; p < n.left.size(); ++p) {
    ++start_[static_cast<std::size_t>(n.left[p]) + 1];
    ++start_[static_cast<std::size_t>(n.right[p]) + 1];
  }
  for (std::size_t d = 0; d < domains; ++d) start_[d + 1] += start_[d];
  pipe_.resize(2 * n.left.size());
  auto cursor = start_;
  for (std::size_t p = 0; p < n.left.size(); ++p) {
    for (const auto d : {n.left[p], n.right[p]})
      pipe_[static_cast<std::size_t>(cursor[static_cast<std::size_t>(d)]++)] = static_cast<std::int32_t>(p);
  }
  waiting_.assign(domains, 0);
  inlet_.assign(domains, 0.0);
  gained_.assign(domains, 0.0);
  done_.assign(domains, 0);
  ready_.reserve(domains);
}

void SecondFluid::carry(Network& n, std::span<const Inlet> inlets, double duration, SecondFluidBooks& books) {
  const auto domains = static_cast<std::int32_t>(n.domain_count());
  std::fill(waiting_.begin(), waiting_.end(), 0);
  std::fill(gained_.begin(), gained_.end(), 0.0);
  std::fill(done_.begin(), done_.end(), 0);
  for (const Inlet& inlet : inlets) inlet_[static_cast<std::size_t>(inlet.domain)] = inlet.share;
  for (std::size_t p = 0; p < n.left.size(); ++p) {
    if (const Ends e = ends_of(n, p); flows(n, p) && e.up != 0) ++waiting_[static_cast<std::size_t>(e.down)];
  }
  done_[0] = 1;
  ready_.clear();
  for (std::int32_t d = 1; d < domains; ++d) {
    if (waiting_[static_cast<std::size_t>(d)] == 0) ready_.push_back(d);
  }
  std::int32_t left_over = 1;
  for (std::size_t next = 0;; ++next) {
    if (next == ready_.size()) {  // those of a ring, if there are any
      while (left_over < domains && done_[static_cast<std::size_t>(left_over)] != 0) ++left_over;
      if (left_over == domains) return;
      ready_.push_back(left_over);
    }
    if (done_[static_cast<std::size_t>(ready_[next])] == 0) pass_on(n, ready_[next], duration, books);
  }
}

void SecondFluid::pass_on(Network& n, std::int32_t d, double duration, SecondFluidBooks& books) {
  const auto at = static_cast<std::size_t>(d);
  done_[at] = 1;
  double out = 0.0, in = 0.0;  // m2
  const auto each_pipe = [&](const auto& visit) {
    for (auto k = start_[at]; k < start_[at + 1]; ++k) {
      const auto p = static_cast<std::size_t>(pipe_[static_cast<std::size_t>(k)]);
      if (flows(n, p)) visit(ends_of(n, p), duration * std::abs(n.flow[p]));
    }
  };
  each_pipe([&](Ends e, double volume) { (e.up == d ? out : in) += volume; });
  const bool well = n.is_well(at);
  double share = inlet_[at];
  if (well) {
    const double through = std::max(in, out);
    if (through > 0.0) share = (gained_[at] + std::max(0.0, out - in) * inlet_[at]) / through;
    n.second_content[at] = share * n.fluid_in(at);
    books.from_wells -= gained_[at];
  } else {
    n.second_content[at] += gained_[at];
    const double all = n.fluid_in(at) + out;
    share = all > 0.0 ? n.second_content[at] / all : 0.0;
  }
  each_pipe([&](Ends e, double volume) {
    if (e.up != d) return;
    const double amount = share * volume;
    (well ? books.from_wells : n.second_content[at]) += well ? amount : -amount;
    give(n, e.down, amount, books);
  });
}

void SecondFluid::give(Network& n, std::int32_t d, double amount, SecondFluidBooks& books) {
  const auto at = static_cast<std::size_t>(d);
  if (d == 0) {
    books.leaked += amount;
    return;
  }
  if (--waiting_[at] == 0 && done_[at] == 0) ready_.push_back(d);
  if (done_[at] == 0) {
    gained_[at] += amount;
  } else if (n.is_well(at)) {
    books.from_wells -= amount;
  } else {
    n.second_content[at] += amount;
  }
}

}  // namespace hfrac

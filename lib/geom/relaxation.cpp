// SPDX-License-Identifier: BSD-3-Clause
#include "geom/relaxation.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "geom/neighbour_pairs.hpp"

namespace hfrac {
namespace {

constexpr std::size_t discs_of_block = 512, discs_worth_sharing = 4000;
// Iterations between reports: so many, of many discs fewer, so that who waits is told, and can stop it, within a second or two.
constexpr std::int64_t most_between_reports = 50, moves_between_reports = 5'000'000;

struct Sums {
  double overlap = 0.0;  // of all contacts, whose forces are their overlaps
  std::int64_t contacts = 0;
  double unbalanced = 0.0;                 // of the sizes of forces
  double power = 0.0, f2 = 0.0, v2 = 0.0;  // force times velocity, squares of both
};

// Where FIRE is on its way.
struct Fire {
  static constexpr double step_max = 0.55, grow = 1.1, shrink = 0.5, mixing_start = 0.1, mixing_decay = 0.99;
  static constexpr int patience = 5;
  double step = 0.1, mixing = mixing_start;
  int downhill = 0;
  double keep = 1.0, turn = 0.0;  // velocity: so much of what it was, so much of the force

  void turn_by(const Sums& sums) {
    keep = 1.0;
    turn = 0.0;
    if (sums.power > 0.0) {
      keep = 1.0 - mixing;
      turn = mixing * std::sqrt(sums.v2 / std::max(sums.f2, 1e-300));
      if (++downhill > patience) {
        step = std::min(step * grow, step_max);
        mixing *= mixing_decay;
      }
    } else {
      keep = 0.0;
      step *= shrink;
      mixing = mixing_start;
      downhill = 0;
    }
  }
};

struct Discs {
  const double *radius, *x, *y;
};

struct Answer {
  double overlap;
  std::int64_t touches;  // 1 or 0
  Vec2 push;             // on the second disc
};

// Nothing branches on whether two touch: that would be guessed wrong too often.
template <bool periodic>
[[gnu::always_inline]] inline Answer answer(const RelaxationBox& box, const Discs& discs, std::size_t i,
                                            std::size_t j) {
  const Vec2 d = box.between<periodic>(discs.x[i], discs.y[i], discs.x[j], discs.y[j]);
  const double reach = discs.radius[i] + discs.radius[j], d2 = d.x * d.x + d.y * d.y,
               distance = std::sqrt(d2);
  const std::int64_t touches = d2 < reach * reach ? 1 : 0;
  const double overlap = static_cast<double>(touches) * (reach - distance),
               scale = overlap / std::max(distance, 1e-300);
  return {overlap, touches, {scale * d.x, scale * d.y}};
}

// Forces of a block's pairs: own_x, own_y of a disc's own pairs, fx, fy of those it is second in. Overlaps of pairs that touch are added up,
// or, with `list`, listed. Returns how many there are.
template <bool periodic, bool list>
std::int64_t push_pairs(const RelaxationBox& box, const Discs& discs, const NeighbourPairs::Block& block,
                        double* __restrict own_x, double* __restrict own_y, double* __restrict fx,
                        double* __restrict fy, double* __restrict touching, double& overlap) {
  const std::int32_t *first = block.first.data(), *second = block.second.data(),
                     *receives = block.receiver.data();
  const std::size_t pairs = block.first.size();
  double sum = 0.0;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < pairs; ++k) {
    const auto i = static_cast<std::size_t>(first[k]), j = static_cast<std::size_t>(second[k]),
               receiver = list ? static_cast<std::size_t>(receives[k]) : j;
    const Answer a = answer<periodic>(box, discs, i, j);
    own_x[i] -= a.push.x;
    own_y[i] -= a.push.y;
    fx[receiver] += a.push.x;
    fy[receiver] += a.push.y;
    if constexpr (list)
      touching[count] = a.overlap;
    else
      sum += a.overlap;
    count += a.touches;
  }
  if (!list) overlap = sum;
  return count;
}

// Of a velocity what stays, and what a force adds to it; and by what of it a place moves.
struct Motion {
  double keep, push, step;
};

void move_discs(const Motion& motion, std::size_t first, std::size_t last, const double* __restrict force,
                double* __restrict velocity, double* __restrict place) {
  for (std::size_t i = first; i < last; ++i) {
    velocity[i] = motion.keep * velocity[i] + motion.push * force[i];
    place[i] += motion.step * velocity[i];
  }
}

}  // namespace

// Workers take blocks of discs; whatever is added up over discs or contacts is so by one of them, in one order.
class Relaxation::Course {
 public:
  using Member = Workers::Member;

  Course(const RelaxationBox& box, const Array<double>& radius, Array<double>& x, Array<double>& y,
         const std::vector<char>& held, double residual, std::int64_t most, Workers* workers)
      : box_(box),
        radius_(radius),
        x_(x),
        y_(y),
        held_(held),
        workers_(workers != nullptr ? *workers : alone_),
        shared_(workers != nullptr && workers->count() > 1 && x.size() >= discs_worth_sharing),
        residual_(residual),
        most_(most),
        mean_radius_(std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(x.size())),
        moving_(static_cast<double>(std::max<std::int64_t>(
            1, static_cast<std::int64_t>(x.size()) -
                   std::count_if(held.begin(), held.end(), [](char h) { return h != 0; })))),
        between_reports_(std::clamp<std::int64_t>(
            moves_between_reports / std::max<std::int64_t>(1, static_cast<std::int64_t>(x.size())), 1,
            most_between_reports)),
        pairs_(box_, radius, 0.4 * mean_radius_, shared_ ? discs_of_block : 0) {
    for (auto* values : {&own_x_, &own_y_, &vx_, &vy_}) values->assign(x.size(), 0.0);
    // And a place for each block, where what it pushes others' discs with is lost.
    for (auto* values : {&fx_, &fy_}) values->assign(pairs_.nowhere(pairs_.blocks.size()), 0.0);
    if (shared_) touching_.resize(pairs_.blocks.size());
  }

  bool go_on() {
    for (;;) {
      if (due_) find_pairs();
      const bool judged = std::exchange(judged_, false);
      workers_.share(shared_, [&](const Member& member) { iterate(member, judged); });
      if (over_) return false;
      if (judged_) break;
    }
    // The residual falls by fits and starts; what was reached once is what counts as done.
    if (report_.iterations == 0) start_ = std::max(report_.residual, 10.0 * residual_);
    done_ = std::clamp(std::log(start_ / report_.residual) / std::log(start_ / residual_), done_, 1.0);
    done_ = std::max(done_, static_cast<double>(report_.iterations) / static_cast<double>(most_));
    return true;
  }

  [[nodiscard]] double done() const { return over_ ? 1.0 : done_; }
  [[nodiscard]] const RelaxationReport& report() const { return report_; }

 private:
  [[nodiscard]] Discs discs() const { return {radius_.data(), x_.data(), y_.data()}; }

  void find_pairs() {
    pairs_.find(x_, y_, workers_);
    due_ = false;
    for (std::size_t b = 0; shared_ && b < touching_.size(); ++b)
      touching_[b].overlap.resize(pairs_.blocks[b].first.size() + 1);  // written ahead of what counts
  }

  // Iterations until the end, until pairs have to be found anew, or until it is time to report, which is before discs move: so `judged`.
  void iterate(const Member& member, bool judged) {
    for (;; judged = false) {
      if (!judged) {
        if (box_.periodic)
          push<true>(member);
        else
          push<false>(member);
        if (member.number == 0) judge();
        member.barrier();
        if (over_ || judged_) return;
      }
      move(member);
      if (due_ || member.team.cut_short()) return;
    }
  }

  // Calls visit(block) for every block, each by one member; a barrier.
  template <class Visit>
  void each_block(const Member& member, const Visit& visit) {
    const auto count = static_cast<std::int64_t>(pairs_.blocks.size());
    const auto mine = member.part(count, 1);
    for (auto b = mine.first; b < mine.last; ++b) visit(static_cast<std::size_t>(b));
    member.barrier();
  }

  template <bool periodic>
  void push(const Member& member) {
    if (!shared_) {
      sums_ = {};
      push_block<periodic, false>(0);
      add_walls();
      return;
    }
    each_block(member, [&](std::size_t b) { push_others<periodic>(b); });
    each_block(member, [&](std::size_t b) { push_block<periodic, true>(b); });
    if (member.number == 0) sums_ = {};
    member.barrier();
    // One after the other, or at once.
    if (member.number == 0) {
      add_overlaps();
      add_walls();
    }
    if (member.number == 1 || member.count == 1) {
      Sums sums;
      for (std::size_t i = 0; i < x_.size(); ++i) add(i, sums);
      take(sums);
    }
    member.barrier();
  }

  // What a block's discs push those of others with.
  template <bool periodic>
  void push_others(std::size_t b) {
    auto& block = pairs_.blocks[b];
    for (std::size_t k = 0; k < block.leaving.size(); ++k) {
      const auto pair = block.leaving[k];
      block.push[k] = answer<periodic>(box_, discs(), static_cast<std::size_t>(block.first[pair]),
                                       static_cast<std::size_t>(block.second[pair]))
                          .push;
    }
  }

  // Forces on a block's discs. A disc's own pairs and those it is second in are added up apart.
  template <bool periodic, bool list>
  void push_block(std::size_t b) {
    const auto& block = pairs_.blocks[b];
    for (auto* values : {&fx_, &fy_, &own_x_, &own_y_})
      std::fill(values->begin() + static_cast<std::ptrdiff_t>(block.first_disc),
                values->begin() + static_cast<std::ptrdiff_t>(block.last_disc), 0.0);
    for (const auto [other, k] : block.arriving) {
      const auto& from = pairs_.blocks[other];
      const auto j = static_cast<std::size_t>(from.second[from.leaving[k]]);
      fx_[j] += from.push[k].x;
      fy_[j] += from.push[k].y;
    }
    (list ? touching_[b].count : sums_.contacts) =
        push_pairs<periodic, list>(box_, discs(), block, own_x_.data(), own_y_.data(), fx_.data(), fy_.data(),
                                   list ? touching_[b].overlap.data() : nullptr, sums_.overlap);
    Sums sums;
    for (auto i = block.first_disc; i < block.last_disc; ++i) {
      Vec2 force{own_x_[i], own_y_[i]};
      if (!periodic) force = pushed_by_walls(i, force);
      const bool stays = !held_.empty() && held_[i] != 0;
      fx_[i] = stays ? 0.0 : fx_[i] + force.x;
      fy_[i] = stays ? 0.0 : fy_[i] + force.y;
      if (!list) add(i, sums);
    }
    if (!list) take(sums);
  }

  // Overlaps of a disc with the box's walls: west, east, south, north.
  [[nodiscard]] std::array<double, 4> overlaps_with_walls(std::size_t i) const {
    return {radius_[i] - x_[i], x_[i] + radius_[i] - box_.width, radius_[i] - y_[i],
            y_[i] + radius_[i] - box_.height};
  }
  [[nodiscard]] Vec2 pushed_by_walls(std::size_t i, Vec2 force) const {
    const auto [west, east, south, north] = overlaps_with_walls(i);
    if (std::max(std::max(west, east), std::max(south, north)) <= 0.0) return force;
    return {force.x + std::max(0.0, west) - std::max(0.0, east),
            force.y + std::max(0.0, south) - std::max(0.0, north)};
  }

  void add_overlaps() {
    double sum = 0.0;
    std::int64_t count = 0;
    for (const auto& block : touching_) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(block.count); ++k) sum += block.overlap[k];
      count += block.count;
    }
    sums_.overlap = sum;
    sums_.contacts = count;
  }
  void add_walls() {
    for (const auto& block : pairs_.blocks) {
      for (const auto i : block.at_walls) {
        for (const double overlap : overlaps_with_walls(static_cast<std::size_t>(i))) {
          if (overlap <= 0.0) continue;
          sums_.overlap += overlap;
          ++sums_.contacts;
        }
      }
    }
  }

  void add(std::size_t i, Sums& sums) const {
    const double fx = fx_[i], fy = fy_[i], vx = vx_[i], vy = vy_[i];
    sums.unbalanced += std::sqrt(fx * fx + fy * fy);
    sums.power += fx * vx + fy * vy;
    sums.f2 += fx * fx + fy * fy;
    sums.v2 += vx * vx + vy * vy;
  }
  // All but those of contacts.
  void take(const Sums& sums) {
    sums_.unbalanced = sums.unbalanced;
    sums_.power = sums.power;
    sums_.f2 = sums.f2;
    sums_.v2 = sums.v2;
  }

  // By one member.
  void judge() {
    const double mean_force = sums_.contacts > 0 ? sums_.overlap / static_cast<double>(sums_.contacts) : 0.0;
    report_.residual = mean_force > 0.0 ? sums_.unbalanced / moving_ / mean_force : 0.0;
    report_.mean_overlap = mean_force / mean_radius_;
    // Below the jamming density all overlaps vanish: that is at rest too.
    report_.at_rest = report_.residual <= residual_ || report_.mean_overlap < 1e-6;
    over_ = report_.at_rest || report_.iterations == most_;
    if (over_) return;
    fire_.turn_by(sums_);
    judged_ = report_.iterations % between_reports_ == 0;
  }

  void move(const Member& member) {
    const Motion motion{fire_.keep, fire_.turn + fire_.step, fire_.step};
    each_block(member, [&](std::size_t b) {
      const auto& block = pairs_.blocks[b];
      move_discs(motion, block.first_disc, block.last_disc, fx_.data(), vx_.data(), x_.data());
      move_discs(motion, block.first_disc, block.last_disc, fy_.data(), vy_.data(), y_.data());
      if (pairs_.are_due(x_, y_, block.first_disc, block.last_disc)) due_ = true;
    });
    if (member.number == 0) ++report_.iterations;
    member.barrier();
  }

  RelaxationBox box_;
  const Array<double>& radius_;
  Array<double>&x_, &y_;
  const std::vector<char>& held_;
  Workers alone_{1};
  Workers& workers_;
  bool shared_;
  double residual_, start_ = 0.0, done_ = 0.0;
  std::int64_t most_;
  double mean_radius_, moving_;
  std::int64_t between_reports_;
  NeighbourPairs pairs_;
  Array<double> fx_, fy_, own_x_, own_y_, vx_, vy_;
  struct Touching {  // of a block: overlaps of pairs that touch
    std::int64_t count = 0;
    Array<double> overlap;
  };
  std::vector<Touching> touching_;
  Sums sums_;
  Fire fire_;
  RelaxationReport report_;
  std::atomic<bool> due_{true};  // pairs are to be found anew
  bool judged_ = false, over_ = false;
};

Relaxation::Relaxation(const RelaxationBox& box, const Array<double>& radius, Array<double>& x,
                       Array<double>& y, const std::vector<char>& held, double residual, std::int64_t most,
                       Workers* workers)
    : course_(std::make_unique<Course>(box, radius, x, y, held, residual, most, workers)) {}

Relaxation::Relaxation(Relaxation&&) noexcept = default;
Relaxation::~Relaxation() = default;

bool Relaxation::go_on() {
  return course_->go_on();
}

double Relaxation::done() const {
  return course_->done();
}

const RelaxationReport& Relaxation::report() const {
  return course_->report();
}

RelaxationReport relax_overlaps(const RelaxationBox& box, const Array<double>& radius, Array<double>& x,
                                Array<double>& y, const std::vector<char>& held, double residual,
                                std::int64_t most, const std::function<bool(double)>& progress,
                                Workers* workers) {
  Relaxation relaxation(box, radius, x, y, held, residual, most, workers);
  while (relaxation.go_on() && !(progress && progress(relaxation.done()))) {
  }
  return relaxation.report();
}

}  // namespace hfrac

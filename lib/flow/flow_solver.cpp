// SPDX-License-Identifier: BSD-3-Clause
#include "flow/flow_solver.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/give_back.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// Whoever solves iteratively, in passes: residual over right-hand side of a pass; change of a pressure over the largest difference of
// pressures at which they have settled.
constexpr PassRules pass_rules{1e-6, 1e-11, 20, 20000};
// The same for a first look at which pores cavitate: one pass. Only in so many rounds of a step.
constexpr PassRules look_rules{1e-6, 1e-11, 1, 20000};
constexpr int most_looks = 20;
// A pressure this far below the floor is below it: less is what conjugate gradients leave open.
constexpr double floor_slack = 0.1;  // Pa
// A fluid that thins: sum of the flows' errors over the flows, at which conductances and pressures agree.
constexpr double thinning_tolerance = 1e-7;
// Error of a cluster's rate over what its wellbore's clusters take, at which rates and pressures agree; and above which rates answer by
// their chord instead of their tangent, which goes to and fro where flow turns round.
constexpr double wellbore_tolerance = 1e-9, wellbore_settled = 0.2;

// What the pressure that a host set beyond a pipe of the outer boundary adds to its flow, left to right.
double outer_flow(const Network& n, std::size_t k) {
  const auto e = static_cast<std::size_t>(n.outer_pipe[k]);
  const double inwards = n.conductance[e] * n.outer_excess[k];
  return n.left[e] == 0 ? inwards : -inwards;
}

// Pairs of domains that a wellbore joins.
std::vector<FlowMatrix::Pair> pairs_of(const std::vector<Wellbore>* wellbores) {
  std::vector<FlowMatrix::Pair> joined;
  if (wellbores == nullptr) return joined;
  for (const auto& wellbore : *wellbores) {
    const auto& clusters = wellbore.clusters;
    for (std::size_t i = 0; i < clusters.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) joined.emplace_back(clusters[i].domain, clusters[j].domain);
  }
  return joined;
}

// From so many domains up to largest_to_factorise each step takes what is quicker for it: conjugate gradients if no more than one domain
// of so many depends on others, which then need a few iterations, else the factor.
constexpr std::int64_t fewest_by_step = 20000, domains_of_one_joined = 8;

bool chooses_by_step(const Network& n, const Options& o) {
  return FlowMatrixSolver{o.flow_solver} == FlowMatrixSolver::automatic &&
         n.domain_count() > fewest_by_step && n.domain_count() <= largest_to_factorise;
}

// Unless a step chooses.
bool iterates(const Network& n, const Options& o) {
  const FlowMatrixSolver wanted{o.flow_solver};
  return wanted == FlowMatrixSolver::automatic ? n.domain_count() > largest_to_factorise
                                               : wanted != FlowMatrixSolver::direct;
}

FlowMatrix::Layout layout_for(const Network& n, const Options& o) {
  if (FlowScheme{o.flow_scheme} == FlowScheme::explicit_scheme) return FlowMatrix::Layout::nothing;
  const bool outside = FlowMatrixSolver{o.flow_solver} == FlowMatrixSolver::petsc;
  return iterates(n, o) && !outside ? FlowMatrix::Layout::rows : FlowMatrix::Layout::lower;
}

}  // namespace

FlowSolver::FlowSolver(const Network& n, const Options& options, std::vector<Wellbore>* wellbores,
                       const Ranks& ranks, Workers* workers, const Device* device)
    : explicit_(FlowScheme{options.flow_scheme} == FlowScheme::explicit_scheme),
      by_step_(chooses_by_step(n, options)),
      iterative_(iterates(n, options)),
      law_(options),
      matrix_(n, pairs_of(wellbores), layout_for(n, options), workers),
      wellbores_(wellbores != nullptr && !wellbores->empty() ? wellbores : nullptr),
      workers_(workers),
      conjugate_gradient_(workers, device, ranks) {
  const auto domains = n.kind.size();
  cavitated_.assign(domains, 0);
  if (explicit_) return;
  double volume = 0.0;
  for (std::size_t d = 1; d < n.volume.size(); ++d) volume += n.volume[d];
  imposed_weight_ = volume / static_cast<double>(domains) / options.fluid_bulk_modulus;
  if (!iterative_ && !by_step_) factor_.analyse(matrix_.pattern());
  if (FlowMatrixSolver{options.flow_solver} == FlowMatrixSolver::petsc) {
    outside_.emplace(ranks, OutsideMatrix::Kind::flow);
    list_places();
  }
}

// This rank's rows, of both triangles.
void FlowSolver::list_places() {
  const SparseMatrix& lower = matrix_.pattern();
  std::vector<std::int32_t> entries(static_cast<std::size_t>(lower.cols()), 0);
  for (std::int32_t k = 0; k < lower.cols(); ++k) {
    for (auto a = lower.outerIndexPtr()[k]; a < lower.outerIndexPtr()[k + 1]; ++a) {
      ++entries[static_cast<std::size_t>(k)];
      if (lower.innerIndexPtr()[a] != k) ++entries[static_cast<std::size_t>(lower.innerIndexPtr()[a])];
    }
  }
  outside_->share_out(entries);
  const auto mine = outside_->rows();
  const auto list = [&](std::int32_t row, std::int32_t column, std::int32_t entry) {
    if (!mine.hold(row)) return;
    row_.push_back(row);
    column_.push_back(column);
    entry_.push_back(entry);
  };
  for (std::int32_t k = 0; k < lower.cols(); ++k) {
    for (auto a = lower.outerIndexPtr()[k]; a < lower.outerIndexPtr()[k + 1]; ++a) {
      const auto row = lower.innerIndexPtr()[a];
      list(row, k, a);
      if (row != k) list(k, row, a);
    }
  }
}

// What is left is found by the product, whoever solves, and solved for again until pressures stay: where conductances differ by powers of
// ten a small residual alone says little about the pressures of tight rock.
void FlowSolver::solve_in_passes(const Eigen::VectorXd& rhs, Eigen::VectorXd& p, double change) {
  if (outside_ ? settle_outside(rhs, p) : conjugate_gradient_.settle(rhs, p, pass_rules, change)) return;
  throw Error(ErrorKind::diverged,
              "the flow step's pressures did not settle in " + std::to_string(pass_rules.most_passes) +
                  " passes of " +
                  (outside_ ? "the solver from outside"
                            : std::to_string(pass_rules.most_iterations) + " iterations") +
                  "; use flow.solver = \"direct\" or a smaller stepping.flow_step");
}

bool FlowSolver::settle_outside(const Eigen::VectorXd& rhs, Eigen::VectorXd& p) {
  const SparseMatrix& lower = matrix_.lower();
  value_.clear();
  for (const auto a : entry_) value_.push_back(lower.valuePtr()[a]);
  outside_->prepare(row_, column_, value_);
  give_back(row_);
  give_back(column_);
  change_.resize(p.size());
  double before = 0.0;
  for (int pass = 0; pass < pass_rules.most_passes; ++pass) {
    symmetric_product(lower, p, residual_);
    residual_ = rhs - residual_;
    if (!(residual_.squaredNorm() > 0.0)) return true;
    outside_->solve(residual_.data(), change_.data(), pass_rules.pass_tolerance);
    p += change_;
    const double change = change_.cwiseAbs().maxCoeff();
    if (pass_rules.are_there(change, before, p.minCoeff(), p.maxCoeff())) return true;
    before = change;
  }
  return false;
}

void FlowSolver::prepare_matrix() {
  bool prepared = true;
  if (!iterative_) {
    if (by_step_ && !analysed_) factor_.analyse(matrix_.pattern());
    analysed_ = true;
    prepared = factor_.factorise(matrix_.lower(), workers_);
  } else if (!outside_) {
    prepared = conjugate_gradient_.prepare(matrix_.rows(), ConjugateGradient::Pattern::kept);
    matrix_.forget_values();  // the levels have them
  }
  if (!prepared)
    throw Error(
        ErrorKind::diverged,
        "the flow matrix cannot be factorised (eq. 6, 8): an aperture, a volume or their ratio left "
        "the range of finite numbers; use a shorter stepping.flow_step or a smaller flow.aperture_limit");
}

void FlowSolver::solve_pressures(const Eigen::VectorXd& rhs, Eigen::VectorXd& p, double change) {
  if (iterative_) {
    solve_in_passes(rhs, p, change);
  } else {
    p.resize(rhs.size());
    factor_.solve(rhs.data(), p.data());
  }
}

int FlowSolver::advance(Network& n, double step, const std::vector<double>& source) {
  return explicit_ ? advance_explicit(n, step, source) : advance_implicit(n, step, source);
}

int FlowSolver::advance_implicit(Network& n, double step, const std::vector<double>& source) {
  const auto domains = static_cast<std::size_t>(n.domain_count());
  if (by_step_) iterative_ = domains_of_one_joined * matrix_.joined(n, step) <= n.domain_count();
  matrix_.share(domains, [&](std::size_t from, std::size_t to) {
    for (auto d = from; d < to; ++d) {
      cavitated_[d] =
          n.stiffness[d] > 0.0 && n.pressure[d] <= n.floor_pressure && n.full_pressure(d) < n.floor_pressure
              ? 1
              : 0;
    }
  });
  if (law_.thins()) {
    at_rest_.resize(n.left.size());
    thinning_.resize(n.left.size());
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      const bool shut = n.conductance[e] == 0.0;
      at_rest_[e] = shut ? 0.0 : law_.at_rest(n.aperture[e], n.length[e]);
      thinning_[e] = shut ? 0.0 : law_.thinning(n.aperture[e], n.length[e]);
    }
  }
  if (wellbores_ != nullptr) {
    source_ = source;
    wellbore_flow_.resize(wellbores_->size());
    for (std::size_t w = 0; w < wellbores_->size(); ++w)
      wellbore_flow_[w].begin((*wellbores_)[w], step, n.floor_pressure);
  }
  const std::vector<double>& fed = wellbores_ != nullptr ? source_ : source;
  int rounds = solve_step(n, step, fed);
  constexpr int most_rounds = 400;
  int passes = 0;
  while (law_.thins() && follow_thinning(n) > thinning_tolerance) {
    if (++passes > most_rounds) {
      throw Error(ErrorKind::diverged,
                  "the flow of the thinning fluid did not settle in " + std::to_string(most_rounds) +
                      " passes; use a smaller stepping.flow_step or a smaller fluid.viscosity");
    }
    rounds += solve_step(n, step, fed);
  }
  matrix_.share(domains, [&](std::size_t from, std::size_t to) {
    for (auto d = from; d < to; ++d) {
      if (n.stiffness[d] <= 0.0) continue;
      n.content[d] += fill_[d] + (fed.empty() ? 0.0 : step * fed[d]);
      n.pressure[d] = std::max(n.floor_pressure, n.full_pressure(d));
    }
  });
  for (std::size_t w = 0; w < wellbore_flow_.size(); ++w) wellbore_flow_[w].keep((*wellbores_)[w]);
  return rounds;
}

// The weight n makes pipes in a row, whose flow is given, right at once; pipes beside each other, whose drop is given, come
// nearer by 1 - n a pass.
double FlowSolver::follow_thinning(Network& n) {
  double off = 0.0, all = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    double& c = n.conductance[e];
    if (c == 0.0) continue;
    const double drop = n.flow[e] / c, wanted = law_.conductance(at_rest_[e], thinning_[e], drop);
    off += std::abs((wanted - c) * drop);
    all += std::abs(wanted * drop);
    c *= std::pow(wanted / c, law_.index());
  }
  return all > 0.0 ? off / all : 0.0;
}

double FlowSolver::drive_wellbores(const Network& n, const Eigen::VectorXd& p) {
  double most_off = 0.0;
  std::size_t at = 0;
  for (std::size_t w = 0; w < wellbore_flow_.size(); ++w) {
    const auto& clusters = (*wellbores_)[w].clusters;
    double off = 0.0, all = 0.0;
    const bool solved_before = linear_at_.size() >= at + clusters.size();
    std::vector<double>& hole = hole_;
    hole.clear();
    for (const auto& cluster : clusters) hole.push_back(std::max(p[cluster.domain], n.floor_pressure));
    wellbore_rate_.assign(clusters.size(), 0.0);
    for (std::size_t i = 0; solved_before && i < clusters.size(); ++i) {
      wellbore_rate_[i] = source_[static_cast<std::size_t>(clusters[i].domain)];
      for (std::size_t j = 0; j < clusters.size(); ++j)
        wellbore_rate_[i] += wellbore_flow_[w].by_pressure(i, j) * (hole[j] - linear_at_[at + j]);
    }
    wellbore_flow_[w].solve(hole);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const double rate = wellbore_flow_[w].rate(i);
      source_[static_cast<std::size_t>(clusters[i].domain)] = rate;
      off = std::max(off, std::abs(rate - wellbore_rate_[i]));
      all += std::abs(rate);
    }
    if (solved_before && off > wellbore_settled * all) wellbore_flow_[w].answer_by_chords(hole);
    most_off = std::max(most_off, solved_before && all > 0.0 ? off / all : 0.0);
    linear_at_.resize(std::max(linear_at_.size(), at + clusters.size()));
    std::copy(hole.begin(), hole.end(), linear_at_.begin() + static_cast<std::ptrdiff_t>(at));
    at += clusters.size();
  }
  return most_off;
}

void FlowSolver::answer_of_wellbores(const Network& n, double step, Eigen::VectorXd& rhs) {
  std::size_t at = 0, pair = 0;
  for (std::size_t w = 0; w < wellbore_flow_.size(); ++w) {
    const auto& clusters = (*wellbores_)[w].clusters;
    const auto solved = [&](std::size_t i) {
      return cavitated_[static_cast<std::size_t>(clusters[i].domain)] == 0;
    };
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = 0; j < clusters.size(); ++j) {
        const double by = step * wellbore_flow_[w].by_pressure(i, j);
        const std::size_t this_pair = i > j ? pair++ : pair;
        if (!solved(i)) continue;
        rhs[clusters[i].domain] -=
            by * (solved(j) ? linear_at_[at + j] : linear_at_[at + j] - n.floor_pressure);
        if (i == j) matrix_.add(clusters[i].domain, -by);
        if (i > j && solved(j)) matrix_.add_to_pair(this_pair, -by);
      }
    }
    at += clusters.size();
  }
}

bool FlowSolver::follow_flow(Network& n, double step, const std::vector<double>& source) {
  const double slack = iterative_ ? floor_slack : 0.0;
  const Eigen::VectorXd& p = pressure_;
  matrix_.share(n.left.size(), [&](std::size_t from, std::size_t to) {
    for (auto e = from; e < to; ++e) n.flow[e] = n.conductance[e] * (p[n.left[e]] - p[n.right[e]]);
  });
  for (std::size_t k = 0; k < n.outer_pipe.size(); ++k) n.flow[n.outer_pipe[k]] += outer_flow(n, k);
  matrix_.add_up_flows(n, step, fill_);
  // What a domain at the floor would hold after the step decides whether it stays there.
  std::atomic<bool> changed{false};
  matrix_.share(fill_.size(), [&](std::size_t from, std::size_t to) {
    for (auto d = from; d < to; ++d) {
      if (n.stiffness[d] <= 0.0) continue;
      const double gain = fill_[d] + (source.empty() ? 0.0 : step * source[d]);
      const bool at_floor = cavitated_[d] ? n.full_pressure(d) + n.stiffness[d] * gain <= n.floor_pressure
                                          : p[static_cast<Eigen::Index>(d)] < n.floor_pressure - slack;
      if (at_floor == (cavitated_[d] != 0)) continue;
      cavitated_[d] = at_floor ? 1 : 0;
      changed = true;
    }
  });
  return changed;
}

int FlowSolver::solve_step(Network& n, double step, const std::vector<double>& source) {
  const auto domains = static_cast<std::size_t>(n.domain_count());
  constexpr int most_rounds = 60;
  Eigen::VectorXd &rhs = rhs_, &p = pressure_;
  p = Eigen::Map<const Eigen::VectorXd>(n.pressure.data(),
                                        static_cast<Eigen::Index>(domains));  // a good guess
  // Rows of imposed pressures weigh as much as others, or the residual would be all theirs.
  const double unit = iterative_ ? imposed_weight_ : 1.0;
  linear_at_.clear();
  if (wellbores_ != nullptr) drive_wellbores(n, p);
  int round = 0;
  bool changed = true;
  for (; changed && round < most_rounds; ++round) {
    matrix_.assemble(n, step, source, {cavitated_, unit}, rhs);
    for (std::size_t k = 0; k < n.outer_pipe.size(); ++k) {
      const auto e = static_cast<std::size_t>(n.outer_pipe[k]);
      const auto inner = static_cast<std::size_t>(n.left[e] == 0 ? n.right[e] : n.left[e]);
      if (n.stiffness[inner] > 0.0 && !cavitated_[inner])
        rhs[static_cast<Eigen::Index>(inner)] += step * n.conductance[e] * n.outer_excess[k];
    }
    if (wellbores_ != nullptr) answer_of_wellbores(n, step, rhs);
    prepare_matrix();
    // Most rounds find pores that cavitate or no longer do: for that the first pass will do.
    double change = 0.0;
    const bool looks = iterative_ && !outside_ && wellbores_ == nullptr && round < most_looks;
    const bool settled = looks && conjugate_gradient_.settle(rhs, p, look_rules, change);
    changed = looks && !settled && follow_flow(n, step, source);
    if (changed) continue;
    if (!settled) solve_pressures(rhs, p, change);
    const bool driven = wellbores_ != nullptr && drive_wellbores(n, p) > wellbore_tolerance;
    changed = follow_flow(n, step, source) || driven;
  }
  if (changed) {
    throw Error(ErrorKind::diverged,
                std::string("which pores are cavitated") +
                    (wellbores_ != nullptr ? ", or how wellbores divide their rates," : "") +
                    " did not settle in " + std::to_string(most_rounds) +
                    " rounds of the flow step; use a smaller stepping.flow_step");
  }
  return round;
}

double FlowSolver::explicit_limit(const Network& n) {
  std::vector<double> sum(static_cast<std::size_t>(n.domain_count()), 0.0);
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    sum[static_cast<std::size_t>(n.left[e])] += n.conductance[e];
    sum[static_cast<std::size_t>(n.right[e])] += n.conductance[e];
  }
  double limit = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < sum.size(); ++d) {
    if (n.stiffness[d] > 0.0 && sum[d] > 0.0) limit = std::min(limit, 1.0 / (n.stiffness[d] * sum[d]));
  }
  return limit;
}

int FlowSolver::advance_explicit(Network& n, double step, const std::vector<double>& source) {
  const double limit = 0.5 * explicit_limit(n);  // half the limit: no domain overshoots its neighbours' mean
  const double cycles = std::max(1.0, std::ceil(step / limit));
  if (cycles > 2e6) {
    throw Error(
        ErrorKind::model,
        "explicit flow would need " + std::to_string(cycles) +
            " sub-cycles for one step; use flow.scheme = \"implicit\" or a smaller flow.aperture_limit");
  }
  const double dt = step / cycles;
  const auto domains = static_cast<std::size_t>(n.domain_count());
  std::fill(n.flow.begin(), n.flow.end(), 0.0);
  for (int cycle = 0; cycle < static_cast<int>(cycles); ++cycle) {
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      const double q = n.conductance[e] * (n.pressure[n.left[e]] - n.pressure[n.right[e]]);
      n.flow[e] += q / cycles;
      n.content[n.left[e]] -= dt * q;
      n.content[n.right[e]] += dt * q;
    }
    for (std::size_t k = 0; k < n.outer_pipe.size(); ++k) {
      const auto e = static_cast<std::size_t>(n.outer_pipe[k]);
      const double q = outer_flow(n, k);
      n.flow[e] += q / cycles;
      n.content[n.left[e]] -= dt * q;
      n.content[n.right[e]] += dt * q;
    }
    for (std::size_t d = 0; d < domains; ++d) {
      if (n.stiffness[d] <= 0.0) {
        n.content[d] = 0.0;  // kept by the wells' and the boundary's own balance
        continue;
      }
      if (!source.empty()) n.content[d] += dt * source[d];
      n.pressure[d] = std::max(n.floor_pressure, n.full_pressure(d));
    }
  }
  return static_cast<int>(cycles);
}

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
// V24  Steady flow through a network of joints.
//
// Formula    Along a joint of hydraulic aperture w fluid flows by w^3 / (12 eta) per length (cubic law; Witherspoon et al. 1980). A network of
//            such joints is a graph: nodes where traces cross and where pressure is imposed, between them conductances w^3 / (12 eta L); flow in =
//            flow out at each node. It is set up here from the traces alone, by plane geometry, and solved apart (Eigen).
// Set-up     Random packings of 100 m, joints of given residual apertures and no other in rock a billion times tighter, so that apertures are
//            constant; pressure imposed in the pores nearest to two points; one joint, two in series, two in parallel, and random
//            networks by a seed between two wide joints, of traces that discs of 0.5 m can tell apart (ends 2.5 m off other traces, no sharp
//            crossings); the rock at rest, the implicit flow solver in steps long enough to be steady.
//            Networks of any traces are printed beside: there the packing decides what ends within a disc of a trace connect.
//            Storage: one joint of 80 m that stores S per length and pressure (joint storage), at rest, then one end held at dp: pressure goes by
//            dp erfc(x / sqrt(4 D t)), D = w^3 / (12 eta S), and sqrt(D t / pi) 2 dp S has gone in (Carslaw and Jaeger 1959, 2.4-2.5), while
//            sqrt(4 D t) is a fifth of its length.
// Tolerance  1 %; storage 3 %, of dp and of the volume.
// Page       docs/verification/V24.md
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "flow/flow_solver.hpp"
#include "joint_model.hpp"
#include "solid/smooth_joints.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace V24_network_flow {

using namespace hfrac;

constexpr double viscosity = 1e-3, drop = 1e4;  // Pa s, Pa

struct Trace {
  Vec2 from, to;
  double aperture;  // m
};
struct Case {
  std::string name;
  std::vector<Trace> traces;
  std::pair<std::size_t, Vec2> in, out;  // trace, and a point of it, where pressure is imposed
};

// Flow through a graph of conductances with one unit of pressure between nodes 0 and 1. What has no way to either adds nothing: its
// rows are singular, and any solution of them does.
double graph_flow(const Eigen::MatrixXd& conductance) {
  const Eigen::VectorXd sums = conductance.rowwise().sum();
  Eigen::MatrixXd balance = Eigen::MatrixXd(sums.asDiagonal()) - conductance;
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(sums.size());
  pressure[0] = 1.0;
  balance.topRows(2) = Eigen::MatrixXd::Identity(2, sums.size());
  pressure = balance.completeOrthogonalDecomposition().solve(pressure).eval();
  return conductance.row(0) * (Eigen::VectorXd::Ones(sums.size()) - pressure);
}

// By the traces alone [m2/s].
double expected(const Case& c) {
  struct Place {
    double at;
    Eigen::Index node;
  };
  std::vector<std::vector<Place>> on(c.traces.size());
  Eigen::Index nodes = 2;
  const auto along = [&](std::size_t k, Vec2 p) {
    const Vec2 way = c.traces[k].to - c.traces[k].from;
    return dot(p - c.traces[k].from, way) / std::sqrt(dot(way, way));
  };
  on[c.in.first].push_back({along(c.in.first, c.in.second), 0});
  on[c.out.first].push_back({along(c.out.first, c.out.second), 1});
  for (std::size_t i = 0; i < c.traces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Trace &p = c.traces[i], &q = c.traces[j];
      const Vec2 d = p.to - p.from, e = q.to - q.from, f = q.from - p.from;
      const double turn = cross(d, e);
      if (turn == 0.0) continue;
      const double s = cross(f, e) / turn, t = cross(f, d) / turn;
      if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) continue;
      on[i].push_back({s * std::sqrt(dot(d, d)), nodes});
      on[j].push_back({t * std::sqrt(dot(e, e)), nodes});
      ++nodes;
    }
  Eigen::MatrixXd conductance = Eigen::MatrixXd::Zero(nodes, nodes);
  for (std::size_t k = 0; k < on.size(); ++k) {
    std::sort(on[k].begin(), on[k].end(), [](const Place& p, const Place& q) { return p.at < q.at; });
    for (std::size_t m = 0; m + 1 < on[k].size(); ++m) {
      const auto [a, i] = on[k][m];
      const auto [b, j] = on[k][m + 1];
      const double g = std::pow(c.traces[k].aperture, 3) / (12.0 * viscosity * std::max(b - a, 1e-6));
      conductance(i, j) += g;
      conductance(j, i) += g;
    }
  }
  return drop * graph_flow(conductance);
}

CaseDefinition network_of(const Case& c, std::int64_t discs, std::int64_t seed) {
  CaseDefinition definition = verification::tight_rock(discs, seed, 10e6);
  definition.options.stress_sigma_Hmax = definition.options.stress_sigma_hmin = 30e6;
  for (const Trace& t : c.traces)
    definition.joints.push_back(verification::plate_joint(t.from, t.to, 1.0, 1e11, t.aperture));
  return definition;
}

struct Flows {
  double model, graph;  // m2/s
  [[nodiscard]] double ratio() const { return model / graph; }
};
Flows measured(Case c, std::int64_t discs, std::int64_t seed) {
  Simulation sim(network_of(c, discs, seed), {}, {});
  const Assembly& a = sim.assembly();
  Network& n = sim.engine().model.network;
  // In the pore of the nearest contact that lies towards the trace's beginning: where its piece begins. That place is the graph's.
  const auto impose = [&](std::pair<std::size_t, Vec2>& where, double pressure) {
    const Trace& t = c.traces[where.first];
    const Vec2 along = (1.0 / std::sqrt(dot(t.to - t.from, t.to - t.from))) * (t.to - t.from);
    double least = 1e300;
    std::int32_t pore = -1;
    Vec2 place{};
    for (const auto& k : a.smooth.contacts) {
      if (k.joint != static_cast<std::int64_t>(where.first)) continue;
      const Vec2 at = Vec2{a.x[a.first[k.bond]], a.y[a.first[k.bond]]} + k.first_arm(),
                 off = at - where.second;
      if (dot(off, off) >= least) continue;
      least = dot(off, off);
      const bool left = dot(n.centroid[n.left[k.bond]] - n.centroid[n.right[k.bond]], along) < 0.0;
      pore = left ? n.left[k.bond] : n.right[k.bond];
      place = at - 0.5 * k.area * along;
    }
    where.second = place;
    n.stiffness[pore] = 0.0;
    n.pressure[pore] = n.reference_pressure + pressure;
    return pore;
  };
  const auto inlet = impose(c.in, drop);
  impose(c.out, 0.0);
  FlowSolver solver(n, sim.options());
  const std::vector<double> source(static_cast<std::size_t>(n.domain_count()), 0.0);
  constexpr double long_time = 1e7;  // s
  for (int k = 0; k < 3; ++k) solver.advance(n, long_time, source);
  double flow = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    if ((n.left[e] == inlet) != (n.right[e] == inlet)) flow += n.left[e] == inlet ? n.flow[e] : -n.flow[e];
  }
  const Flows result{flow, expected(c)};
  std::printf("  %s, %lld discs, packing %lld: flow %.4e m2/s, graph %.4e\n", c.name.c_str(),
              static_cast<long long>(discs), static_cast<long long>(seed), result.model, result.graph);
  std::fflush(stdout);
  return result;
}

constexpr double w = 5e-4;  // m
// Ends of traces reach beyond the points where pressure is imposed.
Case single() {
  return {"one joint", {{{10.0, 20.0}, {90.0, 70.0}, w}}, {0, {18.0, 25.0}}, {0, {82.0, 65.0}}};
}
Case series() {
  return {"two in series",
          {{{10.0, 20.0}, {60.0, 50.0}, w}, {{50.0, 55.0}, {85.0, 15.0}, 0.7 * w}},
          {0, {15.0, 23.0}},
          {1, {81.5, 19.0}}};
}
Case parallel() {
  return {"two in parallel",
          {{{20.0, 10.0}, {25.0, 90.0}, 4.0 * w},
           {{75.0, 10.0}, {80.0, 90.0}, 4.0 * w},
           {{12.0, 30.0}, {90.0, 36.0}, w},
           {{12.0, 66.0}, {90.0, 75.0}, 0.8 * w}},
          {0, {22.5, 50.0}},
          {1, {77.5, 50.0}}};
}

double distance(Vec2 p, const Trace& t) {
  const Vec2 way = t.to - t.from;
  const Vec2 off = p - t.from - std::clamp(dot(p - t.from, way) / dot(way, way), 0.0, 1.0) * way;
  return std::sqrt(dot(off, off));
}

// Whether discs of 0.5 m can tell how two traces lie: apart, or crossing at an angle that is not sharp and not at an end.
bool clear(const Trace& p, const Trace& q) {
  constexpr double apart = 2.5, sharpest = 0.4;  // m, sine
  const Vec2 d = p.to - p.from, e = q.to - q.from;
  const double turn = cross(d, e), s = cross(q.from - p.from, e) / turn, t = cross(q.from - p.from, d) / turn;
  const double ends =
      std::min({distance(p.from, q), distance(p.to, q), distance(q.from, p), distance(q.to, p)});
  if (ends < apart) return false;
  const bool cross_here = s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0;
  return !cross_here || std::abs(turn) > sharpest * std::sqrt(dot(d, d) * dot(e, e));
}

enum class Ends { clear, any };
Case random_network(unsigned seed, Ends ends) {
  Case c{(ends == Ends::any ? "any network " : "network ") + std::to_string(seed),
         {},
         {0, {12.0, 50.0}},
         {1, {88.0, 50.0}}};
  c.traces.push_back({{12.0, 3.0}, {12.0, 97.0}, 4.0 * w});
  c.traces.push_back({{88.0, 3.0}, {88.0, 97.0}, 4.0 * w});
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  constexpr std::size_t traces = 22;
  while (c.traces.size() < traces) {
    const double turn = uniform(0.0, verification::pi), length = uniform(25.0, 70.0);
    const Vec2 middle{uniform(10.0, 90.0), uniform(10.0, 90.0)},
        way{0.5 * length * std::cos(turn), 0.5 * length * std::sin(turn)};
    const Trace one{middle - way, middle + way, w * uniform(0.6, 1.4)};
    const auto inside = [](Vec2 p) { return p.x > 4.0 && p.x < 96.0 && p.y > 4.0 && p.y < 96.0; };
    if (inside(one.from) && inside(one.to) &&
        (ends == Ends::any || std::all_of(c.traces.begin(), c.traces.end(),
                                          [&](const Trace& other) { return clear(one, other); })))
      c.traces.push_back(one);
  }
  return c;
}

TEST(V24NetworkFlowSmoke, FollowsTheCubicLawAlongOneJoint) {
  verification::report("flow along one joint over the cubic law's", measured(single(), 4000, 1).ratio(), 1.0,
                       0.01);
}

TEST(V24NetworkFlowSmoke, StorageSpreadsPressureByItsDiffusivity) {
  constexpr double storage = 8e-9, reach = 16.0;  // m/Pa, m: sqrt(4 D t)
  constexpr int steps = 200;
  const double diffusivity = w * w * w / (12.0 * viscosity * storage),
               time = reach * reach / (4.0 * diffusivity);
  Case c{"storage", {{{10.0, 50.0}, {90.0, 50.0}, w}}, {}, {}};
  CaseDefinition definition = network_of(c, 4000, 1);
  definition.joints[0].storage = storage;
  Simulation sim(definition, {}, {});
  const Assembly& a = sim.assembly();
  Network& n = sim.engine().model.network;
  struct Place {
    double x;
    std::int32_t pore;  // on the contact's far side
  };
  std::vector<Place> places;
  std::int32_t inlet = -1;
  double begin = 1e300;
  for (const auto& k : a.smooth.contacts) {
    const double x = a.x[a.first[k.bond]] + k.first_arm().x, half = 0.5 * k.area;
    const bool left = n.centroid[n.left[k.bond]].x < n.centroid[n.right[k.bond]].x;
    places.push_back({x + half, left ? n.right[k.bond] : n.left[k.bond]});
    if (x - half >= begin) continue;
    begin = x - half;
    inlet = left ? n.left[k.bond] : n.right[k.bond];
  }
  const auto held = [&] {
    double sum = 0.0;
    for (std::int64_t d = 1; d < n.domain_count(); ++d)
      sum += d == inlet ? content_at(n, d, sim.options().fluid_bulk_modulus, n.pressure[d]) : n.content[d];
    return sum;
  };
  const double before = held();
  n.stiffness[inlet] = 0.0;
  n.pressure[inlet] = n.reference_pressure + drop;
  FlowSolver solver(n, sim.options());
  const std::vector<double> source(static_cast<std::size_t>(n.domain_count()), 0.0);
  for (int k = 0; k < steps; ++k) solver.advance(n, time / steps, source);
  double worst = 0.0;
  for (const auto& [x, pore] : places) {
    const double formula = std::erfc((x - begin) / reach),
                 model = (n.pressure[pore] - n.reference_pressure) / drop;
    if (std::abs(model - formula) > std::abs(worst)) worst = model - formula;
  }
  verification::report_absolute("pressure along a joint that stores, worst, over that at its end", worst, 0.0,
                                0.03);
  verification::report(
      "volume it took in over the formula's",
      (held() - before) / (2.0 * drop * storage * std::sqrt(diffusivity * time / verification::pi)), 1.0,
      0.03);
}

TEST(V24NetworkFlow, AddsUpInSeriesAndInParallel) {
  verification::report("two in series, over the graph's", measured(series(), 10000, 1).ratio(), 1.0, 0.01);
  verification::report("two in parallel, over the graph's", measured(parallel(), 10000, 1).ratio(), 1.0,
                       0.01);
}

TEST(V24NetworkFlow, IsThatOfTheGraphInRandomNetworks) {
  constexpr int wanted = 4;
  int connected = 0, apart = 0;
  double mean = 0.0;
  for (unsigned seed = 1; connected < wanted; ++seed) {
    const Case c = random_network(seed, Ends::clear);
    const bool joined = expected(c) > 1e-12;
    if (!joined && apart++ > 0) continue;  // one without a way through is enough
    const Flows flows = measured(c, 10000, seed);
    if (!joined) {
      verification::report_absolute(c.name + ", no way through: flow [mm2/s]", 1e6 * flows.model, 0.0, 1e-6);
      continue;
    }
    verification::report(c.name + ", over the graph's", flows.ratio(), 1.0, 0.01);
    mean += flows.ratio() / wanted;
    ++connected;
  }
  verification::report("mean of the networks", mean, 1.0, 0.01);
}

// What a user's network meets. Held loosely, since one connection more or less is a large part of a flow; where the graph has none at
// all, any flow is only printed.
TEST(V24NetworkFlowLong, WhereEndsNearlyMeetThePackingDecides) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Case c = random_network(seed, Ends::any);
    const Flows flows = measured(c, 10000, seed);
    if (flows.graph > 1e-12) verification::report(c.name + ", over the graph's", flows.ratio(), 1.0, 0.3);
  }
}

}  // namespace V24_network_flow

// SPDX-License-Identifier: BSD-3-Clause
// What natural fractures cost: set-up, steps and memory of a model with smooth joints in it, or without.
//
//     bench_joints DISCS JOINTS dry|wet|coupled [STEPS] [WORKERS] [STIFFNESS]
//
// STIFFNESS: normal, of the joints [Pa/m]; in shear 0.4 of it.
// Joints of six mean disc diameters, anywhere and in any direction, in a square of 100 m under 4 and 3 MPa; a well in the middle.
//   dry      explicit motion in real time, 1 ms a step, no fluid
//   wet      the same with fluid, and joints that conduct
//   coupled  quasi-static with fluid, joints that conduct, 100 s a step
// Prints, for tests/bench/joints to compare:
//
//     hfrac-joints DISCS JOINTS kind SETUP_S STEP_S CYCLES BYTES CONTACTS      seconds of processor time, of the process's peak less an empty one's
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/random.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"

using namespace hfrac;

namespace {

constexpr double side = 100.0;  // m

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024.0 * std::stod(line.substr(6));
  return 0.0;
}

// Away from the edge, where a corner that joints cut off would slide out.
double inner(Random& random) {
  constexpr double margin = 0.08;
  return side * (margin + (1.0 - 2.0 * margin) * random.uniform());
}

CaseDefinition definition_of(std::int64_t discs, std::int64_t joints, const std::string& kind,
                             double stiffness) {
  CaseDefinition definition;
  Options& o = definition.options;
  const bool coupled = kind == "coupled", wet = kind != "dry";
  o.packing_disc_count = discs;
  o.packing_method = static_cast<std::int64_t>(PackingMethod::tiled);
  o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
  o.stress_convention = static_cast<std::int64_t>(StressConvention::total);
  o.stress_sigma_Hmax = 4e6;
  o.stress_sigma_hmin = 3e6;
  o.bond_tensile_strength = o.bond_shear_strength = 1e9;
  o.fluid_formation_pressure = 1e6;
  o.flow_permeability = 1e-18;
  if (!wet) o.flow_scheme = static_cast<std::int64_t>(FlowScheme::off);
  o.stepping_mode = static_cast<std::int64_t>(coupled ? SteppingMode::coupled : SteppingMode::dynamic);
  o.solver_kind = static_cast<std::int64_t>(coupled ? SolverKind::quasi_static : SolverKind::explicit_solver);
  o.stepping_flow_step = coupled ? 100.0 : 1e-3;
  definition.wells.push_back({50.0, 50.0, 4.0, 1.5e6, 0.0, 0.0, WellControl::pressure});
  const double length = 6.0 * 2.0 * expected_mean_radius(o);
  Random random(1);
  for (std::int64_t k = 0; k < joints; ++k) {
    const double angle = std::numbers::pi * random.uniform(), x = inner(random), y = inner(random);
    JointOptions joint;
    joint.x1 = x - 0.5 * length * std::cos(angle);
    joint.y1 = y - 0.5 * length * std::sin(angle);
    joint.x2 = x + 0.5 * length * std::cos(angle);
    joint.y2 = y + 0.5 * length * std::sin(angle);
    joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
    joint.friction = 0.65;
    joint.normal_stiffness = stiffness;
    joint.shear_stiffness = 0.4 * stiffness;
    joint.max_closure = wet ? 1.5e-4 : 0.0;
    joint.aperture = wet ? 1.6e-4 : 0.0;
    definition.joints.push_back(joint);
  }
  return definition;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t discs = argc > 1 ? std::atoll(argv[1]) : 0, joints = argc > 2 ? std::atoll(argv[2]) : -1;
  const std::string kind = argc > 3 ? argv[3] : "";
  const int steps = argc > 4 ? std::atoi(argv[4]) : 3, workers = argc > 5 ? std::atoi(argv[5]) : 1;
  const double stiffness = argc > 6 ? std::atof(argv[6]) : 5e10;
  if (discs < 1000 || discs > 5'000'000 || joints < 0 ||
      (kind != "dry" && kind != "wet" && kind != "coupled") || steps < 1 || workers < 1 ||
      !(stiffness > 0.0)) {
    std::fprintf(stderr, "usage: bench_joints DISCS JOINTS dry|wet|coupled [STEPS] [WORKERS] [STIFFNESS]\n");
    return 2;
  }
  try {
    const double empty = peak_bytes(), start = processor_seconds();
    CaseDefinition definition = definition_of(discs, joints, kind, stiffness);
    definition.options.run_workers = workers;
    Simulation s(std::move(definition), {}, {});
    const double built = processor_seconds() - start, at = processor_seconds();
    const std::int64_t cycles = s.model().clock.cycles;
    for (int k = 0; k < steps; ++k) s.step();
    std::printf("hfrac-joints %lld %lld %s %.3f %.4f %lld %.0f %zu\n", static_cast<long long>(discs),
                static_cast<long long>(joints), kind.c_str(), built, (processor_seconds() - at) / steps,
                static_cast<long long>((s.model().clock.cycles - cycles) / steps), peak_bytes() - empty,
                s.assembly().smooth.contacts.size());
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_joints: %s\n", error.what());
    return 1;
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "options/model_size.hpp"

#ifdef __linux__
#include <sys/sysinfo.h>
#endif

#include <limits>

#include "options/choices.hpp"
#include "options/fracture_law.hpp"
#include "options/number_text.hpp"

namespace hfrac {
namespace {

// The tangent has up to 200 entries a disc in its factor's fronts; conduction and transport of heat by water 27 in their list of entries.
constexpr std::int64_t most_in_a_tangent = 10'000'000, most_in_a_flow_factor = 10'000'000,
                       most_with_heat = 50'000'000;

// Bytes a disc, rounded down from what `bench_memory` and `bench_petsc tangent` print, without and with fluid.
struct BytesOfADisc {
  double dry, wet;
};
constexpr BytesOfADisc explicit_disc{400.0, 850.0}, quasi_static_disc{2000.0, 5000.0};

constexpr double gib = 1024.0 * 1024.0 * 1024.0;

}  // namespace

std::string why_too_large(const CaseDefinition& definition, std::int64_t discs) {
  const Options& o = definition.options;
  const auto beyond = [discs](std::int64_t most, const std::string& what, const char* instead) {
    return number_text(discs) + " discs are more than the " + number_text(most) + " that " + what +
           " takes; give fewer, or " + instead + ".";
  };
  if (SolverKind{o.solver_kind} == SolverKind::quasi_static && discs > most_in_a_tangent)
    return beyond(most_in_a_tangent, "solver.kind = \"quasi-static\"", "set solver.kind = \"explicit\"");
  if (fracture_law_of(definition) == FractureLaw::facet && discs > most_in_a_tangent)
    return beyond(
        most_in_a_tangent,
        std::string("fracture.law = \"facet\"") +
            (FractureLaw{o.fracture_law} == FractureLaw::automatic ? ", which \"auto\" is here," : ""),
        "set fracture.law = \"bond\"");
  if (FlowScheme{o.flow_scheme} == FlowScheme::implicit_scheme &&
      FlowMatrixSolver{o.flow_solver} == FlowMatrixSolver::direct && discs > most_in_a_flow_factor)
    return beyond(most_in_a_flow_factor, "flow.solver = \"direct\"", "set flow.solver = \"auto\"");
  if (ThermalMode{o.thermal_mode} == ThermalMode::transport && discs > most_with_heat)
    return beyond(most_with_heat, "thermal.mode = \"transport\"", "set thermal.mode = \"off\"");
  return {};
}

double least_memory(const CaseDefinition& definition, std::int64_t discs, bool alone) {
  const Options& o = definition.options;
  const bool solved = alone && SolverKind{o.solver_kind} == SolverKind::quasi_static;
  const BytesOfADisc bytes = solved ? quasi_static_disc : explicit_disc;
  return (FlowScheme{o.flow_scheme} == FlowScheme::off ? bytes.dry : bytes.wet) * static_cast<double>(discs);
}

std::string why_no_memory(const CaseDefinition& definition, std::int64_t discs, bool alone, double machine) {
  const double least = least_memory(definition, discs, alone);
  if (least <= machine) return {};
  return "a model of " + number_text(discs) + " discs takes " + rounded_text(least / gib) +
         " GiB at least, and this machine has " + rounded_text(machine / gib) +
         " GiB, swap included; lower packing.disc_count or give fewer discs" +
         (SolverKind{definition.options.solver_kind} == SolverKind::quasi_static
              ? ", or set solver.kind = \"explicit\", which takes less."
              : ".");
}

double machine_memory() {
#ifdef __linux__
  struct sysinfo info {};
  if (sysinfo(&info) == 0)
    return (static_cast<double>(info.totalram) + static_cast<double>(info.totalswap)) *
           static_cast<double>(info.mem_unit);
#endif
  return std::numeric_limits<double>::infinity();
}

}  // namespace hfrac

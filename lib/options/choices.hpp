// SPDX-License-Identifier: BSD-3-Clause
// The words of the option table's choices as enumerations, for code that branches on them:
// `StressConvention{options.stress_convention} == StressConvention::effective`. options.cpp refuses to compile if a number moves.
#pragma once

#include <cstdint>

namespace hfrac {

enum class StressConvention : std::int64_t { total = 0, effective = 1 };
enum class PackingMethod : std::int64_t { relaxed = 0, tiled = 1, growth = 2, square = 3 };
enum class PackingReuse : std::int64_t { model = 0, discs = 1 };
enum class ContactMode : std::int64_t { parallel = 0, after_break = 1 };
enum class ContactShape : std::int64_t { round = 0, flat = 1 };
enum class BoundaryKind : std::int64_t { stress = 0, walls = 1, infinite = 2 };
enum class WallsAfterEquilibration : std::int64_t { fixed = 0, servo = 1 };
enum class FlowScheme : std::int64_t { implicit_scheme = 0, explicit_scheme = 1, off = 2 };
enum class FlowMatrixSolver : std::int64_t { automatic = 0, direct = 1, iterative = 2, petsc = 3 };
enum class FluidKind : std::int64_t { given = 0, water = 1 };
enum class FractureAperture : std::int64_t { bond = 0, plane = 1 };
enum class OuterPores : std::int64_t { formation = 0, closed = 1 };
enum class SteppingMode : std::int64_t { substep = 0, dynamic = 1, coupled = 2 };
enum class InitialState : std::int64_t { uniform = 0, seepage = 1 };
enum class SolverKind : std::int64_t { explicit_solver = 0, quasi_static = 1 };
enum class FactorOf : std::int64_t { own = 0, petsc = 1 };
enum class FractureLaw : std::int64_t { bond = 0, facet = 1, automatic = 2 };  // automatic: fracture_law.hpp
enum class RunDevice : std::int64_t { cpu = 0, gpu = 1, automatic = 2 };
enum class ThermalMode : std::int64_t { off = 0, uniform = 1, transport = 2 };
enum class ThermalOuter : std::int64_t { insulated = 0, held = 1 };
enum class ThermalParameters : std::int64_t { constant = 0, table = 1 };

}  // namespace hfrac

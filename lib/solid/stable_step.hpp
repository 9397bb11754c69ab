// SPDX-License-Identifier: BSD-3-Clause
// Row sums of the stiffness matrix, from which the stable step follows (Gershgorin's bound on its eigenvalues).
#pragma once

#include <span>
#include <vector>

#include "core/workers.hpp"
#include "model/assembly.hpp"
#include "model/network.hpp"

namespace hfrac {

// Sum of the absolute entries of each disc's rows [N/m for translations; N m for rotations, taken with the rotation
// scaled by the radius]: bonds, contacts, and pores that answer undrained (K_f w w^T / V). With `rock_weight`, the pores' weights in rock without
// fractures, each bond counts as a facet that may look any way (solid/facet_motion.hpp). Workers, if any, share the discs.
void stiffness_rows(const Assembly& assembly, const Network& network, const Options& options,
                    const Array<double>* rock_weight, std::span<double> row_x, std::span<double> row_y,
                    std::span<double> row_rotation, Workers* workers = nullptr);

}  // namespace hfrac

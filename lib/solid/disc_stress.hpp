// SPDX-License-Identifier: BSD-3-Clause
// Stress in the rock, disc by disc.
#pragma once

#include "model/model.hpp"
#include "options/options.hpp"

namespace hfrac {

// Mean stress of each disc's cell [Pa; xx, yy, xy per disc, compression positive]: sum of force times arm over its contacts, per cell
// area (Love's formula; Bagi 1996). The cell is the disc with its share of the pores around it; wells and the outside are nobody's.
void find_disc_stress(const Model& model, const Options& options, double* to);

}  // namespace hfrac

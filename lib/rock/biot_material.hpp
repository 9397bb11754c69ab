// SPDX-License-Identifier: BSD-3-Clause
// Constants of a poroelastic rock (eq. 1-3 of the paper; Biot 1941), and those that follow from them.
//
// Five are independent here: drained Young's modulus and Poisson's ratio, Biot's coefficient, the storage at constant
// strain and the mobility. The paper writes eq. 3 with Skempton's B and the undrained Poisson's ratio nu_u (which it calls
// drainage Poisson's ratio) in place of the third and fourth. Relations: Detournay and Cheng (1993), table 1 and eq. 48-54.
#pragma once

namespace hfrac {

struct BiotMaterial {
  double youngs_modulus = 14.2e9;  // drained [Pa]
  double poissons_ratio = 0.24;    // drained [1]
  double biot = 1.0;               // share of the pore pressure that carries the total stress [1]
  double storage = 1e-10;          // fluid taken up per pressure at constant strain, 1 / M [1/Pa]
  double mobility = 1e-14;         // permeability over viscosity [m2/(Pa s)]

  [[nodiscard]] double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poissons_ratio)); }
  [[nodiscard]] double bulk_modulus() const { return youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio)); }
  // Lame's first constant, drained [Pa].
  [[nodiscard]] double lambda() const { return bulk_modulus() - 2.0 / 3.0 * shear_modulus(); }
  // Pressure per mean stress when nothing flows [1].
  [[nodiscard]] double skempton() const { return biot / (bulk_modulus() * storage + biot * biot); }
  [[nodiscard]] double undrained_poissons_ratio() const {
    const double c = biot * skempton() * (1.0 - 2.0 * poissons_ratio);
    return (3.0 * poissons_ratio + c) / (3.0 - c);
  }
  // Diffusivity of the pressure when strain is along one axis [m2/s].
  [[nodiscard]] double consolidation() const {
    return mobility / (storage + biot * biot / (bulk_modulus() + 4.0 / 3.0 * shear_modulus()));
  }
};

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
// Water as a liquid: density, compressibility and viscosity by temperature and pressure, after the formulations of the International Association for the
// Properties of Water and Steam.
//   density    IAPWS R7-97(2012), IF97, region 1: v = R T / p* d gamma / d pi, 273.15 to 623.15 K, from the saturation pressure to 100 MPa
//   viscosity  IAPWS R12-08 without the critical enhancement (1 outside the neighbourhood of the critical point, as the release allows)
#pragma once

namespace hfrac {

constexpr double coldest_water = 273.15, hottest_water = 623.15, highest_water_pressure = 100e6;  // K, Pa

double water_density(double kelvin, double pressure);  // kg/m3, of an absolute pressure [Pa]
// rho d p / d rho at constant temperature [Pa], the inverse of the compressibility.
double water_bulk_modulus(double kelvin, double pressure);
double water_viscosity(double kelvin, double density);  // Pa s
// Of region 1 and region 4, IF97 equation 30: below it water boils [Pa].
double saturation_pressure(double kelvin);
// Viscosity over density [m2/s] at a pressure [Pa]; beyond the region's bounds, that at the bound.
double water_kinematic_viscosity_at(double kelvin, double pressure);

}  // namespace hfrac

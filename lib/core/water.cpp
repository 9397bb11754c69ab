// SPDX-License-Identifier: BSD-3-Clause
#include "core/water.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

struct Term {
  int i, j;
  double n;
};

// IAPWS R7-97, table 2; terms with i = 0 do not change with pressure and are left out.
constexpr Term region_1[] = {
    {1, -9, 0.28319080123804e-3},    {1, -7, -0.60706301565874e-3},   {1, -1, -0.18990068218419e-1},
    {1, 0, -0.32529748770505e-1},    {1, 1, -0.21841717175414e-1},    {1, 3, -0.52838357969930e-4},
    {2, -3, -0.47184321073267e-3},   {2, 0, -0.30001780793026e-3},    {2, 1, 0.47661393906987e-4},
    {2, 3, -0.44141845330846e-5},    {2, 17, -0.72694996297594e-15},  {3, -4, -0.31679644845054e-4},
    {3, 0, -0.28270797985312e-5},    {3, 6, -0.85205128120103e-9},    {4, -5, -0.22425281908000e-5},
    {4, -2, -0.65171222895601e-6},   {4, 10, -0.14341729937924e-12},  {5, -8, -0.40516996860117e-6},
    {8, -11, -0.12734301741641e-8},  {8, -6, -0.17424871230634e-9},   {21, -29, -0.68762131295531e-18},
    {23, -31, 0.14478307828521e-19}, {29, -38, 0.26335781662795e-22}, {30, -39, -0.11947622640071e-22},
    {31, -40, 0.18228094581404e-23}, {32, -41, -0.93537087292458e-25}};

// IAPWS R12-08, table 2: power of 1 / T - 1, power of rho - 1, coefficient.
constexpr Term of_density[] = {
    {0, 0, 5.20094e-1},  {1, 0, 8.50895e-2},  {2, 0, -1.08374},    {3, 0, -2.89555e-1}, {0, 1, 2.22531e-1},
    {1, 1, 9.99115e-1},  {2, 1, 1.88797},     {3, 1, 1.26613},     {5, 1, 1.20573e-1},  {0, 2, -2.81378e-1},
    {1, 2, -9.06851e-1}, {2, 2, -7.72479e-1}, {3, 2, -4.89837e-1}, {4, 2, -2.57040e-1}, {0, 3, 1.61913e-1},
    {1, 3, 2.57399e-1},  {0, 4, -3.25372e-2}, {3, 4, 6.98452e-2},  {4, 5, 8.72102e-3},  {3, 6, -4.35673e-3},
    {5, 6, -5.93264e-4}};

constexpr double unit = 16.53e6;  // Pa, p* of region 1

struct Derivatives {
  double first, second;
};
// Of gamma with pi = p / p*.
Derivatives gamma_by_pi(double kelvin, double pressure) {
  const double pi = 7.1 - pressure / unit, tau = 1386.0 / kelvin - 1.222;
  Derivatives gamma{0.0, 0.0};
  for (const Term& t : region_1) {
    const double of_tau = t.n * t.i * std::pow(tau, t.j);
    gamma.first -= of_tau * std::pow(pi, t.i - 1);
    gamma.second += of_tau * (t.i - 1) * std::pow(pi, t.i - 2);
  }
  return gamma;
}

}  // namespace

double water_density(double kelvin, double pressure) {
  constexpr double gas_constant = 461.526;  // J/(kg K)
  return unit / (gas_constant * kelvin * gamma_by_pi(kelvin, pressure).first);
}

// v = R T / p* d gamma / d pi, so -v dp / dv = -p* gamma_pi / gamma_pi_pi.
double water_bulk_modulus(double kelvin, double pressure) {
  const Derivatives gamma = gamma_by_pi(kelvin, pressure);
  return -unit * gamma.first / gamma.second;
}

double water_viscosity(double kelvin, double density) {
  const double t = kelvin / 647.096, rho = density / 322.0;
  const double dilute =
      100.0 * std::sqrt(t) / (1.67752 + 2.20462 / t + 0.6366564 / (t * t) - 0.241605 / (t * t * t));
  double sum = 0.0;
  for (const Term& h : of_density) sum += h.n * std::pow(1.0 / t - 1.0, h.i) * std::pow(rho - 1.0, h.j);
  return 1e-6 * dilute * std::exp(rho * sum);
}

double saturation_pressure(double kelvin) {
  const double t = kelvin - 0.23855557567849 / (kelvin - 0.65017534844798e3);
  const double a = t * t + 0.11670521452767e4 * t - 0.72421316703206e6,
               b = -0.17073846940092e2 * t * t + 0.12020824702470e5 * t - 0.32325550322333e7,
               c = 0.14915108613530e2 * t * t - 0.48232657361591e4 * t + 0.40511340542057e6;
  const double root = 2.0 * c / (-b + std::sqrt(b * b - 4.0 * a * c));
  return 1e6 * root * root * root * root;
}

double water_kinematic_viscosity_at(double kelvin, double pressure) {
  const double t = std::clamp(kelvin, coldest_water, hottest_water),
               p = std::clamp(pressure, saturation_pressure(t), highest_water_pressure);
  const double density = water_density(t, p);
  return water_viscosity(t, density) / density;
}

}  // namespace hfrac

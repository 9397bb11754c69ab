// SPDX-License-Identifier: BSD-3-Clause
// The body of the kernels, included once per instruction set with HFRAC_KERNEL_NAMESPACE set. See kernels.hpp.
//
// The bond law is written in total form: elastic forces follow from the displacements since bonding, so there is no
// history to drift and elastic energy is a function of state. With D the vector from disc i to disc j at bonding, d
// the vector now, L0 and L their lengths:
//   gap            g  = L - L0, as (2 D.du + du.du) / (L + L0): no cancellation
//   turn of d      phi = asin(D x d / (L0 L))
//   shear          u_s = L0 phi - (a_i theta_i + a_j theta_j)
//   bond           F_n = k_n g, F_s = k_s u_s, M = k_n (R^2 / 3) (theta_j - theta_i)     (eq. 16-20; I / A = R^2 / 3)
//   contact        F_n = -k_n max(0, -g), F_s = k_s (u_s - slip), |F_s| <= mu F_n
//   forces on i    F_n n + F_s (L0 / L) t, moments F_s a_i + M and F_s a_j - M: the exact gradient of the energy
//   breakage       F_n + 3 beta |M| / R >= sigma_c A  or  |F_s| >= tau_c A                (eq. 21-23, tension positive)
#include "solid/kernels.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

typedef double Quad __attribute__((vector_size(32)));  // NOLINT(modernize-use-using): attribute form

inline double positive(double a) {
  return a > 0.0 ? a : 0.0;
}
inline double magnitude(double a) {
  return __builtin_fabs(a);
}

// Eight partial sums: the compiler may keep them in vector registers without changing the order of additions.
struct Partial {
  double lane[8];
};
inline double total(const Partial& p) {
  return ((p.lane[0] + p.lane[1]) + (p.lane[2] + p.lane[3])) +
         ((p.lane[4] + p.lane[5]) + (p.lane[6] + p.lane[7]));
}

// Adds n values in an order that does not depend on the vector width.
inline double sum_of(const double* __restrict values, int64_t n) {
  Partial sum{};
  const int64_t whole = n & ~int64_t{7};
  for (int64_t k = 0; k < whole; k += 8) {
    for (int64_t lane = 0; lane < 8; ++lane) sum.lane[lane] += values[k + lane];
  }
  for (int64_t k = whole; k < n; ++k) sum.lane[k - whole] += values[k];
  return total(sum);
}

__attribute__((noinline)) void bond_block(const KernelArrays& a, int64_t first, int64_t last,
                                          BlockSums& sums) {
  const double* __restrict ux = a.ux;
  const double* __restrict uy = a.uy;
  const double* __restrict rotation = a.rotation;
  const int32_t* __restrict first_disc = a.first;
  const int32_t* __restrict second_disc = a.second;
  const double* __restrict dx_ = a.dx;
  const double* __restrict dy_ = a.dy;
  const double* __restrict length_ = a.length;
  const double* __restrict arm_ = a.arm;
  const double* __restrict radius_ = a.bond_radius;
  const double* __restrict intact_ = a.intact;
  const double* __restrict tensile_capacity = a.tensile_capacity;
  const double* __restrict shear_capacity = a.shear_capacity;
  double* __restrict slip = a.slip;
  double* __restrict force = &a.force->fx;
  const double bond_normal = a.bond_normal, bond_shear = a.bond_shear, contact_normal = a.contact_normal,
               contact_shear = a.contact_shear, friction = a.friction, bending_share = a.bending_share,
               contact_with_bond = a.contact_with_bond;
  double force_size[kernel_block], friction_work[kernel_block], over[kernel_block];
  const double inverse_contact_shear = a.contact_shear > 0.0 ? 1.0 / a.contact_shear : 0.0;
#pragma GCC \
    ivdep  // arrays written here are never the gathered ones; restrict alone does not reach gathers in GCC 12
  for (int64_t e = first; e < last; ++e) {
    const int32_t i = first_disc[e], j = second_disc[e];
    const double dux = ux[j] - ux[i], duy = uy[j] - uy[i];
    const double theta_i = rotation[i], theta_j = rotation[j];
    const double dx = dx_[e], dy = dy_[e], length = length_[e], arm_i = arm_[e], arm_j = length - arm_i;
    const double lx = dx + dux, ly = dy + duy;
    const double now = __builtin_sqrt(lx * lx + ly * ly);
    const double inverse = 1.0 / now;
    const double gap = (2.0 * (dx * dux + dy * duy) + (dux * dux + duy * duy)) / (now + length);
    const double nx = lx * inverse, ny = ly * inverse;
    const double ratio = length * inverse;
    const double sine = (dx * duy - dy * dux) * inverse;  // times L0
    const double s = sine / length, s2 = s * s;
    const double shear = sine * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) -
                         (arm_i * theta_i + arm_j * theta_j);

    const double intact = intact_[e], radius = radius_[e];
    const double bond_n = bond_normal * intact * gap;
    const double bond_s = bond_shear * intact * shear;
    const double bend = bond_normal * intact * radius * (theta_j - theta_i);  // 3 M / R
    const double moment = bend * radius * (1.0 / 3.0);

    const double present = intact > 0.0 ? contact_with_bond : 1.0;
    const double contact_n = contact_normal * present * positive(-gap);
    const double limit = friction * contact_n;
    const double trial = contact_shear * (shear - slip[e]);
    const double contact_s = trial > limit ? limit : (trial < -limit ? -limit : trial);
    const double slipped = magnitude(trial) > limit ? shear - contact_s * inverse_contact_shear : slip[e];
    friction_work[e - first] = magnitude(contact_s * (slipped - slip[e]));
    slip[e] = slipped;

    const double normal = bond_n - contact_n, tangential = bond_s + contact_s;
    const double fx = normal * nx - tangential * ratio * ny;
    const double fy = normal * ny + tangential * ratio * nx;
    force[4 * e] = fx;
    force[4 * e + 1] = fy;
    force[4 * e + 2] = tangential * arm_i + moment;
    force[4 * e + 3] = tangential * arm_j - moment;
    force_size[e - first] = magnitude(fx) + magnitude(fy);

    const double pull = bond_n + bending_share * magnitude(bend);
    // Excess over strength, as a number so that the loop stays in vector registers; a broken bond has none.
    const double excess = pull - tensile_capacity[e] > magnitude(bond_s) - shear_capacity[e]
                              ? pull - tensile_capacity[e]
                              : magnitude(bond_s) - shear_capacity[e];
    over[e - first] = intact > 0.0 && excess >= 0.0 ? 1.0 : 0.0;
  }
  const int64_t n = last - first;
  sums.force = sum_of(force_size, n);
  sums.work += sum_of(friction_work, n);
  sums.flagged = sum_of(over, n) > 0.0 ? 1 : 0;
}

// One degree of freedom of a block of discs: leap-frog with local damping (Cundall 1987). Returns the damping work.
double integrate(int64_t n, double step, double damping, const double* __restrict force,
                 const double* __restrict inverse_mass, double* __restrict velocity,
                 double* __restrict displacement) {
  double work[kernel_block];
  for (int64_t k = 0; k < n; ++k) {
    const double f = force[k], v = velocity[k];
    const double against = v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0);
    const double drag = damping * magnitude(f) * against;
    const double after = v + step * (f - drag) * inverse_mass[k];
    work[k] = 0.5 * step * drag * (v + after);
    velocity[k] = after;
    displacement[k] += step * after;
  }
  return sum_of(work, n);
}

void disc_block(const KernelArrays& a, int64_t first, int64_t last, BlockSums& sums) {
  double fx[kernel_block], fy[kernel_block], moment[kernel_block];
  const Quad on_first = {1.0, 1.0, 1.0, 0.0}, on_second = {-1.0, -1.0, 0.0, 1.0};
  for (int64_t d = first; d < last; ++d) {
    Quad sum = {0.0, 0.0, 0.0, 0.0};
    for (int32_t k = a.incidence_start[d]; k < a.incidence_start[d + 1]; ++k) {
      const int32_t code = a.incidence[k];
      const Quad force = *reinterpret_cast<const Quad*>(a.force + (code >> 1));
      sum += force * ((code & 1) != 0 ? on_second : on_first);
    }
    double px = 0.0, py = 0.0;
    if (a.with_pressure != 0) {
      for (int32_t k = a.disc_corner_start[d]; k < a.disc_corner_start[d + 1]; ++k) {
        const double p = a.pressure[a.disc_corner_domain[k]];
        px += p * a.disc_corner_weight[2 * k];
        py += p * a.disc_corner_weight[2 * k + 1];
      }
    }
    fx[d - first] = sum[0] + px + a.external_x[d];
    fy[d - first] = sum[1] + py + a.external_y[d];
    moment[d - first] = sum[2] + sum[3] + a.external_moment[d];
  }
  const int64_t n = last - first;
  double unbalanced[kernel_block];
  for (int64_t k = 0; k < n; ++k) unbalanced[k] = magnitude(fx[k]) + magnitude(fy[k]);
  sums.force = sum_of(unbalanced, n);
  sums.work += integrate(n, a.step, a.damping, fx, a.inverse_mass + first, a.vx + first, a.ux + first);
  sums.work += integrate(n, a.step, a.damping, fy, a.inverse_mass + first, a.vy + first, a.uy + first);
  sums.work +=
      integrate(n, a.step, a.damping, moment, a.inverse_inertia + first, a.spin + first, a.rotation + first);
}

void domain_block(const KernelArrays& a, int64_t first, int64_t last, BlockSums& sums) {
  double work = 0.0;
  for (int64_t d = first; d < last; ++d) {
    double change = 0.0;
    for (int32_t k = a.domain_corner_start[d]; k < a.domain_corner_start[d + 1]; ++k) {
      const int32_t disc = a.domain_corner_disc[k];
      change += a.domain_corner_weight[2 * k] * a.ux[disc] + a.domain_corner_weight[2 * k + 1] * a.uy[disc];
    }
    const double before = a.pressure[d];
    double p = before;
    if (a.stiffness[d] > 0.0) {
      p = a.reference_pressure + a.stiffness[d] * (a.content[d] - change);
      p = p > a.floor_pressure ? p : a.floor_pressure;  // cavitation
    }
    work += 0.5 * (before + p) * (change - a.volume_change[d]);
    a.pressure[d] = p;
    a.volume_change[d] = change;
  }
  sums.work += work;
}

void bond_pass(const KernelArrays& a, int64_t first, int64_t last) {
  for (int64_t b = first; b < last; b += kernel_block) {
    bond_block(a, b, b + kernel_block < last ? b + kernel_block : last, a.bond_sums[b / kernel_block]);
  }
}
void disc_pass(const KernelArrays& a, int64_t first, int64_t last) {
  for (int64_t b = first; b < last; b += kernel_block) {
    disc_block(a, b, b + kernel_block < last ? b + kernel_block : last, a.disc_sums[b / kernel_block]);
  }
}
void domain_pass(const KernelArrays& a, int64_t first, int64_t last) {
  for (int64_t b = first; b < last; b += kernel_block) {
    domain_block(a, b, b + kernel_block < last ? b + kernel_block : last, a.domain_sums[b / kernel_block]);
  }
}

}  // namespace

extern const KernelTable table;
const KernelTable table = {bond_pass, disc_pass, domain_pass, HFRAC_KERNEL_NAME};

}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac

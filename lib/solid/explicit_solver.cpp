// SPDX-License-Identifier: BSD-3-Clause
#include "solid/explicit_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "solid/stable_step.hpp"

namespace hfrac {
namespace {

// Cycles between looks at the force ratio. Breakage is watched in every cycle.
constexpr std::int64_t look_every = 20;

std::size_t blocks(std::int64_t n) {
  return static_cast<std::size_t>((n + kernel_block - 1) / kernel_block);
}

double sum_force(const std::vector<BlockSums>& sums) {
  double total = 0.0;
  for (const auto& s : sums) total += s.force;
  return total;
}

double take_work(std::vector<BlockSums>& sums) {
  double total = 0.0;
  for (auto& s : sums) {
    total += s.work;
    s.work = 0.0;
  }
  return total;
}

}  // namespace

ExplicitSolver::ExplicitSolver(Assembly& assembly, Network& network, Boundary& boundary,
                               const Options& options, Workers& workers)
    : assembly_(assembly),
      network_(network),
      boundary_(boundary),
      loose_(options),
      options_(options),
      workers_(workers),
      kernels_(kernels()) {
  const auto discs = assembly.disc_count();
  inverse_mass_.resize(static_cast<std::size_t>(discs));
  inverse_inertia_.resize(static_cast<std::size_t>(discs));
  bond_sums_.assign(blocks(assembly.bond_count()), {});
  disc_sums_.assign(blocks(discs), {});
  domain_sums_.assign(blocks(network.domain_count()), {});
  sweeps_ = plan_sweeps(assembly, network, workers.count());
  bind_arrays();
  refresh_stiffness();
  use_scaled_masses();
}

void ExplicitSolver::bind_arrays() {
  auto& a = assembly_;
  auto& n = network_;
  auto& k = arrays_;
  k.ux = a.ux.data();
  k.uy = a.uy.data();
  k.rotation = a.rotation.data();
  k.vx = a.vx.data();
  k.vy = a.vy.data();
  k.spin = a.spin.data();
  k.inverse_mass = inverse_mass_.data();
  k.inverse_inertia = inverse_inertia_.data();
  k.external_x = a.external_x.data();
  k.external_y = a.external_y.data();
  k.external_moment = a.external_moment.data();
  k.disc_count = a.disc_count();
  k.first = a.first.data();
  k.second = a.second.data();
  k.dx = a.dx.data();
  k.dy = a.dy.data();
  k.length = a.length.data();
  k.arm = a.arm.data();
  k.bond_radius = a.bond_radius.data();
  k.intact = a.intact.data();
  k.tensile_capacity = a.tensile_capacity.data();
  k.shear_capacity = a.shear_capacity.data();
  k.slip = a.slip.data();
  k.force = a.force.data();
  k.bond_count = a.bond_count();
  k.incidence_start = a.incidence_start.data();
  k.incidence = a.incidence.data();
  k.disc_corner_start = n.disc_corner_start.data();
  k.disc_corner_domain = n.disc_corner_domain.data();
  k.disc_corner_weight = n.disc_corner_weight.data();
  k.domain_corner_start = n.corner_start.data();
  k.domain_corner_disc = n.corner_disc.data();
  k.domain_corner_weight = n.corner_weight.data();
  k.pressure = n.pressure.data();
  k.volume_change = n.volume_change.data();
  k.content = n.content.data();
  k.domain_count = n.domain_count();
  k.bond_normal = options_.bond_normal_stiffness;
  k.bond_shear = options_.bond_shear_stiffness;
  k.contact_normal = options_.contact_normal_stiffness;
  k.contact_shear = options_.contact_shear_stiffness;
  k.friction = options_.contact_friction;
  k.bending_share = options_.bond_moment_contribution;
  k.contact_with_bond = ContactMode{options_.contact_mode} == ContactMode::parallel ? 1.0 : 0.0;
  k.damping = options_.stepping_damping;
  k.reference_pressure = n.reference_pressure;
  k.floor_pressure = n.floor_pressure;
  k.with_pressure = FlowScheme{options_.flow_scheme} == FlowScheme::off ? 0 : 1;
  k.bond_sums = bond_sums_.data();
  k.disc_sums = disc_sums_.data();
  k.domain_sums = domain_sums_.data();
}

void ExplicitSolver::refresh_stiffness() {
  stiffness_rows(assembly_, network_, options_, row_x_, row_y_, row_rotation_);
  boundary_.add_stiffness(row_x_, row_y_);
  loose_.add_stiffness(assembly_, row_x_, row_y_, row_rotation_);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < row_x_.size(); ++i) {
    const double row = std::max(row_x_[i], row_y_[i]);
    shortest = std::min(shortest, assembly_.mass[i] / row);
    if (row_rotation_[i] > 0.0) shortest = std::min(shortest, assembly_.inertia[i] / row_rotation_[i]);
  }
  // Gershgorin: omega^2 is at most the largest row sum over mass; the leap-frog is stable below 2 / omega.
  real_step_ = options_.stepping_safety * 2.0 * std::sqrt(shortest);
  scaled_ ? use_scaled_masses() : use_real_masses();
}

void ExplicitSolver::use_scaled_masses() {
  if (!scaled_) stop_motion();
  scaled_ = true;
  arrays_.step = 1.0;
  const double factor = 0.25 / (options_.stepping_safety * options_.stepping_safety);
  for (std::size_t i = 0; i < row_x_.size(); ++i) {
    inverse_mass_[i] = 1.0 / (factor * std::max(row_x_[i], row_y_[i]));
    inverse_inertia_[i] = row_rotation_[i] > 0.0 ? 1.0 / (factor * row_rotation_[i]) : 0.0;
  }
}

void ExplicitSolver::use_real_masses() {
  if (scaled_) stop_motion();
  scaled_ = false;
  arrays_.step = real_step_;
  for (std::size_t i = 0; i < row_x_.size(); ++i) {
    inverse_mass_[i] = 1.0 / assembly_.mass[i];
    inverse_inertia_[i] = 1.0 / assembly_.inertia[i];
  }
}

void ExplicitSolver::stop_motion() {
  for (auto* v : {&assembly_.vx, &assembly_.vy, &assembly_.spin}) std::fill(v->begin(), v->end(), 0.0);
  for (auto& wall : boundary_.walls()) wall.velocity = 0.0;
}

void ExplicitSolver::break_bond(const BondView& bond, std::int64_t e, std::int64_t cycle, CrackLog& found) {
  Crack crack;
  crack.bond = e;
  crack.cycle = cycle;
  crack.normal_force = bond.bond_normal;
  crack.shear_force = bond.bond_shear;
  crack.energy = bond.bond_energy;
  crack.released = bond.bond_energy + bond.contact_energy;
  crack.mode = bond.tensile_excess >= bond.shear_excess ? CrackMode::tension : CrackMode::shear;
  found.push_back(crack);
  assembly_.intact[e] = 0.0;
  // In mode after-break a contact takes over where discs were pressed together.
  found.back().released -= view_bond(assembly_, options_, e).contact_energy;
}

void ExplicitSolver::break_bond(std::int64_t bond, CrackLog& log) {
  break_bond(view_bond(assembly_, options_, bond), bond, total_cycles_, log);
  energies_.fracture += log.back().released;
}

// Scalar look at a block some bond of which exceeds its strength; rare.
void ExplicitSolver::break_bonds(std::int64_t first, std::int64_t last, std::int64_t cycle, CrackLog& found) {
  for (std::int64_t e = first; e < last; ++e) {
    if (assembly_.intact[e] == 0.0) continue;
    const BondView bond = view_bond(assembly_, options_, e);
    if (bond.tensile_excess < 1.0 && bond.shear_excess < 1.0) continue;
    break_bond(bond, e, cycle, found);
  }
  kernels_.bond_pass(arrays_, first, last);  // what the block's bonds bear now
}

void ExplicitSolver::take(const SweepItem& item, std::int64_t cycle, CrackLog& found) {
  switch (item.kind) {
    case SweepItem::Kind::bonds:
      kernels_.bond_pass(arrays_, item.first, item.last);
      if (bond_sums_[static_cast<std::size_t>(item.first / kernel_block)].flagged != 0)
        break_bonds(item.first, item.last, cycle, found);
      break;
    case SweepItem::Kind::domains:
      if (arrays_.with_pressure != 0 && undrained_) kernels_.domain_pass(arrays_, item.first, item.last);
      break;
    case SweepItem::Kind::discs:
      kernels_.disc_pass(arrays_, item.first, item.last);
      break;
  }
}

void ExplicitSolver::batch(std::int64_t cycles, std::vector<CrackLog>& found) {
  arrays_.stiffness = network_.stiffness.data();
  const std::function<void(int)> task = [&](int worker) {
    const auto w = static_cast<std::size_t>(worker);
    for (std::int64_t cycle = total_cycles_; cycle < total_cycles_ + cycles; ++cycle) {
      for (const auto& item : sweeps_[w].shared) take(item, cycle, found[w]);
      if (worker == 0 && boundary_.walled()) {
        boundary_.cycle(assembly_, arrays_.step, options_.stepping_safety, arrays_.damping);
      }
      if (worker == 0 && !loose_.empty())
        loose_.cycle(assembly_, boundary_, arrays_.step, energies_.friction);
      workers_.barrier();
      for (const auto& item : sweeps_[w].own) take(item, cycle, found[w]);
      workers_.barrier();
    }
  };
  workers_.run(task);
  total_cycles_ += cycles;
}

double ExplicitSolver::force_ratio() const {
  const double unbalanced = sum_force(disc_sums_) / static_cast<double>(arrays_.disc_count);
  const double contact =
      sum_force(bond_sums_) / static_cast<double>(std::max<std::int64_t>(1, arrays_.bond_count));
  // Below a strain of 1e-12 everywhere there is nothing to balance.
  const double least = 1e-12 * arrays_.contact_normal * assembly_.mean_radius;
  const double ratio = std::max(unbalanced / std::max(contact, least), boundary_.wall_imbalance());
  if (!std::isfinite(unbalanced) || !std::isfinite(contact)) {
    throw Error(ErrorKind::diverged,
                "a force is no longer a finite number after cycle " + std::to_string(total_cycles_) +
                    " (eq. 11); lower stepping.safety, or check stiffnesses and stresses");
  }
  return ratio;
}

ExplicitSolver::Outcome ExplicitSolver::relax(double ratio, std::int64_t most, CrackLog& log,
                                              const std::function<bool()>& interrupt) {
  Outcome outcome;
  std::vector<CrackLog> found(static_cast<std::size_t>(workers_.count()));
  while (outcome.cycles < most) {
    const std::int64_t cycles = std::min(look_every, most - outcome.cycles);
    batch(cycles, found);
    if (scaled_) boundary_.hold_still(assembly_);  // on the way to rest; real motion is left alone
    outcome.cycles += cycles;
    outcome.force_ratio = force_ratio();
    energies_.friction += take_work(bond_sums_);
    energies_.damping += take_work(disc_sums_);
    energies_.fluid += take_work(domain_sums_);
    std::vector<Crack> broken;
    for (auto& part : found) {
      broken.insert(broken.end(), part.begin(), part.end());
      part.clear();
    }
    // Order of breakage, whatever worker found it.
    std::sort(broken.begin(), broken.end(), [](const Crack& a, const Crack& b) {
      return a.cycle != b.cycle ? a.cycle < b.cycle : a.bond < b.bond;
    });
    for (const auto& crack : broken) energies_.fracture += crack.released;
    log.insert(log.end(), broken.begin(), broken.end());
    if (broken.empty() && outcome.force_ratio <= ratio) {
      outcome.at_rest = true;
      break;
    }
    if (interrupt && interrupt()) {
      outcome.stopped = true;
      break;
    }
  }
  return outcome;
}

ExplicitSolver::Outcome ExplicitSolver::run(std::int64_t cycles, CrackLog& log,
                                            const std::function<bool()>& interrupt) {
  return relax(-1.0, cycles, log, interrupt);
}

void ExplicitSolver::evaluate() {
  arrays_.stiffness = network_.stiffness.data();
  kernels_.bond_pass(arrays_, 0, arrays_.bond_count);
  if (arrays_.with_pressure != 0) kernels_.domain_pass(arrays_, 0, arrays_.domain_count);
  energies_.friction += take_work(bond_sums_);
  energies_.fluid += take_work(domain_sums_);
}

void ExplicitSolver::search_contacts(const CrackLog& cracks) {
  if (loose_.search(assembly_, boundary_, cracks)) refresh_stiffness();
}

void ExplicitSolver::after_restore() {
  // What a failed step had summed up so far is void.
  for (auto* sums : {&bond_sums_, &disc_sums_, &domain_sums_})
    std::fill(sums->begin(), sums->end(), BlockSums{});
  refresh_stiffness();
}

double ExplicitSolver::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < inverse_mass_.size(); ++i) {
    energy +=
        0.5 * (assembly_.vx[i] * assembly_.vx[i] + assembly_.vy[i] * assembly_.vy[i]) / inverse_mass_[i];
    if (inverse_inertia_[i] > 0.0)
      energy += 0.5 * assembly_.spin[i] * assembly_.spin[i] / inverse_inertia_[i];
  }
  return energy;
}

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
#include "solid/explicit_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "solid/smooth_joints.hpp"
#include "solid/stable_step.hpp"

namespace hfrac {
namespace {

// Cycles between looks at the force ratio. Breakage is watched in every cycle.
constexpr std::int64_t look_every = 20;

}  // namespace

ExplicitSolver::ExplicitSolver(Model& model, Boundary& boundary, const Options& options, Workers& workers,
                               const Ranks& ranks)
    : assembly_(model.assembly),
      network_(model.network),
      energies_(model.accounts.energies),
      total_cycles_(model.clock.cycles),
      boundary_(boundary),
      contacts_(model.contact_pairs),
      non_bonded_(options, model.contact_pairs),
      options_(options),
      workers_(workers),
      parts_left_(workers.count()),
      outer_parts_left_(workers.count()),
      tiles_left_(workers.count()),
      kernels_(kernels()),
      fragments_(assembly_, options),
      facets_(assembly_, network_, options, energies_),
      plan_(plan_tiles(assembly_, network_, FlowScheme{options.flow_scheme} != FlowScheme::off,
                       boundary.walled())),
      shared_(ranks, assembly_, network_, plan_),
      dropped_(static_cast<std::size_t>(workers.count())) {
  const auto discs = static_cast<std::size_t>(assembly_.disc_count());
  inverse_mass_.resize(discs);
  inverse_inertia_.resize(discs);
  const auto tiles = plan_.tiles.size();
  bond_sums_.assign(tiles + plan_.pairs.size(), {});
  disc_sums_.assign(tiles, {});
  domain_sums_.assign(tiles + plan_.cross_parts.size(), {});
  scratch_.resize(static_cast<std::size_t>(workers.count()));
  for (auto& scratch : scratch_) scratch.assign(static_cast<std::size_t>(tile_scratch), 0.0);
  if (!assembly_.smooth.empty()) {
    for (std::size_t part = 0; part < tiles + plan_.pairs.size(); ++part)
      smooth_from_.push_back(assembly_.smooth.index.listed_before(assembly_.part_first_bond[part]));
    smooth_from_.push_back(static_cast<std::int64_t>(assembly_.smooth.contacts.size()));
  }
  bind_arrays();
  refresh_stiffness();
  if (is_worth_blocking(arrays_.tile_count, workers.count()) && ranks.alone()) set_blocking(blocking_shape);
}

void ExplicitSolver::bind_arrays() {
  bring_home();
  device_cycles_.reset();
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
  k.geometry = a.geometry.data();
  k.intact = a.intact.data();
  k.slip = a.slip.data();
  if (!a.factors.empty()) {
    k.growth = a.factors.growth.data();
    k.stiffness_factor = a.factors.stiffness.data();
    k.tensile_factor = a.factors.tensile.data();
    k.shear_factor = a.factors.shear.data();
    k.bond_friction = a.factors.friction.data();
  }
  if (!a.softening.empty()) {
    k.softening_start = a.softening.start.data();
    k.softening_worst = a.softening.worst.data();
    k.softening = 4.0 * options_.bond_fracture_energy;
  }
  k.bond_count = a.bond_count();
  k.first_cross_bond = a.first_cross_bond();
  k.domain_corner_start = n.corner_start.data();
  k.domain_corner_disc = n.corner_disc.data();
  k.domain_corner_weight = n.corner_weight.data();
  k.domain_corner_turn = n.corner_turn.empty() ? nullptr : n.corner_turn.data();
  k.pressure = n.pressure.data();
  k.volume_change = n.volume_change.data();
  if (FlowScheme{options_.flow_scheme} != FlowScheme::off &&
      FluidKind{options_.fluid_kind} == FluidKind::water &&
      ThermalMode{options_.thermal_mode} != ThermalMode::off)
    filled_.resize(n.content.size());
  k.content = filled_.empty() ? n.content.data() : filled_.data();
  k.tiles = plan_.tiles.data();
  k.pairs = plan_.pairs.data();
  k.pair_count = static_cast<std::int64_t>(plan_.pairs.size());
  k.cross_parts = plan_.cross_parts.data();
  k.tile_count = static_cast<std::int64_t>(plan_.tiles.size());
  k.cross_domain = plan_.cross_domain.data();
  k.cross_corner = plan_.cross_corner.data();
  k.bond_slot = plan_.bond_slot.data();
  k.force_buffer = plan_.force_buffer.data();
  k.bond_normal = options_.bond_normal_stiffness;
  k.bond_shear = options_.bond_shear_stiffness;
  k.contact_normal = options_.contact_normal_stiffness;
  k.contact_shear = options_.contact_shear_stiffness;
  k.tensile_capacity = a.tensile_per_radius;
  k.shear_capacity = a.shear_per_radius;
  k.friction = options_.contact_friction;
  k.bending_share = options_.bond_moment_contribution;
  k.flat = ContactShape{options_.contact_shape} == ContactShape::flat ? 1 : 0;
  k.contact_with_bond = ContactMode{options_.contact_mode} == ContactMode::parallel ? 1.0 : 0.0;
  k.damping = options_.stepping_damping;
  k.reference_pressure = n.reference_pressure;
  k.floor_pressure = n.floor_pressure;
  k.with_pressure = FlowScheme{options_.flow_scheme} == FlowScheme::off ? 0 : 1;
  k.bond_sums = bond_sums_.data();
  k.disc_sums = disc_sums_.data();
  k.domain_sums = domain_sums_.data();
}

// Row sums of the stiffness matrix [N/m].
void ExplicitSolver::stiffness(std::span<double> row_x, std::span<double> row_y,
                               std::span<double> row_rotation) const {
  stiffness_rows(assembly_, network_, options_, facets_.active() ? &facets_.rock_weight() : nullptr, row_x,
                 row_y, row_rotation, &workers_);
  boundary_.add_stiffness(row_x, row_y);
  non_bonded_.add_stiffness(assembly_, row_x, row_y, row_rotation);
  add_smooth_stiffness(assembly_, row_x, row_y, row_rotation);
}

// Row sums stand where the masses by them will.
void ExplicitSolver::refresh_stiffness() {
  bring_home();
  const std::span<double> row_x = inverse_mass_, row_rotation = inverse_inertia_;
  std::vector<double> row_y(row_x.size());
  stiffness(row_x, row_y, row_rotation);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < row_x.size(); ++i) {
    const auto disc = static_cast<std::int64_t>(i);
    shortest = std::min(shortest, assembly_.mass(disc) / std::max(row_x[i], row_y[i]));
    if (row_rotation[i] > 0.0) shortest = std::min(shortest, assembly_.inertia(disc) / row_rotation[i]);
  }
  // Gershgorin: omega^2 is at most the largest row sum over mass; the leap-frog is stable below 2 / omega.
  real_step_ = options_.stepping_safety * 2.0 * std::sqrt(shortest);
  arrays_.step = scaled_ ? 1.0 : real_step_;
  const double factor = 0.25 / (options_.stepping_safety * options_.stepping_safety);
  for (std::size_t i = 0; i < row_x.size(); ++i) {
    const auto disc = static_cast<std::int64_t>(i);
    if (scaled_) {
      inverse_mass_[i] = 1.0 / (factor * std::max(row_x[i], row_y[i]));
      inverse_inertia_[i] = row_rotation[i] > 0.0 ? 1.0 / (factor * row_rotation[i]) : 0.0;
    } else {
      inverse_mass_[i] = 1.0 / assembly_.mass(disc);
      inverse_inertia_[i] = 1.0 / assembly_.inertia(disc);
    }
  }
}

void ExplicitSolver::use_scaled_masses() {
  if (scaled_) return;
  stop_motion();
  scaled_ = true;
  refresh_stiffness();
}

void ExplicitSolver::use_real_masses() {
  if (!scaled_) return;
  stop_motion();
  scaled_ = false;
  refresh_stiffness();
}

void ExplicitSolver::stop_motion() {
  bring_home();
  for (auto* v : {&assembly_.vx, &assembly_.vy, &assembly_.spin}) std::fill(v->begin(), v->end(), 0.0);
  for (auto& wall : boundary_.walls()) wall.velocity = 0.0;
}

// At the end of its softening a bond bears nothing: what it bore where that began, and what it has taken since, go to the log.
void ExplicitSolver::log_softened(Crack& crack) const {
  if (assembly_.smooth.of(crack.bond) != nullptr) return;
  const BondLaw law = bond_law(assembly_, options_, crack.bond);
  const double share = assembly_.factors.stiffness_of(crack.bond), at_start = law.softened.at_start;
  crack.normal_force =
      options_.bond_normal_stiffness * share * law.motion.gap * (law.motion.gap > 0.0 ? at_start : 1.0);
  crack.shear_force = options_.bond_shear_stiffness * share * law.motion.shear * at_start;
  crack.energy += energy_taken(assembly_, options_, crack.bond);
}

void ExplicitSolver::break_bond(const BondView& bond, std::int64_t e, std::int64_t cycle,
                                std::vector<Crack>& found) {
  Crack crack;
  crack.bond = e;
  crack.cycle = cycle;
  crack.normal_force = bond.bond_normal;
  crack.shear_force = bond.bond_shear;
  crack.energy = bond.bond_energy;
  crack.released = bond.bond_energy + bond.contact_energy;
  if (!assembly_.softening.empty()) log_softened(crack);
  crack.mode = bond.tensile_excess >= bond.shear_excess ? CrackMode::tension : CrackMode::shear;
  found.push_back(crack);
  assembly_.intact[e] = 0;
  // In mode after-break a contact takes over where discs were pressed together.
  found.back().released -= view_bond(assembly_, options_, e).contact_energy;
}

void ExplicitSolver::hold_edge(bool hold) {
  bring_home();
  held_.assign(hold ? static_cast<std::size_t>(assembly_.disc_count()) : 0, 0);
  if (hold)
    for (const auto i : boundary_.edge()) held_[static_cast<std::size_t>(i)] = 1;
  if (assembly_.softening.empty()) return;
  assembly_.softening.held.clear();  // nor do they soften
  for (std::int64_t e = 0; hold && e < assembly_.bond_count(); ++e)
    assembly_.softening.held.push_back(is_held(e) ? 1 : 0);
  combine_factors(assembly_, options_);
}

bool ExplicitSolver::is_held(std::int64_t bond) const {
  const auto e = static_cast<std::size_t>(bond);
  const auto held = [this](std::int32_t i) { return held_[static_cast<std::size_t>(i)] != 0; };
  return !held_.empty() && (held(assembly_.first[e]) || held(assembly_.second[e]));
}

void ExplicitSolver::break_bond(std::int64_t bond, CrackLog& log) {
  std::vector<Crack> found;
  break_bond(view_bond(assembly_, options_, bond), bond, total_cycles_, found);
  log.append(found);
  energies_.fracture += log.back().released;
}

FacetMotion& ExplicitSolver::follow_facets(const FacetStart& start, const Array<double>& rock_weight,
                                           FacetRules rules) {
  facets_.begin(start, rock_weight);
  facet_rules_ = std::move(rules);
  bind_arrays();
  refresh_stiffness();
  return facets_;
}

// The list of discs that are pushed follows that of facets.
void ExplicitSolver::take_facets() {
  if (facets_seen_ == facets_.changes()) return;
  facets_seen_ = facets_.changes();
  list_pushed();
}

void ExplicitSolver::list_pushed() {
  std::vector<std::int32_t> discs = non_bonded_.discs();
  discs.insert(discs.end(), facets_.discs().begin(), facets_.discs().end());
  std::sort(discs.begin(), discs.end());
  discs.erase(std::unique(discs.begin(), discs.end()), discs.end());
  pushed_.clear();
  pushed_.reserve(discs.size());
  const auto& edge = boundary_.edge();
  for (const auto disc : discs)
    pushed_.push_back({disc, std::binary_search(edge.begin(), edge.end(), disc), false, {}});
}

double ExplicitSolver::force_ratio(const Sums& sums) {
  const double unbalanced = sums.unbalanced / static_cast<double>(arrays_.disc_count);
  const double contact = sums.contact / static_cast<double>(std::max<std::int64_t>(1, arrays_.bond_count));
  // Below a strain of 1e-12 everywhere there is nothing to balance.
  const double least = 1e-12 * arrays_.contact_normal * assembly_.mean_radius;
  const double ratio = std::max(unbalanced / std::max(contact, least), boundary_.wall_imbalance());
  if (!std::isfinite(unbalanced) || !std::isfinite(contact)) {
    fetch_state();
    const std::string where = first_not_finite();
    throw Error(ErrorKind::diverged, "a force is no longer a finite number after cycle " +
                                         std::to_string(total_cycles_) +
                                         (where.empty() ? " (eq. 11)" : where) +
                                         "; lower stepping.safety, or check stiffnesses and stresses");
  }
  return ratio;
}

// Where to look, and by which equation it moves. Of several the one with the lowest number: by now its neighbours are off too.
std::string ExplicitSolver::first_not_finite() const {
  const auto& a = assembly_;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    for (const double v : {a.ux[i], a.uy[i], a.rotation[i], a.vx[i], a.vy[i], a.spin[i]}) {
      if (std::isfinite(v)) continue;
      return ", at disc " + std::to_string(i) + " near (" + std::to_string(a.x[i]) + ", " +
             std::to_string(a.y[i]) + ") m (eq. 11)";
    }
  }
  for (std::int64_t d = 0; d < network_.domain_count(); ++d) {
    if (!std::isfinite(network_.pressure[d]))
      return ", at the pressure of domain " + std::to_string(d) + " (eq. 8)";
  }
  return {};
}

ExplicitSolver::Outcome ExplicitSolver::relax(double ratio, std::int64_t most, CrackLog& log,
                                              const std::function<bool()>& interrupt, Then then) {
  Outcome outcome;
  std::vector<Found> found(static_cast<std::size_t>(workers_.count()));
  const Ranks& ranks = shared_.ranks();
  take_contents();  // which cycles leave as they are
  // The pressure outside is imposed: its push is the same in all cycles, and its work follows from its change of volume since the last
  // look.
  if (arrays_.with_pressure != 0) {
    arrays_.undrained = undrained_ ? 1 : 0;
    arrays_.stiffness = network_.stiffness.data();
    kernels_.cross_domains(arrays_, arrays_.tile_count);
  }
  on_device_ = runs_on_device();
  if (on_device_)
    begin_on_device();
  else
    bring_home();
  while (outcome.cycles < most) {
    const std::int64_t cycles = std::min(look_every, most - outcome.cycles);
    on_device_ ? batch_on_device(cycles, found) : batch(cycles, found);
    const Sums sums = sum_up(found);
    hold_still(sums);
    outcome.cycles += cycles;
    outcome.force_ratio = force_ratio(sums);
    const std::vector<Crack> broken = sums.broken ? cracks_of(found) : std::vector<Crack>{};
    for (const auto& crack : broken) energies_.fracture += crack.released;
    log.append(broken);
    const bool rest = broken.empty() && outcome.force_ratio <= ratio;
    const bool asked = (rest || !scaled_) && facet_rules_.grow;
    if (asked) {
      shared_.gather(assembly_, network_);
      facets_.begin_cycles();
      facets_.answer(undrained_);
      facets_.end_cycles();
    }
    const bool grows = asked && facet_rules_.grow(log);
    if (rest && !grows) {
      outcome.at_rest = true;
      break;
    }
    const bool asked_to_stop = interrupt && interrupt();
    if (ranks.alone() ? asked_to_stop : ranks.any(asked_to_stop)) {
      outcome.stopped = true;
      break;
    }
    if (assembly_.smooth.empty()) continue;
    if (on_device_) device_cycles_->get_displacements();
    double slide = 0.0;
    // Of other ranks' contacts it may know the motion of one disc alone.
    farthest_slide(assembly_, slide, shared_.first_tile() * tile_size, shared_.last_tile() * tile_size);
    if (ranks.any(slide > assembly_.mean_radius))
      break;  // past what the law holds for: Simulation refuses it
  }
  const bool evaluates = then == Then::evaluate && !outcome.stopped;
  if (evaluates && !ranks.alone() && !on_device_ && !facets_.active() && smooth_forces_.empty()) {
    evaluate_own();
    return outcome;
  }
  if (!on_device_ || !stays_) fetch_state();
  if (evaluates) evaluate();
  return outcome;
}

ExplicitSolver::Outcome ExplicitSolver::run(std::int64_t cycles, CrackLog& log,
                                            const std::function<bool()>& interrupt, Then then) {
  return relax(-1.0, cycles, log, interrupt, then);
}

ExplicitSolver::Outcome ExplicitSolver::run_for(double duration, CrackLog& log,
                                                const std::function<bool()>& interrupt, Then then) {
  const auto cycles =
      std::max<std::int64_t>(1, std::llround(std::ceil(duration / real_step_ * (1.0 - 1e-12))));
  arrays_.step = duration / static_cast<double>(cycles);
  const Outcome outcome = run(cycles, log, interrupt, then);
  arrays_.step = scaled_ ? 1.0 : real_step_;
  return outcome;
}

void ExplicitSolver::take_contents() {
  for (std::int64_t d = 0; d < static_cast<std::int64_t>(filled_.size()); ++d)
    filled_[d] = network_.content[d] + network_.growth_of(d);
}

void ExplicitSolver::begin_evaluation() {
  arrays_.stiffness = facets_.active() ? facets_.stiffness() : network_.stiffness.data();
  arrays_.undrained = 1;  // volumes are looked at
  take_contents();
  begin_smooth_joints();
  mark_left_alone();
}

// As a cycle, but nothing moves or breaks: so many parts across tiles, and tiles.
template <class PartOf>
void ExplicitSolver::answer_once(std::int64_t parts, const PartOf& part_of, std::int64_t first_tile,
                                 std::int64_t last_tile) {
  workers_.share(last_tile - first_tile >= 2 * workers_.count(), [&](const Workers::Member& member) {
    const auto my_parts = member.part(parts, 1), tiles = member.part(last_tile - first_tile, 1);
    for (auto item = my_parts.first; item < my_parts.last; ++item) {
      const auto part = part_of(item);
      const CrossPart& p = plan_.cross_parts[static_cast<std::size_t>(part)];
      for (auto pair = p.first_pair; pair < p.last_pair; ++pair) kernels_.cross_bonds(arrays_, pair);
      if (arrays_.with_pressure != 0) kernels_.cross_domains(arrays_, part);
    }
    member.barrier();
    double* scratch = scratch_[static_cast<std::size_t>(member.number)].data();
    for (auto tile = first_tile + tiles.first; tile < first_tile + tiles.last; ++tile)
      kernels_.tile_forces(arrays_, tile, scratch);
  });
}

void ExplicitSolver::evaluate() {
  if (away_) {
    evaluate_on_device();
    return;
  }
  take_facets();
  if (facets_.active()) facets_.begin_cycles();
  begin_evaluation();
  for (std::size_t k = 0; !smooth_forces_.empty() && k < smooth_forces_.size(); ++k) {
    const SmoothContact& contact = assembly_.smooth.contacts[k];
    smooth_forces_[k] = answer_of(assembly_, contact, assembly_.slip[contact.bond], energies_.friction);
  }
  answer_once(
      arrays_.tile_count + 1, [](std::int64_t part) { return part; }, 0, arrays_.tile_count);
  take_works();
  if (!facets_.active()) return;
  facets_.answer(true);
  facets_.end_cycles();
}

// After cycles, before what they changed was gathered: each rank its own parts. Only the pore outside needs discs of all.
void ExplicitSolver::evaluate_own() {
  begin_evaluation();
  answer_once(
      shared_.part_count(), [this](std::int64_t item) { return shared_.part(item); }, shared_.first_tile(),
      shared_.last_tile());
  fetch_state();
  if (arrays_.with_pressure != 0) kernels_.cross_domains(arrays_, arrays_.tile_count);
  take_own_works();
}

// Of an evaluation, to the ledger.
void ExplicitSolver::take_works() {
  ExactSum friction, fluid;
  for (auto& of : bond_sums_) take_work(of, friction);
  for (auto& of : domain_sums_) take_work(of, fluid);
  energies_.friction += friction.value();
  energies_.fluid += fluid.value();
}

void ExplicitSolver::search_contacts(const CrackLog& cracks) {
  if (away_ && non_bonded_.is_due(assembly_, cracks)) bring_home();
  if (!non_bonded_.search(assembly_, boundary_, cracks)) return;
  list_pushed();
  refresh_stiffness();
}

void ExplicitSolver::after_restore(double sigma_Hmax, double sigma_hmin) {
  facets_seen_ = facets_.changes();
  list_pushed();
  // What stands on those discs was saved with them; a restored state is the one saved, to the last bit.
  for (auto& disc : pushed_) disc.load = {assembly_.external_x[disc.disc], assembly_.external_y[disc.disc]};
  boundary_.restore_load(assembly_, network_, sigma_Hmax, sigma_hmin);
  for (const auto& disc : pushed_) {
    assembly_.external_x[disc.disc] = disc.load.x;
    assembly_.external_y[disc.disc] = disc.load.y;
  }
  // What a failed step had summed up so far is void.
  for (auto* sums : {&bond_sums_, &disc_sums_, &domain_sums_})
    std::fill(sums->begin(), sums->end(), TileSums{});
  refresh_stiffness();
}

double ExplicitSolver::kinetic_energy() const {
  bring_home();
  return kinetic_of(0, inverse_mass_.size());
}

// Of discs in a row.
double ExplicitSolver::kinetic_of(std::size_t first, std::size_t last) const {
  double energy = 0.0;
  for (auto i = first; i < last; ++i) {
    energy +=
        0.5 * (assembly_.vx[i] * assembly_.vx[i] + assembly_.vy[i] * assembly_.vy[i]) / inverse_mass_[i];
    if (inverse_inertia_[i] > 0.0)
      energy += 0.5 * assembly_.spin[i] * assembly_.spin[i] / inverse_inertia_[i];
  }
  return energy;
}

// Added up in whatever order, if that is clear enough.
bool ExplicitSolver::is_slower(double kinetic) const {
  constexpr double clear = 1.0 - 1e-6;
  double roughly = 0.0;
  if (away_) {
    roughly = device_cycles_->look_over().kinetic;
  } else {
    std::mutex one_by_one;
    share_items(&workers_, static_cast<std::int64_t>(inverse_mass_.size()),
                [&](std::int64_t first, std::int64_t last) {
                  const double here =
                      kinetic_of(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
                  const std::lock_guard lock(one_by_one);
                  roughly += here;
                });
  }
  return roughly <= clear * kinetic || kinetic_energy() <= kinetic;
}

}  // namespace hfrac

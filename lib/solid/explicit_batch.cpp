// SPDX-License-Identifier: BSD-3-Clause
// A batch of cycles: who of the workers does what between which barriers, what breaks on the way, and what it all came to, over
// workers and ranks.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <exception>
#include <functional>
#include <new>
#include <vector>

#include "core/error.hpp"
#include "solid/explicit_solver.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {

namespace {

// And two counts likewise, in one message.
template <std::size_t Sums>
void add_over_ranks(const Ranks& ranks, std::array<ExactSum, Sums>& sums,
                    std::array<std::int64_t, 2>& counts) {
  std::array<std::int64_t, Sums * ExactSum::word_count + 2> words{};
  auto* to = std::copy(counts.begin(), counts.end(), words.data());
  for (auto& sum : sums) {
    sum.carry();
    to = std::copy(sum.words().begin(), sum.words().end(), to);
  }
  ranks.sum(words);
  const auto* from = words.data() + counts.size();
  std::copy_n(words.data(), counts.size(), counts.begin());
  for (auto& sum : sums) {
    std::copy_n(from, ExactSum::word_count, sum.words().begin());
    from += ExactSum::word_count;
  }
}

}  // namespace

// Adds up the works of a part's sums, which begin anew.
void ExplicitSolver::take_work(TileSums& sums, ExactSum& total) {
  total.add(sums.work);
  sums.work = 0.0;
}

void ExplicitSolver::put_loads() {
  for (auto& disc : pushed_) {
    disc.load = {};
    if (!disc.outermost && boundary_.grips().empty()) continue;  // most
    disc.walled = boundary_.touches_wall(disc.disc);
    disc.load = boundary_.load_on(disc.disc);
  }
}

// External forces back to the boundary's.
void ExplicitSolver::release_pushed() {
  for (const auto& [i, outermost, walled, load] : pushed_) {
    assembly_.external_moment[i] = 0.0;
    if (walled) continue;  // written anew in every cycle
    assembly_.external_x[i] = load.x;
    assembly_.external_y[i] = load.y;
  }
}

// Between two cycles: what was found to break becomes facets, in the order of bonds. Whether one stays depends on those before it.
void ExplicitSolver::break_into_facets(std::int64_t cycle, std::vector<Found>& found) {
  std::vector<std::int64_t> bonds, broken;
  for (auto& part : found) {
    bonds.insert(bonds.end(), part.to_facets.begin(), part.to_facets.end());
    part.to_facets.clear();
  }
  bonds = shared_.ranks().gather(bonds);
  shared_.gather(assembly_, network_);
  std::vector<Crack>& log =
      (shared_.ranks().rank() == 0 ? found[0] : dropped_[0]).cracks;  // all ranks find the same
  std::sort(bonds.begin(), bonds.end());
  for (const auto e : bonds) {
    if (stays(e)) {
      hold_bond(assembly_, e);
      continue;
    }
    break_bond(view_bond(assembly_, options_, e), e, cycle, log);
    network_.facet_time[e] =
        time_ + (scaled_ ? 0.0 : arrays_.step * static_cast<double>(cycle - cycles_then_));
    broken.push_back(e);
  }
  if (broken.empty()) return;
  facets_.end_cycles();
  facet_rules_.breaks(broken);
  take_facets();
  facets_.begin_cycles();
  arrays_.stiffness = facets_.stiffness();
  put_loads();
  mark_left_alone();
  show_everywhere();
}

// Scalar look at bonds some of which exceed their strength; rare. True if any broke.
bool ExplicitSolver::break_bonds(std::int64_t first, std::int64_t last, std::int64_t cycle, Found& found) {
  const std::size_t before = found.cracks.size();
  for (std::int64_t e = first; e < last; ++e) {
    if (assembly_.intact[e] == 0) continue;
    const BondView bond = view_bond(assembly_, options_, e);
    if (!bond.breaks()) continue;
    if (assembly_.smooth.of(e) != nullptr) {
      break_bond(bond, e, cycle, found.cracks);
      continue;
    }
    if (is_held(e)) continue;
    if (facets_.active()) {
      found.to_facets.push_back(e);
      facets_to_come_ = cycle;
      continue;
    }
    if (!fragments_.is_last(assembly_, e)) break_bond(bond, e, cycle, found.cracks);
  }
  return found.cracks.size() > before;
}

// What the kernels are to know of smooth joints in the cycles to come.
void ExplicitSolver::begin_smooth_joints() {
  const SmoothJoints& smooth = assembly_.smooth;
  if (smooth.empty()) return;
  smooth_laws_ = laws_for_kernels(assembly_);
  smooth_forces_.resize(kernels_know(assembly_) && !facets_.active() ? 0 : smooth.contacts.size());
  arrays_.smooth = {static_cast<std::int64_t>(smooth.contacts.size()),
                    smooth.contacts.data(),
                    smooth.settled.empty() ? nullptr : &smooth.settled[0].open_before,
                    smooth.law_number.data(),
                    smooth_laws_.data(),
                    smooth_forces_.empty() ? nullptr : smooth_forces_.data(),
                    smooth_from_.data()};
}

// Contacts of a tile or block whose laws the kernels do not know: which break, and the forces of all.
void ExplicitSolver::answer_smooth_joints(std::int64_t part, std::int64_t cycle, Found& found) {
  if (smooth_forces_.empty()) return;
  const auto p = static_cast<std::size_t>(part);
  for (auto k = smooth_from_[p]; k < smooth_from_[p + 1]; ++k) {
    const SmoothContact& contact = assembly_.smooth.contacts[static_cast<std::size_t>(k)];
    if (assembly_.intact[contact.bond] != 0) {
      const BondView bond = view_smooth(assembly_, contact);
      if (bond.breaks()) break_bond(bond, contact.bond, cycle, found.cracks);
    }
    smooth_forces_[static_cast<std::size_t>(k)] =
        answer_of(assembly_, contact, assembly_.slip[contact.bond], bond_sums_[p].work);
  }
}

// After breakage the forces are computed again, as those of what is left.
void ExplicitSolver::take_pairs(std::int64_t part, std::int64_t cycle, Found& found) {
  const CrossPart& p = plan_.cross_parts[static_cast<std::size_t>(part)];
  for (auto pair = p.first_pair; pair < p.last_pair; ++pair) {
    answer_smooth_joints(arrays_.tile_count + pair, cycle, found);
    kernels_.cross_bonds(arrays_, pair);
    if (!fragments_.kept() && break_cross_bonds(pair, cycle, found)) kernels_.cross_bonds(arrays_, pair);
  }
}

bool ExplicitSolver::break_cross_bonds(std::int64_t pair, std::int64_t cycle, Found& found) {
  if (bond_sums_[static_cast<std::size_t>(arrays_.tile_count + pair)].flagged == 0) return false;
  const TilePair& p = plan_.pairs[static_cast<std::size_t>(pair)];
  return break_bonds(p.first_bond, p.last_bond, cycle, found);
}

void ExplicitSolver::take_tile(std::int64_t tile, std::int64_t cycle, double* scratch, Found& found) {
  answer_smooth_joints(tile, cycle, found);
  kernels_.tile_forces(arrays_, tile, scratch);
  const auto t = static_cast<std::size_t>(tile);
  if (bond_sums_[t].flagged != 0 &&
      break_bonds(plan_.tiles[t].first_bond, plan_.tiles[t].last_bond, cycle, found))
    kernels_.tile_forces(arrays_, tile, scratch);
  kernels_.tile_move(arrays_, tile, scratch);
}

// Which of the rank's tiles nothing outside pushes, now and in the cycles to come: most, and they are spared three arrays.
void ExplicitSolver::mark_left_alone() {
  const auto zero = [](double force) { return std::bit_cast<std::uint64_t>(force) == 0; };
  const auto& a = assembly_;
  workers_.share(shared_.tile_count() >= 16 * workers_.count(), [&](const Workers::Member& member) {
    const auto mine = member.part(shared_.tile_count(), 1);
    for (auto t = shared_.first_tile() + mine.first; t < shared_.first_tile() + mine.last; ++t) {
      Tile& tile = plan_.tiles[static_cast<std::size_t>(t)];
      bool alone = true;
      for (const auto* force : {&a.external_x, &a.external_y, &a.external_moment})
        alone = alone && std::all_of(force->begin() + tile.first_disc, force->begin() + tile.last_disc, zero);
      tile.left_alone = alone ? 1 : 0;
    }
  });
  const auto pushed = [&](std::int32_t disc) {
    plan_.tiles[static_cast<std::size_t>(disc / tile_size)].left_alone = 0;
  };
  for (const auto& wall : boundary_.walls()) std::for_each(wall.discs.begin(), wall.discs.end(), pushed);
  for (const auto& grip : boundary_.grips()) pushed(grip.disc);
  if (boundary_.exterior() != nullptr)
    std::for_each(boundary_.edge().begin(), boundary_.edge().end(), pushed);
  for (const auto& disc : pushed_) pushed(disc.disc);
}

void ExplicitSolver::batch(std::int64_t cycles, std::vector<Found>& found) {
  take_facets();
  if (facets_.active()) facets_.begin_cycles();
  arrays_.stiffness = facets_.active() ? facets_.stiffness() : network_.stiffness.data();
  arrays_.undrained = undrained_ ? 1 : 0;
  begin_smooth_joints();
  mark_left_alone();
  if (may_block()) {
    run_blocked(cycles, found);
    return;
  }
  put_loads();
  show_everywhere();
  const Ranks& ranks = shared_.ranks();
  // A worker that finds no memory for its cracks may not leave the others waiting: it goes on to the end of the batch, and
  // then the step fails.
  // Of worker 0, who alone talks to other ranks and changes facets: all workers end the batch at the next barrier.
  std::exception_ptr failure;
  std::atomic<bool> lost{false};
  std::atomic<std::int64_t> flagged{-1};  // cycle in which a bond across tiles exceeds its strength
  const auto watched = [&](auto&& part) {
    try {
      part();
    } catch (const std::bad_alloc&) {
      no_memory_ = true;
    } catch (const Error&) {
      failure = std::current_exception();
      lost = true;
    }
  };
  const auto refill_parts = [&] {
    parts_left_.refill(workers_, shared_.inner_count());
    outer_parts_left_.refill(workers_, shared_.part_count() - shared_.inner_count());
  };
  std::int64_t done = 0;
  bool under_way = false;  // other ranks' discs, from the end of a cycle to where the next one needs them
  const std::function<void(int)> task = [&](int worker) {
    const auto w = static_cast<std::size_t>(worker);
    double* scratch = scratch_[w].data();
    const auto take_part = [&](std::int64_t item, std::int64_t now) {
      const auto part = shared_.part(item);
      if (arrays_.with_pressure != 0) kernels_.cross_domains(arrays_, part);
      take_pairs(part, now, shared_.is_own(item) ? found[w] : dropped_[w]);
      const CrossPart& p = plan_.cross_parts[static_cast<std::size_t>(part)];
      for (auto pair = p.first_pair; fragments_.kept() && pair < p.last_pair; ++pair) {
        if (bond_sums_[static_cast<std::size_t>(arrays_.tile_count + pair)].flagged != 0) flagged = now;
      }
    };
    for (std::int64_t cycle = done; cycle < cycles; ++cycle) {
      const std::int64_t now = total_cycles_ + cycle;
      // Whether a bond stays depends on others of its discs, maybe another worker's: then one worker breaks them all, in order.
      watched([&] { parts_left_.take(worker, [&](std::int64_t item) { take_part(item, now); }); });
      if (!ranks.alone()) {
        if (worker == 0 && under_way) {
          under_way = false;
          watched([&] { shared_.finish_exchange(assembly_); });
        }
        workers_.barrier();
        if (lost) return;
        watched([&] {
          outer_parts_left_.take(worker,
                                 [&](std::int64_t item) { take_part(shared_.inner_count() + item, now); });
        });
      }
      if (worker == 0 && boundary_.reacts()) {
        boundary_.cycle(assembly_, arrays_.step, options_.stepping_safety, arrays_.damping);
      }
      if (worker == 0) release_pushed();
      if (worker == 0 && !non_bonded_.empty()) non_bonded_.cycle(assembly_, arrays_.step, energies_.friction);
      if (worker == 0 && facets_.active()) {
        facets_.answer(undrained_);
        facets_.add_forces();
      }
      workers_.barrier();
      if (worker == 0) refill_parts();
      if (fragments_.kept() && !ranks.alone()) {
        if (worker == 0) {
          watched([&] {
            if (ranks.any(flagged == now)) flagged = now;
          });
        }
        workers_.barrier();
      }
      if (flagged == now) {
        if (worker == 0) watched([&] { break_across(now, found[0]); });
        workers_.barrier();
      }
      watched([&] {
        tiles_left_.take(worker, [&](std::int64_t item) {
          take_tile(shared_.first_tile() + item, now, scratch, found[w]);
        });
      });
      workers_.barrier();
      // Where other ranks' discs are needed before the next cycle comes to them.
      const bool at_once = facets_.active() || cycle + 1 == cycles;
      if (!ranks.alone()) {
        if (worker == 0) {
          watched([&] {
            shared_.start_exchange(assembly_);
            under_way = !at_once;
            if (!at_once) return;
            shared_.finish_exchange(assembly_);
            if (facets_.active() && ranks.any(facets_to_come_ == now)) facets_to_come_ = now;
          });
        }
        if (at_once) workers_.barrier();
      }
      if (facets_to_come_ == now) {
        if (worker == 0) watched([&] { break_into_facets(now, found); });
        workers_.barrier();
      }
      if (at_once && lost) return;
      if (worker == 0) {
        tiles_left_.refill(workers_, shared_.tile_count());
        done = cycle + 1;
      }
      if (workers_.cut_short()) return;
    }
  };
  while (done < cycles && !lost) {
    refill_parts();
    tiles_left_.refill(workers_, shared_.tile_count());
    workers_.run(task);
  }
  if (lost) std::rethrow_exception(failure);
  if (facets_.active()) facets_.end_cycles();
  total_cycles_ += cycles;
}

// Of what every rank needs to know in every cycle one worker of each finds the same.
void ExplicitSolver::show_everywhere() {
  if (shared_.ranks().alone()) return;
  std::vector<std::int32_t> discs;
  for (const auto& disc : pushed_) discs.push_back(disc.disc);
  for (const auto d : facets_.holes()) {
    for (auto k = network_.corner_start[d]; k < network_.corner_start[d + 1]; ++k)
      discs.push_back(network_.corner_disc[k]);
  }
  if (boundary_.reacts()) {
    discs.insert(discs.end(), boundary_.edge().begin(), boundary_.edge().end());
    for (const auto& grip : boundary_.grips()) discs.push_back(grip.disc);
  }
  shared_.show_everywhere(std::move(discs));
}

// Bonds across tiles that break where one worker breaks them all, in order: whether one stays depends on those before it.
void ExplicitSolver::break_across(std::int64_t cycle, Found& found) {
  TileSums* of_pairs = bond_sums_.data() + arrays_.tile_count;
  if (!shared_.ranks().alone()) {
    shared_.gather(assembly_, network_);
    shared_.gather(assembly_, of_pairs);
  }
  const auto first = plan_.cross_parts[static_cast<std::size_t>(shared_.first_tile())].first_pair,
             last = plan_.cross_parts[static_cast<std::size_t>(shared_.last_tile())].first_pair;
  for (std::int64_t pair = 0; pair < arrays_.pair_count; ++pair) {
    const bool own = shared_.ranks().alone() || (pair >= first && pair < last);
    if (break_cross_bonds(pair, cycle, own ? found : dropped_[0])) kernels_.cross_bonds(arrays_, pair);
  }
}

// Over this rank's parts, then over ranks; the works go to the ledger. Sums of parts are made in a fixed order, those of parts without
// rounding.
ExplicitSolver::Sums ExplicitSolver::sum_up(const std::vector<Found>& found) {
  enum { unbalanced, contact, friction, damping, fluid, momenta, count = momenta + 6 };
  std::array<ExactSum, count> sum{};
  const auto tiles = static_cast<std::size_t>(arrays_.tile_count);
  const auto add_bonds = [&](TileSums& of) {
    sum[contact].add(of.force);
    take_work(of, sum[friction]);
  };
  const bool still = scaled_ && boundary_.holds_still();
  std::vector<Boundary::RigidMotion> of_tiles;
  if (still && on_device_) of_tiles = device_cycles_->momenta();
  for (auto tile = shared_.first_tile(); tile < shared_.last_tile(); ++tile) {
    const auto t = static_cast<std::size_t>(tile);
    sum[unbalanced].add(disc_sums_[t].force);
    take_work(disc_sums_[t], sum[damping]);
    add_bonds(bond_sums_[t]);
    for (auto p = plan_.cross_parts[t].first_pair; p < plan_.cross_parts[t].last_pair; ++p)
      add_bonds(bond_sums_[tiles + static_cast<std::size_t>(p)]);
    take_work(domain_sums_[t], sum[fluid]);
    take_work(domain_sums_[tiles + t], sum[fluid]);
    if (!still) continue;
    const auto of_tile =
        on_device_ ? of_tiles[t]
                   : boundary_.momenta(assembly_, plan_.tiles[t].first_disc, plan_.tiles[t].last_disc);
    for (std::size_t k = 0; k < of_tile.size(); ++k) sum[momenta + k].add(of_tile[k]);
  }
  if (shared_.ranks().rank() == 0) take_work(domain_sums_[2 * tiles], sum[fluid]);
  Sums total;
  total.no_memory = no_memory_.exchange(false);
  for (const auto& part : found) total.broken = total.broken || !part.cracks.empty();
  if (!shared_.ranks().alone()) {
    forget_works_of_others();
    for (auto& part : dropped_) part = {};
    std::array<std::int64_t, 2> flags{total.no_memory ? 1 : 0, total.broken ? 1 : 0};
    add_over_ranks(shared_.ranks(), sum, flags);
    total.no_memory = flags[0] > 0;
    total.broken = flags[1] > 0;
  }
  if (total.no_memory) throw std::bad_alloc();
  total.unbalanced = sum[unbalanced].value();
  total.contact = sum[contact].value();
  energies_.friction += sum[friction].value();
  energies_.damping += sum[damping].value();
  energies_.fluid += sum[fluid].value();
  for (std::size_t k = 0; k < total.momenta.size(); ++k) total.momenta[k] = sum[momenta + k].value();
  return total;
}

// Of a shared evaluation, to the ledger: as sum_up.
void ExplicitSolver::take_own_works() {
  std::array<ExactSum, 2> sum{};
  auto& [friction, fluid] = sum;
  const auto tiles = static_cast<std::size_t>(arrays_.tile_count);
  for (auto tile = shared_.first_tile(); tile < shared_.last_tile(); ++tile) {
    const auto t = static_cast<std::size_t>(tile);
    take_work(bond_sums_[t], friction);
    for (auto p = plan_.cross_parts[t].first_pair; p < plan_.cross_parts[t].last_pair; ++p)
      take_work(bond_sums_[tiles + static_cast<std::size_t>(p)], friction);
    take_work(domain_sums_[t], fluid);
    take_work(domain_sums_[tiles + t], fluid);
  }
  if (shared_.ranks().rank() == 0) take_work(domain_sums_[2 * tiles], fluid);
  forget_works_of_others();
  std::array<std::int64_t, 2> none{};
  add_over_ranks(shared_.ranks(), sum, none);
  energies_.friction += friction.value();
  energies_.fluid += fluid.value();
}

// What was done for other ranks counts there.
void ExplicitSolver::forget_works_of_others() {
  for (auto* sums : {&bond_sums_, &domain_sums_})
    for (auto& of : *sums) of.work = 0.0;
}

// All that broke, on whatever worker or rank, in the order of breakage.
std::vector<Crack> ExplicitSolver::cracks_of(std::vector<Found>& found) const {
  std::vector<Crack> broken;
  for (auto& part : found) {
    broken.insert(broken.end(), part.cracks.begin(), part.cracks.end());
    part.cracks.clear();
  }
  broken = shared_.ranks().gather(broken);
  std::sort(broken.begin(), broken.end(), [](const Crack& a, const Crack& b) {
    return a.cycle != b.cycle ? a.cycle < b.cycle : a.bond < b.bond;
  });
  return broken;
}

// On the way to rest; real motion is left alone.
void ExplicitSolver::hold_still(const Sums& sums) {
  if (!scaled_ || !boundary_.holds_still()) return;
  const auto motion = boundary_.motion_of(sums.momenta);
  if (on_device_) {
    device_cycles_->take_out(motion);
    return;
  }
  shared_.for_each_known(assembly_, [&](std::int64_t disc) { boundary_.take_out(assembly_, motion, disc); });
}

}  // namespace hfrac

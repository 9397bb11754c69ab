// SPDX-License-Identifier: BSD-3-Clause
#include "solid/device_cycles.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <type_traits>

namespace hfrac {

DeviceCycles::DeviceCycles(const Device& device, const KernelArrays& arrays, const TilePlan& plan,
                           Assembly& assembly, Network& network, Boundary& boundary, const Options& options)
    : device_(device),
      host_(arrays),
      assembly_(assembly),
      network_(network),
      boundary_(boundary),
      options_(options),
      item_(device),
      sums_(device),
      large_works_(device),
      held_force_(device),
      momenta_(device),
      outside_(device),
      wall_discs_(device),
      wall_force_(device),
      pairs_(device),
      pushed_(device),
      pushed_pairs_(device),
      pairs_copy_(device),
      looked_(device),
      smooth_contacts_(device),
      smooth_settled_(device),
      smooth_law_number_(device),
      smooth_laws_(device),
      smooth_from_(device) {
  lay_out(plan);
  list_forces(plan);
  put(Travels::once);
}

void DeviceCycles::put(Travels when) {
  for (std::size_t k = 0; k < twins_.size(); ++k) {
    if (twins_[k].when == when) of_twins_[k].put(twins_[k].host, twins_[k].bytes);
  }
}

void DeviceCycles::get(Travels when) {
  for (std::size_t k = 0; k < twins_.size(); ++k) {
    if (twins_[k].when == when) of_twins_[k].get(twins_[k].host, twins_[k].bytes);
  }
}

template <class T>
void DeviceCycles::twin(T* host, std::int64_t count, T*& at, Travels when) {
  at = nullptr;
  if (host == nullptr || count == 0) return;
  const auto bytes = static_cast<std::size_t>(count) * sizeof(T);
  of_twins_.emplace_back(device_);
  at = static_cast<T*>(of_twins_.back().reserve(bytes));
  // What only goes there is not written here.
  twins_.push_back({const_cast<std::remove_const_t<T>*>(host), bytes, when});
}

template <class T>
void DeviceCycles::list(const std::vector<T>& values, const T*& at) {
  lists_.emplace_back(device_);
  lists_.back().put(values.data(), values.size() * sizeof(T));
  at = lists_.back().template as<T>();
}

void DeviceCycles::lay_out(const TilePlan& plan) {
  using enum Travels;
  const KernelArrays& h = host_;
  DeviceArrays& d = task_.d;
  KernelArrays& a = d.a;
  a = h;
  const auto discs = h.disc_count, bonds = h.bond_count;
  const auto domains = h.with_pressure != 0 ? network_.domain_count() : 0;
  const auto corners = domains > 0 ? static_cast<std::int64_t>(network_.corner_disc.size()) : 0;
  // Flow needs openings and normal forces: of rotations and of what bonds slid and softened only where those bear on them.
  const bool turns = h.flat != 0 || h.domain_corner_turn != nullptr || !assembly_.smooth.empty();
  const auto of_bonds = assembly_.smooth.empty() && h.softening_start == nullptr ? kept : moved;
  for (auto of : {&KernelArrays::ux, &KernelArrays::uy}) twin(h.*of, discs, a.*of, moved);
  twin(h.rotation, discs, a.rotation, turns ? moved : kept);
  for (auto of : {&KernelArrays::vx, &KernelArrays::vy, &KernelArrays::spin}) twin(h.*of, discs, a.*of, kept);
  for (auto of : {&KernelArrays::inverse_mass, &KernelArrays::inverse_inertia})
    twin(h.*of, discs, a.*of, there);
  twin(assembly_.external_x.data(), discs, d.external_x, kept);
  twin(assembly_.external_y.data(), discs, d.external_y, kept);
  twin(assembly_.external_moment.data(), discs, d.external_moment, kept);
  a.external_x = d.external_x;
  a.external_y = d.external_y;
  a.external_moment = d.external_moment;
  twin(h.first, bonds, a.first, once);
  twin(h.second, bonds, a.second, once);
  twin(h.geometry, assembly_.geometry.value_count(), a.geometry, once);
  twin(h.intact, bonds, a.intact, there);
  twin(h.slip, bonds, a.slip, of_bonds);
  for (auto of : {&KernelArrays::growth, &KernelArrays::stiffness_factor, &KernelArrays::tensile_factor,
                  &KernelArrays::shear_factor, &KernelArrays::bond_friction})
    twin(h.*of, bonds, a.*of, there);
  twin(h.softening_start, bonds, a.softening_start, of_bonds);
  twin(h.softening_worst, bonds, a.softening_worst, of_bonds);
  twin(h.domain_corner_start, domains > 0 ? domains + 1 : 0, a.domain_corner_start, once);
  twin(h.domain_corner_disc, corners, a.domain_corner_disc, once);
  twin(h.domain_corner_weight, 2 * corners, a.domain_corner_weight, once);
  twin(h.domain_corner_turn, corners, a.domain_corner_turn, once);
  twin(h.pressure, domains, a.pressure, pores);
  twin(h.volume_change, domains, a.volume_change, pores);
  twin(h.content, domains, a.content, fluid);
  twin(h.stiffness, domains, a.stiffness, fluid);
  twin(h.tiles, h.tile_count, a.tiles, there);
  twin(h.pairs, h.pair_count, a.pairs, once);
  twin(h.cross_parts, static_cast<std::int64_t>(plan.cross_parts.size()), a.cross_parts, once);
  twin(h.cross_domain, static_cast<std::int64_t>(plan.cross_domain.size()), a.cross_domain, once);
  twin(h.bond_slot, static_cast<std::int64_t>(plan.bond_slot.size()), a.bond_slot, once);
  twin(h.force_buffer, static_cast<std::int64_t>(plan.force_buffer.size()), a.force_buffer, once);
  // What stopped a batch, and its sums: one after the other, so that they come home at once.
  const auto of_bonds_count = static_cast<std::size_t>(h.tile_count + h.pair_count),
             tiles = static_cast<std::size_t>(h.tile_count);
  came_.resize(sizeof(std::int64_t) + (of_bonds_count + 3 * tiles) * sizeof(TileSums));
  d.stop = static_cast<std::int64_t*>(sums_.reserve(came_.size()));
  a.bond_sums = reinterpret_cast<TileSums*>(d.stop + 1);
  a.disc_sums = a.bond_sums + of_bonds_count;
  a.domain_sums = a.disc_sums + tiles;
  twin(static_cast<const double*>(assembly_.x.data()), discs, d.x, once);
  twin(static_cast<const double*>(assembly_.y.data()), discs, d.y, once);
  twin(static_cast<const double*>(assembly_.radius.data()), discs, d.radius, once);
  std::vector<std::int32_t> large;
  for (std::size_t place = 0; domains > 0 && place < plan.cross_domain.size(); ++place) {
    const auto* start = h.domain_corner_start + plan.cross_domain[place];
    if (plan.cross_domain[place] == 0) continue;  // the outside is the host's
    if (start[1] - start[0] > most_corners) large.push_back(static_cast<std::int32_t>(place));
  }
  large_pore_count_ = static_cast<std::int64_t>(large.size());
  list(large, d.large_pores);
  d.large_works = static_cast<double*>(large_works_.reserve(plan.cross_domain.size() * sizeof(double)));
  std::vector<double> mass;
  for (std::int64_t i = 0; i < discs; ++i) mass.push_back(assembly_.mass(i));
  list(mass, d.mass);
  d.centre_x = boundary_.centre().x;
  d.centre_y = boundary_.centre().y;
  d.held_force =
      static_cast<double*>(held_force_.reserve(3 * static_cast<std::size_t>(discs) * sizeof(double)));
  d.looked =
      static_cast<double*>(looked_.reserve(2 * static_cast<std::size_t>(h.tile_count) * sizeof(double)));
  d.momenta = static_cast<double*>(
      momenta_.reserve(static_cast<std::size_t>(h.tile_count) * sizeof(Boundary::RigidMotion)));
  for (const auto& tile : plan.tiles) {
    most_bonds_ = std::max(most_bonds_, tile.last_bond - tile.first_bond);
    most_domains_ = std::max(most_domains_, tile.last_domain - tile.first_domain);
  }
  for (std::int64_t part = 0; part < h.tile_count; ++part) {
    const auto& p = plan.cross_parts[static_cast<std::size_t>(part)];
    most_cross_domains_ = std::max(most_cross_domains_, p.last_domain - p.first_domain);
  }
}

// By disc, what adds to its force, in the order in which a worker comes to it.
void DeviceCycles::list_forces(const TilePlan& plan) {
  const auto discs = static_cast<std::size_t>(host_.disc_count);
  std::vector<std::int32_t> bond_start(discs + 1, 0), slot_start = bond_start, corner_start = bond_start,
                                                      cross_start = bond_start;
  const auto each_bond = [&](const auto& visit) {
    for (const auto& tile : plan.tiles) {
      for (auto e = tile.first_bond; e < tile.last_bond; ++e) {
        const auto at = static_cast<std::uint16_t>(2 * (e - tile.first_bond));
        visit(static_cast<std::size_t>(host_.first[e]), at);
        visit(static_cast<std::size_t>(host_.second[e]), static_cast<std::uint16_t>(at + 1));
      }
    }
  };
  const auto each_corner = [&](const auto& visit) {
    for (const auto& tile : plan.tiles) {
      for (auto k = tile.first_domain; host_.with_pressure != 0 && k < tile.last_domain; ++k) {
        for (auto c = host_.domain_corner_start[k]; c < host_.domain_corner_start[k + 1]; ++c)
          visit(static_cast<std::size_t>(host_.domain_corner_disc[c]),
                DeviceCorner{c, static_cast<std::int32_t>(k)});
      }
    }
  };
  const auto by_disc = [&](const auto& each, auto& start, auto& items) {
    each([&](std::size_t disc, const auto&) { ++start[disc + 1]; });
    for (std::size_t i = 0; i < discs; ++i) start[i + 1] += start[i];
    items.resize(static_cast<std::size_t>(start.back()));
    auto next = start;
    each([&](std::size_t disc, const auto& item) { items[static_cast<std::size_t>(next[disc]++)] = item; });
  };
  std::vector<std::uint16_t> bond_of;
  std::vector<DeviceCorner> corner_of;
  by_disc(each_bond, bond_start, bond_of);
  by_disc(each_corner, corner_start, corner_of);
  std::vector<CrossCorner> cross_corner;
  by_disc(
      [&](const auto& visit) {
        for (const auto& corner : plan.cross_corner) visit(static_cast<std::size_t>(corner.disc), corner);
      },
      cross_start, cross_corner);
  for (const auto& entry : plan.force_buffer) ++slot_start[static_cast<std::size_t>(entry.disc) + 1];
  std::partial_sum(slot_start.begin(), slot_start.end(), slot_start.begin());
  std::vector<DeviceBonds> bonds_of(discs);
  for (std::size_t i = 0; i < discs; ++i) {
    const auto count = bond_start[i + 1] - bond_start[i];
    const auto* first = bond_of.data() + bond_start[i];
    const auto number = [&](std::int32_t q) -> std::uint64_t {
      if (q == disc_bonds - 1 && count > disc_bonds) return more_bonds;
      return q < count ? first[q] : no_bond;
    };
    for (std::int32_t q = 0; q < disc_bonds; ++q)
      (q < 4 ? bonds_of[i].first : bonds_of[i].second) |= number(q) << static_cast<unsigned>(16 * (q % 4));
  }
  DeviceArrays& d = task_.d;
  list(bonds_of, d.bonds_of);
  list(bond_start, d.bond_start);
  list(bond_of, d.bond_of);
  list(slot_start, d.slot_start);
  list(cross_start, d.cross_start);
  list(cross_corner, d.a.cross_corner);
  list(corner_start, d.corner_start);
  list(corner_of, d.corner_of);
}

// Numbers that the host changes are those of now.
void DeviceCycles::take_numbers() {
  KernelArrays& a = task_.d.a;
  a.damping = host_.damping;
  a.step = host_.step;
  a.reference_pressure = host_.reference_pressure;
  a.floor_pressure = host_.floor_pressure;
  a.undrained = host_.undrained;
}

void DeviceCycles::begin(std::span<const Pushed> pushed, const ContactPairs& contacts) {
  using enum Travels;
  take_numbers();
  for (const auto what : {there, fluid, moved, kept, pores}) put(what);
  put_smooth_joints();
  plain_ = host_.softening_start == nullptr && host_.flat == 0 && host_.smooth.contacts == nullptr;
  put_walls();
  put_contacts(pushed, contacts);
}

// Volumes are as the device left them.
void DeviceCycles::go_on() {
  take_numbers();
  put(Travels::fluid);
  for (std::size_t k = 0; k < twins_.size(); ++k)
    if (twins_[k].host == host_.pressure) of_twins_[k].put(twins_[k].host, twins_[k].bytes);
}

void DeviceCycles::put_smooth_joints() {
  const SmoothArrays& h = host_.smooth;
  SmoothArrays& to = task_.d.a.smooth;
  to = {};
  if (h.contacts == nullptr) return;
  const SmoothJoints& joints = assembly_.smooth;
  const auto count = static_cast<std::size_t>(h.count);
  const auto put = [](DeviceArray& array, const auto* values, std::size_t items) {
    array.put(values, items * sizeof *values);
    return array.as<std::remove_reference_t<decltype(*values)>>();
  };
  to.count = h.count;
  to.contacts = put(smooth_contacts_, joints.contacts.data(), count);
  if (h.settled != nullptr) to.settled = put(smooth_settled_, h.settled, 4 * count);
  to.law_number = put(smooth_law_number_, h.law_number, joints.law_number.size());
  to.laws = put(smooth_laws_, h.laws, joints.laws.size());
  to.from = put(smooth_from_, h.from, static_cast<std::size_t>(host_.tile_count + host_.pair_count) + 1);
}

void DeviceCycles::put_walls() {
  DeviceArrays& d = task_.d;
  d.walled = boundary_.walled() ? 1 : 0;
  d.servo = boundary_.walls_move() ? 1 : 0;
  d.wall_stiffness = boundary_.contact_stiffness();
  std::vector<DeviceWallDisc> discs;
  std::map<std::int32_t, std::size_t> place_of;
  std::int32_t places = 0;
  for (std::size_t w = 0; w < boundary_.walls().size(); ++w) {
    const Wall& wall = boundary_.walls()[w];
    DeviceWall& to = walls_.walls[w];
    to.first = places;
    for (const auto i : wall.discs) {
      const auto [at, is_new] = place_of.try_emplace(i, discs.size());
      if (is_new) discs.push_back({i, {-1, -1}, {-1, -1}, assembly_.thermal.growth_of(i)});
      DeviceWallDisc& disc = discs[at->second];
      const int side = disc.wall[0] < 0 ? 0 : 1;
      disc.wall[side] = static_cast<std::int32_t>(w);
      disc.place[side] = places++;
    }
    to.last = places;
    to.inward_x = wall.inward.x;
    to.inward_y = wall.inward.y;
    to.target = boundary_.load() * wall.target * wall.length;
    to.floor = 1e-9 * d.wall_stiffness * wall.length;
    to.mass = boundary_.wall_mass(wall, host_.step, options_.stepping_safety);
  }
  wall_discs_.put(discs.data(), discs.size() * sizeof(DeviceWallDisc));
  d.wall_discs = wall_discs_.as<DeviceWallDisc>();
  d.wall_disc_count = static_cast<std::int64_t>(discs.size());
  d.wall_force = static_cast<double*>(wall_force_.reserve(static_cast<std::size_t>(places) * sizeof(double)));
  d.outside = static_cast<DeviceOutside*>(outside_.reserve(sizeof(DeviceOutside)));
}

void DeviceCycles::put_contacts(std::span<const Pushed> pushed, const ContactPairs& contacts) {
  contacts_.clear();
  std::vector<std::vector<std::int32_t>> of_disc(pushed.size());
  const auto place = [&](std::int32_t disc) {
    const auto at = std::lower_bound(pushed.begin(), pushed.end(), disc,
                                     [](const Pushed& p, std::int32_t i) { return p.disc < i; });
    return static_cast<std::size_t>(at - pushed.begin());
  };
  const auto& thermal = assembly_.thermal;
  for (const auto& pair : contacts.pairs) {
    const auto number = 2 * static_cast<std::int32_t>(contacts_.size());
    of_disc[place(pair.first)].push_back(number);
    of_disc[place(pair.second)].push_back(number + 1);
    const double share = thermal.pair_stiffness(pair.first, pair.second);
    DevicePair to{};
    to.first = pair.first;
    to.second = pair.second;
    to.normal = options_.contact_normal_stiffness * share;
    to.shear = options_.contact_shear_stiffness * share;
    to.friction = options_.contact_friction * thermal.pair_friction(pair.first, pair.second);
    to.growth_first = thermal.growth_of(pair.first);
    to.growth_second = thermal.growth_of(pair.second);
    to.reference_gap = pair.reference_gap;
    to.normal_force = pair.normal_force;
    to.shear_force = pair.shear_force;
    contacts_.push_back(to);
  }
  std::vector<DevicePushedDisc> discs;
  std::vector<std::int32_t> pairs;
  for (std::size_t k = 0; k < pushed.size(); ++k) {
    const auto first = static_cast<std::int64_t>(pairs.size());
    pairs.insert(pairs.end(), of_disc[k].begin(), of_disc[k].end());
    discs.push_back({pushed[k].disc, first, static_cast<std::int64_t>(pairs.size()), pushed[k].load.x,
                     pushed[k].load.y, pushed[k].walled ? 1 : 0});
  }
  DeviceArrays& d = task_.d;
  pairs_.put(contacts_.data(), contacts_.size() * sizeof(DevicePair));
  pushed_.put(discs.data(), discs.size() * sizeof(DevicePushedDisc));
  pushed_pairs_.put(pairs.data(), pairs.size() * sizeof(std::int32_t));
  d.pairs = pairs_.as<DevicePair>();
  d.pushed = pushed_.as<DevicePushedDisc>();
  d.pushed_pairs = pushed_pairs_.as<std::int32_t>();
  d.contact_count = static_cast<std::int64_t>(contacts_.size());
  d.pushed_count = static_cast<std::int64_t>(discs.size());
}

// By what changes in a cycle in one block's hands.
bool DeviceCycles::is_pushed() const {
  return (task_.d.walled != 0 && task_.d.servo != 0) || task_.d.pushed_count > 0;
}

void DeviceCycles::begin_batch(double friction) {
  clear_sums();
  if (task_.d.walled == 0 && !is_pushed()) return;
  for (std::size_t w = 0; w < boundary_.walls().size(); ++w) {
    walls_.walls[w].displacement = boundary_.walls()[w].displacement;
    walls_.walls[w].velocity = boundary_.walls()[w].velocity;
  }
  walls_.work = boundary_.wall_work();
  walls_.imbalance = 0.0;
  walls_.friction = friction;
  outside_.put(&walls_, sizeof walls_);
}

void DeviceCycles::end_batch(double& friction) {
  if (!sums_are_home_) get_sums();
  if (is_pushed()) {
    outside_.get(&walls_, sizeof walls_);
    friction = walls_.friction;
  }
  if (task_.d.walled == 0) return;
  for (std::size_t w = 0; w < boundary_.walls().size(); ++w) {
    boundary_.walls()[w].displacement = walls_.walls[w].displacement;
    boundary_.walls()[w].velocity = walls_.walls[w].velocity;
  }
  boundary_.note_walls(walls_.work, walls_.imbalance);
}

// Returns the stage that stopped the batch.
std::int64_t DeviceCycles::get_sums() {
  sums_.get(came_.data(), came_.size());
  std::int64_t stop = never_stopped;
  const std::byte* from = came_.data();
  const auto take = [&from](auto* to, std::int64_t count) {
    const auto bytes = static_cast<std::size_t>(count) * sizeof *to;
    std::memcpy(to, from, bytes);
    from += bytes;
  };
  take(&stop, 1);
  take(host_.bond_sums, host_.tile_count + host_.pair_count);
  take(host_.disc_sums, host_.tile_count);
  take(host_.domain_sums, 2 * host_.tile_count);
  sums_are_home_ = true;
  return stop;
}

void DeviceCycles::launch(DeviceKernel kernel, std::int64_t blocks) {
  const std::int64_t domains = kernel == device_cross_pores ? most_cross_domains_ : most_domains_;
  device_.launch(kernel, blocks, device_shared_bytes(kernel, most_bonds_, domains), &task_, sizeof task_);
}

void DeviceCycles::launch_one(DeviceKernel kernel, std::int64_t item) {
  const auto number = static_cast<std::int32_t>(item);
  sums_are_home_ = false;
  item_.put(&number, sizeof number);
  task_.list = item_.as<std::int32_t>();
  launch(kernel, 1);
  task_.list = nullptr;
}

// As the host's are before a batch.
void DeviceCycles::clear_sums() {
  const auto most = std::max(host_.tile_count + host_.pair_count, 2 * host_.tile_count);
  launch(device_clear_sums, (most + device_threads - 1) / device_threads);
}

void DeviceCycles::answer_pores_across() {
  launch(device_large_pores, large_pore_count_);
  launch(device_cross_pores, host_.tile_count);
}

std::int64_t DeviceCycles::run(std::int64_t stage, std::int64_t last) {
  const KernelArrays& h = host_;
  if (stage > 0) sums_.put(&never_stopped, sizeof never_stopped);
  const auto wants_forces = [last](std::int64_t of) { return of >= last - 2 ? 1 : 0; };
  for (; stage < last; ++stage) {
    task_.stage = stage;
    task_.wants_forces = wants_forces(stage);
    if (stage % 2 == 1) {
      launch(plain_ ? device_plain_tile_step : device_tile_step, h.tile_count);
      continue;
    }
    if (h.with_pressure != 0 && h.undrained != 0) answer_pores_across();
    launch(plain_ ? device_plain_cross_pairs : device_cross_pairs, h.pair_count);
    if (task_.d.walled != 0)
      launch(device_press_walls, (task_.d.wall_disc_count + device_threads - 1) / device_threads);
    if (is_pushed()) launch(device_push, 1);
  }
  task_.stage = std::min(get_sums(), last);  // of what is done again
  task_.wants_forces = wants_forces(task_.stage);
  return task_.stage;
}

template <class T>
void DeviceCycles::get(T* host, const T* at, std::int64_t first, std::int64_t last) {
  if (at != nullptr && last > first)
    device_.download(host + first, at + first, static_cast<std::size_t>(last - first) * sizeof(T));
}

void DeviceCycles::get_bonds(std::int64_t first, std::int64_t last) {
  const KernelArrays& a = task_.d.a;
  get(host_.slip, a.slip, first, last);
  get(host_.softening_start, a.softening_start, first, last);
  get(host_.softening_worst, a.softening_worst, first, last);
}

void DeviceCycles::get_discs(std::int64_t first, std::int64_t last) {
  const KernelArrays& a = task_.d.a;
  get(host_.ux, a.ux, first, last);
  get(host_.uy, a.uy, first, last);
  get(host_.rotation, a.rotation, first, last);
}

void DeviceCycles::get_tile(std::int64_t tile) {
  const Tile& t = host_.tiles[tile];
  get_discs(t.first_disc, t.last_disc);
  get_bonds(t.first_bond, t.last_bond);
}

void DeviceCycles::get_pair(std::int64_t pair) {
  const TilePair& p = host_.pairs[pair];
  for (const auto disc : {host_.first[p.first_bond], host_.second[p.first_bond]}) {
    const Tile& t = host_.tiles[disc / tile_size];
    get_discs(t.first_disc, t.last_disc);
  }
  get_bonds(p.first_bond, p.last_bond);
}

void DeviceCycles::put_broken(std::int64_t first, std::int64_t last) {
  device_.upload(const_cast<std::uint8_t*>(task_.d.a.intact) + first, host_.intact + first,
                 static_cast<std::size_t>(last - first));
}

void DeviceCycles::repeat_pair(std::int64_t pair) {
  launch_one(plain_ ? device_plain_cross_pairs : device_cross_pairs, pair);
}

void DeviceCycles::repeat_tile(std::int64_t tile) {
  task_.moves_anyway = 1;
  launch_one(plain_ ? device_plain_tile_step : device_tile_step, tile);
  task_.moves_anyway = 0;
}

void DeviceCycles::move_tile(std::int64_t tile) {
  launch_one(device_tile_move, tile);
}

std::vector<Boundary::RigidMotion> DeviceCycles::momenta() {
  launch(device_momenta, host_.tile_count);
  std::vector<Boundary::RigidMotion> of_tiles(static_cast<std::size_t>(host_.tile_count));
  momenta_.get(of_tiles.data(), of_tiles.size() * sizeof(Boundary::RigidMotion));
  return of_tiles;
}

void DeviceCycles::take_out(const Boundary::RigidMotion& motion) {
  std::copy(motion.begin(), motion.end(), task_.motion);
  launch(device_take_out, host_.tile_count);
}

void DeviceCycles::evaluate() {
  clear_sums();
  task_.stage = 0;
  task_.looks_only = task_.wants_forces = 1;
  task_.d.a.undrained = 1;  // volumes are looked at
  if (host_.with_pressure != 0) answer_pores_across();
  launch(plain_ ? device_plain_cross_pairs : device_cross_pairs, host_.pair_count);
  launch(plain_ ? device_plain_tile_step : device_tile_step, host_.tile_count);
  task_.looks_only = 0;
  get_sums();
}

DeviceCycles::Look DeviceCycles::look_over() {
  launch(device_look_over, host_.tile_count);
  std::vector<double> looked(2 * static_cast<std::size_t>(host_.tile_count));
  looked_.get(looked.data(), looked.size() * sizeof(double));
  Look all{0.0, true};
  for (std::size_t k = 0; k < looked.size(); k += 2) {
    all.kinetic += looked[k];
    all.finite = all.finite && looked[k + 1] == 0.0;
  }
  return all;
}

void DeviceCycles::get_displacements() {
  get_discs(0, host_.disc_count);
}

// Without the outside, whose volume the host alone follows.
void DeviceCycles::get_pores() {
  if (host_.with_pressure == 0) return;
  const KernelArrays& a = task_.d.a;
  get(host_.pressure, static_cast<const double*>(a.pressure), 1, network_.domain_count());
  get(host_.volume_change, static_cast<const double*>(a.volume_change), 1, network_.domain_count());
}

void DeviceCycles::get_moved() {
  get(Travels::moved);
  get_pores();
}

void DeviceCycles::take_contacts(ContactPairs& contacts) const {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts.pairs[k].normal_force = contacts_[k].normal_force;
    contacts.pairs[k].shear_force = contacts_[k].shear_force;
  }
}

void DeviceCycles::get_state(ContactPairs& contacts) {
  get_moved();
  get(Travels::kept);
  pairs_.get(contacts_.data(), contacts_.size() * sizeof(DevicePair));
  take_contacts(contacts);
}

void DeviceCycles::keep() {
  const auto copy = [&](DeviceArray& to, const DeviceArray& from, std::size_t bytes) {
    if (bytes > 0) device_.copy(to.reserve(bytes), from.as<void>(), bytes, 1);
  };
  while (copies_.size() < twins_.size()) copies_.emplace_back(device_);
  for (std::size_t k = 0; k < twins_.size(); ++k)
    if (twins_[k].when == Travels::kept) copy(copies_[k], of_twins_[k], twins_[k].bytes);
  copy(pairs_copy_, pairs_, contacts_.size() * sizeof(DevicePair));
  contacts_kept_ = contacts_.size();
}

void DeviceCycles::get_kept(ContactPairs& contacts) {
  for (std::size_t k = 0; k < twins_.size(); ++k)
    if (twins_[k].when == Travels::kept) copies_[k].get(twins_[k].host, twins_[k].bytes);
  contacts_.resize(contacts_kept_);  // of those found since it knows nothing
  pairs_copy_.get(contacts_.data(), contacts_.size() * sizeof(DevicePair));
  take_contacts(contacts);
}

void DeviceCycles::spoil_host() const {
  for (const auto& twin : twins_) {
    if (twin.when != Travels::kept) continue;
    auto* values = static_cast<double*>(twin.host);
    std::fill(values, values + twin.bytes / sizeof(double), 1e99);
  }
}

}  // namespace hfrac

// SPDX-License-Identifier: BSD-3-Clause
// One simulation on several ranks.
#include "hfrac/exchange.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/ranks.hpp"
#include "internal.hpp"
#include "options/number_text.hpp"
#include "sim_handle.hpp"
#include "step/simulation.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

hfrac_exchange default_exchange() {
  hfrac_exchange exchange{};
  exchange.struct_size = sizeof exchange;
  exchange.size = 1;
  return exchange;
}

hfrac_linear_solver default_solver() {
  hfrac_linear_solver solver{};
  solver.struct_size = sizeof solver;
  return solver;
}

void require_sound(const hfrac_exchange& given) {
  constexpr std::int32_t most = 1048576;
  if (given.size < 1 || given.size > most)
    throw Error(ErrorKind::argument, "hfrac_exchange: size is " + std::to_string(given.size) +
                                         "; it has to be 1 to " + std::to_string(most) +
                                         ", the number of ranks.");
  if (given.rank < 0 || given.rank >= given.size)
    throw Error(ErrorKind::argument, "hfrac_exchange: rank is " + std::to_string(given.rank) + "; with " +
                                         std::to_string(given.size) + " ranks it has to be 0 to " +
                                         std::to_string(given.size - 1) + ".");
  const bool whole = given.start != nullptr && given.finish != nullptr && given.sum != nullptr &&
                     given.gather != nullptr && given.fail != nullptr;
  if (given.size > 1 && !whole)
    throw Error(ErrorKind::argument,
                "hfrac_exchange: a function is NULL; with more than one rank start, finish, sum, gather and "
                "fail have to be given.");
}

const hfrac_linear_solver& solver(void* user) {
  return *static_cast<const hfrac_linear_solver*>(user);
}

const OutsideSolver* take_solver(hfrac_sim& sim) {
  static_assert(sizeof(MatrixRows) == sizeof(hfrac_matrix) &&
                offsetof(MatrixRows, count) == offsetof(hfrac_matrix, count) &&
                offsetof(MatrixRows, value) == offsetof(hfrac_matrix, value));
  sim.linear_solver =
      read_struct(sim.exchange.linear_solver, default_solver(), "hfrac_exchange: linear_solver");
  const auto& given = sim.linear_solver;
  if (given.prepare == nullptr || given.solve == nullptr || given.release == nullptr ||
      given.reason == nullptr)
    throw Error(ErrorKind::argument, "hfrac_linear_solver: a function is NULL; all four have to be given.");
  OutsideSolver& of = sim.solver;
  of.user = &sim.linear_solver;
  of.prepare = [](void* user, const MatrixRows* matrix, void** prepared) {
    return solver(user).prepare(solver(user).user, reinterpret_cast<const hfrac_matrix*>(matrix), prepared);
  };
  of.solve = [](void* user, void* prepared, const double* right, double* x, double tolerance,
                std::int32_t* iterations) {
    return solver(user).solve(solver(user).user, prepared, right, x, tolerance, iterations);
  };
  of.release = [](void* user, void* prepared) { return solver(user).release(solver(user).user, prepared); };
  of.reason = [](void* user, char* text, std::int64_t size) {
    return solver(user).reason(solver(user).user, text, size);
  };
  return &of;
}

const hfrac_exchange& table(void* user) {
  return *static_cast<const hfrac_exchange*>(user);
}

}  // namespace

Ranks hfrac::capi::ranks_of(hfrac_sim& sim) {
  hfrac_exchange& kept = sim.exchange;
  static_assert(sizeof(Message) == sizeof(hfrac_message) &&
                offsetof(Message, receive_bytes) == offsetof(hfrac_message, receive_bytes) &&
                offsetof(Message, receive) == offsetof(hfrac_message, receive));
  Exchange exchange{kept.rank, std::max(kept.size, 1), &kept};
  if (kept.linear_solver != nullptr) exchange.solver = take_solver(sim);
  exchange.start = [](void* user, const Message* messages, std::int32_t count) {
    return table(user).start(table(user).user, reinterpret_cast<const hfrac_message*>(messages), count);
  };
  exchange.finish = [](void* user) { return table(user).finish(table(user).user); };
  exchange.sum = [](void* user, std::int64_t* values, std::int32_t count) {
    return table(user).sum(table(user).user, values, count);
  };
  exchange.gather = [](void* user, void* all, const std::int64_t* begin) {
    return table(user).gather(table(user).user, all, begin);
  };
  exchange.fail = [](void* user) { return table(user).fail(table(user).user); };
  if (kept.fail_text != nullptr)
    exchange.fail_text = [](void* user, const char* text) {
      return table(user).fail_text(table(user).user, text);
    };
  if (kept.failed != nullptr)
    exchange.failed = [](void* user, std::int32_t* rank, char* text, std::int32_t size) {
      return table(user).failed(table(user).user, rank, text, size);
    };
  return Ranks(exchange);
}

int32_t hfrac_exchange_init(hfrac_exchange* exchange, int32_t struct_size) {
  return guarded([&] { put_defaults(exchange, struct_size, default_exchange(), "exchange"); });
}

int32_t hfrac_linear_solver_init(hfrac_linear_solver* solver, int32_t struct_size) {
  return guarded([&] { put_defaults(solver, struct_size, default_solver(), "solver"); });
}

int32_t hfrac_sim_create_on(const hfrac_sim_def* def, const hfrac_exchange* exchange, hfrac_sim** sim) {
  return guarded([&] {
    require_not_null(sim, "sim");
    *sim = nullptr;
    const hfrac_exchange given = read_struct(exchange, default_exchange(), "hfrac_exchange");
    require_sound(given);
    return create(def, given, sim);
  });
}

int32_t hfrac_get_traffic(const hfrac_sim* sim, hfrac_traffic* traffic) {
  return guarded_sim(sim, [&] {
    const auto t = sim->simulation->engine_as_is().mechanics->shared_tiles().traffic();
    hfrac_traffic of{};
    of.messages = t.messages;
    of.bytes = t.bytes;
    of.foreign_discs = t.foreign_discs;
    of.shared_bonds = t.shared_bonds;
    write_struct(traffic, of, "hfrac_traffic");
  });
}

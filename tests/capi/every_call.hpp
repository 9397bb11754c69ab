// SPDX-License-Identifier: BSD-3-Clause
// Every function of the C interface in one table, with good arguments for each, and for each type of argument the values no
// host should give. What is done with them stands in every_call_test.cpp. A function without a row fails a test.
#pragma once

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim_support.hpp"

namespace testing_capi {

// With temperature, so that what sets one has a meaning.
inline hfrac::Definition warm_def() {
  hfrac::Definition def = quiet_def(200);
  def.thermal_mode = 2;
  return def;
}

inline hfrac_exchange one_rank() {
  hfrac_exchange exchange;
  hfrac_exchange_init(&exchange, sizeof exchange);
  return exchange;
}

// What the calls write to and read from; larger than any of them needs.
struct Ground {
  hfrac_sim* sim = nullptr;
  hfrac_sim* made = nullptr;  // by hfrac_sim_create, or to be destroyed
  hfrac_exchange exchange = one_rank();
  hfrac_linear_solver linear_solver{};
  hfrac::Definition def = warm_def(), read;
  std::vector<double> reals = std::vector<double>(1U << 17U, 30e6);
  std::vector<int32_t> numbers = std::vector<int32_t>(1U << 17U);
  std::vector<unsigned char> bytes = std::vector<unsigned char>(1U << 23U);
  char text[4096] = "";
  int32_t number = 0, other = 0, third = 0;
  int64_t big = 0, next = 0, discs = 0;
  double real = 0.0;
  const void* data = nullptr;
  std::string case_file, trace_file, record_file, state_file, grdecl_file;
  std::vector<unsigned char> image;
  std::vector<double> kelvins = std::vector<double>(1U << 17U, 550.0);
  std::vector<hfrac_crack> cracks = std::vector<hfrac_crack>(64);
  std::vector<hfrac_slip> slips = std::vector<hfrac_slip>(64);
  hfrac_lab* lab = nullptr;       // a finished test
  hfrac_lab* lab_made = nullptr;  // by hfrac_lab_run, or to be destroyed
  hfrac_lab_spec spec{};
  hfrac_targets targets{};
  hfrac_grid grid{};
  const char* folderless = "/nonexistent/folder/x";

  template <class Struct>
  Struct* sized() {
    auto* made_of_bytes = reinterpret_cast<Struct*>(bytes.data());
    std::memset(bytes.data(), 0, sizeof(Struct));
    made_of_bytes->struct_size = sizeof(Struct);
    return made_of_bytes;
  }
  hfrac_sim_def* empty_def() {
    hfrac_sim_def_free(&read);
    return &read;
  }
  template <class Struct>
  Struct* several() {
    return reinterpret_cast<Struct*>(bytes.data());
  }
};

// Why a value is no good, and so what the status has to be.
enum class Fault { null, handle, size, not_finite, odd };

template <class T>
struct Bad {
  T value;
  Fault fault;
};

template <class T>
constexpr bool is_sized_struct = requires(T t) {
  t.struct_size;
};

// What bad values point to.
using Kept = std::vector<std::vector<unsigned char>>;

// The bad values of a type.
template <class T>
std::vector<Bad<T>> bad_values(Kept& kept) {
  using Pointed = std::remove_const_t<std::remove_pointer_t<T>>;
  if constexpr (std::is_same_v<T, double>) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{std::nan(""), Fault::not_finite},
            {inf, Fault::not_finite},
            {-inf, Fault::not_finite},
            {-1.0, Fault::odd},
            {1e308, Fault::odd},
            {5e-324, Fault::odd}};
  } else if constexpr (std::is_integral_v<T>) {
    return {{std::numeric_limits<T>::min(), Fault::odd},
            {T{-1}, Fault::odd},
            {T{0}, Fault::odd},
            {T{7}, Fault::odd},
            {std::numeric_limits<T>::max(), Fault::odd},
            {std::numeric_limits<T>::max() / 3, Fault::odd}};
  } else if constexpr (std::is_same_v<T, const char*>) {
    kept.emplace_back(1U << 20U, 'x');
    kept.back().back() = 0;
    return {{nullptr, Fault::null},
            {"", Fault::odd},
            {reinterpret_cast<const char*>(kept.back().data()), Fault::odd},
            {"/nonexistent/\xff\xfe", Fault::odd}};
  } else if constexpr (std::is_same_v<Pointed, hfrac_sim>) {
    hfrac_sim* gone = nullptr;
    static const hfrac::Definition def = quiet_def(200);
    EXPECT_EQ(hfrac_sim_create(&def, &gone), HFRAC_OK);
    hfrac_sim* const copy = gone;
    EXPECT_EQ(hfrac_sim_destroy(&gone), HFRAC_OK);
    kept.emplace_back(1U << 14U, 0xEE);
    return {{nullptr, Fault::handle},
            {copy, Fault::handle},
            {reinterpret_cast<T>(kept.back().data()), Fault::handle}};
  } else if constexpr (std::is_same_v<Pointed, hfrac_lab>) {
    kept.emplace_back(1U << 10U, 0xEE);
    return {{nullptr, Fault::handle}, {reinterpret_cast<T>(kept.back().data()), Fault::handle}};
  } else if constexpr (std::is_pointer_v<T> && std::is_function_v<std::remove_pointer_t<T>>) {
    return {{nullptr, Fault::odd}};
  } else if constexpr (is_sized_struct<Pointed>) {
    std::vector<Bad<T>> bad = {{nullptr, Fault::null}};
    for (const int32_t size : {0, -1, 4, 12, 65544, std::numeric_limits<int32_t>::max()}) {
      auto& memory =
          kept.emplace_back(sizeof(Pointed), 0xEE);  // of its true size: sanitizers see a byte beyond
      std::memcpy(memory.data(), &size, sizeof size);
      bad.push_back({reinterpret_cast<T>(memory.data()), Fault::size});
    }
    return bad;
  } else {
    return {{nullptr, Fault::null}};
  }
}

// A bad value for the argument number `at`; `put` writes it where the argument stands.
struct Change {
  std::size_t at;
  Fault fault;
  std::function<void(void* argument)> put;
};

template <class T>
void add_changes(std::size_t at, bool may_be_null, Kept& kept, std::vector<Change>& changes) {
  for (const auto& bad : bad_values<T>(kept)) {
    const bool allowed = may_be_null && (bad.fault == Fault::null || bad.value == T{});
    changes.push_back({at, allowed ? Fault::odd : bad.fault,
                       [value = bad.value](void* argument) { *static_cast<T*>(argument) = value; }});
  }
}

// One function of the interface. What is made anew for each stays short: the compiler has two hundred of them to translate.
struct Row {
  std::string name;
  bool takes_sim;  // as a handle, to read or to change
  bool changes;    // refused inside a callback
  // Calls it with good arguments but for those that are changed.
  std::function<int32_t(Ground&, const std::vector<const Change*>&)> call;
  std::function<std::vector<Change>(Kept&)> bad;
  int32_t good(Ground& ground) const { return call(ground, {}); }
};

// `optional`: arguments, counted from 0, that may be NULL.
template <class... P, class Good>
Row make_row(const char* name, int32_t (*function)(P...), bool changes, std::set<std::size_t> optional,
             Good good) {
  Row row;
  row.name = name;
  row.takes_sim = (std::is_same_v<std::remove_const_t<std::remove_pointer_t<P>>, hfrac_sim> || ...);
  row.changes = changes;
  row.call = [=](Ground& ground, const std::vector<const Change*>& changed) {
    return std::apply(
        [&](auto... argument) {
          void* const at[] = {&argument...};
          for (const auto* change : changed) change->put(at[change->at]);
          return function(argument...);
        },
        std::tuple<P...>(good(ground)));
  };
  row.bad = [optional = std::move(optional)](Kept& kept) {
    std::vector<Change> all;
    std::size_t at = 0;
    ((add_changes<P>(at, optional.count(at) != 0, kept, all), ++at), ...);
    return all;
  };
  return row;
}

std::vector<Row> every_call();

}  // namespace testing_capi

// SPDX-License-Identifier: BSD-3-Clause
// One walk over a simulation's state serves saving, restoring and hashing: Simulation::visit_state lists every value once,
// and the archives here say what happens to it. A value forgotten in one of the three cannot be.
//
// The bytes are those of the machine (little-endian here; the image's header says so), doubles bit for bit.
// What is kept to undo a step is read by the process that wrote it and by nobody else; it is compact: of arrays that are often zero
// only the rest is kept, where that is shorter, and of a log its length, since going back cuts off what came later.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/workers.hpp"

namespace hfrac {

// Of the arrays' values, how many are not zero to the last bit.
template <class Values>
std::int64_t others_than_zero(const Values& values, Workers* workers = nullptr) {
  std::atomic<std::int64_t> all{0};
  share_items(workers, static_cast<std::int64_t>(values.size()), [&](std::int64_t first, std::int64_t last) {
    std::int64_t others = 0;
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k)
      others += std::bit_cast<std::uint64_t>(static_cast<double>(values[k])) != 0 ? 1 : 0;
    all += others;
  });
  return all;
}

// Place and value of each, instead of all values.
template <class Values>
bool shorter_by_place(const Values& values, Workers* workers = nullptr) {
  constexpr std::int64_t place_and_value = sizeof(std::int32_t) + sizeof(double);
  return others_than_zero(values, workers) * place_and_value <
         static_cast<std::int64_t>(values.size() * sizeof(double));
}

// How many bytes the others write or read. Workers, if any, share what is long, here as below.
class Counter {
 public:
  explicit Counter(bool compact = false, Workers* workers = nullptr) : compact_(compact), workers_(workers) {}
  template <class Value>
  void value(const Value&) {
    size_ += sizeof(Value);
  }
  template <class Values>
  void array(const Values& values) {
    size_ += sizeof(std::int64_t) + values.size() * sizeof values[0];
  }
  template <class Values>
  void mostly_zero(const Values& values) {
    size_ += 2 * sizeof(std::int64_t) + 12 * static_cast<std::size_t>(others_than_zero(values, workers_));
  }
  template <class Values>
  void often_zero(const Values& values) {
    size_ += compact_ ? sizeof(bool) : 0;
    if (compact_ && shorter_by_place(values, workers_)) {
      mostly_zero(values);
    } else {
      array(values);
    }
  }
  template <class Flags>
  void flags(const Flags& values) {
    size_ += sizeof(std::int64_t) + (compact_ ? (values.size() + 7) / 8 : values.size());
  }
  template <class Values, class Item>
  void list(const Values& values, Item&& item) {
    size_ += sizeof(std::int64_t);
    for (const auto& element : values) item(*this, element);
  }
  template <class Values, class Item>
  void log(const Values& values, Item&& item) {
    if (compact_)
      size_ += sizeof(std::int64_t);
    else
      list(values, item);
  }
  void require(bool /*sound*/) const {}
  [[nodiscard]] std::size_t size() const { return size_; }
  static constexpr bool loading = false;

 private:
  bool compact_;
  Workers* workers_;
  std::size_t size_ = 0;
};

// Writes into memory of the size a Counter found.
class Saver {
 public:
  explicit Saver(std::span<std::byte> to, bool compact = false, Workers* workers = nullptr)
      : to_(to), compact_(compact), workers_(workers) {}
  template <class Value>
  void value(const Value& v) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
    append(&v, sizeof v);
  }
  // An array whose length the model fixes.
  template <class Values>
  void array(const Values& values) {
    value(static_cast<std::int64_t>(values.size()));
    append(values.data(), values.size() * sizeof values[0]);
  }
  // The same, for an array most of which is zero: length, number of others, their places and values.
  template <class Values>
  void mostly_zero(const Values& values) {
    std::int64_t others = others_than_zero(values, workers_);
    value(static_cast<std::int64_t>(values.size()));
    value(others);
    constexpr std::size_t block = 64;
    for (std::size_t first = 0; others > 0 && first < values.size(); first += block) {
      const std::size_t last = std::min(values.size(), first + block);
      std::uint64_t any = 0;
      for (auto k = first; k < last; ++k) any |= std::bit_cast<std::uint64_t>(static_cast<double>(values[k]));
      for (auto k = first; any != 0 && k < last; ++k) {
        if (std::bit_cast<std::uint64_t>(static_cast<double>(values[k])) == 0) continue;
        value(static_cast<std::int32_t>(k));
        value(values[k]);
        --others;
      }
    }
  }
  // An array that may be zero here and there: in an image as any other, compact as is shorter.
  template <class Values>
  void often_zero(const Values& values) {
    const bool by_place = compact_ && shorter_by_place(values, workers_);
    if (compact_) value(by_place);
    if (by_place) {
      mostly_zero(values);
    } else {
      array(values);
    }
  }
  // Bytes that are 0 or 1: in an image as they are, compact as bits.
  template <class Flags>
  void flags(const Flags& values) {
    if (!compact_) {
      array(values);
      return;
    }
    value(static_cast<std::int64_t>(values.size()));
    const std::size_t bytes = (values.size() + 7) / 8;
    const std::span<std::byte> to = take(bytes);
    share_items(workers_, static_cast<std::int64_t>(bytes), [&](std::int64_t first, std::int64_t last) {
      for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
        unsigned bits = 0;
        for (std::size_t b = 0; b < 8 && 8 * k + b < values.size(); ++b)
          bits |= values[8 * k + b] != 0 ? 1U << b : 0U;
        to[k] = static_cast<std::byte>(bits);
      }
    });
  }
  // A list that grows and shrinks; item(archive, element) visits one.
  template <class Values, class Item>
  void list(const Values& values, Item&& item) {
    value(static_cast<std::int64_t>(values.size()));
    for (const auto& element : values) item(*this, element);
  }
  // A list that only grows.
  template <class Values, class Item>
  void log(const Values& values, Item&& item) {
    if (compact_)
      value(static_cast<std::int64_t>(values.size()));
    else
      list(values, item);
  }
  void require(bool /*sound*/) const {}
  static constexpr bool loading = false;

 private:
  std::span<std::byte> take(std::size_t size) {
    if (size > to_.size()) throw Error(ErrorKind::internal, "a state is larger than it was counted.");
    const auto taken = to_.first(size);
    to_ = to_.subspan(size);
    return taken;
  }
  void append(const void* data, std::size_t size) {
    constexpr std::int64_t worth_sharing = 1 << 17, grain = 1 << 12;
    const std::span<std::byte> to = take(size);
    if (size == 0) return;
    share_items(
        workers_, static_cast<std::int64_t>(size),
        [&](std::int64_t first, std::int64_t last) {
          std::memcpy(to.data() + first, static_cast<const std::byte*>(data) + first,
                      static_cast<std::size_t>(last - first));
        },
        worth_sharing, grain);
  }
  std::span<std::byte> to_;
  bool compact_;
  Workers* workers_;
};

// Reads back, never past the end. Throws Error(argument) if the bytes are not those of such a simulation.
class Loader {
 public:
  explicit Loader(std::span<const std::byte> from, bool compact = false) : from_(from), compact_(compact) {}
  template <class Value>
  void value(Value& v) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
    if constexpr (std::is_same_v<Value, bool>) {
      unsigned char byte = 0;
      take(&byte, 1);
      require(byte <= 1);
      v = byte == 1;
    } else {
      take(&v, sizeof v);
    }
  }
  // What a number read must fulfil to be used as an index. A checksum protects against accidents, not against intent.
  void require(bool sound) const {
    if (!sound) refuse();
  }
  template <class Values>
  void array(Values& values) {
    std::int64_t count = 0;
    value(count);
    if (count != static_cast<std::int64_t>(values.size())) refuse();
    take(values.data(), values.size() * sizeof values[0]);
  }
  template <class Values>
  void mostly_zero(Values& values) {
    std::int64_t count = 0, others = 0;
    value(count);
    value(others);
    if (count != static_cast<std::int64_t>(values.size())) refuse();
    for (auto& v : values) v = 0.0;
    for (; others > 0; --others) {
      std::int32_t place = 0;
      value(place);
      if (place < 0 || place >= count) refuse();
      value(values[static_cast<std::size_t>(place)]);
    }
  }
  template <class Values>
  void often_zero(Values& values) {
    bool by_place = false;
    if (compact_) value(by_place);
    if (by_place) {
      mostly_zero(values);
    } else {
      array(values);
    }
  }
  template <class Flags>
  void flags(Flags& values) {
    if (!compact_) {
      array(values);
      return;
    }
    std::int64_t count = 0;
    value(count);
    if (count != static_cast<std::int64_t>(values.size())) refuse();
    for (std::size_t k = 0; k < values.size(); k += 8) {
      unsigned char bits = 0;
      value(bits);
      for (std::size_t b = 0; b < 8 && k + b < values.size(); ++b) values[k + b] = (bits >> b) & 1U;
    }
  }
  template <class Values, class Item>
  void list(Values& values, Item&& item) {
    std::int64_t count = 0;
    value(count);
    if (count < 0 || static_cast<std::uint64_t>(count) > from_.size()) refuse();
    values.resize(static_cast<std::size_t>(count));
    for (auto& element : values) item(*this, element);
  }
  template <class Values, class Item>
  void log(Values& values, Item&& item) {
    std::int64_t count = 0;
    value(count);
    if (count < 0 || static_cast<std::uint64_t>(count) > (compact_ ? values.size() : from_.size())) refuse();
    if (compact_) {
      values.cut(static_cast<std::size_t>(count));
      return;
    }
    values.clear();
    for (; count > 0; --count) {
      typename Values::value_type element;
      item(*this, element);
      values.load(element);
    }
  }
  [[nodiscard]] std::size_t left() const { return from_.size(); }
  static constexpr bool loading = true;

 private:
  [[noreturn]] static void refuse() {
    throw Error(
        ErrorKind::argument,
        "the state image does not fit this simulation: it was taken from another model, or is damaged.");
  }
  void take(void* to, std::size_t size) {
    if (size > from_.size()) refuse();
    if (size > 0) std::memcpy(to, from_.data(), size);
    from_ = from_.subspan(size);
  }
  std::span<const std::byte> from_;
  bool compact_;
};

// What looks at a state takes all arrays alike, however they are kept.
template <class Look>
class ReadOnly {
 public:
  template <class Flags>
  void flags(const Flags& values) {
    look().array(values);
  }
  template <class Values>
  void often_zero(const Values& values) {
    look().array(values);
  }
  template <class Values>
  void mostly_zero(const Values& values) {
    look().array(values);
  }
  template <class Values, class Item>
  void log(const Values& values, Item&& item) {
    look().list(values, item);
  }
  void require(bool /*sound*/) const {}
  static constexpr bool loading = false;

 private:
  friend Look;
  ReadOnly() = default;
  Look& look() { return static_cast<Look&>(*this); }
};

// By their bits, since compilers put no comparisons of numbers side by side that may not be ones: adding one to an exponent of ones alone
// makes a sign.
inline bool all_finite(const double* values, std::size_t count) {
  constexpr std::uint64_t exponent = 0x7ffULL << 52, one = 1ULL << 52;
  std::uint64_t signs = 0;
  for (std::size_t k = 0; k < count; ++k) signs |= (std::bit_cast<std::uint64_t>(values[k]) & exponent) + one;
  return (signs >> 63) == 0;
}

// Whether every number it is shown is finite.
class FiniteCheck : public ReadOnly<FiniteCheck> {
 public:
  explicit FiniteCheck(Workers* workers = nullptr) : workers_(workers) {}
  template <class Value>
  void value(const Value& v) {
    if constexpr (std::is_floating_point_v<Value>) finite_ = finite_ && std::isfinite(v);
  }
  template <class Values>
  void array(const Values& values) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(values[0])>>) {
      std::atomic<bool> all{finite_};
      share_items(workers_, static_cast<std::int64_t>(values.size()),
                  [&](std::int64_t first, std::int64_t last) {
                    if (!all_finite(values.data() + first, static_cast<std::size_t>(last - first)))
                      all = false;
                  });
      finite_ = all;
    }
  }
  template <class Values, class Item>
  void list(const Values& values, Item&& item) {
    for (const auto& element : values) item(*this, element);
  }
  [[nodiscard]] bool finite() const { return finite_; }

 private:
  Workers* workers_;
  bool finite_ = true;
};

// Hashes what it is shown.
class Hasher : public ReadOnly<Hasher> {
 public:
  template <class Value>
  void value(const Value& v) {
    if constexpr (std::is_floating_point_v<Value>) {
      hash_.add(static_cast<double>(v));
    } else {
      hash_.add(static_cast<std::uint64_t>(v));
    }
  }
  template <class Values>
  void array(const Values& values) {
    for (const auto& v : values) value(v);
  }
  template <class Values, class Item>
  void list(const Values& values, Item&& item) {
    value(static_cast<std::int64_t>(values.size()));
    for (const auto& element : values) item(*this, element);
  }
  [[nodiscard]] std::uint64_t result() const { return hash_.value(); }

 private:
  Hash hash_;
};

}  // namespace hfrac

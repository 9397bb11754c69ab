// SPDX-License-Identifier: BSD-3-Clause
// Arrays of the engine: std::vector on cache-line boundaries, so that every kernel may load whole vectors from the
// start of an array.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <numbers>
#include <utility>
#include <vector>

namespace hfrac {

// Asks for pages of 2 MB under large arrays: fewer address translations where a step streams through all of them
// (docs/performance.md). A hint; nothing happens where the system knows no such pages.
void advise_large_pages(void* array, std::size_t bytes) noexcept;

// Gives pages back to the system that lie unused between what is in use, as building a model leaves them; the process's peak is
// lower by them later. Nothing happens where the C library cannot.
void return_unused_pages() noexcept;

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) noexcept {
  }  // NOLINT: the standard wants it implicit
  T* allocate(std::size_t n) {
    T* p = static_cast<T*>(::operator new(n * sizeof(T), alignment));
    advise_large_pages(p, n * sizeof(T));
    return p;
  }
  void deallocate(T* p, std::size_t /*n*/) noexcept { ::operator delete(p, alignment); }
  template <class U>
  bool operator==(const CacheLineAllocator<U>& /*other*/) const noexcept {
    return true;
  }
};

template <class T>
using Array = std::vector<T, CacheLineAllocator<T>>;

// Of numbers that are written before they are read: resize() leaves new ones as the memory was.
template <class T>
struct UnfilledAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UnfilledAllocator<U>;
  };
  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Given>
  void construct(U* place, Given&&... given) {
    ::new (static_cast<void*>(place)) U(std::forward<Given>(given)...);
  }
};
using UnfilledVector = std::vector<double, UnfilledAllocator<double>>;

struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const Vec2&) const = default;
};
inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator*(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}
// A quarter turn clockwise.
inline Vec2 clockwise(Vec2 a) {
  return {a.y, -a.x};
}
inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
// From `a` anticlockwise to `b`, 0 to 2 pi.
inline double angle_between(Vec2 a, Vec2 b) {
  const double angle = std::atan2(cross(a, b), dot(a, b));
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

}  // namespace hfrac

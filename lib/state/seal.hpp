// SPDX-License-Identifier: BSD-3-Clause
// Bytes that say what they are: magic, format, byte order, a fingerprint of the model, length and checksum of what follows. What is cut,
// damaged, of another kind, format or machine is refused in words before anything of it is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hfrac {

struct SealKind {
  char magic[9];
  std::uint32_t format;
  const char* refusal;  // "the state image cannot be restored: "
  const char* what;     // "an image"
  const char* fix;      // of another format
};

inline constexpr std::size_t seal_size = 40;  // bytes before the body

// Over the first seal_size bytes of `whole`, whose rest is written.
void put_seal(std::span<std::byte> whole, const SealKind& kind, std::uint64_t model);

struct Sealed {
  std::span<const std::byte> body;
  std::uint64_t model;
};
// Throws Error(argument).
Sealed open_seal(std::span<const std::byte> whole, const SealKind& kind);

}  // namespace hfrac

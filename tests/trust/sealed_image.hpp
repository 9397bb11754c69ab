// SPDX-License-Identifier: BSD-3-Clause
// State images with changed bytes under a checksum that is right again: what an accident does not make, a test does.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/hash.hpp"

namespace testing_trust {

inline constexpr std::size_t image_head = 40;  // magic 8, format 4, byte order 4, model 8, size 8, checksum 8

// Length and checksum as lib/step/image.cpp makes them.
inline void seal(std::vector<std::uint8_t>& image) {
  if (image.size() < image_head) return;
  const std::uint64_t size = image.size() - image_head;
  std::memcpy(image.data() + 24, &size, 8);
  std::array<std::uint64_t, 5> words{};
  std::memcpy(words.data(), image.data(), image_head);
  hfrac::Hash hash;
  hash.add(words[2]);
  hash.add(words[3]);
  hash.add((words[1] << 32U) | (words[1] >> 32U));  // format, byte order
  std::size_t k = image_head;
  for (; k + 8 <= image.size(); k += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, image.data() + k, 8);
    hash.add(word);
  }
  for (; k < image.size(); ++k) hash.add(static_cast<std::uint64_t>(image[k]));
  const std::uint64_t sum = hash.value();
  std::memcpy(image.data() + 32, &sum, 8);
}

}  // namespace testing_trust

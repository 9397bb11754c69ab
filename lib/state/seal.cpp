// SPDX-License-Identifier: BSD-3-Clause
#include "state/seal.hpp"

#include <cstring>
#include <string>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace hfrac {
namespace {

struct Header {
  char magic[8];
  std::uint32_t format;
  std::uint32_t byte_order;
  std::uint64_t model, size, checksum;  // the checksum is of the header before it and of the body
};
static_assert(sizeof(Header) == seal_size);
constexpr std::uint32_t our_byte_order = 0x01020304;

std::uint64_t checksum(const Header& header, std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(header.model);
  hash.add(header.size);
  hash.add((static_cast<std::uint64_t>(header.format) << 32U) | header.byte_order);
  std::size_t k = 0;
  for (; k + 8 <= bytes.size(); k += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + k, 8);
    hash.add(word);
  }
  for (; k < bytes.size(); ++k) hash.add(static_cast<std::uint64_t>(bytes[k]));
  return hash.value();
}

}  // namespace

void put_seal(std::span<std::byte> whole, const SealKind& kind, std::uint64_t model) {
  const auto body = whole.subspan(seal_size);
  Header header{};
  std::memcpy(header.magic, kind.magic, sizeof header.magic);
  header.format = kind.format;
  header.byte_order = our_byte_order;
  header.model = model;
  header.size = body.size();
  header.checksum = checksum(header, body);
  std::memcpy(whole.data(), &header, sizeof header);
}

Sealed open_seal(std::span<const std::byte> whole, const SealKind& kind) {
  const auto refuse = [&](const std::string& why) { throw Error(ErrorKind::argument, kind.refusal + why); };
  const std::string what = kind.what;
  Header header{};
  if (whole.size() < sizeof header) refuse("it is shorter than " + what + "'s header.");
  std::memcpy(&header, whole.data(), sizeof header);
  const auto body = whole.subspan(sizeof header);
  if (std::memcmp(header.magic, kind.magic, sizeof header.magic) != 0)
    refuse("it is not " + what + " of this library.");
  if (header.byte_order != our_byte_order) refuse("it comes from a machine of the other byte order.");
  if (header.format != kind.format) {
    refuse("its format is " + std::to_string(header.format) + ", and this library reads format " +
           std::to_string(kind.format) + "; " + kind.fix);
  }
  if (header.size != body.size()) {
    refuse("it should be " + std::to_string(header.size + sizeof header) + " bytes long and is " +
           std::to_string(whole.size()) + ": it was cut, or something was added.");
  }
  if (header.checksum != checksum(header, body)) refuse("it is damaged: its checksum differs.");
  return {body, header.model};
}

}  // namespace hfrac

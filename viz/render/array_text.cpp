// SPDX-License-Identifier: BSD-3-Clause
#include "array_text.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <span>
#include <system_error>

namespace hfrac::viz {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t best_compression = 1100;  // no method here packs tighter than this

constexpr std::array<std::int8_t, 256> base64_values() {
  std::array<std::int8_t, 256> values{};
  for (auto& value : values) value = -1;
  const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (int i = 0; i < 64; ++i) values[static_cast<unsigned char>(letters[i])] = static_cast<std::int8_t>(i);
  return values;
}

// The text is one or more base64 runs behind each other (sizes and data are coded apart), so padding may come
// in the middle; groups of four letters stand for themselves.
Bytes from_base64(const std::string& text) {
  static constexpr auto values = base64_values();
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int letters = 0;
  int padding = 0;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isspace(code) != 0) continue;
    if (letter == '=') {
      ++padding;
    } else if (values[code] < 0 || padding > 0) {
      throw ArrayDamage("its text is not base64");
    }
    group = group << 6 | (letter == '=' ? 0U : static_cast<std::uint32_t>(values[code]));
    if (++letters < 4) continue;
    if (padding > 2) throw ArrayDamage("its text is not base64");
    bytes.push_back(static_cast<std::uint8_t>(group >> 16));
    if (padding < 2) bytes.push_back(static_cast<std::uint8_t>(group >> 8));
    if (padding < 1) bytes.push_back(static_cast<std::uint8_t>(group));
    group = 0;
    letters = 0;
    padding = 0;
  }
  if (letters != 0) throw ArrayDamage("its text ends too early");
  return bytes;
}

// Takes sizes from the front of the bytes.
class SizeReader {
 public:
  SizeReader(std::span<const std::uint8_t> bytes, bool wide) : bytes_(bytes), width_(wide ? 8 : 4) {}

  std::uint64_t next() {
    if (bytes_.size() < width_) throw ArrayDamage("its sizes are cut off");
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < width_; ++i) value |= static_cast<std::uint64_t>(bytes_[i]) << (8 * i);
    bytes_ = bytes_.subspan(width_);
    return value;
  }
  std::uint64_t possible() const { return bytes_.size() / width_; }
  std::span<const std::uint8_t> rest() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t width_;
};

Bytes uncompressed(const Bytes& coded, const ArrayCoding& coding) {
  SizeReader sizes(coded, coding.wide_headers);
  const std::uint64_t block_count = sizes.next();
  if (block_count == 0) return {};
  const std::uint64_t block_size = sizes.next();
  const std::uint64_t last_size = sizes.next();
  if (block_count > sizes.possible()) throw ArrayDamage("it has fewer blocks than it says");
  std::vector<std::uint64_t> packed(block_count);
  for (std::uint64_t& size : packed) size = sizes.next();
  std::span<const std::uint8_t> rest = sizes.rest();
  Bytes plain;
  for (std::uint64_t i = 0; i < block_count; ++i) {
    const std::uint64_t wanted = i + 1 == block_count && last_size > 0 ? last_size : block_size;
    if (packed[i] > rest.size() || wanted > best_compression * (packed[i] + 1)) {
      throw ArrayDamage("a block's size does not fit");
    }
    const std::size_t start = plain.size();
    plain.resize(start + wanted);
    if (coding.compressor->Uncompress(rest.data(), packed[i], plain.data() + start, wanted) != wanted) {
      throw ArrayDamage("a block cannot be unpacked");
    }
    rest = rest.subspan(packed[i]);
  }
  return plain;
}

template <class Number>
std::vector<double> numbers(const Bytes& bytes) {
  if (bytes.size() % sizeof(Number) != 0) throw ArrayDamage("its length is not a whole number of values");
  std::vector<double> values(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < values.size(); ++i) {
    Number number;
    std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
    values[i] = static_cast<double>(number);
  }
  return values;
}

std::vector<double> numbers_of_type(const Bytes& bytes, const std::string& type) {
  if (type == "Float64") return numbers<double>(bytes);
  if (type == "Float32") return numbers<float>(bytes);
  if (type == "Int64") return numbers<std::int64_t>(bytes);
  if (type == "UInt64") return numbers<std::uint64_t>(bytes);
  if (type == "Int32") return numbers<std::int32_t>(bytes);
  if (type == "UInt32") return numbers<std::uint32_t>(bytes);
  if (type == "Int16") return numbers<std::int16_t>(bytes);
  if (type == "UInt16") return numbers<std::uint16_t>(bytes);
  if (type == "Int8") return numbers<std::int8_t>(bytes);
  if (type == "UInt8") return numbers<std::uint8_t>(bytes);
  throw ArrayDamage("its type \"" + type + "\" is unknown");
}

// Not strtod: that one obeys the host's locale.
std::vector<double> from_ascii(const std::string& text) {
  std::vector<double> values;
  const char* position = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    while (position != end && std::isspace(static_cast<unsigned char>(*position)) != 0) ++position;
    if (position == end) return values;
    double value = 0;
    const auto [next, error] = std::from_chars(position, end, value);
    if (error != std::errc()) throw ArrayDamage("its text is not a number");
    values.push_back(value);
    position = next;
  }
}

}  // namespace

std::vector<double> decode_array(const std::string& text, const std::string& type, const std::string& format,
                                 const ArrayCoding& coding) {
  if (format == "ascii") return from_ascii(text);
  const bool appended = format == "appended";
  if (format != "binary" && !appended)
    throw ArrayDamage("its format \"" + format + "\" is neither binary, ascii nor appended");
  const Bytes coded = appended ? Bytes(text.begin(), text.end()) : from_base64(text);
  if (coding.compressor != nullptr) return numbers_of_type(uncompressed(coded, coding), type);
  if (coded.empty()) return {};
  SizeReader sizes(coded, coding.wide_headers);
  const std::uint64_t size = sizes.next();
  const auto rest = sizes.rest();
  // Appended bytes may be followed by some that belong to nothing.
  if (appended ? size > rest.size() : size != rest.size()) throw ArrayDamage("it is not as long as it says");
  return numbers_of_type({rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size)}, type);
}

}  // namespace hfrac::viz

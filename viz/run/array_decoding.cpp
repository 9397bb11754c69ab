// SPDX-License-Identifier: BSD-3-Clause
#include <libdeflate.h>
#include <lz4.h>
#include <lzma.h>

#include <cctype>
#include <charconv>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <system_error>

#include "run/array_coding.hpp"
#include "run/text.hpp"

namespace hfrac::run {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t best_compression = 1100;  // no method here packs tighter than this

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

/** Unpacks one block into `to`, which is as long as the block was; says whether it was. */
class Unpacker {
 public:
  explicit Unpacker(Compression compression)
      : compression_(compression), zlib_(libdeflate_alloc_decompressor(), libdeflate_free_decompressor) {
    if (!zlib_) throw std::bad_alloc();
  }

  bool unpack(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) const {
    if (compression_ == Compression::zlib) {
      return libdeflate_zlib_decompress(zlib_.get(), from.data(), from.size(), to.data(), to.size(),
                                        nullptr) == LIBDEFLATE_SUCCESS;
    }
    if (compression_ == Compression::lz4) {
      constexpr std::size_t most = std::numeric_limits<int>::max();
      if (from.size() > most || to.size() > most) return false;
      return LZ4_decompress_safe(reinterpret_cast<const char*>(from.data()),
                                 reinterpret_cast<char*>(to.data()), static_cast<int>(from.size()),
                                 static_cast<int>(to.size())) == static_cast<int>(to.size());
    }
    std::uint64_t most_memory = std::uint64_t{1} << 30U;  // [byte]
    std::size_t taken = 0, made = 0;
    return lzma_stream_buffer_decode(&most_memory, 0, nullptr, from.data(), &taken, from.size(), to.data(),
                                     &made, to.size()) == LZMA_OK &&
           made == to.size();
  }

 private:
  Compression compression_;
  std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> zlib_;
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
  const Unpacker unpacker(coding.compression);
  for (std::uint64_t i = 0; i < block_count; ++i) {
    const std::uint64_t wanted = i + 1 == block_count && last_size > 0 ? last_size : block_size;
    if (packed[i] > rest.size() || wanted > best_compression * (packed[i] + 1)) {
      throw ArrayDamage("a block's size does not fit");
    }
    const std::size_t start = plain.size();
    plain.resize(start + wanted);
    if (!unpacker.unpack(rest.first(packed[i]), std::span(plain).subspan(start)))
      throw ArrayDamage("a block cannot be unpacked");
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

std::vector<double> numbers_of_type(const Bytes& bytes, std::string_view type) {
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
  throw ArrayDamage("its type \"" + std::string(type) + "\" is unknown");
}

// Not strtod: that one obeys the host's locale.
std::vector<double> from_ascii(std::string_view text) {
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

std::vector<double> decode_array(std::string_view text, std::string_view type, std::string_view format,
                                 const ArrayCoding& coding) {
  if (format == "ascii") return from_ascii(text);
  const bool appended = format == "appended";
  if (format != "binary" && !appended)
    throw ArrayDamage("its format \"" + std::string(format) + "\" is neither binary, ascii nor appended");
  Bytes coded;
  if (appended) {
    coded.assign(text.begin(), text.end());
  } else if (auto bytes = from_base64(text)) {
    coded = *std::move(bytes);
  } else {
    throw ArrayDamage("its text is not base64");
  }
  if (coding.compression != Compression::none) return numbers_of_type(uncompressed(coded, coding), type);
  if (coded.empty()) return {};
  SizeReader sizes(coded, coding.wide_headers);
  const std::uint64_t size = sizes.next();
  const auto rest = sizes.rest();
  // Appended bytes may be followed by some that belong to nothing.
  if (appended ? size > rest.size() : size != rest.size()) throw ArrayDamage("it is not as long as it says");
  return numbers_of_type({rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size)}, type);
}

}  // namespace hfrac::run

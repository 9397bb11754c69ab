// SPDX-License-Identifier: BSD-3-Clause
// The numbers of an array as they stand in a VTK XML file: cut into blocks, each packed by itself, with their sizes in
// front; as base64 inside the XML. Written inline only; read as ascii, inline or appended.
//
// Packing is most of the time that a snapshot takes. libdeflate makes the same zlib streams as zlib, at a third of the cost, and
// blocks are packed side by side (build/bin/bench_output). In reading every size is checked against what is there before it is
// used: VTK's own readers trust what a file says about itself and end the process on some damaged ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::run {

/** The words of output.compression, in their order, and one that only others write. */
enum class Compression : int32_t { zlib = 0, lz4 = 1, none = 2, lzma = 3 };

/** What the first tag of a file calls it: "vtkZLibDataCompressor"; empty for none. */
std::string_view compressor_name(Compression compression);
/** Nothing if the name is unknown. */
std::optional<Compression> compression_named(std::string_view name);

/** An array's numbers in the machine's little-endian order. */
using RawBytes = std::span<const std::byte>;

/** words[0], the coded form of arrays[0], words[1], ... : one word more than arrays. Up to `workers` threads code blocks side by
 * side; the text is the same for any number. */
std::string with_coded_arrays(std::span<const std::string> words, std::span<const RawBytes> arrays,
                              Compression compression, int workers);

/** What is wrong with an array, without the file's name. */
class ArrayDamage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** What the file's first tag says about all its arrays. */
struct ArrayCoding {
  bool wide_headers = false;  ///< sizes are 64 bits wide, else 32
  Compression compression = Compression::none;
};

/** `type` as in the file, "Float64", "Int32", ...; `format` "ascii", "binary" or "appended". Throws ArrayDamage. */
std::vector<double> decode_array(std::string_view text, std::string_view type, std::string_view format,
                                 const ArrayCoding& coding);

}  // namespace hfrac::run

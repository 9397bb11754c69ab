// SPDX-License-Identifier: BSD-3-Clause
// The numbers of an array as they stand in a VTU file: cut into blocks, each packed by itself, with their
// sizes in front; as base64 if they stand inside the XML.
//
// Packing is most of the time that a snapshot takes. libdeflate makes the same zlib streams as zlib, at a
// third of the cost; a million discs with six arrays are below a second (tests/bench/output_bench.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace hfrac::output {

// The words of output.compression and output.layout, in their order.
enum class Compression : int32_t { zlib = 0, lz4 = 1, none = 2 };
enum class Layout : int32_t { inlined = 0, appended = 1 };

struct Coding {
  Compression compression = Compression::zlib;
  Layout layout = Layout::inlined;
};

/** What the first tag of a file says about packing, with a blank in front; empty for none. */
const char* compressor_attribute(Compression compression);

/** Adds the coded form of `bytes`, numbers in the machine's little-endian order, to `text`. */
void append_coded(std::string& text, std::span<const std::byte> bytes, Coding coding);

}  // namespace hfrac::output

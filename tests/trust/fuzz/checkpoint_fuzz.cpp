// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a checkpoint, with and without a checksum that is right: refused with a sentence, or taken and packed again as it was.
#include <libdeflate.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "output/checkpoint.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hfrac::output;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (size > 40 && (data[size - 1] & 1U) != 0) {  // lengths and checksum are made to fit
    const std::uint64_t content = size - 40, course = content * 3 / 4, image = content - course;
    std::memcpy(bytes.data() + 16, &course, 8);
    std::memcpy(bytes.data() + 24, &image, 8);
    std::memset(bytes.data() + 32, 0, 4);
    const auto sum = libdeflate_crc32(0, bytes.data(), size);
    std::memcpy(bytes.data() + 32, &sum, 4);
  }
  try {
    const Checkpoint read = unpack_checkpoint(bytes);
    const Checkpoint again = unpack_checkpoint(pack_checkpoint(read));
    if (again.step != read.step || again.image != read.image ||
        again.snapshots.size() != read.snapshots.size())
      std::abort();
  } catch (const CheckpointError& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  return 0;
}

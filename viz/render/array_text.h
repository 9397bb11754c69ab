// SPDX-License-Identifier: BSD-3-Clause
// One <DataArray> of a VTK XML file into numbers: ascii, or binary with or without compression, inline as base64
// or appended as raw bytes.
//
// VTK's own readers trust what a file says about itself and end the process on some damaged ones. Here every
// size is checked against what is there before it is used, so damage of any kind is an error and nothing
// else.
#pragma once

#include <vtkDataCompressor.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace hfrac::viz {

// What is wrong with an array, without the file's name.
class ArrayDamage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What the file's first tag says about all its arrays.
struct ArrayCoding {
  bool wide_headers = false;                      // sizes are 64 bits wide, else 32
  vtkSmartPointer<vtkDataCompressor> compressor;  // null: not compressed
};

// `type` as in the file, "Float64", "Int32", ...; `format` "ascii", "binary" or "appended". Throws ArrayDamage.
std::vector<double> decode_array(const std::string& text, const std::string& type, const std::string& format,
                                 const ArrayCoding& coding);

}  // namespace hfrac::viz

// SPDX-License-Identifier: BSD-3-Clause
// Gives an array's memory back. Neither clear() does that nor `array = {}`, which assigns an empty list of values.
#pragma once

namespace hfrac {

template <class Array>
void give_back(Array& array) {
  Array().swap(array);
}

}  // namespace hfrac

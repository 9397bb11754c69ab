// SPDX-License-Identifier: BSD-3-Clause
// The built page, carried inside the program: it works wherever the program does, with nothing to install.
#pragma once

#include <span>
#include <string_view>

namespace hfrac::web {

struct PageFile {
  std::string_view name;  ///< as in the address
  std::string_view type;  ///< media type
  std::string_view bytes;
};

std::span<const PageFile> page_files();

}  // namespace hfrac::web

// SPDX-License-Identifier: BSD-3-Clause
// The assembler copies the files of viz/web/built and index.html as they are; HFRAC_PAGE_FOLDER is the place of the built ones.
#include "web/server/page_files.hpp"

#include <array>

// NOLINTBEGIN: symbols of the assembler
#define HFRAC_PAGE_FILE(symbol, file)                                  \
  __asm__(                                                             \
      ".pushsection .rodata\n"                                         \
      ".global hfrac_page_" #symbol                                    \
      "\n"                                                             \
      ".hidden hfrac_page_" #symbol                                    \
      "\n"                                                             \
      "hfrac_page_" #symbol ":\n.incbin \"" HFRAC_PAGE_FOLDER "/" file \
      "\"\n"                                                           \
      ".global hfrac_page_" #symbol                                    \
      "_end\n"                                                         \
      ".hidden hfrac_page_" #symbol                                    \
      "_end\n"                                                         \
      "hfrac_page_" #symbol "_end:\n.byte 0\n.popsection\n");          \
  extern "C" const char hfrac_page_##symbol[];                         \
  extern "C" const char hfrac_page_##symbol##_end[];

HFRAC_PAGE_FILE(index, "../page/index.html")
HFRAC_PAGE_FILE(script, "viewer.js")
HFRAC_PAGE_FILE(style, "viewer.css")
// NOLINTEND

namespace hfrac::web {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<size_t>(end - begin)};
}

}  // namespace

std::span<const PageFile> page_files() {
  static const std::array<PageFile, 3> files = {
      {{"index.html", "text/html; charset=utf-8", between(hfrac_page_index, hfrac_page_index_end)},
       {"viewer.js", "text/javascript; charset=utf-8", between(hfrac_page_script, hfrac_page_script_end)},
       {"viewer.css", "text/css; charset=utf-8", between(hfrac_page_style, hfrac_page_style_end)}}};
  return files;
}

}  // namespace hfrac::web

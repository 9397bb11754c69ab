// SPDX-License-Identifier: BSD-3-Clause
// An XML file as a tree: names, attributes, text.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::run {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  ///< its own, without its children's; of an array whose numbers are appended: those bytes
  std::vector<std::unique_ptr<XmlElement>> children;

  /** The first child of that name, or nullptr. */
  const XmlElement* child(std::string_view wanted) const;
  /** An attribute, or an empty text. */
  std::string attribute(std::string_view wanted) const;
};

/** The root of `content`; `path` is what errors call it. Throws ReadError if it is not well-formed. */
std::unique_ptr<XmlElement> parse_xml(std::string_view content, const std::filesystem::path& path);

}  // namespace hfrac::run

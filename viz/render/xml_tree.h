// SPDX-License-Identifier: BSD-3-Clause
// An XML file as a tree: names, attributes, text.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hfrac::viz {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string
      text;  // its own, without that of its children; of an array whose numbers are appended: those bytes
  std::vector<std::unique_ptr<XmlElement>> children;

  // The first child of that name, or nullptr.
  const XmlElement* child(const std::string& wanted) const;
  // An attribute, or an empty text.
  std::string attribute(const std::string& wanted) const;
};

// The root. Throws Failure(HFRAC_VIZ_ERR_READ) if the file is missing or not well-formed.
std::unique_ptr<XmlElement> read_xml(const std::filesystem::path& path);

}  // namespace hfrac::viz

// SPDX-License-Identifier: BSD-3-Clause
// By expat, the parser inside VTK's own readers.
#include "run/xml_tree.hpp"

#include <expat.h>

#include <algorithm>
#include <climits>
#include <new>

#include "run/files.hpp"
#include "run/text.hpp"

namespace hfrac::run {
namespace {

constexpr std::size_t deepest = 32;  // a VTU file is six deep

// Builds the tree from what the parser meets. Called from inside a C library: keeps what goes wrong for later.
class TreeBuilder {
 public:
  void parse(std::string_view document, const std::filesystem::path& path) {
    const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                              XML_ParserFree);
    if (!parser) throw std::bad_alloc();
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(
        parser.get(),
        [](void* self, const char* name, const char** attributes) {
          static_cast<TreeBuilder*>(self)->start(name, attributes);
        },
        [](void* self, const char*) { static_cast<TreeBuilder*>(self)->end(); });
    XML_SetCharacterDataHandler(parser.get(), [](void* self, const char* data, int length) {
      auto* builder = static_cast<TreeBuilder*>(self);
      builder->guarded([&] { builder->open_.back()->text.append(data, static_cast<std::size_t>(length)); });
    });
    auto status = XML_STATUS_OK;
    do {  // a piece at a time, for files of 2 GB and more
      const auto piece = document.substr(0, INT_MAX / 2);
      document.remove_prefix(piece.size());
      status =
          XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), document.empty() ? 1 : 0);
    } while (status == XML_STATUS_OK && !document.empty());
    const auto error = XML_GetErrorCode(parser.get());
    if (out_of_memory_ || error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    if (status != XML_STATUS_OK) {
      fail_reading(path.string() + " cannot be read: it is not well-formed XML: " + XML_ErrorString(error) +
                   " in line " + std::to_string(XML_GetCurrentLineNumber(parser.get())));
    }
    if (too_deep_ || top.children.size() != 1)
      fail_reading(path.string() + " cannot be read: it is not the XML that VTK writes");
  }

  XmlElement top;

 private:
  void start(const char* name, const char** attributes) noexcept {
    guarded([&] {
      too_deep_ = too_deep_ || ++depth_ > deepest;
      if (too_deep_) return;
      auto element = std::make_unique<XmlElement>();
      element->name = name;
      for (const char** pair = attributes; pair[0] != nullptr; pair += 2)
        element->attributes[pair[0]] = pair[1];
      open_.push_back(element.get());
      open_[open_.size() - 2]->children.push_back(std::move(element));
    });
  }
  void end() noexcept {
    if (too_deep_ || out_of_memory_) return;
    --depth_;
    open_.pop_back();
  }
  template <class Work>
  void guarded(const Work& work) noexcept {
    try {
      if (!out_of_memory_) work();
    } catch (...) {
      out_of_memory_ = true;
    }
  }

  std::vector<XmlElement*> open_{&top};
  std::size_t depth_ = 0;
  bool too_deep_ = false, out_of_memory_ = false;
};

// Raw bytes after the XML, which no XML parser takes, are cut off before and handed to their arrays after.
constexpr std::string_view appended_tag = "<AppendedData";
constexpr std::string_view appended_end = "</AppendedData>";

std::size_t offset_of(const XmlElement& array) {
  return number_in<std::size_t>(array.attribute("offset")).value_or(std::string::npos);
}

template <class Visit>
void visit_appended_arrays(XmlElement& element, const Visit& visit) {
  for (const auto& child : element.children) visit_appended_arrays(*child, visit);
  if (element.name == "DataArray" && element.attribute("format") == "appended") visit(element);
}

// Each array gets the bytes from its offset to the next array's.
void hand_out(XmlElement& root, std::string_view bytes) {
  std::vector<std::size_t> offsets = {bytes.size()};
  visit_appended_arrays(root, [&](const XmlElement& array) { offsets.push_back(offset_of(array)); });
  std::sort(offsets.begin(), offsets.end());
  visit_appended_arrays(root, [&](XmlElement& array) {
    const std::size_t begin = offset_of(array);
    if (begin >= bytes.size()) return;  // has no bytes, which its decoding will say
    const std::size_t end = *std::upper_bound(offsets.begin(), offsets.end(), begin);
    array.text = bytes.substr(begin, end - begin);
  });
}

}  // namespace

const XmlElement* XmlElement::child(std::string_view wanted) const {
  for (const auto& element : children) {
    if (element->name == wanted) return element.get();
  }
  return nullptr;
}

std::string XmlElement::attribute(std::string_view wanted) const {
  const auto found = attributes.find(wanted);
  return found != attributes.end() ? found->second : std::string();
}

std::unique_ptr<XmlElement> parse_xml(std::string_view content, const std::filesystem::path& path) {
  std::string_view document = content, appended;
  std::string head;
  if (const std::size_t tag = document.find(appended_tag); tag != std::string_view::npos) {
    const std::size_t begin = document.find('_', tag);
    const std::size_t end = document.rfind(appended_end);
    if (begin == std::string_view::npos || end == std::string_view::npos || end <= begin)
      fail_reading(path.string() + " cannot be read: its appended data are cut off");
    if (document.substr(tag, begin - tag).find("\"raw\"") == std::string_view::npos)
      fail_reading(path.string() + " cannot be read: its appended data are not raw");
    appended = document.substr(begin + 1, end - begin - 1);
    head = std::string(document.substr(0, tag)) + "</VTKFile>";
    document = head;
  }
  TreeBuilder builder;
  builder.parse(document, path);
  hand_out(*builder.top.children.front(), appended);
  return std::move(builder.top.children.front());
}

}  // namespace hfrac::run

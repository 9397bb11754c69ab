// SPDX-License-Identifier: BSD-3-Clause
#include "xml_tree.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "failure.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

constexpr std::size_t deepest = 32;  // a VTU file is six deep

// Builds the tree from what the parser meets. Called from inside a C library: keeps what goes wrong for
// later.
class TreeBuilder final : public vtkXMLParser {
 public:
  static TreeBuilder* New();
  vtkTypeMacro(TreeBuilder, vtkXMLParser) TreeBuilder(const TreeBuilder&) = delete;
  TreeBuilder& operator=(const TreeBuilder&) = delete;

  XmlElement top;
  bool too_deep = false;
  bool out_of_memory = false;

 protected:
  TreeBuilder() { open_.push_back(&top); }
  ~TreeBuilder() override = default;

  void StartElement(const char* name, const char** attributes) override {
    guarded([&] {
      ++depth_;
      if (depth_ > deepest) {
        too_deep = true;
        return;
      }
      auto element = std::make_unique<XmlElement>();
      element->name = name;
      for (const char** pair = attributes; pair[0] != nullptr; pair += 2)
        element->attributes[pair[0]] = pair[1];
      open_.push_back(element.get());
      open_[open_.size() - 2]->children.push_back(std::move(element));
    });
  }
  void EndElement(const char* /*name*/) override {
    if (depth_-- <= deepest && open_.size() > 1) open_.pop_back();
  }
  void CharacterDataHandler(const char* data, int length) override {
    guarded([&] { open_.back()->text.append(data, static_cast<std::size_t>(length)); });
  }

 private:
  template <class Work>
  void guarded(const Work& work) noexcept {
    try {
      if (!out_of_memory) work();
    } catch (...) {
      out_of_memory = true;
    }
  }

  std::vector<XmlElement*> open_;
  std::size_t depth_ = 0;
};

vtkStandardNewMacro(TreeBuilder)

    // Raw bytes after the XML, which no XML parser takes, are cut off before and handed to their arrays after.
    constexpr std::string_view appended_tag = "<AppendedData";
constexpr std::string_view appended_end = "</AppendedData>";

std::size_t offset_of(const XmlElement& array) {
  const std::string text = array.attribute("offset");
  std::size_t offset = std::string::npos;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
  return error == std::errc() && end == text.data() + text.size() ? offset : std::string::npos;
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

std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  if (!stream || (stream.peek() != std::ifstream::traits_type::eof() && !(content << stream.rdbuf())))
    fail_reading(path.string() + " cannot be read");
  return std::move(content).str();
}

}  // namespace

const XmlElement* XmlElement::child(const std::string& wanted) const {
  for (const auto& element : children) {
    if (element->name == wanted) return element.get();
  }
  return nullptr;
}

std::string XmlElement::attribute(const std::string& wanted) const {
  const auto found = attributes.find(wanted);
  return found != attributes.end() ? found->second : std::string();
}

std::unique_ptr<XmlElement> read_xml(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) fail_reading("there is no file " + path.string());
  const std::string content = content_of(path);
  std::string_view document = content;
  std::string_view appended;
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
  VtkMessages messages;
  vtkNew<TreeBuilder> builder;
  const int parsed = builder->Parse(document.data(), static_cast<unsigned>(document.size()));
  const std::string errors = messages.take_errors();
  if (builder->out_of_memory) throw std::bad_alloc();
  if (!errors.empty()) fail_reading(path.string() + " cannot be read: " + errors);
  if (parsed == 0 || builder->too_deep || builder->top.children.size() != 1) {
    fail_reading(path.string() + " cannot be read: it is not the XML that VTK writes");
  }
  hand_out(*builder->top.children.front(), appended);
  return std::move(builder->top.children.front());
}

}  // namespace hfrac::viz

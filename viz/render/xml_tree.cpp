// SPDX-License-Identifier: BSD-3-Clause
#include "xml_tree.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

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
  VtkMessages messages;
  vtkNew<TreeBuilder> builder;
  builder->SetFileName(path.c_str());
  const int parsed = builder->Parse();
  const std::string errors = messages.take_errors();
  if (builder->out_of_memory) throw std::bad_alloc();
  if (!errors.empty()) fail_reading(path.string() + " cannot be read: " + errors);
  if (parsed == 0 || builder->too_deep || builder->top.children.size() != 1) {
    fail_reading(path.string() + " cannot be read: it is not the XML that VTK writes");
  }
  return std::move(builder->top.children.front());
}

}  // namespace hfrac::viz

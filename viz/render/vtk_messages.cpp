// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <thread>

#include "failure.h"

namespace hfrac::viz {
namespace {

constexpr std::size_t longest_kept =
    4000;  // [byte] an error is often followed by hundreds of its consequences

// "ERROR: In file.cxx, line 12\nvtkThing (0x1234): what happened\n\n" -> "what happened"
std::string without_position(const std::string& message) {
  std::string text = message;
  if (text.starts_with("ERROR:") || text.starts_with("Generic Warning:") || text.starts_with("Warning:")) {
    const std::size_t line_end = text.find('\n');
    if (line_end != std::string::npos) text.erase(0, line_end + 1);
  }
  const std::size_t object_end = text.find("): ");
  if (text.starts_with("vtk") && object_end != std::string::npos) text.erase(0, object_end + 3);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (char& letter : text) {
    if (letter == '\n') letter = ' ';
  }
  return text;
}

}  // namespace

class VtkMessages::Keeper final : public vtkOutputWindow {
 public:
  static Keeper* New();
  vtkTypeMacro(Keeper, vtkOutputWindow) Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  void DisplayErrorText(const char* message) override {
    if (foreign()) {
      previous->DisplayErrorText(message);
    } else if (errors.size() < longest_kept) {
      if (!errors.empty()) errors += "; ";
      errors += without_position(message);
    }
  }
  void DisplayText(const char* message) override {
    if (foreign()) previous->DisplayText(message);
  }
  void DisplayWarningText(const char* message) override {
    if (foreign()) previous->DisplayWarningText(message);
  }
  void DisplayGenericWarningText(const char* message) override {
    if (foreign()) previous->DisplayGenericWarningText(message);
  }
  void DisplayDebugText(const char* message) override {
    if (foreign()) previous->DisplayDebugText(message);
  }

  std::string errors;
  vtkSmartPointer<vtkOutputWindow> previous;

 protected:
  Keeper() = default;
  ~Keeper() override = default;

 private:
  bool foreign() const { return previous != nullptr && std::this_thread::get_id() != owner_; }

  std::thread::id owner_ = std::this_thread::get_id();
};

vtkStandardNewMacro(VtkMessages::Keeper)

    VtkMessages::VtkMessages()
    : previous_(vtkOutputWindow::GetInstance()), keeper_(vtkSmartPointer<Keeper>::New()) {
  keeper_->previous = previous_;
  previous_verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(keeper_);
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(previous_);
  vtkLogger::SetStderrVerbosity(vtkLogger::ConvertToVerbosity(previous_verbosity_));
}

std::string VtkMessages::take_errors() {
  std::string taken;
  taken.swap(keeper_->errors);
  return taken;
}

void VtkMessages::demand_none() {
  const std::string errors = take_errors();
  if (!errors.empty()) fail_drawing("drawing failed: " + errors);
}

}  // namespace hfrac::viz

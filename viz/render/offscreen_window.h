// SPDX-License-Identifier: BSD-3-Clause
// The one place that knows where pixels come from: a VTK render window in plain memory.
//
// VTK draws into its own framebuffer object, so the context's default framebuffer is only a few pixels that
// nobody looks at and resizing needs nothing. Nothing else in the renderer knows about OSMesa; a window on
// another off-screen system replaces make_offscreen_window and this class.
#pragma once

#include <vtkOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>

namespace hfrac::viz {

class OffscreenWindow final : public vtkOpenGLRenderWindow {
 public:
  static OffscreenWindow* New();
  vtkTypeMacro(OffscreenWindow, vtkOpenGLRenderWindow)

      void Initialize() override;
  void Finalize() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void OpenGLInitContext() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 0; }
  void* GetGenericContext() override { return context_; }
  int* GetScreenSize() override;
  const char* ReportCapabilities() override;

  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

 protected:
  OffscreenWindow();
  ~OffscreenWindow() override;
  void CreateAWindow() override { Initialize(); }
  void DestroyWindow() override { Finalize(); }

 private:
  static constexpr int dummy_size = 16;  // [pixel]

  void* context_ = nullptr;
  alignas(16) std::array<std::uint8_t, dummy_size * dummy_size * 4> dummy_framebuffer_{};
};

// A window ready to draw in. Throws Failure if this system cannot draw off screen.
vtkSmartPointer<OffscreenWindow> make_offscreen_window();

}  // namespace hfrac::viz

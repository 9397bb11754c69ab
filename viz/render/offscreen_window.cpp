// SPDX-License-Identifier: BSD-3-Clause
#include "offscreen_window.h"

#include <GL/glew.h>
// glew.h takes these away again, osmesa.h needs them
#ifndef GLAPI
#define GLAPI extern
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#include <GL/osmesa.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <string>

#include "failure.h"
#include "gl_dispatch.h"
#include "number_text.h"

namespace hfrac::viz {
namespace {

OSMesaContext as_context(void* pointer) {
  return static_cast<OSMesaContext>(pointer);
}

// OSMesa's own exit handler joins its drawing threads and hangs if a context is still alive then. Handlers
// run in reverse order of registration: ours is registered after the first context was made, so it runs
// before and ends whatever is alive. The set is never freed, because exit may come at any time.
struct LiveWindows {
  std::mutex mutex;
  std::set<OffscreenWindow*> windows;
};

LiveWindows& live_windows() {
  static auto* const live = new LiveWindows;
  return *live;
}

void finalize_live_windows() {
  std::set<OffscreenWindow*> windows;
  {
    const std::lock_guard lock(live_windows().mutex);
    windows.swap(live_windows().windows);
  }
  for (OffscreenWindow* window : windows) window->Finalize();
}

void register_live(OffscreenWindow* window) {
  static std::once_flag registered;
  std::call_once(registered, [] { std::atexit(finalize_live_windows); });
  const std::lock_guard lock(live_windows().mutex);
  live_windows().windows.insert(window);
}

void unregister_live(OffscreenWindow* window) {
  const std::lock_guard lock(live_windows().mutex);
  live_windows().windows.erase(window);
}

std::string gl_text(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "?";
}

}  // namespace

vtkStandardNewMacro(OffscreenWindow)

    OffscreenWindow::OffscreenWindow() {
  this->DoubleBuffer = 0;
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->FrameBlitMode = NoBlit;
  this->MultiSamples = 0;
}

OffscreenWindow::~OffscreenWindow() {
  Finalize();
  vtkCollectionSimpleIterator position;
  this->Renderers->InitTraversal(position);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(position))
    renderer->SetRenderWindow(nullptr);
}

void OffscreenWindow::Initialize() {
  if (context_ != nullptr) return;
  static constexpr std::array<int, 13> wanted = {OSMESA_FORMAT,
                                                 OSMESA_RGBA,
                                                 OSMESA_DEPTH_BITS,
                                                 24,
                                                 OSMESA_STENCIL_BITS,
                                                 0,
                                                 OSMESA_PROFILE,
                                                 OSMESA_CORE_PROFILE,
                                                 OSMESA_CONTEXT_MAJOR_VERSION,
                                                 3,
                                                 OSMESA_CONTEXT_MINOR_VERSION,
                                                 2,
                                                 0};
  context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
  if (context_ == nullptr) fail_drawing("OSMesa offers no OpenGL 3.2 context");
  register_live(this);
  this->Mapped = 0;
  MakeCurrent();
  this->OpenGLInit();
}

void OffscreenWindow::OpenGLInitContext() {
  this->ContextCreationTime.Modified();
  if (this->Initialized) return;
  glewExperimental = GL_TRUE;
  // GLEW loads every OpenGL function and only then looks for an X display, whose absence is no error here.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
  if (!this->GlewInitValid || !GLEW_VERSION_3_2)
    fail_drawing("the OpenGL functions of OSMesa cannot be loaded");
  this->Initialized = true;
  std::array<GLfloat, 2> line_widths{1.0F, 1.0F};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, line_widths.data());
  this->MaximumHardwareLineWidth = line_widths[1];
}

void OffscreenWindow::MakeCurrent() {
  if (context_ == nullptr) return;
  gl_dispatch::bind();
  if (OSMesaGetCurrentContext() == as_context(context_)) return;
  if (OSMesaMakeCurrent(as_context(context_), dummy_framebuffer_.data(), GL_UNSIGNED_BYTE, dummy_size,
                        dummy_size) != GL_TRUE) {
    fail_drawing("OSMesa cannot make its context current");
  }
}

void OffscreenWindow::ReleaseCurrent() {
  if (!IsCurrent()) return;
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl_dispatch::unbind();
}

bool OffscreenWindow::IsCurrent() {
  return context_ != nullptr && gl_dispatch::bound() && OSMesaGetCurrentContext() == as_context(context_);
}

void OffscreenWindow::Finalize() {
  if (context_ == nullptr) return;
  unregister_live(this);
  try {
    MakeCurrent();
    glFinish();
    this->ReleaseGraphicsResources(this);
  } catch (const Failure&) {
    // The context cannot be made current any more: VTK's objects in it go with it.
  }
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl_dispatch::unbind();
  OSMesaDestroyContext(as_context(context_));
  context_ = nullptr;
  this->Initialized = false;
}

int* OffscreenWindow::GetScreenSize() {
  this->ScreenSize[0] = this->Size[0];
  this->ScreenSize[1] = this->Size[1];
  return this->ScreenSize;
}

const char* OffscreenWindow::ReportCapabilities() {
  Initialize();
  MakeCurrent();
  const std::string text = gl_text(GL_RENDERER) + ", OpenGL " + gl_text(GL_VERSION);
  delete[] this->Capabilities;
  this->Capabilities = new char[text.size() + 1];
  std::memcpy(this->Capabilities, text.c_str(), text.size() + 1);
  return this->Capabilities;
}

namespace {

// Mesa and x264 end the process where memory runs out under them. Under `ulimit -v` that is known before.
void require_address_space() {
  constexpr double megabyte = 1e6, needed = 700;  // [MB] measured: pictures 1600 and a movie 1280 pixels wide
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const double allowed = static_cast<double>(limit.rlim_cur) / megabyte;
  const double taken = static_cast<double>(pages) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / megabyte;
  if (allowed - taken >= needed) return;
  throw Failure(HFRAC_ERR_MEMORY, "not enough memory to draw: this process may take " + value_text(allowed) +
                                      " MB (ulimit -v), has " + value_text(taken) + " MB and needs " +
                                      value_text(needed) + " MB more");
}

}  // namespace

vtkSmartPointer<OffscreenWindow> make_offscreen_window() {
  require_address_space();
  auto window = vtkSmartPointer<OffscreenWindow>::New();
  window->Initialize();
  return window;
}

}  // namespace hfrac::viz

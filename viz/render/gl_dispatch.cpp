// SPDX-License-Identifier: BSD-3-Clause
#include "gl_dispatch.h"

#include <GL/osmesa.h>

#include "failure.h"

// The part of libglvnd's binary interface that window-system libraries use. It has no installed header; its
// number (1 since libglvnd 1.0) is checked before anything else is called.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
struct HfracDispatchThreadState {
  int tag;
  void (*thread_destroyed)(HfracDispatchThreadState*);
  void* owned_by_dispatch;
};
int __glDispatchGetABIVersion(void);
void __glDispatchInit(void);
int __glDispatchNewVendorID(void);
void* __glDispatchCreateTable(void* (*get_function)(const char* name, void* parameter), void* parameter);
unsigned char __glDispatchMakeCurrent(HfracDispatchThreadState* state, void* table, int vendor,
                                      const void* patches);
void __glDispatchLoseCurrent(void);
HfracDispatchThreadState* __glDispatchGetCurrentThreadState(void);
}

namespace hfrac::viz::gl_dispatch {
namespace {

constexpr int supported_interface = 1;
// Tags 0 and 1 are GLX and EGL, which would take a state with their tag for one of their own structures.
constexpr int own_tag = 2;

void* osmesa_function(const char* name, void* /*parameter*/) {
  return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}

void nothing_to_free(HfracDispatchThreadState* /*state*/) {}

struct Vendor {
  int id = 0;
  void* table = nullptr;
};

const Vendor& vendor() {
  static const Vendor registered = [] {
    Vendor made;
    if (__glDispatchGetABIVersion() != supported_interface) {
      fail_drawing("libGLdispatch has an interface this renderer does not know (number " +
                   std::to_string(__glDispatchGetABIVersion()) + ", expected 1)");
    }
    __glDispatchInit();
    made.id = __glDispatchNewVendorID();
    made.table = __glDispatchCreateTable(osmesa_function, nullptr);
    if (made.table == nullptr) fail_drawing("libGLdispatch made no table for OSMesa");
    return made;
  }();
  return registered;
}

thread_local HfracDispatchThreadState thread_state{own_tag, nothing_to_free, nullptr};

}  // namespace

bool bound() noexcept {
  return __glDispatchGetCurrentThreadState() == &thread_state;
}

void bind() {
  const Vendor& osmesa = vendor();
  if (bound()) return;
  if (__glDispatchGetCurrentThreadState() != nullptr) {
    fail_drawing(
        "another OpenGL context is current on this thread; release it or render from another thread");
  }
  if (__glDispatchMakeCurrent(&thread_state, osmesa.table, osmesa.id, nullptr) == 0) {
    fail_drawing("libGLdispatch refused to make OSMesa current");
  }
}

void unbind() noexcept {
  if (bound()) __glDispatchLoseCurrent();
}

}  // namespace hfrac::viz::gl_dispatch
// NOLINTEND(bugprone-reserved-identifier)

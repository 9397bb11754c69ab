// SPDX-License-Identifier: BSD-3-Clause
// OSMesa as one more vendor of libglvnd.
//
// VTK as distributed calls OpenGL through libglvnd: its stubs jump to whichever vendor's functions are
// current on the thread. OSMesa does not announce itself there, so a current OSMesa context is invisible to
// VTK. We do for OSMesa what libGLX and libEGL do for their vendors: make a dispatch table from its functions
// once, and bind it to the thread whenever an OSMesa context is made current.
#pragma once

namespace hfrac::viz::gl_dispatch {

// Binds OSMesa's functions to this thread. Throws Failure if another library's context is current here,
// because that one could not be put back afterwards.
void bind();

// Leaves this thread without OpenGL functions; does nothing if OSMesa's are not bound.
void unbind() noexcept;

// True if OSMesa's functions are bound to this thread.
bool bound() noexcept;

}  // namespace hfrac::viz::gl_dispatch

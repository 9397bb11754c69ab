// SPDX-License-Identifier: BSD-3-Clause
// How finely discs are drawn: as round points with a rim where they can be told apart, as density where not.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <span>

#include "page.h"
#include "snapshot.h"

namespace hfrac::viz {

// Whether the discs of this view are too small, or too many, for points.
bool drawn_as_density(const View& view, const Discs& discs);

// The discs of a view, all in one colour. `drawn_pixel` [m]: of a drawn pixel.
vtkSmartPointer<vtkActor> discs_in_view(const View& view, const Discs& discs, Colour fill, Colour rim,
                                        double drawn_pixel);
// Each disc in its own colour.
vtkSmartPointer<vtkActor> discs_in_view(const View& view, const Discs& discs, std::span<const Colour> fills,
                                        double drawn_pixel);

}  // namespace hfrac::viz

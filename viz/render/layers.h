// SPDX-License-Identifier: BSD-3-Clause
// What lies in a view of the model, each layer one VTK actor: discs, bonds, cracks, domains, wells.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <span>
#include <vector>

#include "colour.h"
#include "run/run_folder.hpp"
#include "snapshot.h"

namespace hfrac::viz {

// Order from below; the values only need to rise.
namespace depth {
inline constexpr double wells = 0.0;
inline constexpr double domains = 1.0;
inline constexpr double discs = 2.0;
inline constexpr double bonds = 3.0;
inline constexpr double cracks = 4.0;
inline constexpr double rings = 5.0;
}  // namespace depth

// Discs as round points: the graphics processor cuts each disc out of one triangle. `pixel` [m] is the size
// of a drawn pixel; discs are never drawn smaller than one, and their rim is one to two pixels wide whatever
// the view.
vtkSmartPointer<vtkActor> disc_layer(const Discs& discs, Colour fill, Colour rim, double pixel);

// Discs, each in its own colour with a darker rim.
vtkSmartPointer<vtkActor> disc_layer(const Discs& discs, std::span<const Colour> fills, double pixel);

// Of the following those draw what meets `seen` alone that may have millions of shapes to leave out.

// Lines between disc centres, `width` drawn pixels wide; below one they fade instead of getting thinner.
vtkSmartPointer<vtkActor> bond_layer(std::span<const Segment> bonds, const Bounds& seen, Colour colour,
                                     double width);

// Cracks as bands of equal width, tension and shear in their colours; `casing` [m] of paper around them, if
// positive.
vtkSmartPointer<vtkActor> crack_layer(std::span<const Crack> cracks, double half_width, double casing);

// Cracks in the colour of their aperture, wider the wider they are open: half_width [m] at aperture `widest`.
vtkSmartPointer<vtkActor> aperture_layer(std::span<const Crack> cracks, double widest, double half_width);

// Bonds as bands as wide as their force is large: half_width [m] at `largest` [N] and above; weaker ones than
// a fiftieth of it are left out.
vtkSmartPointer<vtkActor> force_layer(std::span<const BondForce> bonds, const Bounds& seen, double largest,
                                      double half_width);

// Cracks and bonds in colours of their own: that of cell i of their file is colours[i].
vtkSmartPointer<vtkActor> coloured_cracks(std::span<const Crack> cracks, std::span<const Colour> colours,
                                          double half_width);
vtkSmartPointer<vtkActor> coloured_bonds(std::span<const Segment> bonds, const Bounds& seen,
                                         std::span<const Colour> colours, double half_width);

// Contacts of joints in colours of their own, with a thin line around each joint, since one colour may be that of the rock.
vtkSmartPointer<vtkActor> joint_layer(std::span<const Segment> contacts, std::span<const Colour> colours,
                                      double half_width, double casing);

// Domains in colours of their own, by cell of their file.
vtkSmartPointer<vtkActor> domain_layer(const Flow& flow, const Bounds& seen, std::span<const Colour> colours);
// Domains in the colour of their pressure between two values.
vtkSmartPointer<vtkActor> domain_layer(const Flow& flow, const Bounds& seen, double lowest, double highest);

// The holes of the wells, to lie under the discs: the wells' domains if flow has any, otherwise circles.
vtkSmartPointer<vtkActor> well_layer(const Flow& flow, std::span<const WellPlace> wells,
                                     double smallest_radius, Colour colour = palette().well);

// Around each well the circle of the hole that was asked for, or its domain.
vtkSmartPointer<vtkActor> well_rings(const Flow& flow, std::span<const WellPlace> wells, double half_width,
                                     Colour colour);

}  // namespace hfrac::viz

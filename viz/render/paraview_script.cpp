// SPDX-License-Identifier: BSD-3-Clause
#include "paraview_script.h"

#include <fmt/format.h>

#include <cmath>

#include "colour.h"

namespace hfrac::viz {
namespace {

std::string share(int part) {
  return fmt::to_string(static_cast<double>(std::lround(part / 255.0 * 1000)) / 1000);
}

std::string list_of(Colour colour) {
  std::string text = "[";
  text.append(share(colour.red)).append(", ").append(share(colour.green)).append(", ");
  return text.append(share(colour.blue)).append("]");
}

// Value, red, green, blue, value, ...
std::string points_of(const ColourMap& map, const char* from, const char* to) {
  constexpr int count = 9;
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double place = static_cast<double>(i) / (count - 1);
    const Colour colour = map.at(place);
    text.append("    ").append(from).append(" + (").append(to).append(" - ").append(from).append(") * ");
    text.append(fmt::to_string(place)).append(", ").append(share(colour.red)).append(", ");
    text.append(share(colour.green)).append(", ").append(share(colour.blue)).append(",\n");
  }
  return text;
}

constexpr const char* script_head =
    R"py(# Opens this run in ParaView as its pictures look: File > Load State, or `pvpython paraview_state.py`.
#
# It looks for the run in its own folder; if ParaView does not say where that is, in the folder named by the
# environment variable HFRAC_RUN, or else in the current one. Arrays and their units: the names end in the unit.
import os
import sys

from paraview.simple import (AnnotateTimeFilter, ColorBy, CreateRenderView, Disk, GetAnimationScene,
                             GetColorTransferFunction, GetScalarBar, Hide, PVDReader, SetActiveView, Show)

try:
    FOLDER = os.path.dirname(os.path.abspath(__file__))
except NameError:
    FOLDER = os.environ.get("HFRAC_RUN", os.getcwd())

)py";

constexpr const char* script_body = R"py(

def series(name):
    """The reader of NAME.pvd, or None if the run has no such series."""
    path = os.path.join(FOLDER, name + ".pvd")
    if not os.path.exists(path):
        return None
    reader = PVDReader(registrationName=name, FileName=path)
    reader.UpdatePipelineInformation()
    return reader


view = CreateRenderView()
view.InteractionMode = "2D"
view.CameraParallelProjection = 1
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = PAPER
view.ViewSize = [1200, 1000]
view.CameraFocalPoint = [0.58 * WIDTH, HEIGHT / 2, 0.0]
view.CameraPosition = [0.58 * WIDTH, HEIGHT / 2, 10.0 * max(WIDTH, HEIGHT)]
view.CameraParallelScale = 0.55 * max(WIDTH, HEIGHT)
SetActiveView(view)

discs, bonds, cracks, flow, joints = (series(name) for name in ("discs", "bonds", "cracks", "flow", "joints"))
TIMES = []
if discs:
    times = discs.TimestepValues
    TIMES = list(times) if hasattr(times, "__len__") else [times]

# The wells' holes, under the discs.
for x, y, radius in WELLS:
    hole = Disk(registrationName="well", InnerRadius=0.0, OuterRadius=radius, CircumferentialResolution=64)
    shown = Show(hole, view)
    shown.Position = [x, y, -0.01 * max(WIDTH, HEIGHT)]
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    shown.AmbientColor = shown.DiffuseColor = WELL

# Discs as true circles: points drawn as flat discs of their own radius.
if discs:
    shown = Show(discs, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.ShaderPreset = "Plain circle"
    shown.ScaleByArray = 1
    shown.SetScaleArray = ["POINTS", "radius_m"]
    shown.UseScaleFunction = 0
    shown.GaussianRadius = 1.0
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = DISC
    shown.DiffuseColor = DISC

# Fluid pressure fills the pores; hidden, because it covers the discs: switch on its eye to see it.
if flow:
    shown = Show(flow, view)
    shown.SetRepresentationType("Surface")
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    ColorBy(shown, ("CELLS", "pressure_Pa"))
    scale = GetColorTransferFunction("pressure_Pa")
    flow.UpdatePipeline(TIMES[-1] if TIMES else 0.0)
    low, high = flow.CellData["pressure_Pa"].GetRange()
    scale.RGBPoints = pressure_points(low, high if high > low else low + 1.0)
    scale.ColorSpace = "RGB"
    bar = GetScalarBar(scale, view)
    bar.Title, bar.ComponentTitle = "pressure (Pa)", ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize = bar.LabelFontSize = 12
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.90, 0.15], 0.40
    Hide(flow, view)

if bonds:
    shown = Show(bonds, view)
    shown.SetRepresentationType("Surface")
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = BOND
    shown.LineWidth = 1.0
    Hide(bonds, view)

# Smooth joints by their hydraulic aperture, over the cracks.
if joints:
    shown = Show(joints, view)
    shown.SetRepresentationType("Surface")
    shown.LineWidth = 4.0
    shown.Position = [0.0, 0.0, 0.02 * max(WIDTH, HEIGHT)]
    joints.UpdatePipeline(TIMES[-1] if TIMES else 0.0)
    ColorBy(shown, ("CELLS", "hydraulic_aperture_m"))
    shown.RescaleTransferFunctionToDataRange(False, True)

# Cracks by mode: 1 tension, 2 shear.
if cracks:
    shown = Show(cracks, view)
    shown.SetRepresentationType("Surface")
    shown.LineWidth = 4.0
    shown.Position = [0.0, 0.0, 0.01 * max(WIDTH, HEIGHT)]
    cracks.UpdatePipeline(TIMES[-1] if TIMES else 0.0)  # before the first crack there are no modes
    ColorBy(shown, ("CELLS", "mode"))
    scale = GetColorTransferFunction("mode")
    scale.InterpretValuesAsCategories = 1
    scale.Annotations = ["1", "tension", "2", "shear"]
    scale.IndexedColors = TENSION + SHEAR
    bar = GetScalarBar(scale, view)
    bar.Title, bar.ComponentTitle = "crack", ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize = bar.LabelFontSize = 12
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.90, 0.70], 0.16
    shown.SetScalarBarVisibility(view, True)

if discs:
    clock = AnnotateTimeFilter(registrationName="time", Input=discs)
    clock.Format = "t = {time:g} s"
    written = Show(clock, view)
    written.Color = INK
    written.FontSize = 12
    written.WindowLocation, written.Position = "Any Location", [0.90, 0.92]

# Going to a time draws, which a Linux without a display cannot.
scene = GetAnimationScene()
if sys.platform != "linux" or "DISPLAY" in os.environ or "WAYLAND_DISPLAY" in os.environ:
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
elif TIMES:
    view.ViewTime = TIMES[-1]
)py";

}  // namespace

std::string paraview_script(const RunFolder& run) {
  const Palette& colours = light_palette();
  std::string text = script_head;
  text.append("WIDTH, HEIGHT = ")
      .append(fmt::to_string(run.model_width > 0 ? run.model_width : 100.0))
      .append(", ");
  text.append(fmt::to_string(run.model_height > 0 ? run.model_height : 100.0))
      .append("  # m, of the model\n");
  const std::pair<const char*, Colour> named[] = {
      {"PAPER", colours.paper},     {"INK", colours.ink},     {"DISC", colours.disc}, {"BOND", colours.bond},
      {"TENSION", colours.tension}, {"SHEAR", colours.shear}, {"WELL", colours.well}};
  for (const auto& [name, colour] : named)
    text.append(name).append(" = ").append(list_of(colour)).append("\n");
  text += "WELLS = [";
  for (const WellPlace& well : run.wells) {
    text.append("(").append(fmt::to_string(well.x)).append(", ").append(fmt::to_string(well.y)).append(", ");
    text.append(fmt::to_string(well.radius)).append("), ");
  }
  text += "]  # x, y, radius in m\n\n\ndef pressure_points(low, high):\n";
  text += "    \"\"\"The pictures' colours between two pressures.\"\"\"\n    return [\n";
  text += points_of(pressure_map, "low", "high") + "    ]\n";
  return text + script_body;
}

}  // namespace hfrac::viz

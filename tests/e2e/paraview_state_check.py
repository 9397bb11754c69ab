"""Run by pvpython: the state script of a run folder must open everything and stand at the last time."""
import os
import runpy
import sys

from paraview import simple


def demand(good, text):
    if not good:
        sys.exit("paraview_state_check: " + text)


folder = sys.argv[1]
state = runpy.run_path(os.path.join(folder, "paraview_state.py"))
sources = {name for name, _ in simple.GetSources()}
for name in ("discs", "bonds", "cracks", "flow", "time"):
    demand(name in sources, f"{name} is not open, only {sorted(sources)}")
demand(state["TIMES"] and state["view"].ViewTime == state["TIMES"][-1], "the view is not at the last time")
discs = simple.GetDisplayProperties(state["discs"], state["view"])
demand(discs.Representation == "Point Gaussian", "the discs are not drawn as discs")
demand(discs.SetScaleArray[1] == "radius_m", "the discs are not drawn with their radius")
cracks = simple.GetDisplayProperties(state["cracks"], state["view"])
demand(cracks.ColorArrayName[1] == "mode", "the cracks are not coloured by mode")
flow = simple.GetDisplayProperties(state["flow"], state["view"])
demand(flow.ColorArrayName[1] == "pressure_Pa", "the domains are not coloured by pressure")
print(f"paraview_state_check: good, {len(state['TIMES'])} times, {len(state['WELLS'])} wells")

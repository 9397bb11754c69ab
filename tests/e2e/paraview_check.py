"""Run by pvpython: every series of a run folder must open in ParaView with its times and its arrays."""
import sys
import xml.etree.ElementTree

from paraview import servermanager, simple

ARRAYS = {
    "discs": ("PointData", {"radius_m": 1, "displacement_m": 3, "rotation_rad": 1, "stress_Pa": 3, "intact_bonds": 1,
                            "disc_id": 1}),
    "bonds": ("CellData", {"state": 1, "normal_force_N": 1, "shear_force_N": 1, "moment_N_m": 1, "gap_m": 1,
                           "aperture_m": 1, "flow_m2_per_s": 1, "bond_id": 1}),
    "cracks": ("CellData", {"mode": 1, "aperture_m": 1, "pressure_Pa": 1, "time_s": 1, "step": 1, "fracture": 1,
                            "crack_id": 1}),
    "flow": ("CellData", {"pressure_Pa": 1, "volume_m2": 1, "domain_id": 1, "kind": 1}),
}


def demand(good, text):
    if not good:
        sys.exit("paraview_check: " + text)


def check_series(folder, name):
    """Opens one PVD, walks through all its times and looks for the arrays at the last."""
    path = f"{folder}/{name}.pvd"
    written = [float(entry.get("timestep")) for entry in xml.etree.ElementTree.parse(path).iter("DataSet")]
    reader = simple.PVDReader(FileName=path)
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues) if hasattr(reader.TimestepValues, "__len__") else [reader.TimestepValues]
    demand(times == written, f"{path}: ParaView finds times {times}, written were {written}")

    location, arrays = ARRAYS[name]
    for time in times:
        reader.UpdatePipeline(time)
        grid = servermanager.Fetch(reader)
        stamp = grid.GetFieldData().GetArray("TimeValue")
        demand(stamp is not None and stamp.GetValue(0) == time, f"{path}: no TimeValue {time}")
        data = grid.GetPointData() if location == "PointData" else grid.GetCellData()
        items = grid.GetNumberOfPoints() if location == "PointData" else grid.GetNumberOfCells()
        demand(items > 0 or name == "cracks", f"{path}: nothing at time {time}")
        for array, components in arrays.items():
            found = data.GetArray(array)
            demand(found is not None, f"{path}: no array {array} at time {time}")
            demand(found.GetNumberOfComponents() == components, f"{path}: {array} has another shape")
            demand(found.GetNumberOfTuples() == items, f"{path}: {array} has {found.GetNumberOfTuples()} of {items}")
    low, high, _, _, _, _ = grid.GetBounds() if items else (0, 0, 0, 0, 0, 0)
    print(f"{name}: {len(times)} times from {times[0]:g} s to {times[-1]:g} s, {items} items, x from {low:g} to {high:g}")


def main():
    print("ParaView", simple.GetParaViewVersion())
    for name in ARRAYS:
        check_series(sys.argv[1], name)
    print("paraview_check: good")


main()

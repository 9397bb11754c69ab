#!/usr/bin/python3 -B
"""The paper's figures from a set, by hfrac plot and hfrac render. usage: figures.py OUT FOLDER

Curves are drawn from tables cut out of measured.csv, means with standard deviations over packings; a figure whose
runs are not all there is drawn from those that are.
"""
import csv
import os
import pathlib
import shutil
import subprocess
import sys

# name of the picture: (families, {column of the picture: column measured}, title)
LENGTHS = {"extent_m": "extent_m", "width_m": "width_m"}
ONSET = {"initiation_pressure_Pa": "onset_MPa"}
CHARTS = {
    "figure-05-end": (
        ["figure-05"],
        {"crack_count": "cracks", "fracture_wings": "wings"},
        "Figure 5: cracks by injection pressure",
    ),
    "figure-07": (["figure-07"], ONSET, "Figure 7: initiation against horizontal stresses"),
    "figure-08": (["figure-08"], ONSET, "Figure 8: initiation against contact stiffness"),
    "figure-09": (["figure-09"], ONSET, "Figure 9: initiation against bond strength"),
    "figure-10": (["figure-10"], LENGTHS, "Figure 10: length and width by injection pressure"),
    "figure-11": (["figure-11"], LENGTHS, "Figure 11: length and width by smaller stress"),
    "figure-12": (["figure-12"], LENGTHS, "Figure 12: length and width by permeability"),
    "total-07": (["figure-07-total"], ONSET, "Figure 7, total stresses"),
    "total-08": (["figure-08-total"], ONSET, "Figure 8, total stresses"),
    "total-09": (["figure-09-total"], ONSET, "Figure 9, total stresses"),
    "total-12": (["figure-12-total"], ONSET, "Figure 12, total stresses: initiation by permeability"),
    "beyond-05": (
        ["figure-05", "beyond-05-steps", "beyond-05-supply", "beyond-05-stress"],
        {"crack_count": "cracks", "cracks_after_a_tenth": "cracks_at_tenth"},
        "Figure 5 with changed physics",
    ),
    "beyond-09": (["figure-09", "beyond-09-lower", "beyond-09-stress"], ONSET, "Figure 9 with changed stresses"),
    "beyond-10": (
        ["beyond-10-supply", "beyond-10-strength", "beyond-10-volume"],
        LENGTHS,
        "Figure 10 with changed physics",
    ),
    "beyond-11": (["beyond-11-pressure", "beyond-11-strength"], LENGTHS, "Figure 11 with changed physics"),
    "beyond-12": (
        ["beyond-12-slow", "beyond-12-strength"],
        LENGTHS,
        "Figure 12 with changed physics",
    ),
}
# What the legend adds to the series of a family whose physics is changed. No commas: names stand in a table.
CHANGED = {
    "beyond-05-steps": " (500 sub-steps)",
    "beyond-05-supply": " (cracks filled at once)",
    "beyond-05-stress": " (stresses 7 and 0 MPa)",
    "beyond-09-lower": " (stresses 28 and 21 MPa)",
    "beyond-09-stress": " (stresses 24 and 24 MPa)",
    "beyond-10-supply": " (a tenth of the fluid)",
    "beyond-10-strength": " (falling strength)",
    "beyond-10-volume": " (as much fluid)",
    "beyond-11-pressure": " (50 MPa held)",
    "beyond-11-strength": " (falling strength; 60 MPa held)",
    "beyond-12-slow": " (twelve days)",
    "beyond-12-strength": " (falling strength)",
}
# The axis of a family: its name with the SI unit, and that unit in the family's.
STRESS, PRESSURE = ("effective_stress_Pa", 1e6), ("injection_pressure_Pa", 1e6)
STIFFNESS, STRENGTH = ("contact_stiffness_N_per_m", 1e9), ("bond_strength_Pa", 1e6)
AXES = {
    "05": PRESSURE,
    "07": STRESS,
    "08": STIFFNESS,
    "09": STRENGTH,
    "10": PRESSURE,
    "11": STRESS,
    "12": ("permeability_mD", 1),
}


def hfrac(*words):
    done = subprocess.run([os.environ["HFRAC"], *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        print(f"figures: {' '.join(map(str, words[:2]))}: {done.stderr.strip()}", file=sys.stderr)
    return done.returncode == 0


def in_si(text, column):
    return float(text) * 1e6 if text and column.endswith("_MPa") else text


def chart(rows, tables, folder, name):
    wanted, columns, title = CHARTS[name]
    chosen = [row for row in rows if row["family"] in wanted and row["status"] == "done"]
    kind = name.split("-")[0].replace("total", "figure")
    if not any(row["family"].startswith(kind) for row in chosen):
        return  # a picture of changed physics wants more than what it is compared with
    axis, unit = AXES[name.split("-")[1]]
    if name.startswith("total"):
        axis = axis.replace("effective", "total")
    table = tables / f"{name}.csv"
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["series", axis, *columns])
        for row in chosen:
            series = row["series"].replace("paper", "held pressure") + CHANGED.get(row["family"], "")
            writer.writerow(
                [
                    series,
                    float(row["x"]) * unit,
                    *(in_si(row[column], column) for column in columns.values()),
                ]
            )
    hfrac("plot", "--compare", table, "--title", title, "--width", 900, "-o", folder / f"{name}.png")


def courses(rows, out, folder):
    """Figure 5: cracks over the sub-steps."""
    runs = [out / "runs" / row["run"] for row in rows if row["family"] == "figure-05" and row["status"] == "done"]
    runs = [run for run in runs if (run / "history.csv").exists()]
    if runs and hfrac(
        "plot",
        "--compare",
        *runs,
        "--x",
        "step",
        "--y",
        "cracks",
        "--series",
        "well[0].pressure",
        "--title",
        "Figure 5: cracks over the sub-steps",
        "--width",
        900,
        "-o",
        out / "figure-05.png",
    ):
        (out / "figure-05.png").replace(folder / "figure-05.png")


def stages(run, folder, pressure):
    """Figures 3 and 4 at the paper's pressure, and Figure 4 moving at that and a higher one."""
    if pressure != "45":
        hfrac("render", run, "--movie", folder / f"figure-04-{pressure}-MPa.webp", "--width", 360, "-q")
        return
    if hfrac("render", run, "--no-movie", "--width", 800, "-q"):
        shutil.copyfile(run / "pictures/model.png", folder / "figure-03.png")
        shutil.copyfile(run / "pictures/growth.png", folder / "figure-04.png")
    hfrac("render", run, "--movie", folder / "figure-04.webp", "--width", 480, "-q")


def pictures(rows, out, folder):
    """Figures 3, 4 and 6: the model, five stages, four pressures."""
    for row in rows:
        run, pressure = out / "runs" / row["run"], f"{float(row['x']):.0f}"
        if row["status"] != "done" or not (run / "discs.pvd").exists():
            continue
        if row["family"] == "figure-03-04":
            stages(run, folder, pressure)
        if row["family"] == "figure-06":
            name = f"figure-06-{pressure}-MPa.png"
            hfrac("render", run, "--view", "bonds", "--width", 480, "-q", "-o", folder / name)


def main(out, folder):
    out, folder = pathlib.Path(out), pathlib.Path(folder)
    tables = out / "tables"
    tables.mkdir(parents=True, exist_ok=True)
    folder.mkdir(parents=True, exist_ok=True)
    with open(out / "measured.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for name in CHARTS:
        chart(rows, tables, folder, name)
    courses(rows, out, folder)
    pictures(rows, out, folder)
    if shutil.which("pngquant"):  # 64 colours, as the other pictures of the documentation
        for path in sorted(folder.glob("*.png")):
            subprocess.run(
                ["pngquant", "--force", "--strip", "--speed", "1", "--output", path, "64", path], check=False
            )


if __name__ == "__main__":
    main(*sys.argv[1:])

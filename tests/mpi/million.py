#!/usr/bin/python3
"""A quasi-static step of a large coupled model over ranks, with hfrac's own factor, or MUMPS's, which is written to disk: the memory of all
processes together, which is sampled every few seconds (counting the pages of 15 GB takes a core some tenths), and the balance at its end. A hole
under 5 MPa in tiled rock, so that nothing breaks.

  million.py [--discs N] [--ranks N] [--workers N] [--factor own|petsc] [--one-model] [--gigabytes N]

exits with 1 if they took more, or found no equilibrium. --one-model: the ranks are processes of one machine that share a model.
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile
import time

from over_ranks import COUPLED, ENVIRONMENT, HFRAC, over

def children(process):
    """Processes below one, by /proc."""
    found, parents = [], [str(process)]
    while parents:
        parent = parents.pop()
        for tasks in pathlib.Path(f"/proc/{parent}/task").glob("*/children"):
            try:
                parents += tasks.read_text().split()
            except OSError:
                continue
        found.append(parent)
    return found[1:]


def memory_of(processes):
    """Bytes; what processes share counts once in all."""
    total = 0
    for process in processes:
        try:
            rows = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
        except OSError:
            continue  # it has gone
        total += sum(1024 * int(row.split()[1]) for row in rows if row.startswith("Pss:"))
    return total


def peaks_of(processes, program):
    """Most memory [bytes] that each process of a program has had so far."""
    peaks = {}
    for process in processes:
        try:
            rows = dict(row.split(":", 1) for row in pathlib.Path(f"/proc/{process}/status").read_text().splitlines())
        except OSError:
            continue  # it has gone
        if rows["Name"].strip() == program and "VmHWM" in rows:
            peaks[process] = 1024 * int(rows["VmHWM"].split()[0])
    return peaks


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--discs", type=int, default=1_000_000)
    arguments.add_argument("--ranks", type=int, default=4)
    arguments.add_argument("--workers", type=int, default=1)
    arguments.add_argument("--factor", choices=("own", "petsc"), default="petsc")
    arguments.add_argument("--one-model", action="store_true")
    arguments.add_argument("--gigabytes", type=float, default=16.0)
    options = arguments.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "case.toml").write_text(COUPLED.format(width=options.discs ** 0.5, seed=3, method="tiled", discs=options.discs, factor=options.factor,
                                                         tolerance="1e-6", flow_step=0.02, steps=1, radius=8.5, pressure="5e6"))
        (folder / "factor").mkdir()
        environment = dict(ENVIRONMENT, PETSC_OPTIONS="-hfrac_tangent_mat_mumps_icntl_22 1", MUMPS_OOC_TMPDIR=str(folder / "factor"))
        begin, most, on_disk = time.monotonic(), 0, 0
        peaks = {}
        shares = ["--one-model"] if options.one_model else []
        with subprocess.Popen(over(options.ranks, HFRAC, "run", folder / "case.toml", "-o", folder / "run", "-q", "--workers", options.workers, *shares),
                              env=environment) as running:
            while running.poll() is None:
                processes = children(running.pid)
                most = max(most, memory_of(processes))
                peaks |= peaks_of([running.pid, *processes], pathlib.Path(HFRAC).name)
                on_disk = max(on_disk, sum(path.stat().st_size for path in (folder / "factor").glob("mumps*")))
                time.sleep(min(3.0, 1e-5 * options.discs))
        if running.returncode != 0:
            sys.exit(f"million: hfrac ended with {running.returncode}")
        with open(folder / "run" / "history.csv", encoding="utf-8") as file:
            last = list(csv.DictReader(file))[-1]
    print(f"{options.discs} discs, {options.ranks} ranks{' with one model' if options.one_model else ''}, {options.factor} factor: {1e-9 * most:.2f} GB in all, "
          f"{1e-6 * min(peaks.values(), default=0):.0f} to {1e-6 * max(peaks.values(), default=0):.0f} MB a rank, {1e-9 * on_disk:.2f} GB on disk, "
          f"{time.monotonic() - begin:.0f} s, {last['newton_iterations']} Newton iterations, force ratio {last['force_ratio']}, "
          f"fluid error {float(last['fluid_error_m2']) / float(last['injected_volume_m2']):.1e} of the injected")
    if last["at_rest"] != "1":
        sys.exit("million: no equilibrium")
    if most > 1e9 * options.gigabytes:
        sys.exit(f"million: more than {options.gigabytes} GB")


if __name__ == "__main__":
    main()

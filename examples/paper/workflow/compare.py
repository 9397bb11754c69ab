#!/usr/bin/python3 -B
"""Two tables of measurements, run by run, to the last digit; state hashes are among what is compared.

usage: compare.py TABLE.csv AGAIN.csv [common]

With `common` only points that both tables have are compared: the fast set's runs are runs of the full set, too.
Exit status 0 if every run of both is done and has the same numbers. A run that is missing or broken in either is a
difference: nothing was compared there.
"""
import csv
import sys


def rows_of(path):
    """Rows by what they measure: a point of a figure."""
    with open(path, newline="") as file:
        return {(row["family"], row["series"], row["x"], row["seed"]): row for row in csv.DictReader(file)}


def differences(first, second):
    """(run, what differs) for each point that is not the same in both tables."""
    found = []
    for point in sorted({*first, *second}):
        one, other = first.get(point), second.get(point)
        name = (one or other)["run"]
        if one is None or other is None:
            found.append((name, f"only in the {'second' if one is None else 'first'} table"))
            continue
        states = {one["status"], other["status"]}
        if states != {"done"}:
            found.append((name, f"{one['status']} and {other['status']}"))
            continue
        # "run" is the name of a folder, which says which family came first to a run that several share
        columns = [key for key in {**one, **other} if key != "run" and one.get(key) != other.get(key)]
        if columns:
            found.append((name, ", ".join(f"{key} {one.get(key)} and {other.get(key)}" for key in columns)))
    return found


def main(first, second, which="all"):
    tables = rows_of(first), rows_of(second)
    if which == "common":
        tables = tuple({point: one[point] for point in tables[0].keys() & tables[1].keys()} for one in tables)
    found = differences(*tables)
    for name, what in found[:20]:
        print(f"{name}: {what}")
    if len(found) > 20:
        print(f"... and {len(found) - 20} more")
    verdict = "the same to the last bit" if not found else "NOT the same"
    print(f"{len(tables[0])} points, {len(found)} differ; {verdict}")
    return 1 if found or not tables[0] else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

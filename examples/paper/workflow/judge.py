#!/usr/bin/python3 -B
"""The verdict: each claim of the paper against the measurements. usage: judge.py SET TABLE.csv VERDICT.md

A claim is judged only if every run it rests on is there and has the value asked for.
"""
import pathlib
import sys
import tomllib

import claims_initiation  # noqa: F401  its claims enter the list, in this order
import claims_fracture  # noqa: F401
import families
from claims import CLAIMS
from measured import Incomplete, Measured

HERE = pathlib.Path(__file__).resolve().parent
COMMAND = {
    "full": "examples/paper/run --full",
    "fast": "examples/paper/run --fast",
    "fine": "examples/paper/run --fine",
    "facets": "examples/paper/run --facets",
}


def answer_of(claim, data, limit, **keywords):
    try:
        return claim.judge(data, limit, **keywords), None
    except Incomplete as gap:
        return None, str(gap)


def verdict_of(claim, data, limit):
    """(verdict, figure, test, why) of a claim; the verdict is one of four words, perhaps with a condition."""
    answer, gap = answer_of(claim, data, limit)
    if answer is None:
        return "not judged", gap, "", ""
    notes, other_convention = [], ""
    for where, keywords in claim.against:
        other, gap = answer_of(claim, data, limit, **keywords)
        if other is None:
            notes.append(f"With {where}: not judged, {gap}.")
            continue
        notes.append(f"With {where}: {'holds' if other.holds else 'does not hold'}; {other.figure}.")
        if answer.holds and not other.holds:
            return f"holds only if not with {where}", answer.figure, answer.test, " ".join(notes)
        if other.holds and not answer.holds:
            other_convention = f"with {where}"
    if answer.holds:
        return "holds", answer.figure, answer.test, " ".join(notes)
    tried = [(condition, *answer_of(claim, data, limit, **keywords)) for condition, keywords in claim.needs]
    for condition, other, gap in tried:
        if other is None:
            notes.append(f"Changed physics ({condition}): not judged, {gap}.")
        elif other.holds:
            notes.append(f"With this change it holds: {condition}. {other.figure}.")
        else:
            notes.append(f"Tried: {condition}. {other.figure}; it does not make the claim hold.")
    why = " ".join(one for one in [claim.why_not, *notes] if one)
    helping = [condition for condition, other, _ in tried if other is not None and other.holds]
    conditions = [one for one in [other_convention, *helping] if one]
    return f"holds only if {conditions[0]}" if conditions else "does not hold", answer.figure, answer.test, why


ASSUMPTIONS = """
- 2 000 discs of mean radius 1.12 m in place of Table 1's 3.6 million (`table-1.toml`). Onset falls with finer discs
  unless strengths are scaled to a constant toughness; `--fine` does that.
- The bond's stiffness, which the paper does not print, is 0.46 of the contact's, so that E = 14.2 GPa and nu = 0.24
  (`table-1.toml`).
- Contact and bond act in parallel; a bond breaks at whichever strength it reaches first.
- stress.convention effective: pressures net of the formation's, rigid walls (`convention-effective.toml`). With
  total stresses: boundary under stress, slow ramp (`convention-total.toml`), judged by initiation pressure
  only.
- Stresses of 49, 50, ... and 56 MPa are taken as effective ones from 0 and 8 MPa (`figure-07.toml`, `figure-11.toml`).
- A sub-step lasts 10 ms; 100 of them are a run (`convention-effective.toml`). Figure 12 has 100 s, since permeability cannot
  act within milliseconds (`figure-12.toml`).
- Figure 9's tangential series stands under 31 and 24 MPa effective: without stress nothing breaks in shear
  (`figure-09.toml`).
- Temperature is Table 3 and nothing else: stiffness, friction, porosity; the bond's stiffness in proportion
  (`table-3.toml`).
- Beyond the paper only, each in a family `beyond-*.toml` that says what it changes; among them strength falling to
  0.667 at 400 °C (`strength-by-temperature.toml`).
- Length is the extent of the longest fracture with the hole, width its largest opening. A run ends when a tip comes
  near the boundary; such lengths are lower bounds.
"""


def by_family(data, names):
    """How many of its runs each family lacks."""
    parts = []
    for family in sorted({one.family for one in data.expected}):
        runs = {one.run for one in data.points(family)}
        if runs & names:
            parts.append(f"{family}: {len(runs & names)} of {len(runs)}")
    return "; ".join(parts)


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


# Tables that are kept, and what is said of each where it stands beside another.
KEPT = {
    "full": ("examples/paper/measured.csv", "with 2 000 discs, broken contacts"),
    "fine": ("examples/paper/measured-fine.csv", "with 10 000 discs"),
    "facets": ("examples/paper/measured-facets.csv", "with facets"),
}
TITLES = {
    "fine": "# The paper's claims with finer discs",
    "facets": "# The paper's claims with fractures as facets",
}
ABOUT = {
    "fine": "The set of the [verdict](paper-reproduction.md) with 10 000 discs in place of 2 000, strengths at "
    "constant toughness, half the packings, and three values of each series of Figures 7 to 9. It asks "
    "whether what holds there is the rock's or the discs'; the verdict is the other page's. Changed physics was "
    "not tried here.",
    "facets": "The set of the [verdict](paper-reproduction.md) with `fracture.law = \"facet\"` and nothing else changed, half the "
    "packings, and three values of each series of Figures 7 to 9. It asks whether what holds there holds for fractures that "
    "follow linear elastic fracture mechanics, too ([KGD](verification/kgd-random.md)); the verdict is the other page's. Changed "
    "physics was not tried here.",
}


def others_than(which, limit):
    """[(what it is, verdict by claim)] of the kept sets beside this one."""
    if which not in KEPT:
        return []
    found = []
    for other, (table, words) in KEPT.items():
        if other == which or (which != "full" and other != "full") or not (HERE.parents[2] / table).is_file():
            continue
        data = Measured.read(HERE.parents[2] / table, families.expand(other)[1])
        found.append((words, {claim.words: verdict_of(claim, data, limit)[0] for claim in CLAIMS}))
    return found


def page(which, data, limit, path):
    runs = {one.run for one in data.expected}
    seeds = {one.seed for one in data.expected if one.family == "figure-05"}
    lacking = data.lacking()
    judged = [(claim, *verdict_of(claim, data, limit)) for claim in CLAIMS]
    count = {}
    for _, verdict, *_ in judged:
        word = "holds only if" if verdict.startswith("holds only if") else verdict
        count[word] = count.get(word, 0) + 1
    lines = [
        TITLES.get(which, "# Does it do what the paper says?"),
        "",
        f"Written by `{COMMAND[which]}` from {len(runs) - len(lacking)} of {len(runs)} runs, {len(seeds)} packings "
        f"each; measurements in `{path}`. Thresholds: `examples/paper/workflow/thresholds.toml`, set before the runs. "
        "Means ± standard deviations over packings; intervals are 90 % bootstrap intervals over packings.",
        "",
        f"{len(judged)} claims. " + "; ".join(f"{word}: {n}" for word, n in sorted(count.items())) + ".",
        "",
    ]
    if which == "full":
        lines += [
            "Changes of the physics, tried for claims that fail, have 3 packings "
            '(`examples/paper/families/beyond-*.toml`); so "holds only if" says what can help, not how surely.',
            "",
        ]
    if which in ABOUT:
        lines += [ABOUT[which], ""]
    elif len(seeds) < limit["packings"]["least"]:
        lines += [
            f"**{len(seeds)} packings are no sample** ({limit['packings']['least']} are the least): this page shows "
            "that the workflow works, and decides nothing.",
            "",
        ]
    if lacking:
        for kind in ("missing", "broken"):
            names = {run for run, status in lacking if status == kind}
            if names:
                lines += [
                    f"**{len(names)} runs are {kind}**; no claim that rests on one is judged. "
                    f"{by_family(data, names)}.",
                    "",
                ]
    before = {row["run"]: int(row["equilibration_cracks"] or 0) for row in data.rows.values() if row["status"] == "done"}
    cracked = [count for count in before.values() if count]
    lines += [
        f"{len(cracked)} runs had cracks from the stresses alone, before injection"
        + (f" (at most {max(cracked)})." if cracked else ".")
        + " Initiation pressures are of the first crack after that, and "
        "as fine as the ramp, 1 MPa.",
        "",
    ]
    others = others_than(which, limit)
    lines += [
        "| place | claim | verdict |" + "".join(f" {words} |" for words, _ in others),
        "|---|---|---|" + "---|" * len(others),
    ]
    for claim, verdict, *_ in judged:
        beside = "".join(f" {cell(verdicts[claim.words])} |" for _, verdicts in others)
        lines += [f"| {claim.place} | {claim.words} | **{cell(verdict)}** |{beside}"]
    lines += ["", "## One by one"]
    for claim, verdict, figure, test, why in judged:
        lines += ["", f"**{claim.words}** (section {claim.place}) *{verdict}*", "", f"- ours: {figure}"]
        lines += [f"- test: {test}"] if test else []
        lines += [f"- why: {why}" if verdict != "holds" else f"- besides: {why}"] if why else []
    lines += ["", "## Assumptions", "", "Each once; files are in `examples/paper/families`.", ASSUMPTIONS.strip(), ""]
    lines += figures(which)
    return "\n".join(lines) + "\n"


# Captions of the figures of the page; a name stands for all pictures that begin with it.
CAPTIONS = {
    "figure-03": "Figure 3, the model: discs and bonds",
    "figure-04": "Figure 4, five stages at 45 MPa; moving: at 45 and 60 MPa",
    "figure-05": "Figure 5, cracks over the sub-steps and at their end",
    "figure-06": "Figure 6, broken bonds at 30, 40, 50 and 60 MPa",
    "figure-07": "Figure 7, initiation by horizontal stresses",
    "figure-08": "Figure 8, initiation by contact stiffness",
    "figure-09": "Figure 9, initiation by bond strength",
    "figure-10": "Figure 10, length (a) and width (b) by injection pressure",
    "figure-11": "Figure 11, length (a) and width (b) by the smaller stress",
    "figure-12": "Figure 12, length (a) and width (b) by permeability",
    "total-": "Total stresses: initiation as in Figures 7, 8, 9 and 12",
    "beyond-": "Beyond the paper: changed physics, tried for claims that fail",
}


def figures(which):
    """Links to the figures that are there, beside the page of the full set only."""
    folder = HERE.parents[2] / "docs/images/paper"
    if which != "full" or not folder.is_dir():
        return []
    lines = ["## Figures", "", "Drawn by `hfrac plot` and `hfrac render` from the runs above."]
    there = sorted(path for path in folder.iterdir() if path.suffix in (".png", ".webp"))
    for start, caption in CAPTIONS.items():
        shown = [path for path in there if path.name.startswith(start)]
        if shown:
            lines += ["", f"### {caption}"]
        for path in shown:
            lines += ["", f"![{path.stem.replace('-', ' ')}](images/paper/{path.name})"]
    return lines


def main(which, table, verdict):
    expected = families.expand(which)[1]
    limit = tomllib.loads((HERE / "thresholds.toml").read_text())
    shown = KEPT[which][0] if which in KEPT else pathlib.Path(table).name
    text = page(which, Measured.read(table, expected), limit, shown)
    pathlib.Path(verdict).write_text(text)
    print(next(line for line in text.splitlines() if " claims. " in line))


if __name__ == "__main__":
    main(*sys.argv[1:])

"""Section 4: cracks at held pressures (Figures 5, 6), and what the first crack depends on (Figures 7 to 9)."""
import numpy as np
from claims import Answer, claim, listed, slope_of, span
from estimates import interval, kink, r_squared, spearman

TOTAL_7 = (("total stresses", {"family": "figure-07-total"}),)
TOTAL_8 = (("total stresses", {"family": "figure-08-total"}),)
TOTAL_9 = (("total stresses", {"family": "figure-09-total"}),)
# Changes of the physics tried for Figures 5 and 9, and the families that have them.
TRIED_05 = (
    ("a run has the paper's 500 sub-steps, not 100", {"family": "beyond-05-steps"}),
    ("fluid is never short: in a sub-step of 1 s cracks fill", {"family": "beyond-05-supply"}),
    ("horizontal stresses are 7 and 0 MPa, not equal", {"family": "beyond-05-stress"}),
)
TENTH_05 = (("a sub-step brings a tenth of the fluid", {"family": "beyond-10-supply", "series": "250 C"}),)
TRIED_09 = (
    ("stresses are 28 and 21 MPa effective, not 31 and 24", {"family": "beyond-09-lower"}),
    ("stresses are equal, 24 and 24 MPa effective, not 31 and 24", {"family": "beyond-09-stress"}),
)


@claim("4.3.1, Figure 5", "Below the initiation pressure nothing cracks.")
def quiet_below_initiation(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    limit = limit["figure-05"]["quiet_up_to"]
    worst = cracks.values[:, cracks.x <= limit].max()
    return Answer(
        bool(worst == 0),
        f"most cracks in any packing at {limit} MPa: {worst:.0f}; mean cracks at "
        f"{', '.join(f'{x:g}' for x in cracks.x)} MPa: {listed(cracks)}",
        f"none at ≤ {limit} MPa (the paper: none below 35)",
    )


@claim(
    "4.3.1, Figure 5",
    "Cracks begin at 35 MPa.",
    "First cracks follow the weakest place at the hole, which differs from packing to packing.",
)
def onset_pressure(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    low, high = limit["figure-05"]["onset"]
    first = np.array([next((x for x, n in zip(cracks.x, row) if n > 0), np.inf) for row in cracks.values])
    middle = float(np.median(first))
    return Answer(
        low <= middle <= high,
        f"median {middle:g} MPa; packings {', '.join(f'{x:g}' for x in first)} MPa",
        f"median over packings in {low} to {high} MPa",
    )


@claim("4.3.1, Figure 5", "The higher the injection pressure, the more cracks.")
def cracks_rise(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    limit = limit["figure-05"]
    rank = spearman(cracks.x, cracks.means)
    few, many = cracks.at(45).mean(), cracks.at(60).mean()
    return Answer(
        rank >= limit["rising_spearman"] and few > 0 and many >= limit["many_over_few"] * few,
        f"Spearman {rank:.2f}; {few:.1f} cracks at 45 MPa, {many:.1f} at 60",
        f"Spearman of means ≥ {limit['rising_spearman']}, n(60) ≥ {limit['many_over_few']:g} n(45)",
    )


@claim(
    "4.3.1, Figure 5",
    "Between 35 and 55 MPa the number of cracks grows slowly and levels off.",
    "With short sub-steps a crack that has begun may go on for as long as fluid arrives.",
    against=(("runs of the paper's 500 sub-steps (3 packings)", {"family": "beyond-05-steps"}),),
)
def plateau(data, limit, family="figure-05"):
    before = data.table(family, "paper", "cracks_at_four_fifths").at(45).mean()
    after = data.table(family, "paper", "cracks").at(45).mean()
    early = data.table(family, "paper", "cracks_at_tenth").at(45).mean()
    growth = (after - before) / after if after > 0 else 1.0
    most = limit["figure-05"]["plateau_growth"]
    return Answer(
        growth <= most,
        f"at 45 MPa {early:.1f} cracks after a tenth of the sub-steps, {before:.1f} after four "
        f"fifths, {after:.1f} at the end: the last fifth adds {100 * growth:.0f} %",
        f"the last fifth of the sub-steps adds ≤ {100 * most:.0f} % at 45 MPa",
    )


@claim(
    "4.3.1, Figure 5",
    "Above 55 MPa the cracks reach their number within a very short time.",
    "Here wings go on growing while fluid arrives; the number is not reached at once.",
    needs=TRIED_05,
)
def sudden_above_upper(data, limit, family="figure-05"):
    early = data.table(family, "paper", "cracks_at_tenth")
    end = data.table(family, "paper", "cracks")
    shares = {x: early.at(x).sum() / max(end.at(x).sum(), 1) for x in (45, 60, 65) if x in end.x}
    least = limit["figure-05"]["sudden_share"]
    return Answer(
        all(share >= least for x, share in shares.items() if x >= 60),
        "after a tenth of the sub-steps " + ", ".join(f"{100 * s:.0f} % at {x} MPa" for x, s in shares.items()),
        f"≥ {100 * least:.0f} % of the cracks after a tenth of the sub-steps at 60 MPa and above",
    )


@claim(
    "4.3.1, Figure 5",
    "The behaviour changes at 55 MPa.",
    "Without stresses the number of cracks rises steadily from the first on; nothing singles out an upper pressure. "
    "Where stresses differ, one direction is easy and the others need more pressure.",
    needs=(TRIED_05[2], *TENTH_05),
)
def upper_pressure(data, limit, family="figure-05", series="paper"):
    cracks = data.table(family, series, "cracks")
    limit = limit["figure-05"]
    cracking = cracks.x >= 30
    where, before, after = kink(cracks.x[cracking], cracks.means[cracking])
    strong = after >= limit["kink_ratio"] * max(before, 0.0) if before > 0 else after > 0
    low, high = limit["upper_limit"]
    return Answer(
        bool(low <= where <= high and strong),
        f"change point {where:.0f} MPa, {before:.2f} cracks per MPa before, " f"{after:.2f} after",
        f"change point of mean cracks in {low} to {high} MPa, slopes {limit['kink_ratio']}-fold",
    )


@claim("4.3.1, Figure 5", "Excessive pressure opens fractures in other directions besides the main one.")
def more_wings(data, limit):
    wings = data.table("figure-05", "paper", "wings")
    gain = (wings.at(65) - wings.at(45))[:, None]
    sure = interval(gain, lambda mean: mean[..., 0])
    return Answer(
        sure[0] > 0,
        f"wings at 45 MPa {wings.at(45).mean():.1f}, at 65 MPa {wings.at(65).mean():.1f}; gain "
        f"{gain.mean():.1f} {span(sure, 1)}",
        "gain of wings from 45 to 65 MPa, interval above 0",
    )


@claim("4.3.1, Figure 6", "Every broken bond is a crack drawn.")
def bonds_are_cracks(data, limit):
    broken = data.table("figure-05", "paper", "cracks")
    drawn = data.table("figure-05", "paper", "cracks_drawn")
    wrong = int(np.sum(broken.values != drawn.values))
    return Answer(
        wrong == 0,
        f"{int(broken.values.sum())} bonds, {int(drawn.values.sum())} cracks in {broken.values.size} runs",
        "equal in every run",
    )


def in_proportion(onset, limit):
    """A straight line whose slope lies between two limits."""
    rise, sure = slope_of(onset)
    fit = r_squared(onset.x, onset.means)
    low, high = limit["slope"]
    return Answer(
        low <= rise <= high and fit >= limit["linear_r2"],
        f"slope {rise:.2f} {span(sure)}, R² {fit:.3f}; {listed(onset)} MPa",
        f"slope {low:g} to {high:g}, R² of means ≥ {limit['linear_r2']}",
    )


@claim("4.3.2, Figure 7", "Initiation pressure rises in proportion to the smaller horizontal stress.", against=TOTAL_7)
def smaller_stress(data, limit, family="figure-07"):
    return in_proportion(data.table(family, "sigma_hmin", "onset_MPa"), limit["figure-07"])


@claim(
    "4.3.2, Figure 7",
    "The larger horizontal stress hardly matters.",
    against=TOTAL_7,
    why_not="Elastic theory (Kirsch 1898) has initiation fall with the larger stress, at a third of the other's slope.",
)
def larger_stress(data, limit, family="figure-07"):
    reference, _ = slope_of(data.table(family, "sigma_hmin", "onset_MPa"))
    onset = data.table(family, "sigma_Hmax", "onset_MPa")
    rise, sure = slope_of(onset)
    share = limit["figure-07"]["sigma_Hmax_share"]
    return Answer(
        abs(rise) <= share * reference,
        f"slope {rise:.2f} {span(sure)} against {reference:.2f}; {listed(onset)} MPa",
        f"|slope| ≤ {share} of the smaller stress's",
    )


def rise_of(table):
    def relative(mean):
        return (mean[..., -1] - mean[..., 0]) / mean[..., 0]

    return float(relative(table.means)), interval(table.values, relative)


@claim("4.3.2, Figure 8", "Initiation pressure rises with the contacts' normal stiffness.", against=TOTAL_8)
def normal_stiffness(data, limit, family="figure-08"):
    onset = data.table(family, "normal", "onset_MPa")
    rise, sure = rise_of(onset)
    least = limit["figure-08"]["normal_rise"]
    return Answer(
        rise >= least,
        f"rise {100 * rise:.0f} % [{100 * sure[0]:.0f}, {100 * sure[1]:.0f}]; {listed(onset)} MPa",
        f"rise ≥ {100 * least:.0f} % from {onset.x[0]:g} to {onset.x[-1]:g} GN/m",
    )


@claim("4.3.2, Figure 8 and 7", "The tangential stiffness does not matter.", against=TOTAL_8)
def tangential_stiffness(data, limit, family="figure-08"):
    normal, _ = rise_of(data.table(family, "normal", "onset_MPa"))
    onset = data.table(family, "tangential", "onset_MPa")
    rise, sure = rise_of(onset)
    share = limit["figure-08"]["tangential_share"]
    return Answer(
        rise <= share * normal,
        f"rise {100 * rise:.0f} % [{100 * sure[0]:.0f}, {100 * sure[1]:.0f}] against "
        f"{100 * normal:.0f} %; {listed(onset)} MPa",
        f"rise ≤ {share} of the normal stiffness's",
    )


@claim("4.3.2, Figure 9", "Initiation pressure rises in proportion to the bonds' normal strength.", against=TOTAL_9)
def normal_strength(data, limit, family="figure-09"):
    return in_proportion(data.table(family, "normal", "onset_MPa"), limit["figure-09"])


@claim(
    "4.3.2, Figure 9",
    "It rises with the tangential strength too, but less.",
    against=TOTAL_9,
    why_not="Where the tangential strength is the smaller one it counts nearly as much as the other; once it exceeds "
    "the normal strength the first bond breaks in tension and it does not act at all.",
    needs=TRIED_09,
)
def tangential_strength(data, limit, family="figure-09"):
    normal = "figure-09" if family.startswith("beyond") else family
    reference, _ = slope_of(data.table(normal, "normal", "onset_MPa"))
    onset = data.table(family, "tangential", "onset_MPa")
    rise, sure = slope_of(onset)
    share = limit["figure-09"]["tangential_share"]
    return Answer(
        0.0 <= rise <= share * reference,
        f"slope {rise:.4f} {span(sure)} against {reference:.4f}; {listed(onset)} " "MPa",
        f"slope not negative and ≤ {share} of the normal strength's, here {share * reference:.4f}",
    )

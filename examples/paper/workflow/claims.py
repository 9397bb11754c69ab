"""What the paper claims, each with its place and the test that decides. A claim is a function of the measurements and the
thresholds; it answers with its figure, and measured.Incomplete where runs lack. Nothing here writes or reads files."""
import dataclasses
from collections.abc import Callable

import numpy as np
from estimates import interval, kink, largest_drop, r_squared, slope, spearman

CLAIMS = []


@dataclasses.dataclass(frozen=True)
class Answer:
    holds: bool
    figure: str
    test: str


@dataclasses.dataclass(frozen=True)
class Claim:
    name: str
    place: str
    words: str  # the claim in our words
    why_not: str  # what stands against it where it fails; physics, not excuse
    judge: Callable
    against: tuple = ()  # (where, keywords): the same test on other runs, e.g. the sound reading
    needs: tuple = ()  # (condition, keywords): changes of the physics that may make it hold


def claim(place, words, why_not="", against=(), needs=()):
    def keep(judge):
        CLAIMS.append(Claim(judge.__name__, place, words, why_not, judge, against, needs))
        return judge

    return keep


def listed(table, digits=1):
    return ", ".join(f"{m:.{digits}f} ± {s:.{digits}f}" for m, s in zip(table.means, table.spread))


def span(pair, digits=2):
    return f"[{pair[0]:.{digits}f}, {pair[1]:.{digits}f}]"


def slope_of(table):
    return float(slope(table.x, table.means)), interval(table.values, lambda mean: slope(table.x, mean))


SOUND_7 = (("the sound reading", {"family": "figure-07-sound"}),)
SOUND_8 = (("the sound reading", {"family": "figure-08-sound"}),)
SOUND_9 = (("the sound reading", {"family": "figure-09-sound"}),)
SUPPLY_05 = (("fluid is never short: a sub-step lasts 1 s, so that open cracks fill within it", {"family": "beyond-05-supply"}),)
STRENGTH_10 = (("strength falls with temperature (assumed table)", {"hot": "beyond-10-strength"}),)
STRENGTH_11 = (("strength falls with temperature (assumed table)", {"hot": "beyond-11-strength"}),)


@claim("4.3.1, Figure 5", "Below the initiation pressure nothing cracks.")
def quiet_below_initiation(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    limit = limit["figure-05"]["quiet_up_to"]
    worst = cracks.values[:, cracks.x <= limit].max()
    return Answer(bool(worst == 0), f"most cracks in any packing at {limit} MPa: {worst:.0f}; mean cracks at "
                  f"{', '.join(f'{x:g}' for x in cracks.x)} MPa: {listed(cracks)}", f"none at ≤ {limit} MPa (the paper: none below 35)")


@claim("4.3.1, Figure 5", "Cracks begin at 35 MPa.",
       "First cracks follow the weakest place at the hole, which differs from packing to packing.")
def onset_pressure(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    low, high = limit["figure-05"]["onset"]
    first = np.array([next((x for x, n in zip(cracks.x, row) if n > 0), np.inf) for row in cracks.values])
    middle = float(np.median(first))
    return Answer(low <= middle <= high, f"median {middle:g} MPa; packings {', '.join(f'{x:g}' for x in first)} MPa",
                  f"median over packings in {low} to {high} MPa")


@claim("4.3.1, Figure 5", "The higher the injection pressure, the more cracks.")
def cracks_rise(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    limit = limit["figure-05"]
    rank = spearman(cracks.x, cracks.means)
    few, many = cracks.at(45).mean(), cracks.at(60).mean()
    return Answer(rank >= limit["rising_spearman"] and few > 0 and many >= limit["many_over_few"] * few,
                  f"Spearman {rank:.2f}; {few:.1f} cracks at 45 MPa, {many:.1f} at 60",
                  f"Spearman of means ≥ {limit['rising_spearman']}, n(60) ≥ {limit['many_over_few']:g} n(45)")


@claim("4.3.1, Figure 5", "Between 35 and 55 MPa the number of cracks grows slowly and levels off.",
       "With short sub-steps a crack that has begun may go on for as long as fluid arrives.")
def plateau(data, limit):
    before = data.table("figure-05", "paper", "cracks_at_four_fifths").at(45).mean()
    after = data.table("figure-05", "paper", "cracks").at(45).mean()
    early = data.table("figure-05", "paper", "cracks_at_tenth").at(45).mean()
    growth = (after - before) / after if after > 0 else 1.0
    most = limit["figure-05"]["plateau_growth"]
    return Answer(growth <= most, f"at 45 MPa {early:.1f} cracks after a tenth of the sub-steps, {before:.1f} after four "
                  f"fifths, {after:.1f} at the end: the last fifth adds {100 * growth:.0f} %",
                  f"the last fifth of the sub-steps adds ≤ {100 * most:.0f} % at 45 MPa")


@claim("4.3.1, Figure 5", "Above 55 MPa the cracks reach their number within a very short time.",
       "Here arms go on growing while fluid arrives; the number is not reached at once.", needs=SUPPLY_05)
def sudden_above_upper(data, limit, family="figure-05"):
    early = data.table(family, "paper", "cracks_at_tenth")
    end = data.table(family, "paper", "cracks")
    shares = {x: early.at(x).sum() / max(end.at(x).sum(), 1) for x in (45, 60, 65) if x in end.x}
    least = limit["figure-05"]["sudden_share"]
    return Answer(all(share >= least for x, share in shares.items() if x >= 60),
                  "after a tenth of the sub-steps " + ", ".join(f"{100 * s:.0f} % at {x} MPa" for x, s in shares.items()),
                  f"≥ {100 * least:.0f} % of the cracks after a tenth of the sub-steps at 60 MPa and above")


@claim("4.3.1, Figure 5", "The behaviour changes at 55 MPa.",
       "The number of cracks rises steadily with pressure; nothing in the model singles out an upper pressure.")
def upper_pressure(data, limit):
    cracks = data.table("figure-05", "paper", "cracks")
    limit = limit["figure-05"]
    cracking = cracks.x >= 30
    where, before, after = kink(cracks.x[cracking], cracks.means[cracking])
    strong = after >= limit["kink_ratio"] * max(before, 0.0) if before > 0 else after > 0
    low, high = limit["upper_limit"]
    return Answer(bool(low <= where <= high and strong), f"change point {where:.0f} MPa, {before:.2f} cracks per MPa before, "
                  f"{after:.2f} after", f"change point of mean cracks in {low} to {high} MPa, slopes {limit['kink_ratio']}-fold")


@claim("4.3.1, Figure 5", "Excessive pressure opens fractures in other directions besides the main one.")
def more_arms(data, limit):
    arms = data.table("figure-05", "paper", "arms")
    gain = (arms.at(65) - arms.at(45))[:, None]
    sure = interval(gain, lambda mean: mean[..., 0])
    return Answer(sure[0] > 0, f"arms at 45 MPa {arms.at(45).mean():.1f}, at 65 MPa {arms.at(65).mean():.1f}; gain "
                  f"{gain.mean():.1f} {span(sure, 1)}", "gain of arms from 45 to 65 MPa, interval above 0")


@claim("4.3.1, Figure 6", "Every broken bond is a crack drawn.")
def bonds_are_cracks(data, limit):
    broken = data.table("figure-05", "paper", "cracks")
    drawn = data.table("figure-05", "paper", "cracks_drawn")
    wrong = int(np.sum(broken.values != drawn.values))
    return Answer(wrong == 0, f"{int(broken.values.sum())} bonds, {int(drawn.values.sum())} cracks in {broken.values.size} runs",
                  "equal in every run")


@claim("4.3.2, Figure 7", "Initiation pressure rises in proportion to the smaller horizontal stress.", against=SOUND_7)
def smaller_stress(data, limit, family="figure-07"):
    onset = data.table(family, "sigma_h", "onset_MPa")
    rise, sure = slope_of(onset)
    limit = limit["figure-07"]
    fit = r_squared(onset.x, onset.means)
    low, high = limit["slope"]
    return Answer(low <= rise <= high and fit >= limit["linear_r2"],
                  f"slope {rise:.2f} {span(sure)}, R² {fit:.2f}; {listed(onset)} MPa",
                  f"slope {low:g} to {high:g}, R² of means ≥ {limit['linear_r2']}")


@claim("4.3.2, Figure 7", "The larger horizontal stress hardly matters.", against=SOUND_7,
       why_not="Elastic theory (Kirsch 1898) has initiation fall with the larger stress, at a third of the other's slope.")
def larger_stress(data, limit, family="figure-07"):
    reference, _ = slope_of(data.table(family, "sigma_h", "onset_MPa"))
    onset = data.table(family, "sigma_H", "onset_MPa")
    rise, sure = slope_of(onset)
    share = limit["figure-07"]["sigma_H_share"]
    return Answer(abs(rise) <= share * reference, f"slope {rise:.2f} {span(sure)} against {reference:.2f}; {listed(onset)} MPa",
                  f"|slope| ≤ {share} of the smaller stress's")


def rise_of(table):
    def relative(mean):
        return (mean[..., -1] - mean[..., 0]) / mean[..., 0]

    return float(relative(table.means)), interval(table.values, relative)


@claim("4.3.2, Figure 8", "Initiation pressure rises with the contacts' normal stiffness.", against=SOUND_8)
def normal_stiffness(data, limit, family="figure-08"):
    onset = data.table(family, "normal", "onset_MPa")
    rise, sure = rise_of(onset)
    least = limit["figure-08"]["normal_rise"]
    return Answer(rise >= least, f"rise {100 * rise:.0f} % [{100 * sure[0]:.0f}, {100 * sure[1]:.0f}]; {listed(onset)} MPa",
                  f"rise ≥ {100 * least:.0f} % from {onset.x[0]:g} to {onset.x[-1]:g} GN/m")


@claim("4.3.2, Figure 8 and 7", "The tangential stiffness does not matter.", against=SOUND_8)
def tangential_stiffness(data, limit, family="figure-08"):
    normal, _ = rise_of(data.table(family, "normal", "onset_MPa"))
    onset = data.table(family, "tangential", "onset_MPa")
    rise, sure = rise_of(onset)
    share = limit["figure-08"]["tangential_share"]
    return Answer(rise <= share * normal, f"rise {100 * rise:.0f} % [{100 * sure[0]:.0f}, {100 * sure[1]:.0f}] against "
                  f"{100 * normal:.0f} %; {listed(onset)} MPa", f"rise ≤ {share} of the normal stiffness's")


@claim("4.3.2, Figure 9", "Initiation pressure rises in proportion to the bonds' normal strength.", against=SOUND_9)
def normal_strength(data, limit, family="figure-09"):
    onset = data.table(family, "normal", "onset_MPa")
    rise, sure = slope_of(onset)
    limit = limit["figure-09"]
    fit = r_squared(onset.x, onset.means)
    low, high = limit["slope"]
    return Answer(low <= rise <= high and fit >= limit["linear_r2"],
                  f"slope {rise:.2f} {span(sure)}, R² {fit:.2f}; {listed(onset)} MPa",
                  f"slope {low:g} to {high:g}, R² of means ≥ {limit['linear_r2']}")


@claim("4.3.2, Figure 9", "It rises with the tangential strength too, but less.", against=SOUND_9)
def tangential_strength(data, limit, family="figure-09"):
    reference, _ = slope_of(data.table(family, "normal", "onset_MPa"))
    onset = data.table(family, "tangential", "onset_MPa")
    rise, sure = slope_of(onset)
    share = limit["figure-09"]["tangential_share"]
    return Answer(0.0 <= rise <= share * reference, f"slope {rise:.2f} {span(sure)} against {reference:.2f}; {listed(onset)} "
                  "MPa", f"slope not negative and ≤ {share} of the normal strength's")


def inner_maximum(table, drop):
    place = int(np.argmax(table.means))
    inner = 0 < place < len(table.x) - 1 and table.means[-1] <= (1.0 - drop) * table.means[place]
    return bool(inner), float(table.x[place])


def with_pressure(data, limit, quantity, digits):
    drop = limit["figure-10"]["inner_drop"]
    parts, good = [], []
    for series in ("250 C", "300 C", "350 C", "400 C"):
        table = data.table("figure-10", series, quantity)
        inner, place = inner_maximum(table, drop)
        good.append(inner)
        parts.append(f"{series}: largest at {place:g} MPa ({listed(table, digits)} m)")
    return Answer(all(good), "; ".join(parts),
                  f"at each temperature the largest mean is inside and the last lies ≥ {100 * drop:.0f} % below it")


@claim("5.1, Figure 10a", "Fracture length first grows with injection pressure, then falls.",
       "At high pressure fluid is never short at a held pressure, so arms do not take from each other.")
def length_falls_again(data, limit):
    return with_pressure(data, limit, "extent_m", 0)


@claim("5.1, Figure 10b", "Fracture width first grows with injection pressure, then falls.",
       "Width is elastic opening under the pressure held in the well; more pressure opens more. The paper's own text also says "
       "that width goes on rising slowly.")
def width_falls_again(data, limit):
    return with_pressure(data, limit, "width_m", 3)


def volume(data, family, series):
    extent, width = (data.table(family, series, one) for one in ("extent_m", "width_m"))
    return extent.x, extent.values * width.values


@claim("5.1, Figure 10", "The optimum of length times width lies at 60 MPa at 250 C and at 40 MPa at 400 C.",
       "Table 3 changes stiffness only. Quasi-static breakage depends on pressure over strength, so stiffness alone cannot move "
       "an optimum by a third.", needs=STRENGTH_10)
def optimum_moves(data, limit, hot="figure-10"):
    limit, best = limit["figure-10"], {}
    for temperature, family in ((250, "figure-10"), (400, hot)):
        x, values = volume(data, family, f"{temperature} C")
        best[temperature] = float(x[int(np.argmax(values.mean(axis=0)))])
    near = all(abs(best[t] - limit["optimum"][str(t)]) <= limit["optimum_within"] for t in best)
    return Answer(near and best[400] < best[250], f"{best[250]:g} MPa at 250 C, {best[400]:g} MPa at 400 C",
                  f"60 and 40 MPa, each within {limit['optimum_within']}, and falling")


@claim("5.2, Figure 11", "Fracture length and width fall with the smaller horizontal stress.")
def falls_with_stress(data, limit):
    parts, good = [], []
    for series in ("250 C", "400 C"):
        for quantity in ("extent_m", "width_m"):
            table = data.table("figure-11", series, quantity)
            rank = float(np.mean([spearman(table.x, row) for row in table.values]))
            good.append(rank <= limit["figure-11"]["spearman"])
            parts.append(f"{series} {quantity[:-2]} {rank:.2f}")
    return Answer(all(good), "mean Spearman: " + ", ".join(parts), f"each ≤ {limit['figure-11']['spearman']}")


@claim("5.2, Figure 11", "At a key stress length and width drop suddenly.",
       "Where the drop comes differs from packing to packing; in some there is none.")
def sudden_drop(data, limit):
    limit = limit["figure-11"]
    parts, good = [], []
    for series in ("250 C", "400 C"):
        extent = data.table("figure-11", series, "extent_m")
        drops = [largest_drop(row, limit["from_cracks_m"]) for row in extent.values]
        share = float(np.mean([drop >= limit["jump"] for _, drop in drops]))
        good.append(share >= limit["jump_packings"])
        parts.append(f"{series}: " + ", ".join(f"{100 * d:.0f} % after {extent.x[i]:g} MPa" for i, d in drops))
    return Answer(all(good), "largest fall of extent by packing, " + "; ".join(parts),
                  f"≥ {100 * limit['jump']:.0f} % within one step in ≥ {100 * limit['jump_packings']:.0f} % of the packings")


@claim("5.2, Figure 11", "The key stress is lower in hotter rock (51 MPa at 250 C, 49 MPa at 400 C).",
       "In Table 3 hotter rock is softer, not weaker. Absolute values hang on how the paper's stresses are read.",
       needs=STRENGTH_11)
def key_stress_moves(data, limit, hot="figure-11"):
    floor = limit["figure-11"]["from_cracks_m"]
    cold_table = data.table("figure-11", "250 C", "extent_m")
    hot_table = data.table(hot, "400 C", "extent_m")
    places = [[table.x[largest_drop(row, floor)[0]] + 0.5 for row in table.values] for table in (cold_table, hot_table)]
    change = (np.array(places[1]) - np.array(places[0]))[:, None]
    sure = interval(change, lambda mean: mean[..., 0])
    return Answer(sure[1] < 0, f"250 C {np.mean(places[0]):.1f} MPa, 400 C {np.mean(places[1]):.1f} MPa effective; change "
                  f"{change.mean():.1f} {span(sure, 1)}", "change of the key stress, interval below 0")


@claim("5.2, Figure 11", "Beyond the key stress length falls more slowly than before it.",
       "The mean over packings blurs the drop; a change of slope is then not certain.")
def slower_beyond(data, limit):
    parts, good = [], []
    for series in ("250 C", "400 C"):
        extent = data.table("figure-11", series, "extent_m")
        key, _ = largest_drop(extent.means, limit["figure-11"]["from_cracks_m"])
        if not 1 <= key <= len(extent.x) - 3:
            good.append(False)
            parts.append(f"{series}: the largest drop of the mean is after {extent.x[key]:g} MPa, at the end of the series")
            continue
        before, after = (float(slope(extent.x[part], extent.means[part])) for part in (slice(0, key + 1), slice(key + 1, None)))
        good.append(before < 0 and abs(after) < abs(before))
        parts.append(f"{series}: {before:.2f} m/MPa up to {extent.x[key]:g} MPa, {after:.2f} after the drop")
    return Answer(all(good), "; ".join(parts), "on both sides of the largest drop of the mean: falling before, flatter after")


@claim("5.3, Figure 12", "Fracture length and width grow with permeability.",
       "Cracks fill through themselves; what seeps into rock of some millidarcy within the run is little.")
def grows_with_permeability(data, limit):
    parts, good = [], []
    for series in ("250 C", "400 C"):
        for quantity in ("width_m", "cracks"):
            table = data.table("figure-12", series, quantity)
            rise, sure = slope_of(table)
            good.append(sure[1] >= limit["figure-12"]["not_falling"])
            parts.append(f"{series} {quantity.removesuffix('_m')} {rise:.3g} [{sure[0]:.2g}, {sure[1]:.2g}] per mD")
    return Answer(all(good), "; ".join(parts), "no slope's interval lies below 0")


@claim("5.3, Figure 12", "The increase becomes steeper at about 5.8 mD.",
       "Nothing in the equations changes at a permeability; leak-off grows in proportion to its root.")
def permeability_kink(data, limit):
    limit = limit["figure-12"]
    parts, good = [], []
    for series in ("250 C", "400 C"):
        for quantity in ("extent_m", "width_m"):
            table = data.table("figure-12", series, quantity)
            where, before, after = kink(table.x, table.means)
            good.append(abs(where - limit["kink"]) <= limit["kink_within"] and before >= 0
                        and after > limit["kink_ratio"] * before)
            parts.append(f"{series} {quantity[:-2]}: {where:.1f} mD, {before:.2g} before, {after:.2g} m/mD after")
    return Answer(all(good), "; ".join(parts),
                  f"change point {limit['kink']} ± {limit['kink_within']:g} mD, slope {limit['kink_ratio']}-fold after")


@claim("5.3, Figure 12", "The hotter the rock, the more permeability adds.",
       "With no clear growth at any temperature there is no difference to see.")
def hotter_grows_more(data, limit):
    parts, good = [], []
    for quantity in ("extent_m", "width_m"):
        cold, hot = (data.table("figure-12", series, quantity) for series in ("250 C", "400 C"))
        more = interval(hot.values - cold.values, lambda mean: slope(cold.x, mean))
        good.append(more[0] > 0)
        parts.append(f"{quantity[:-2]}: 400 C less 250 C [{more[0]:.2g}, {more[1]:.2g}] m/mD")
    return Answer(all(good), "; ".join(parts), "difference of slopes, interval above 0")


@claim("4.3.2 and 7", "Fractures run along the larger horizontal stress.")
def along_larger_stress(data, limit):
    azimuth = data.table("figure-12", "250 C", "azimuth_deg", gaps=True).values
    azimuth = np.nanmean(azimuth[~np.isnan(azimuth).all(axis=1)], axis=1)[:, None]
    sure = interval(azimuth, lambda mean: mean[..., 0])
    most = limit["figure-12"]["azimuth_deg"]
    return Answer(azimuth.mean() <= most, f"longest fracture {azimuth.mean():.0f}° {span(sure, 0)} from the larger stress, "
                  "under 7 and 0 MPa", f"mean ≤ {most}°")

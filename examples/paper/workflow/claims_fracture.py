"""Section 5: how far and wide fractures get, by pressure, stress and permeability, at four temperatures (10 to 12)."""
import numpy as np
from claims import Answer, claim, listed, slope_of, span
from estimates import interval, kink, largest_drop, slope, spearman

# Changes of the physics tried, and the families that have them. "As much fluid": the run ends when its fractures hold
# what those at 45 MPa hold.
WEAKER = "strength falls with temperature (assumed table)"
TRIED_10 = (
    ("a sub-step brings a tenth of the fluid, 250 C alone", {"family": "beyond-10-supply", "temperatures": ("250 C",)}),
    (
        "every pressure has as much fluid, 250 C alone",
        {"family": "beyond-10-volume", "temperatures": ("250 C",)},
    ),
)
TRIED_OPTIMUM = ((WEAKER, {"hot": "beyond-10-strength"}),)
LOWER = (("injection is held at 50 MPa, not 60", {"family": "beyond-11-pressure"}),)
TRIED_KEY = (
    (WEAKER, {"hot": "beyond-11-strength"}),
    (LOWER[0][0], {"family": "beyond-11-pressure", "hot": "beyond-11-pressure"}),
)
TRIED_12 = (
    ("injection lasts twelve days, not three hours", {"family": "beyond-12-slow", "hot": "beyond-12-slow"}),
    (WEAKER + "", {"hot": "beyond-12-strength"}),
)


def inner_maximum(table, drop):
    place = int(np.argmax(table.means))
    inner = 0 < place < len(table.x) - 1 and table.means[-1] <= (1.0 - drop) * table.means[place]
    return bool(inner), float(table.x[place])


TEMPERATURES = ("250 C", "300 C", "350 C", "400 C")


def with_pressure(data, limit, quantity, digits, family, temperatures):
    drop = limit["figure-10"]["inner_drop"]
    parts, good = [], []
    for series in temperatures:
        table = data.table(family, series, quantity)
        inner, place = inner_maximum(table, drop)
        good.append(inner)
        parts.append(f"{series}: largest at {place:g} MPa ({listed(table, digits)} m)")
    return Answer(
        all(good),
        "; ".join(parts),
        f"at each temperature the largest mean is inside and the last lies ≥ {100 * drop:.0f} % below it",
    )


@claim(
    "5.1, Figure 10a",
    "Fracture length first grows with injection pressure, then falls.",
    "At a held pressure wings do not take fluid from each other, and they hinder each other little: n wings of one "
    "length under one pressure feel 2 sqrt(n - 1) / n of what a single crack feels (Westmann 1964), 0.87 with 4 wings "
    "and 0.75 with 6, less than the pressure gains.",
    needs=TRIED_10,
)
def length_falls_again(data, limit, family="figure-10", temperatures=TEMPERATURES):
    return with_pressure(data, limit, "extent_m", 0, family, temperatures)


@claim(
    "5.1, Figure 10b",
    "Fracture width first grows with injection pressure, then falls.",
    "Width is elastic opening under the pressure held in the well; more pressure opens more. The paper's own text also "
    "says that width goes on rising slowly.",
    needs=TRIED_10,
)
def width_falls_again(data, limit, family="figure-10", temperatures=TEMPERATURES):
    return with_pressure(data, limit, "width_m", 3, family, temperatures)


def volume(data, family, series):
    extent, width = (data.table(family, series, one) for one in ("extent_m", "width_m"))
    return extent.x, extent.values * width.values


@claim(
    "5.1, Figure 10",
    "The optimum of length times width lies at 60 MPa at 250 C and at 40 MPa at 400 C.",
    "Without a fall there is no optimum. Nor could Table 3 move one so far: quasi-static breakage depends on pressure "
    "over strength, which it leaves alone, and its denser packing at 350 and 400 C cracks later. Falling strength "
    "moves the whole curve to lower pressures, as the paper has it.",
    needs=TRIED_OPTIMUM,
)
def optimum_moves(data, limit, cold="figure-10", hot="figure-10"):
    limit, best, early = limit["figure-10"], {}, {}
    for temperature, family in ((250, cold), (400, hot)):
        x, values = volume(data, family, f"{temperature} C")
        best[temperature] = float(x[int(np.argmax(values.mean(axis=0)))])
        early[temperature] = data.table(family, f"{temperature} C", "extent_m").at(40).mean()
    near = all(abs(best[t] - limit["optimum"][str(t)]) <= limit["optimum_within"] for t in best)
    return Answer(
        near and best[400] < best[250],
        f"{best[250]:g} MPa at 250 C, {best[400]:g} MPa at 400 C; mean length at 40 MPa {early[250]:.1f} m at 250 C, "
        f"{early[400]:.1f} m at 400 C",
        f"60 and 40 MPa, each within {limit['optimum_within']}, and falling",
    )


@claim(
    "5.2, Figure 11",
    "Fracture length and width fall with the smaller horizontal stress.",
    "At 60 MPa the fracture of most 250 C packings is long under every stress of the series.",
    needs=LOWER,
)
def falls_with_stress(data, limit, family="figure-11"):
    parts, good = [], []
    for series in ("250 C", "400 C"):
        for quantity in ("extent_m", "width_m"):
            table = data.table(family, series, quantity)
            rank = float(np.mean([spearman(table.x, row) for row in table.values]))
            good.append(rank <= limit["figure-11"]["spearman"])
            parts.append(f"{series} {quantity[:-2]} {rank:.2f}")
    return Answer(all(good), "mean Spearman: " + ", ".join(parts), f"each ≤ {limit['figure-11']['spearman']}")


@claim(
    "5.2, Figure 11",
    "At a key stress length and width drop suddenly.",
    "Where the drop comes differs from packing to packing; in some there is none.",
    needs=LOWER,
)
def sudden_drop(data, limit, family="figure-11"):
    limit = limit["figure-11"]
    parts, good = [], []
    for series in ("250 C", "400 C"):
        extent = data.table(family, series, "extent_m")
        drops = [largest_drop(row, limit["from_cracks_m"]) for row in extent.values]
        share = float(np.mean([drop >= limit["jump"] for _, drop in drops]))
        good.append(share >= limit["jump_packings"])
        parts.append(f"{series}: " + ", ".join(f"{100 * d:.0f} % after {extent.x[i]:g} MPa" for i, d in drops))
    return Answer(
        all(good),
        "largest fall of extent by packing, " + "; ".join(parts),
        f"≥ {100 * limit['jump']:.0f} % within one step in ≥ {100 * limit['jump_packings']:.0f} % of the packings",
    )


@claim(
    "5.2, Figure 11",
    "The key stress is lower in hotter rock (51 MPa at 250 C, 49 MPa at 400 C).",
    "At 60 MPa many packings have no drop within the series, and what falls most is noise. Absolute values hang on how "
    "the paper's stresses are read.",
    needs=TRIED_KEY,
)
def key_stress_moves(data, limit, family="figure-11", hot="figure-11"):
    floor = limit["figure-11"]["from_cracks_m"]
    cold_table = data.table(family, "250 C", "extent_m")
    hot_table = data.table(hot, "400 C", "extent_m")
    packings = min(len(cold_table.values), len(hot_table.values))  # the first ones, the same in both
    places = [
        [table.x[largest_drop(row, floor)[0]] + 0.5 for row in table.values[:packings]]
        for table in (cold_table, hot_table)
    ]
    change = (np.array(places[1]) - np.array(places[0]))[:, None]
    sure = interval(change, lambda mean: mean[..., 0])
    return Answer(
        sure[1] < 0,
        f"250 C {np.mean(places[0]):.1f} MPa, 400 C {np.mean(places[1]):.1f} MPa effective; change "
        f"{change.mean():.1f} {span(sure, 1)}",
        "change of the key stress, interval below 0",
    )


@claim(
    "5.2, Figure 11",
    "Beyond the key stress length falls more slowly than before it.",
    "At 60 MPa the drop of the 250 C rock lies at the end of the series or beyond it.",
    needs=LOWER,
)
def slower_beyond(data, limit, family="figure-11"):
    parts, good = [], []
    for series in ("250 C", "400 C"):
        extent = data.table(family, series, "extent_m")
        key, _ = largest_drop(extent.means, limit["figure-11"]["from_cracks_m"])
        if not 1 <= key <= len(extent.x) - 3:
            good.append(False)
            parts.append(
                f"{series}: the largest drop of the mean is after {extent.x[key]:g} MPa, at the end of the series"
            )
            continue
        before, after = (
            float(slope(extent.x[part], extent.means[part])) for part in (slice(0, key + 1), slice(key + 1, None))
        )
        good.append(before < 0 and abs(after) < abs(before))
        parts.append(f"{series}: {before:.2f} m/MPa up to {extent.x[key]:g} MPa, {after:.2f} after the drop")
    return Answer(
        all(good), "; ".join(parts), "on both sides of the largest drop of the mean: falling before, flatter after"
    )


@claim(
    "5.3, Figure 12",
    "Fracture length and width grow with permeability.",
    "Cracks fill through themselves; what seeps into rock of some millidarcy within the run is little.",
    needs=TRIED_12,
)
def grows_with_permeability(data, limit, family="figure-12", hot="figure-12"):
    parts, good = [], []
    for where, series in ((family, "250 C"), (hot, "400 C")):
        for quantity in ("width_m", "cracks"):
            table = data.table(where, series, quantity)
            rise, sure = slope_of(table)
            good.append(sure[1] >= limit["figure-12"]["not_falling"])
            parts.append(f"{series} {quantity.removesuffix('_m')} {rise:.3g} [{sure[0]:.2g}, {sure[1]:.2g}] per mD")
    return Answer(all(good), "; ".join(parts), "no slope's interval lies below 0")


@claim(
    "5.3, Figure 12",
    "The increase becomes steeper at about 5.8 mD.",
    "Nothing in the equations changes at a permeability; leak-off grows in proportion to its root.",
    needs=TRIED_12,
)
def permeability_kink(data, limit, family="figure-12", hot="figure-12"):
    limit = limit["figure-12"]
    parts, good = [], []
    for source, series in ((family, "250 C"), (hot, "400 C")):
        for quantity in ("extent_m", "width_m"):
            table = data.table(source, series, quantity)
            where, before, after = kink(table.x, table.means)
            good.append(
                abs(where - limit["kink"]) <= limit["kink_within"]
                and before >= 0
                and after > limit["kink_ratio"] * before
            )
            parts.append(f"{series} {quantity[:-2]}: {where:.1f} mD, {before:.2g} before, {after:.2g} m/mD after")
    return Answer(
        all(good),
        "; ".join(parts),
        f"change point {limit['kink']} ± {limit['kink_within']:g} mD, slope {limit['kink_ratio']}-fold after",
    )


@claim(
    "5.3, Figure 12",
    "The hotter the rock, the more permeability adds.",
    "With no clear growth at any temperature there is no difference to see.",
    needs=TRIED_12,
)
def hotter_grows_more(data, limit, family="figure-12", hot="figure-12"):
    parts, good = [], []
    for quantity in ("extent_m", "width_m"):
        cold = data.table(family, "250 C", quantity)
        warm = data.table(hot, "400 C", quantity)
        packings = min(len(cold.values), len(warm.values))  # the first ones, the same in both
        more = interval(warm.values[:packings] - cold.values[:packings], lambda mean: slope(cold.x, mean))
        good.append(more[0] > 0)
        parts.append(f"{quantity[:-2]}: 400 C less 250 C [{more[0]:.2g}, {more[1]:.2g}] m/mD")
    return Answer(all(good), "; ".join(parts), "difference of slopes, interval above 0")


@claim("4.3.2 and 7", "Fractures run along the larger horizontal stress.")
def along_larger_stress(data, limit):
    azimuth = data.table("figure-12", "250 C", "azimuth_deg", gaps=True).values
    azimuth = np.nanmean(azimuth[~np.isnan(azimuth).all(axis=1)], axis=1)[:, None]
    sure = interval(azimuth, lambda mean: mean[..., 0])
    most = limit["figure-12"]["azimuth_deg"]
    return Answer(
        azimuth.mean() <= most,
        f"longest fracture {azimuth.mean():.0f}° {span(sure, 0)} from the larger stress, " "under 7 and 0 MPa",
        f"mean ≤ {most}°",
    )

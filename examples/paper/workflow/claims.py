"""What a claim of the paper is: its place, our words, and the test that decides. A claim is a function of
measurements and thresholds; it answers with its figure, and measured.Incomplete where runs lack. Nothing here
writes or reads files."""
import dataclasses
from collections.abc import Callable

from estimates import interval, slope

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
    against: tuple = ()  # (where, keywords): the same test on other runs, e.g. total stresses
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

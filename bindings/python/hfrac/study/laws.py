# SPDX-License-Identifier: BSD-3-Clause
"""Laws of parameters: what turns a number between 0 and 1 into a value, by the inverse of the distribution function.

Every design (designs.py) and the ensemble smoother work with numbers between 0 and 1, so a law is all that they know of a
parameter, and values never leave the law's range.
"""
import math
from typing import Any, Dict, List, NamedTuple, Tuple

import numpy as np
from scipy.special import ndtri

#: what each law needs
KEYS: Dict[str, Tuple[str, ...]] = {
    "uniform": ("low", "high"),
    "loguniform": ("low", "high"),
    "normal": ("mean", "deviation"),
    "lognormal": ("median", "deviation"),
    "list": ("values",),
}
EDGE = 1e-9  # values of normal laws stay within six standard deviations


class Parameter(NamedTuple):
    """One thing that varies."""

    #: its column in tables
    name: str
    #: keys of the case that take the value, as in case files ("stress.sigma_hmin")
    options: Tuple[str, ...]
    #: one of KEYS
    law: str
    #: what the law needs, in the order of KEYS
    numbers: Tuple[Any, ...]
    #: values that a grid takes of it
    levels: int

    def value(self, share: float) -> Any:
        """The value below which `share` of the law lies; of a list, its entry there."""
        if self.law == "list":
            return self.numbers[0][min(int(share * len(self.numbers[0])), len(self.numbers[0]) - 1)]
        first, second = self.numbers
        if self.law == "uniform":
            return first + share * (second - first)
        if self.law == "loguniform":
            return first * (second / first) ** share
        score = float(ndtri(min(max(share, EDGE), 1.0 - EDGE)))
        if self.law == "normal":
            return first + second * score
        return first * math.exp(second * score)

    def grid(self) -> List[float]:
        """Middles of classes of equal probability; of a list, of its entries."""
        count = len(self.numbers[0]) if self.law == "list" else self.levels
        return list((np.arange(count) + 0.5) / count)

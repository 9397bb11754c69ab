"""The few tests the judge uses, on values[packing, x]. Intervals are 90 % bootstrap intervals over packings: packings
are the sample, and nothing is assumed about how they scatter. The generator is seeded, so a verdict repeats to the
digit."""
import numpy as np

DRAWS = 2000


def slope(x, y):
    """Least-squares slope of y with x; of each row if y has rows."""
    x = np.asarray(x, float) - np.mean(x)
    return np.asarray(y, float) @ x / (x @ x)


def r_squared(x, y):
    total = np.sum((y - np.mean(y)) ** 2)
    if total == 0.0:
        return 0.0
    fit = np.mean(y) + slope(x, y) * (np.asarray(x) - np.mean(x))
    return float(1.0 - np.sum((y - fit) ** 2) / total)


def interval(values, quantity):
    """(5 %, 95 %) of quantity(mean over packings), packings drawn with replacement. `quantity` takes rows of means."""
    generator = np.random.Generator(np.random.PCG64(1))
    picks = generator.integers(0, len(values), (DRAWS, len(values)))
    return tuple(float(one) for one in np.quantile(quantity(values[picks].mean(axis=1)), (0.05, 0.95)))


def ranks(values):
    """1, 2, ...; ties share their mean rank."""
    values = np.asarray(values, float)
    return np.array([np.sum(values < one) + 0.5 * (np.sum(values == one) + 1) for one in values])


def spearman(x, y):
    """Rank correlation; 0 where nothing varies."""
    a, b = ranks(x), ranks(y)
    a, b = a - a.mean(), b - b.mean()
    size = np.sqrt((a @ a) * (b @ b))
    return float(a @ b / size) if size > 0.0 else 0.0


def kink(x, y):
    """(x of the change, slope before, slope after) of the continuous line of two pieces that fits best, with at
    least two points on either side."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    best = None
    for place in np.linspace(x[1], x[-2], 201):
        base = np.column_stack([np.ones_like(x), np.minimum(x - place, 0.0), np.maximum(x - place, 0.0)])
        fit, *_ = np.linalg.lstsq(base, y, rcond=None)
        error = float(np.sum((base @ fit - y) ** 2))
        if best is None or error < best[0] * (1.0 - 1e-12):
            best = (error, float(place), float(fit[1]), float(fit[2]))
    return best[1:]


def largest_drop(y, least):
    """(index after which, share) of the largest relative fall from one x to the next, of values above `least`."""
    y = np.asarray(y, float)
    shares = [(y[i] - y[i + 1]) / y[i] if y[i] >= least else 0.0 for i in range(len(y) - 1)]
    place = int(np.argmax(shares))
    return place, float(shares[place])

"""The best place of a pivot on an arc, by dividing it more and more closely (наилучшее место шарнира)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from plans.model.motion import Floats

STATIONS = 361  # of an arc, where the best is looked for; then closer about the best of them
CLOSER = 7  # times
HALVED = 52  # times: as often as a number has binary digits
PLACED = 7  # decimals of a radian: the place of a largest value is known to the square root of a rounding


def best_of(values: Callable[[Floats], Floats], least: float, most: float) -> tuple[float, float]:
    """Give the place with the largest value, and that value; where there is none it is NaN."""
    place = found = np.nan
    for _ in range(CLOSER):
        places = np.linspace(least, most, STATIONS)
        known = np.nan_to_num(values(places), nan=-np.inf)
        k = int(np.argmax(known))
        place, found = float(places[k]), float(known[k])
        least, most = places[max(k - 2, 0)], places[min(k + 2, STATIONS - 1)]
    return place, found


def crossed(values: Callable[[Floats], Floats], least: float, most: float) -> Iterator[float]:
    """Give the place where a value becomes positive or ceases to be, if it does, by halving about it."""
    places = np.linspace(least, most, STATIONS)
    known = np.nan_to_num(values(places), nan=-1.0) > 0
    for k in np.flatnonzero(known[:-1] != known[1:])[:1]:
        low, high = float(places[k]), float(places[k + 1])
        for _ in range(HALVED):
            middle = (low + high) / 2
            if (values(np.array([middle]))[0] > 0) == known[k]:
                low = middle
            else:
                high = middle
        yield (low + high) / 2

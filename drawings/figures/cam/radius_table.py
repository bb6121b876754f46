"""The table of a profile to be made: polar radius and angle at even turns of the cam (таблица радиусов-векторов)."""

from __future__ import annotations

import math

from drawings.figures.cam.manufacturing_figure import TabledProfile
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import fixed
from drawings.page.drafting import Drafting

NAME = "radii"
PLACES = 3  # of a millimetre and of a degree: finer than any machine divides
MM = 1000.0  # of a metre
POLAR, PLANE = ("polar radius, mm", "polar angle, °"), ("abscissa, mm", "ordinate, mm")


def radii(shown: TabledProfile, every: int, drafting: Drafting) -> RuledTable:
    """Tell the profile, of a groove its middle, at every so many of the tabled turns."""
    lines = [_row(shown, k, drafting) for k in range(0, len(shown.names), every)]
    words = PLANE if shown.cam.translates else POLAR
    first = drafting.word("x of cam, mm" if shown.cam.translates else "φ of cam, °")
    return table(lines, first, tuple(drafting.word(key) for key in words), drafting.hand.text)._replace(name=NAME)


def _row(shown: TabledProfile, k: int, drafting: Drafting) -> TableRow:
    cells = (fixed(value, drafting.language, PLACES) for value in told(shown, k))
    return TableRow(drafting.number(shown.names[k], 5), tuple(cells))


def told(shown: TabledProfile, k: int) -> tuple[float, float]:
    """Give what a row tells: polar radius mm and angle in degrees, or the coordinates of a cam that translates, mm."""
    if shown.cam.translates:
        spot = MM * complex(shown.told[k])
        return spot.real, spot.imag
    return MM * float(shown.radii[k]), math.degrees(float(shown.angles[k]))

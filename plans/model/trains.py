"""The equations of a gear train and how many of them are independent: its mobility (подвижность)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TypeAlias

from plans.model.gears import FRAME, BoxGear, Train

Row: TypeAlias = list[Fraction]


def equations(train: Train, gear: BoxGear) -> Iterator[Mapping[str, int]]:
    """Give the factors of the speeds in each equation: (w_a - w_H) z_a + (w_b - w_H) z_b = 0, w = 0, w_x = w_y.

    Of an axis across the speed is that over its carrier, so that this has no part in it.
    """
    for one, other in (train.signed(*pair) for pair in train.pairs):
        carrier = train.carrier_between(one, other)
        level = sum(wheel.teeth for wheel in (one, other) if wheel.link not in train.crossing)
        yield {one.link: one.teeth, other.link: other.teeth, carrier: -level}
    yield from ({link: 1} for link in gear.held)
    yield from ({one: 1, other: -1} for one, other in (*gear.locked, *train.joints))


def mobility(train: Train, gear: BoxGear) -> int:
    """Give the mobility of a train in a gear: its links less the equations that are independent."""
    return len(train.links) - len(reduced(matrix(train, gear, 0), len(train.links)))


def determined(train: Train, gear: BoxGear) -> bool:
    """Tell whether the speeds of the drives give all links theirs."""
    rows = [*matrix(train, gear, 0), *([Fraction(link == one) for link in train.links] for one, _ in train.drives)]
    return len(reduced(rows, len(train.links))) == len(train.links)


def matrix(train: Train, gear: BoxGear, more: int) -> list[Row]:
    """Put the equations in rows, a column a link, and more columns of zeros for what stands on the right."""
    found = []
    for factors in equations(train, gear):
        row = [Fraction(0)] * (len(train.links) + more)
        for link, factor in factors.items():
            if link != FRAME:
                row[train.links.index(link)] += factor
        found.append(row)
    return found


def reduced(matrix: Sequence[Row], columns: int) -> list[Row]:
    """Reduce a matrix to unit rows, one for each independent equation (метод Гаусса - Жордана)."""
    rows, done = [[*row] for row in matrix], list[Row]()
    for column in range(columns):
        pivot = next((row for row in rows if row[column]), None)
        if pivot is None:
            continue
        rows.remove(pivot)
        unit = [value / pivot[column] for value in pivot]
        rows = [_less(row, unit, column) for row in rows]
        done = [*(_less(row, unit, column) for row in done), unit]
    return done


def _less(row: Row, unit: Row, column: int) -> Row:
    return [value - row[column] * part for value, part in zip(row, unit, strict=True)] if row[column] else row

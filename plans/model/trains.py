"""The equations of a gear train and how many of them are independent: its mobility (подвижность)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TypeAlias

from plans.model.gears import BoxGear, Train

Row: TypeAlias = list[Fraction]


def equations(train: Train, gear: BoxGear) -> Iterator[Mapping[str, Fraction]]:
    """Give the factors of the speeds in each equation: (w_a - w_H) z_a + (w_b - w_H) z_b = 0, w = 0, w_x = w_y.

    Of an axis across the speed is that over its carrier, so that this has no part in it.
    """
    unit = Fraction(1)
    for mesh, (one, other) in zip(train.meshes, train.pairs, strict=True):
        turned = dict(zip((one.link, other.link), train.rolling(mesh), strict=True))
        level = sum((teeth for link, teeth in turned.items() if link not in train.crossing), Fraction(0))
        yield {**turned, train.carrier_between(one, other): -level}
    yield from ({link: unit} for link in gear.held)
    yield from ({one: unit, other: -unit} for one, other in (*gear.locked, *train.joints))


def mobility(train: Train, gear: BoxGear) -> int:
    """Give the mobility of a train in a gear: its links less the equations that are independent."""
    return len(train.links) - len(reduced(table(equations(train, gear), train.links), len(train.links)))


def determined(train: Train, gear: BoxGear) -> bool:
    """Tell whether the speeds of the drives give all links theirs."""
    rows = *equations(train, gear), *({link: Fraction(1)} for link, _ in train.drives)
    return len(reduced(table(rows, train.links), len(train.links))) == len(train.links)


def table(rows: Iterable[Mapping[str, Fraction]], columns: Sequence[str]) -> list[Row]:
    """Put equations in rows, a column for each unknown, then for what stands on the right; the frame has none."""
    return [[row.get(name, Fraction(0)) for name in columns] for row in rows]


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


def solved(
    train: Train, rows: Iterable[Mapping[str, Fraction]], right: Sequence[str]
) -> Mapping[str, tuple[Fraction, ...]]:
    """Give the speed of each link as shares of what stands on the right."""
    count, found = len(train.links), reduced(table(rows, (*train.links, *right)), len(train.links))
    return {link: tuple(row[count:]) for link, row in zip(train.links, found, strict=True)}


def shares(train: Train, gear: BoxGear) -> Mapping[str, tuple[Fraction, ...]]:
    """Give the speed of each link as shares of those of the drives."""
    given = {link: f"given {link}" for link, _ in train.drives}
    drives = ({link: Fraction(1), name: Fraction(1)} for link, name in given.items())
    return solved(train, (*equations(train, gear), *drives), (*given.values(),))


def inertia(train: Train, gear: BoxGear, link: str) -> float | None:
    """Give the moment of inertia kg*m2 of all links, reduced to one; nothing where it rests or none is given."""
    found = shares(train, gear)
    if not (train.inertia or train.masses) or not train.single or not found[link][0]:
        return None
    turns = {name: share[0] / found[link][0] for name, share in found.items()}
    total = sum(train.count(one) * size * float(turns[one]) ** 2 for one, size in train.inertia.items())
    for one, mass in train.masses.items():
        carrier = train.carrier_of[one]
        arm = turns[carrier] * (train.heights[one] - train.heights[carrier])
        total += train.count(one) * mass * float(arm) ** 2
    return total

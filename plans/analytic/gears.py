"""Gear trains by one linear system of meshes, brakes, clutches and shafts that are one, exact in rational numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from plans.model.gears import FRAME, Gear, Train

Row = list[Fraction]


def equations(train: Train, gear: Gear) -> Iterator[Mapping[str, int]]:
    """Give the factors of the speeds in each equation: (w_a - w_H) z_a + (w_b - w_H) z_b = 0, w = 0, w_x = w_y."""
    for one, other in train.pairs:
        carrier = train.carrier_between(one, other)
        yield {one.link: one.teeth, other.link: other.teeth, carrier: -one.teeth - other.teeth}
    yield from ({link: 1} for link in gear.held)
    pairs = (*gear.locked, *((group[0], other) for group in train.joined for other in group[1:]))
    yield from ({one: 1, other: -1} for one, other in pairs)


def mobility(train: Train, gear: Gear) -> int:
    """Give the mobility of a train in a gear: its links less the equations that are independent."""
    return len(train.links) - len(_reduced(_matrix(train, gear, 0), len(train.links)))


def shares(train: Train, gear: Gear) -> Mapping[str, tuple[Fraction, ...]] | None:
    """Give the speed of each link as shares of those of the drives; nothing where these do not determine them all."""
    count, links = len(train.drives), train.links
    matrix = _matrix(train, gear, count)
    for k, (link, _) in enumerate(train.drives):
        row = [Fraction(0)] * (len(links) + count)
        row[links.index(link)], row[len(links) + k] = Fraction(1), Fraction(1)
        matrix.append(row)
    rows = _reduced(matrix, len(links))
    if len(rows) < len(links) or _contradicted(matrix, rows, len(links)):
        return None
    return {link: tuple(row[len(links) :]) for link, row in zip(links, rows, strict=True)}


def speeds(train: Train, gear: Gear) -> Mapping[str, Fraction]:
    """Give the speeds rad/s of all links, exact for the speeds that the drives are given."""
    found = shares(train, gear)
    assert found is not None  # its reading has seen to that
    given = [Fraction(speed) for _, speed in train.drives]
    return {link: sum((u * w for u, w in zip(row, given, strict=True)), Fraction(0)) for link, row in found.items()}


def ratio_with(train: Train, first: str, other: str, carrier: str) -> Fraction | None:
    """Give the ratio of two links where a carrier is held and nothing else, brakes, clutches or joined shafts."""
    bare, place, last = replace(train, joined=()), train.links.index(first), len(train.links)
    rows = _matrix(bare, Gear("", () if carrier == FRAME else (carrier,), ()), 1)
    drive = [Fraction(0)] * (last + 1)
    drive[train.links.index(other)] = drive[last] = Fraction(1)
    row = next((row for row in _reduced([*rows, drive], last) if row[place]), None)
    return None if row is None or sum(map(bool, row[:last])) > 1 else row[last]


def velocity(train: Train, speeds: Mapping[str, Fraction], link: str, height: Fraction) -> float:
    """Give the velocity m/s of a point of a link: omega r, of a planet's over that of its centre."""
    carrier = train.carrier_of.get(link)
    centre = speeds[carrier] * (train.heights[link] - train.heights[carrier]) if carrier else Fraction(0)
    return float(centre + speeds[link] * (height - train.heights[link]))


def _matrix(train: Train, gear: Gear, more: int) -> list[Row]:
    matrix = []
    for factors in equations(train, gear):
        row = [Fraction(0)] * (len(train.links) + more)
        for link, factor in factors.items():
            if link != FRAME:
                row[train.links.index(link)] += factor
        matrix.append(row)
    return matrix


def _reduced(matrix: Sequence[Row], columns: int) -> list[Row]:
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


def _contradicted(matrix: Sequence[Row], rows: Sequence[Row], columns: int) -> bool:
    """Tell whether some equation is not met: a drive that the others do not leave free."""
    values = [row[columns:] for row in rows]
    for equation in matrix:
        for k, right in enumerate(equation[columns:]):
            if (
                sum((factor * value[k] for factor, value in zip(equation[:columns], values, strict=True)), Fraction(0))
                != right
            ):
                return True
    return False

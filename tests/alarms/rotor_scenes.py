"""Scenes of rotors and of banks of equal mechanisms by lot (роторы, блоки механизмов)."""

from __future__ import annotations

from collections.abc import Sequence

from tests.alarms.lot import Lot, length, rows

GRADES = ("G2.5", "G6.3", "G16", "G40")
# Engines by the degrees of their cranks, and of their guides, in the order of their places along the shaft.
ENGINES: dict[str, tuple[Sequence[float], Sequence[float]]] = {
    "single": ((0,), (0,)),
    "twin": ((0, 180), (0, 0)),
    "twin 360": ((0, 0), (0, 0)),
    "three in a row": ((0, 120, 240), (0, 0, 0)),
    "four in a row": ((0, 180, 180, 0), (0, 0, 0, 0)),
    "five in a row": ((0, 144, 288, 72, 216), (0, 0, 0, 0, 0)),
    "six in a row": ((0, 120, 240, 240, 120, 0), (0, 0, 0, 0, 0, 0)),
    "V-twin": ((0, 0), (45, -45)),
    "V-twin 60": ((0, 0), (30, -30)),
    "V-four": ((0, 0, 180, 180), (45, -45, 45, -45)),
    "boxer": ((0, 180), (90, -90)),
    "boxer four": ((0, 180, 180, 0), (90, -90, 90, -90)),
}


def rotor(lot: Lot) -> str:
    """Write a scene of a rotor that is balanced in one plane or in two."""
    span, disc = lot.size(0.2, 1, 0.5, 0.6), lot.size(0.05, 0.3, 0.1, 0.2)
    flat = lot.on(0.3)
    weights = [_unbalance(lot, disc, None if flat else span) for _ in range(lot.whole(2, 6))]
    places = [None] if flat else [span * lot.size(0.75, 1, 0.8, 1), span * lot.size(-0.1, 0.15, 0)]
    ends = f"bearings = [{length(-0.2 * span)}, {length(1.3 * span)}]"
    quality = lot.some(0.6, f"mass = {lot.size(10, 100, 20, 40)}", f'grade = "{lot.any(*GRADES)}"')
    return rows(
        'title = "Rotor"\nsheets = ["rotor"]\n[rotor]',
        f'speed = "{lot.any(1, 1, -1) * lot.size(300, 6000, 600, 1500, 3000):g} rpm"',
        quality,
        () if flat else lot.some(0.8, ends),
        *weights,
        *(_plane(lot, disc, place) for place in places),
        "[sheet]",
    )


def _unbalance(lot: Lot, disc: float, span: float | None) -> Sequence[str]:
    angle = lot.size(0, 355, 0, 30, 45, 60, 90, 120, 180, 210, 240, 270, 315)
    mass, radius = lot.size(0.1, 2, 0.5, 1), disc * lot.size(0.5, 1, 0.8, 1)
    size = [f"mass = {mass}", f"radius = {length(radius)}"] if lot.on(0.85) else [f"moment = {mass * radius:.4f}"]
    at = [] if span is None else [f"place = {length(span * lot.size(0, 1.1, 0.25, 0.5, 0.75, 1))}"]
    return ("[[rotor.masses]]", *size, f"angle = {angle:g}", *at)


def _plane(lot: Lot, disc: float, place: float | None) -> Sequence[str]:
    size = lot.any(f"radius = {length(disc * lot.size(0.6, 1, 0.8))}", f"mass = {lot.size(0.2, 2, 0.5, 1)}")
    return ("[[rotor.planes]]", size, *([] if place is None else [f"place = {length(place)}"]))


def bank(lot: Lot) -> str:
    """Write a scene of an engine's bank of cylinders, with compensators of its first or second order or without."""
    name = lot.any(*ENGINES)
    cranks, axes = ENGINES[name]
    crank, apart = lot.size(0.025, 0.08, 0.04, 0.05), lot.size(0.06, 0.2, 0.1)
    orders = lot.any([1, 2, 4, 6], [1, 2, 4], [1, 2], [2, 4])
    return rows(
        f'title = "Engine, {name}"\nsheets = ["bank"]\n[bank]',
        f'speed = "{lot.size(600, 6000, 1500, 3000):g} rpm"',
        f"orders = {orders}",
        lot.some(0.2, f"axis = {lot.any(0, 45, 180)}"),
        ("[bank.unit]", f"crank = {length(crank)}", f"rod = {length(crank * lot.size(2.8, 5, 3, 3.5, 4))}"),
        lot.some(0.8, f"rotating = {lot.size(0.2, 2, 0.5, 1)}"),
        f"reciprocating = {lot.size(0.2, 2, 0.5, 1)}",
        *(_member(cranks[k], axes[k], apart * (k - (len(cranks) - 1) / 2)) for k in range(len(cranks))),
        lot.some(0.35, *_compensator(lot, lot.any(*[order for order in orders if order < 3]))),
        "[sheet]",
    )


def _member(crank: float, axis: float, place: float) -> Sequence[str]:
    turned = [f"axis = {axis}"] if axis else []
    return ("[[bank.members]]", f"crank = {crank}", f"place = {length(place)}", *turned)


def _compensator(lot: Lot, order: int) -> Sequence[str]:
    aside = (f"offset = {length(lot.size(0.02, 0.1, 0.05))}", f"shafts = {length(lot.size(0.2, 0.6, 0.5))}")
    beside = lot.any((), aside[:1], aside)
    return ("[[bank.compensators]]", f"order = {order}", f"mass = {lot.size(0.1, 3, 0.2, 0.5, 1)}", *beside)

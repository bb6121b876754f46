"""The record of a rotor's sheet: its two polygons and the places of its masses, by analysis (ротор)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.grading import verdict
from drawings.grading.marking import Found, Letters, Record, Slip
from drawings.paper.strokes import Leaf
from geometry.board import Board
from geometry.span import Span
from plans.model.rotor import Balance, Unbalance
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.heading import heading
from plans.rotor.letters import moment_letters, unbalance_letters
from plans.rotor.polygon import Polygon
from plans.rotor.study import RotorStudy
from plans.study import Study

ALONG = "along"  # the view along the shaft, where each mass lies at its radius
SHOWN = (COUPLES, UNBALANCES, ALONG)


def record_of(study: Study, leaf: Leaf) -> Record:
    """Give the record of the vectors of a rotor's sheet."""
    rotor, balance = study["rotor"], study.comparison("rotor").analysis
    found: dict[Letters, Found] = {(COUPLES, None, "", one.name): one for one in _couples(rotor, balance)}
    found |= {(UNBALANCES, None, "", one.name): one for one in _unbalances(rotor, balance)}
    found |= {(ALONG, None, "", one.name): one for one in _masses(rotor, balance)}
    return Record(found, {name: {None: mu} for name, mu in leaf.metadata["scales"].items() if name in SHOWN})


def _couples(study: RotorStudy, balance: Balance) -> Iterator[Found]:
    """Give the moments of the masses about the last plane, and what closes them."""
    rotor, polygon = study.rotor, study.drawing.moments
    arms = {f"h_{one.name}": rotor.arm(one.place) for one in rotor.masses}
    true = {moment_letters(one.name): _moment(one) * rotor.arm(one.place) for one in rotor.masses}
    slips = {moment_letters(one.name): tuple(_of_arm(one, arms)) for one in rotor.masses}
    if rotor.dynamic:
        plane = rotor.planes[0]
        true[moment_letters(plane.name)] = balance.moments[0] * rotor.arm(plane.place)
    yield from _polygon(polygon, true, slips)


def _unbalances(study: RotorStudy, balance: Balance) -> Iterator[Found]:
    """Give the static moments of the masses, that of the first counterweight, and what closes them."""
    rotor = study.rotor
    radii = {f"r_{one.name}": one.radius for one in rotor.masses if one.radius is not None}
    true = {unbalance_letters(one.name): _moment(one) for one in rotor.masses}
    corrections = zip(rotor.planes, balance.moments, strict=True)
    true |= {unbalance_letters(plane.name): moment for plane, moment in corrections}
    slips = {unbalance_letters(one.name): tuple(_of_radius(one, radii)) for one in rotor.masses}
    yield from _polygon(study.drawing.forces, true, slips)


def _polygon(polygon: Polygon, true: Mapping[str, complex], slips: Mapping[str, tuple[Slip, ...]]) -> Iterator[Found]:
    """Give the sides of a polygon; what closes it is against all others."""
    zero, closing = polygon.board["0"], polygon.closing
    for vector, start, end in polygon.sides:
        own = slips.get(vector.name) or (Slip(verdict.HEAVY, -true[vector.name]),)
        yield Found(vector.name, true[vector.name], Span(zero, vector), Span(start, end), slips=own)
    if closing.name in true:
        last = polygon.sides[-1].end if polygon.sides else zero
        heavy = Slip(verdict.HEAVY, -true[closing.name])
        yield Found(closing.name, true[closing.name], Span(zero, closing), Span(last, zero), slips=(heavy,))


def _masses(study: RotorStudy, balance: Balance) -> Iterator[Found]:
    """Give where the masses and the counterweights lie, looking along the shaft."""
    rotor, board = study.rotor, Board(ALONG)
    centre = board.given("O", 0j)
    for one in rotor.masses:
        if one.radius is not None:
            place = one.radius * heading(one.angle)
            yield Found(f"m_{one.name}", place, Span(centre, board.given(f"m_{one.name}", place)))
    for correction, drawn in zip(balance.corrections, study.drawing.corrections, strict=True):
        size, radius = correction.moment.size, correction.radius
        if size and radius is not None:
            place, name = correction.moment.value * radius / size, f"m_{correction.plane.name}"
            mark = board.turn(name, drawn.mark, radius / size)
            yield Found(name, place, Span(centre, mark), slips=(Slip(verdict.HEAVY, -place),))


def _of_radius(one: Unbalance, radii: Mapping[str, float]) -> Iterator[Slip]:
    """Give what a static moment is with the radius of another mass."""
    for name, radius in radii.items():
        if one.mass is not None and name != f"r_{one.name}":
            yield Slip(verdict.PRODUCT, one.mass * radius * heading(one.angle), name)


def _of_arm(one: Unbalance, arms: Mapping[str, float]) -> Iterator[Slip]:
    """Give what the moment of a mass is with the arm of another, or with its own arm taken the other way.

    >>> from fractions import Fraction
    >>> mass = Unbalance("2", 0.5, Fraction(0), Fraction(-1, 5))
    >>> [(one.kind, one.value.real, one.of) for one in _of_arm(mass, {"h_1": 0.4, "h_2": -0.2})]
    [('product', 0.2, 'h_1'), ('beyond', 0.1, '')]
    """
    for name, arm in arms.items():
        if name != f"h_{one.name}":
            yield Slip(verdict.PRODUCT, _moment(one) * arm, name)
        elif arm < 0:
            yield Slip(verdict.BEYOND, -_moment(one) * arm)


def _moment(one: Unbalance) -> complex:
    return one.moment * heading(one.angle)

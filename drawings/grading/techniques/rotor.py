"""The records of the sheets of a rotor, a bank, a balanced mechanism: vectors by analysis (уравновешивание)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence

from drawings.balance.due import Balanced
from drawings.balance.graphs import SHAKING
from drawings.balance.scheme import AFTER, BEFORE, SCHEME
from drawings.balance.sheet import MOMENTS
from drawings.bank.diagrams import plan_of
from drawings.bank.due import Bank, OrderPolygon
from drawings.bank.star import fanned
from drawings.forces.report import drafting_of_forces
from drawings.grading import verdict
from drawings.grading.asked import Found, Letters, Record, Slip, lettered
from drawings.lettering.words import CENTRE, RESULT
from drawings.lettering.words import FORCE as FORCE_LETTER
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from geometry.board import Board, Mark, Span
from plans.balance.quantities import BalanceComparison
from plans.balance.study import BalanceStudy
from plans.bank.harmonics import FORCE, MOMENT, letters
from plans.bank.study import BankStudy
from plans.model.balance.bank import Harmonic, Member
from plans.model.rotor import RotorBalance, Unbalance
from plans.rotor.balancing import COUPLES, UNBALANCES, VectorPolygon, heading, moment_letters, unbalance_letters
from plans.rotor.study import RotorStudy
from plans.study import Study

ALONG = "along"  # the view along the shaft, where each mass lies at its radius
SHOWN = (COUPLES, UNBALANCES, ALONG)


def record_of_rotor(study: Study, leaf: Leaf) -> Record:
    """Give the record of the vectors of a rotor's sheet."""
    rotor = study.of(RotorStudy)
    masses, drawing = rotor.rotor.masses, rotor.drawing
    arms = {f"h_{mass.name}": rotor.rotor.arm(mass.place) for mass in masses}
    radii = {f"r_{mass.name}": mass.radius for mass in masses if mass.radius is not None}
    couples = {moment_letters(mass.name): tuple(_of_arm(mass, arms)) for mass in masses}
    unbalances = {unbalance_letters(mass.name): tuple(_of_radius(mass, radii)) for mass in masses}
    found = lettered(COUPLES, None, _polygon(drawing.moments, couples))
    found |= lettered(UNBALANCES, None, _polygon(drawing.forces, unbalances))
    found |= lettered(ALONG, None, _masses(rotor, study.comparison("rotor").analysis))
    return Record(found, {name: {None: mu} for name, mu in leaf.metadata["scales"].items() if name in SHOWN})


def _polygon(polygon: VectorPolygon, slips: Mapping[str, tuple[Slip, ...]]) -> Iterator[Found]:
    """Give the sides of a polygon, with what is known of those of masses; what closes it is against all others."""
    zero, closing = polygon.board["0"], polygon.closing
    for vector, start, end in polygon.sides:
        back = "" if slips.get(vector.name) else verdict.HEAVY
        yield Found(vector.name, Span(zero, vector), Span(start, end), slips=slips.get(vector.name, ()), back=back)
    last = polygon.sides[-1].end if polygon.sides else zero
    yield Found(closing.name, Span(zero, closing), Span(last, zero), back=verdict.HEAVY)


def _masses(study: RotorStudy, balance: RotorBalance) -> Iterator[Found]:
    """Give where the masses and the counterweights lie, looking along the shaft."""
    board = Board(ALONG)
    centre = board.given("O", 0j)
    for mass in study.rotor.masses:
        if mass.radius is not None:
            name = f"m_{mass.name}"
            yield Found(name, Span(centre, board.given(name, mass.radius * heading(mass.angle))))
    for correction, drawn in zip(balance.corrections, study.drawing.corrections, strict=True):
        size, radius = correction.moment.size, correction.radius
        if size and radius is not None:
            name = f"m_{correction.plane.name}"
            yield Found(name, Span(centre, board.turn(name, drawn.mark, radius / size)), back=verdict.HEAVY)


def _of_radius(mass: Unbalance, radii: Mapping[str, float]) -> Iterator[Slip]:
    """Give what a static moment is with the radius of another mass."""
    for name, radius in radii.items():
        if mass.mass is not None and name != f"r_{mass.name}":
            yield Slip(verdict.PRODUCT, mass.mass * radius * heading(mass.angle), name)


def _of_arm(mass: Unbalance, arms: Mapping[str, float]) -> Iterator[Slip]:
    """Give what the moment of a mass is with the arm of another, or with its own arm taken the other way.

    >>> from fractions import Fraction
    >>> mass = Unbalance("2", 0.5, Fraction(0), Fraction(-1, 5))
    >>> [(one.kind, one.value.real, one.of) for one in _of_arm(mass, {"h_1": 0.4, "h_2": -0.2})]
    [('product', 0.2, 'h_1'), ('beyond', 0.1, '')]
    """
    for name, arm in arms.items():
        if name != f"h_{mass.name}":
            yield Slip(verdict.PRODUCT, _moment(mass) * arm, name)
        elif arm < 0:
            yield Slip(verdict.BEYOND, -_moment(mass) * arm)


def _moment(mass: Unbalance) -> complex:
    return mass.moment * heading(mass.angle)


def record_of_bank(study: Study, leaf: Leaf) -> Record:
    """Give the record of the polygons of a bank's sheet."""
    expected = Bank(study.of(BankStudy).task, study.comparison("bank"))
    found: dict[Letters, Found] = {}
    plans: dict[str, Mapping[int | None, float]] = {}
    scales, forces = leaf.metadata["scales"], dict[str, Mark]()
    for polygon in expected.polygons():
        plan = plan_of(polygon.kind, polygon.signed)
        vectors = list(_order_polygon(expected, polygon, plan, forces))
        if plan in scales:
            found |= lettered(plan, None, vectors)
            plans[plan] = {None: scales[plan]}
    return Record(found, plans)


def _order_polygon(expected: Bank, polygon: OrderPolygon, plan: str, forces: dict[str, Mark]) -> Iterator[Found]:
    """Give the vectors of the mechanisms laid end to end, and their sum; a moment is a force by its place."""
    board = Board(plan)
    pole = end = board.given("0", 0j)
    members = {letters(polygon.kind, polygon.signed, member.name): member for member in expected.members}
    for name, _ in fanned(list(polygon.sides.items())):
        vector = _vector(board, polygon, members[name], forces)
        start, end = end, board.lay_off(f"{plan}:{name}", end, vector)
        slips = tuple(_slips(expected, polygon, members[name]))
        yield Found(name, Span(pole, vector), Span(start, end), slips=slips)
    yield Found(polygon.name, Span(pole, end), Span(pole, end), diagonal=True)


def _vector(board: Board, polygon: OrderPolygon, member: Member, forces: dict[str, Mark]) -> Mark:
    """Lay down the force of a mechanism, or its moment: the force multiplied by its place."""
    name = letters(polygon.kind, polygon.signed, member.name)
    if polygon.kind == MOMENT and (force := forces.get(letters(FORCE, polygon.signed, member.name))) is not None:
        return board.turn(name, force, float(member.place))
    vector = board.given(name, polygon.sides[name])
    if polygon.kind == FORCE:
        forces[name] = vector
    return vector


def _slips(expected: Bank, polygon: OrderPolygon, member: Member) -> Iterator[Slip]:
    """Give what the vector of a mechanism is by another order, or by another mechanism's place."""
    for order, single in expected.analysis.single.items():
        if order != abs(polygon.signed):
            yield from (Slip(verdict.ORDER, value, f"n = {order}") for value in _by(expected, polygon, member, single))
    if polygon.kind == MOMENT:
        name, place = letters(polygon.kind, polygon.signed, member.name), float(member.place)
        for other in expected.members:
            times = float(other.place) / place
            kind = verdict.BEYOND if math.isclose(times, -1.0) else verdict.PRODUCT
            if other is not member:
                yield Slip(kind, polygon.sides[name] * times, "" if kind == verdict.BEYOND else f"z_{other.name}")


def _by(expected: Bank, polygon: OrderPolygon, member: Member, other: Harmonic) -> Iterator[complex]:
    """Give a vector turned by the angle of another order, of its size, or both."""
    single, sign = expected.analysis.single[abs(polygon.signed)], 1 if polygon.signed > 0 else -1
    sizes = (single.ahead, other.ahead) if sign > 0 else (single.back, other.back)
    turns = [heading(sign * order * member.phase + member.axis) for order in (single.order, other.order)]
    arm = expected.arm(polygon.kind, member) * expected.turn
    for size, turn in ((sizes[0], turns[1]), (sizes[1], turns[0]), (sizes[1], turns[1])):
        yield size * turn * arm


NAMES = {BEFORE: FORCE_LETTER, AFTER: f"{FORCE_LETTER}'"}  # of the main vector of the inertia forces


def record_of_balance(study: Study, leaf: Leaf) -> Record:
    """Give the record of the vectors of a sheet of balancing."""
    balance, k = study.of(BalanceStudy), int(leaf.metadata["position"])
    expected = Balanced(balance, study.of(BalanceComparison), drafting_of_forces(balance.statics), k)
    plans = {SCHEME + state: list(_scheme(expected, state)) for state in expected.states}
    plans |= {MOMENTS: list(_moments(expected)), SHAKING: list(_shaking(expected))}
    found = {letters: vector for plan in plans for letters, vector in lettered(plan, k, plans[plan]).items()}
    scales = {group.data["plan"]: float(group.data["scale"]) for group in groups(leaf.groups) if "scale" in group.data}
    return Record(found, {name: {k: scales[name]} for name in plans if name in scales})


def _moments(expected: Balanced) -> Iterator[Found]:
    """Give the static moments of the links laid end to end, and their sum from the datum."""
    masses = {body.link: body.mass for body in expected.solid(BEFORE)}
    slips = {
        f"m_{link}r_S{link}": [(f"m_{other}", mass / masses[link]) for other, mass in masses.items() if other != link]
        for link in masses
    }
    vectors = list(expected.moments())
    sides, corners = _spans(MOMENTS, vectors)
    for (name, value), side, found in zip(vectors, sides, corners, strict=True):
        wrong = (Slip(verdict.PRODUCT, value * times, of) for of, times in slips[name])
        yield Found(name, side, found, slips=tuple(wrong))
    if corners:
        whole = Span(corners[0].start, corners[-1].end)
        yield Found(RESULT, whole, whole, diagonal=True)


def _scheme(expected: Balanced, state: str) -> Iterator[Found]:
    """Give the vectors of main points to the common mass centre, the points of the links, and the counterweights."""
    vectors = list(expected.chain(state))
    sides, corners = _spans(SCHEME + state, vectors)
    board = Board(SCHEME + state)
    datum = board.given("O", 0j)
    for (name, value), side in zip(vectors, sides, strict=True):
        # drawn beside links and one another, in lanes: their ends need not meet on paper
        yield Found(name, side, slips=tuple(_lacking(expected, state, name, value)))
    if corners:
        yield Found(CENTRE, Span(corners[0].start, corners[-1].end))
    yield from (Found(name, Span(datum, board.given(name, place))) for name, place in expected.points.items())
    for weight in expected.weights(state):
        place, begin = (expected.at(weight.link, spot) for spot in (weight.centre, weight.origin))
        name, other = f"m_cw{weight.link}", Slip(verdict.HEAVY, 2 * begin - place)
        yield Found(name, Span(datum, board.given(name, place)), slips=(other,))


def _spans(plan: str, vectors: Sequence[tuple[str, complex]]) -> tuple[list[Span], list[Span]]:
    """Lay vectors end to end as a student does; give each from nothing, and between its corners."""
    board = Board(plan)
    pole = board.given("0", 0j)
    sides, corners, end = list[Span](), list[Span](), pole
    for number, (name, value) in enumerate(vectors, 1):
        vector: Mark = board.given(name, value)
        start, end = end, board.lay_off(f"{plan}:{number}", end, vector)
        sides.append(Span(pole, vector))
        corners.append(Span(start, end))
    return sides, corners


def _lacking(expected: Balanced, state: str, name: str, value: complex) -> Iterator[Slip]:
    """Give what the vector of a link is without the masses of one that follows it."""
    tree, solid = expected.study.tree, expected.solid(state)
    whole = sum(body.mass for body in solid)
    stem = next((stem for stem in tree.stems if name == f"h_{stem.link}"), None)
    if stem is None:
        return
    angle = float(expected.comparison.motion.analysis.links[stem.link].angle[expected.shown])
    for other in tree.followers[stem.link]:
        behind = set(tree.behind(other.link))
        mass = sum(body.mass for body in solid if body.link in behind)
        arm = (other.at - stem.origin) * cmath.rect(1.0, angle)
        yield Slip(verdict.FORGOTTEN, value - arm * mass / whole, f"m_{'+'.join(map(str, sorted(behind)))}")


def _shaking(expected: Balanced) -> Iterator[Found]:
    """Give the main vectors of the inertia forces in the shown position, before and after."""
    board = Board(SHAKING)
    pole = board.given("0", 0j)
    for state, found in expected.states.items():
        name, value = NAMES[state], complex(found.centre.force[expected.shown])
        yield Found(name, Span(pole, board.given(name, value)), back=verdict.INERTIA)

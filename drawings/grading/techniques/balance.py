"""The record of a sheet of balancing: main points, static moments, counterweights, by analysis (уравновешивание)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence

from drawings.due.balanced import Balanced, Side
from drawings.figures.balance.scheme import AFTER, BEFORE, SCHEME
from drawings.figures.balance.shaking_hodograph import NAME as SHAKING
from drawings.figures.balance.static_polygon import NAME as MOMENTS
from drawings.grading import verdict
from drawings.grading.marking import Found, Letters, Record, Slip
from drawings.lettering.balance_letters import CENTRE, FORCE, RESULT
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from drawings.report.balance.balance_report import drafting_for
from geometry.board import Board, Mark
from geometry.span import Span
from plans.study import Study

NAMES = {BEFORE: FORCE, AFTER: f"{FORCE}'"}  # of the main vector of the inertia forces


def record_of(study: Study, leaf: Leaf) -> Record:
    """Give the record of the vectors of a sheet of balancing."""
    own, k = study["balance"], int(leaf.metadata["position"])
    expected = Balanced(own, study.comparison("balance"), drafting_for(own), k)
    plans = {SCHEME + state: list(_scheme(expected, state)) for state in expected.states}
    plans |= {MOMENTS: list(_moments(expected)), SHAKING: list(_shaking(expected))}
    found: dict[Letters, Found] = {(plan, k, "", one.name): one for plan, all_ in plans.items() for one in all_}
    scales = {one.data["plan"]: float(one.data["scale"]) for one in groups(leaf.groups) if "scale" in one.data}
    return Record(found, {name: {k: scales[name]} for name in plans if name in scales})


def _moments(expected: Balanced) -> Iterator[Found]:
    """Give the static moments of the links laid end to end, and their sum from the datum."""
    masses = {one.link: one.mass for one in expected.solid(BEFORE)}
    slips = {
        f"m_{link}r_S{link}": [(f"m_{other}", mass / masses[link]) for other, mass in masses.items() if other != link]
        for link in masses
    }
    laid = list(expected.moments())
    sides, corners = _laid(MOMENTS, laid)
    for one, side, found in zip(laid, sides, corners, strict=True):
        wrong = (Slip(verdict.PRODUCT, one.value * times, of) for of, times in slips[one.name])
        yield Found(one.name, one.value, side, found, slips=tuple(wrong))
    if corners:
        whole = Span(corners[0].start, corners[-1].end)
        yield Found(RESULT, laid[-1].start + laid[-1].value, whole, whole, diagonal=True)


def _scheme(expected: Balanced, state: str) -> Iterator[Found]:
    """Give the vectors of main points to the common mass centre, the points of the links, and the counterweights."""
    laid = list(expected.chain(state))
    sides, corners = _laid(SCHEME + state, laid)
    board = Board(SCHEME + state)
    datum = board.given("O", 0j)
    for one, side, found in zip(laid, sides, corners, strict=True):
        yield Found(one.name, one.value, side, found, slips=tuple(_lacking(expected, state, one)))
    if corners:
        yield Found(CENTRE, expected.centre(state), Span(corners[0].start, corners[-1].end))
    for name, place in expected.points.items():
        yield Found(name, place, Span(datum, board.given(name, place)))
    for weight in expected.weights(state):
        place, begin = (expected.at(weight.link, spot) for spot in (weight.centre, weight.origin))
        name, other = f"m_cw{weight.link}", Slip(verdict.HEAVY, 2 * begin - place)
        yield Found(name, place, Span(datum, board.given(name, place)), slips=(other,))


def _laid(plan: str, laid: Sequence[Side]) -> tuple[list[Span], list[Span]]:
    """Lay vectors end to end as a student does; give each from nothing, and between its corners."""
    board = Board(plan)
    pole = board.given("0", 0j)
    sides, corners, end = list[Span](), list[Span](), pole
    for number, one in enumerate(laid, 1):
        vector: Mark = board.given(one.name, one.value)
        start, end = end, board.lay_off(f"{plan}:{number}", end, vector)
        sides.append(Span(pole, vector))
        corners.append(Span(start, end))
    return sides, corners


def _lacking(expected: Balanced, state: str, one: Side) -> Iterator[Slip]:
    """Give what the vector of a link is without the masses of one that follows it."""
    tree, solid = expected.own.tree, expected.solid(state)
    whole = sum(body.mass for body in solid)
    stem = next((stem for stem in tree.stems if one.name == f"h_{stem.link}"), None)
    if stem is None:
        return
    angle = float(expected.comparison.motion.analysis.links[stem.link].angle[expected.shown])
    for other in tree.followers[stem.link]:
        behind = set(tree.behind(other.link))
        mass = sum(body.mass for body in solid if body.link in behind)
        arm = (other.at - stem.origin) * cmath.rect(1.0, angle)
        yield Slip(verdict.FORGOTTEN, one.value - arm * mass / whole, f"m_{'+'.join(map(str, sorted(behind)))}")


def _shaking(expected: Balanced) -> Iterator[Found]:
    """Give the main vectors of the inertia forces in the shown position, before and after."""
    board = Board(SHAKING)
    pole = board.given("0", 0j)
    for state, one in expected.states.items():
        name, value = NAMES[state], complex(one.centre.force[expected.shown])
        yield Found(name, value, Span(pole, board.given(name, value)), slips=(Slip(verdict.INERTIA, -value),))

"""The plans of positions, velocities, accelerations: drawn, or followed from a pattern; vector sums (планы).

Vector sums are read off a motion, whichever road found it: of a tip that turns about a start
a_B = a_A + a^n_BA + a^t_BA, of a point that slides on a link a_B = a_B7 + a^k + a^r (M3.1, M3.7).
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Mark
from geometry.branch import Side
from geometry.tracing import Tracing
from plans.linkage.dyads import KINDS
from plans.linkage.leads import key
from plans.linkage.plan import Plan, PlanLetters, Turning, heading
from plans.linkage.primary import PRIMARIES, CrankPositions
from plans.model.dyad import Assur, Dyad
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import LinkMotion, Motion, PointMotion, Rates, steady

Moved = tuple[complex, complex]  # velocity m/s and acceleration m/s2 of a point


class VectorSum(NamedTuple):
    """What one link of a group gives of its inner point: base, and the motion relative to it.

    `arm` are the letters of the line that turns; without them the point slides on the link along `slot`.
    `images` are the letters of the plans: of the base, of the end of a^n or a^k, and of the point.
    """

    point: str
    base: str
    link: int
    arm: str
    length: float  # m, of the arm
    slot: str
    fixed: bool  # whether the base is a point of the frame
    images: tuple[str, str, str]
    velocity: tuple[complex, complex]  # of the base, relative
    acceleration: tuple[complex, complex, complex]  # of the base, normal or Coriolis part, the rest

    @property
    def turns(self) -> bool:
        """Whether the relative motion is a turning."""
        return bool(self.arm)

    @property
    def guided(self) -> bool:
        """Whether the point slides on the frame: then its direction alone is told."""
        return not self.turns and self.link == FRAME

    @property
    def relative(self) -> str:
        """The letters of the relative motion: BA."""
        return f"{self.point}{self.base}"


class VectorSums(NamedTuple):
    """The vector equations of a mechanism in one position of a motion."""

    mechanism: Mechanism
    motion: Motion
    position: int
    letters: PlanLetters

    def of(self, dyad: Dyad) -> tuple[VectorSum, VectorSum]:
        """Give the two equations from which the plans find a group's inner point."""
        if isinstance(dyad.inner, str):
            first, second = (self._lead(dyad, end) for end in (0, 1))
            return first, second
        return self._slot(dyad), self._owner(dyad)

    def turning(self, vector: Turning) -> VectorSum:
        """Tell a tip that turns about a start."""
        _, start, tip = vector
        fixed = start in self.mechanism.links[FRAME].points
        images = start, self.letters.normal(tip, "" if fixed else start), self.letters.small(tip)
        return self._turned(vector, tip, self.rates(tip), images)

    def others(self, dyad: Dyad) -> Iterator[str]:
        """Name the points that similarity gives of a group's links."""
        known = {*(joint for joint in (*dyad.outer, dyad.inner) if isinstance(joint, str))}
        for link in dyad.links:
            yield from (name for name in self.mechanism.links[link].points if name not in known)

    def _lead(self, dyad: Dyad, end: int) -> VectorSum:
        if isinstance(dyad.outer[end], str):
            return self.turning(Turning(dyad.links[end], dyad.hinge(end), dyad.pin))
        host, image = dyad.hosts[end], self.letters.small(dyad.pin)
        base, place = self.carried(host, self._place(dyad.pin)), dyad.slide(end).label
        images = self.letters.under(dyad.pin, host), self.letters.coriolis(dyad.pin, host, key(dyad.slide(end))), image
        letters = dyad.pin, under(dyad.pin, host)
        return self._slid(letters, (host, place), (base, self.rates(dyad.pin)), images)

    def _slot(self, dyad: Dyad) -> VectorSum:
        """Tell the slotted link's point under the pin from the pin itself, along the slot."""
        pin, link = dyad.hinge(0), dyad.links[1]
        whole, written = self.carried(link, self._place(pin)), self.letters
        images = written.small(pin), written.coriolis(pin, link, key(dyad.slide())), written.under(pin, link)
        return self._slid((under(pin, link), pin), (link, dyad.slide().label), (self.rates(pin), whole), images)

    def _owner(self, dyad: Dyad) -> VectorSum:
        """Tell the slotted link's point under the pin from what the slotted link hangs on."""
        pin, link, host = dyad.hinge(0), dyad.links[1], dyad.hosts[1]
        whole, image = self.carried(link, self._place(pin)), self.letters.under(pin, link)
        if isinstance(dyad.outer[1], str):
            vector = Turning(link, dyad.hinge(1), pin)
            images = vector.start, self.letters.normal(image.upper()), image
            return self._turned(vector, under(pin, link), whole, images)
        base = self.carried(host, self._place(pin))
        images = self.letters.under(pin, host), self.letters.coriolis(pin, host, key(dyad.slide(1))), image
        letters = under(pin, link), under(pin, host)
        return self._slid(letters, (host, dyad.slide(1).label), (base, whole), images)

    def _turned(self, vector: Turning, point: str, whole: Moved, images: tuple[str, str, str]) -> VectorSum:
        link, start, tip = vector
        arm, base = self._place(tip) - self._place(start), self.rates(start)
        normal = -(self.omega(link) ** 2) * arm
        velocity = base[0], whole[0] - base[0]
        acceleration = base[1], normal, whole[1] - base[1] - normal
        fixed = start in self.mechanism.links[FRAME].points
        names = ("" if fixed else self.letters.small(start)), *images[1:]
        return VectorSum(
            point, start, link, f"{start}{tip}", abs(arm), "", fixed, (names[0], names[1], names[2]), velocity,
            acceleration,
        )  # fmt: skip

    def _slid(
        self, letters: tuple[str, str], slot: tuple[int, str], rates: tuple[Moved, Moved], images: tuple[str, str, str]
    ) -> VectorSum:
        """Tell a point that slides on a link, from the base that lies under it."""
        (point, base), (link, label), (under_it, whole) = letters, slot, rates
        slip = whole[0] - under_it[0]
        coriolis = 2j * self.omega(link) * slip
        return VectorSum(
            point, base, link, "", 0.0, label, link == FRAME, images, (under_it[0], slip),
            (under_it[1], coriolis, whole[1] - under_it[1] - coriolis),
        )  # fmt: skip

    def carried(self, link: int, place: complex) -> Moved:
        """Give the velocity and the acceleration of the point of a link that lies at a place."""
        if link == FRAME:
            return 0j, 0j
        name = next(iter(self.mechanism.links[link].points))
        (v, a), reach, omega = self.rates(name), place - self._place(name), self.omega(link)
        return v + 1j * omega * reach, a + (1j * self.epsilon(link) - omega**2) * reach

    def rates(self, point: str) -> Moved:
        """Give the velocity and the acceleration of a named point; one of the frame rests."""
        if point in self.mechanism.links[FRAME].points:
            return 0j, 0j
        rows = self.motion.points[point]
        return complex(rows.v[self.position]), complex(rows.a[self.position])

    def _place(self, point: str) -> complex:
        return complex(self.motion.points[point].r[self.position])

    def omega(self, link: int) -> float:
        """Angular velocity of a link, rad/s."""
        return 0.0 if link == FRAME else float(self.motion.links[link].omega[self.position])

    def epsilon(self, link: int) -> float:
        """Angular acceleration of a link, rad/s2."""
        return 0.0 if link == FRAME else float(self.motion.links[link].epsilon[self.position])


def under(point: str, link: int) -> str:
    """Letter the point of a link that lies under another's, its prime last.

    >>> under("A", 3), under("A'", 3)
    ('A_{3}', "A_{3}'")
    """
    bare = point.rstrip("'")
    return f"{bare}_{{{link}}}{point[len(bare) :]}"


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def positions(mechanism: Mechanism, groups: Sequence[Assur], sides: Sequence[Side], turn: CrankPositions) -> Plan:
    """Draw the plan of positions; `sides` gives each group's side of its meeting, NaN where it must stay undrawn."""
    plan = PRIMARIES[mechanism.drive.kind].positions(mechanism, turn)
    for group, side in zip(groups, sides, strict=True):
        KINDS[group.kind].positions(plan, group, side)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def velocities(positions: Plan, groups: Sequence[Assur], rates: Rates | None = None) -> Plan:
    """Draw the velocity plan over a plan of positions, group after group (section 6.4.2, M3.1).

    `rates` are the drive's in each of the positions; None: those that its scene gives.
    """
    plan = Plan("velocities", positions.mechanism, (positions,))
    drive = plan.mechanism.drive
    PRIMARIES[drive.kind].velocities(plan, rates or steady(drive))
    for group in groups:
        KINDS[group.kind].velocities(plan, group)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def accelerations(velocities: Plan, groups: Sequence[Assur], rates: Rates | None = None) -> Plan:
    """Draw the acceleration plan over the velocity plan, group after group (section 6.4.2, M3.1).

    `rates` are those by which the velocity plan was drawn.
    """
    positions = velocities.positions
    plan = Plan("accelerations", positions.mechanism, (positions, velocities))
    drive = plan.mechanism.drive
    PRIMARIES[drive.kind].accelerations(plan, rates or steady(drive))
    for group in groups:
        KINDS[group.kind].accelerations(plan, group)
    return plan


def openness(corners: Sequence[npt.NDArray[np.complex128]]) -> npt.NDArray[np.float64]:
    """Give how open figures are by their corners, a row each over the positions: 2ab/(a^2 + b^2) of their ellipse.

    >>> openness([np.array([0j, 0j]), np.array([1 + 0j, 1 + 0j]), np.array([1j, 2 + 0j])]).round(6).tolist()
    [0.866025, 0.0]
    """
    spread = np.array(corners) - np.mean(corners, axis=0)
    size, along = (np.abs(spread) ** 2).mean(axis=0), np.abs((spread**2).mean(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN, and a plan at rest is no figure
        return np.where(size > 0.0, np.sqrt(np.maximum(1.0 - (along / size) ** 2, 0.0)), 0.0)


UNIT = Rates(np.ones(1), np.ones(1))  # by which a pattern is drawn whose rates vary


class PlanTemplate:
    """Plans of the orders 0, 1, ... over each other, with the images of all named points on them."""

    def __init__(self, plans: Sequence[Plan]) -> None:
        self.plans = plans
        links = plans[0].mechanism.links
        letters = sorted({point for link in links.values() for point in link.points})
        images = {letter: [plan.point(letter) for plan in plans] for letter in letters}
        self.primary = PRIMARIES[plans[0].mechanism.drive.kind]
        free = plans[0].board[self.primary.free]
        tracing = Tracing((mark for plan in plans for mark in plan.board), free)
        self.tracing = tracing
        arms = {link: (image.arm, image.span) for link, image in sorted(plans[0].images.items()) if image.arm}
        self._crank = tracing.acts.fix(None)  # the heading of a link that turns with the crank
        self._points = {letter: [tracing.place(mark) for mark in marks] for letter, marks in images.items()}
        self._links = {link: [self._heading(*arm), *self._rates(link)] for link, arm in arms.items()}
        self._still = {**self._at_rest(self._points, np.complex128), **self._at_rest(self._links, np.float64)}
        self._rows: tuple[int, dict[int, npt.NDArray[Any]]] = 0, {}

    def _heading(self, arm: Mark, span: complex) -> int:
        """Tell where the direction of a link's own +x axis is, one vector of which is `span` there."""
        tracing = self.tracing
        if tracing.follows(arm, span):
            return self._crank
        return tracing.acts.do(heading, tracing.place(arm), tracing.acts.fix(span))

    def _rates(self, link: int) -> Iterator[int]:
        for readings in (plan.readings for plan in self.plans[1:]):
            if link in readings:
                yield self.tracing.acts.rate(*map(self.tracing.place, (readings[link].turning, readings[link].arm)))
            else:
                yield self.tracing.acts.fix(0.0)  # it does not turn

    def _at_rest(self, by_kind: Mapping[Any, list[int]], kind: type) -> dict[int, npt.NDArray[Any]]:
        """Give the values that are the same at all positions."""
        known = {place: self.tracing.acts.fixed(place) for places in by_kind.values() for place in places}
        return {place: np.array([value], dtype=kind) for place, value in known.items() if value is not None}

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def follow(self, turn: CrankPositions) -> list[Any]:
        """Work out all numbers of the plans at other crank positions."""
        values = self.primary.values(self.plans[0].mechanism, turn)
        if turn.rates is None:
            return self.tracing.follow(values)
        rates = zip(self.tracing.sizes, turn.rates, strict=False)  # a pattern of velocities has no epsilon
        return self.tracing.follow(values, {mark: mark.step.size * rate for mark, rate in rates})

    def clear(self, numbers: list[Any]) -> bool:
        """Tell whether no meeting of the plans is near a miss or a dead centre."""
        return self.tracing.clear(numbers)

    def plans_of(self, numbers: list[Any]) -> list[Plan]:
        """Make the plans that have these numbers."""
        boards, made = self.tracing.boards(numbers)
        found: list[Plan] = []
        for plan in self.plans:
            found.append(plan.redraw(boards[plan.board.subject], made, tuple(found)))
        return found

    def read(self, numbers: list[Any], turn: CrankPositions) -> Motion:
        """Read all named points and moving links off the plans."""
        shown = numbers.copy()
        count = len(turn)
        if self._rows[0] != count:
            self._rows = count, {place: resting(value, count) for place, value in self._still.items()}
        for place, row in self._rows[1].items():
            shown[place] = row
        shown[self._crank] = turn.headings
        points = {letter: PointMotion([shown[place] for place in places]) for letter, places in self._points.items()}
        links = {link: LinkMotion([shown[place] for place in places]) for link, places in self._links.items()}
        return Motion("construction", turn.phi, points, links, ())


def resting(value: npt.NDArray[Any], count: int) -> npt.NDArray[Any]:
    """See a value that is the same at all positions as a row, which takes no room and cannot be written in."""
    row: npt.NDArray[Any] = np.ndarray(count, value.dtype, value, strides=(0,))
    row.flags.writeable = False
    return row

"""The parts of velocities and accelerations by both roads: relative, normal, tangential, Coriolis; of mass centres.

The construction's are vectors between two marks of its plans; the analysis gives each by its own formula, from omega
and epsilon of the link and the places of its points (M3.1) (составляющие).
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from geometry.board import Mark, Span, between
from geometry.hand_error import SlippingHand, slopes
from geometry.precision import errors
from plans.linkage.drafts import Drafts
from plans.linkage.dyads import KINDS
from plans.linkage.plan import NONE, Masses, Plan, PlanLetters, Sliding, Slotted, SpecialPoint, Turning, Vector, unnamed
from plans.linkage.primary import PRIMARIES
from plans.linkage.quantities import MotionComparison, with_analysis
from plans.linkage.special_points import special_rows
from plans.linkage.study import LinkageStudy
from plans.model.dyad import Assur
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import ACCELERATIONS, ORDERS, POSITIONS, VELOCITIES, Complexes, Floats, Motion, Order
from plans.quantity import SLIP, Quantity, Shown, Slipping, errors_by_hand
from plans.study import Study

# A vector by the plan's subject and the names of its ends: ("velocities", "a", "b").
Arrow = tuple[str, str, str]


def vectors_of(mechanism: Mechanism, groups: Iterable[Assur]) -> Iterator[Vector]:
    """Tell the vectors that the plans of a mechanism must have, beside those of its points."""
    yield from PRIMARIES[mechanism.drive.kind].vectors(mechanism)
    for group in groups:
        yield from KINDS[group.kind].vectors(group)


class AnalysedVectors:
    """The vectors of the plans of one position, from the motion by analysis; the relative-motion formulas are M3.1."""

    def __init__(self, mechanism: Mechanism, motion: Motion, position: int, letters: PlanLetters) -> None:
        self.mechanism, self.motion, self.k, self.letters = mechanism, motion, position, letters

    def arrows(self, groups: Sequence[Assur]) -> dict[Arrow, complex]:
        """Give every arrow that a plan may show between named points, normal and Coriolis ends."""
        found = dict(self._absolute())
        for vector in vectors_of(self.mechanism, groups):
            found.update(self._of(vector))
        return found

    def _of(self, vector: Vector) -> Iterable[tuple[Arrow, complex]]:
        match vector:
            case Turning():
                return self._turning(vector)
            case Slotted():
                return self._slotted(vector)
            case SpecialPoint():
                rows = special_rows(self.mechanism, self.motion, self.letters, vector)
                return [((row.order.plan, row.start, row.end), complex(row.values[self.k])) for row in rows]
        return ()

    def _absolute(self) -> Iterator[tuple[Arrow, complex]]:
        fixed = self.mechanism.links[FRAME].points
        for name in (name for name in self.motion.points if name not in fixed):
            yield ("velocities", "p", self.letters.small(name)), self.v(name)
            yield ("accelerations", "π", self.letters.small(name)), self.a(name)

    def r(self, name: str) -> complex:
        """Place of a point, m."""
        return complex(self.motion.points[name].r[self.k])

    def v(self, name: str) -> complex:
        """Velocity of a point, m/s."""
        return complex(self.motion.points[name].v[self.k])

    def a(self, name: str) -> complex:
        """Acceleration of a point, m/s2."""
        return complex(self.motion.points[name].a[self.k])

    def centre(self, link: int, place: complex, order: int) -> complex:
        """Velocity (order 1) or acceleration (2) of a place of a link, by that of its first point (M3.1)."""
        name, first = next(iter(self.mechanism.links[link].points.items()))
        turned, rates = (place - first) * np.exp(1j * self.motion.links[link].angle[self.k]), self.motion.links[link]
        omega, epsilon = float(rates.omega[self.k]), float(rates.epsilon[self.k])
        spun = 1j * omega if order == 1 else 1j * epsilon - omega**2
        return complex(self.motion.points[name][order][self.k] + spun * turned)

    def omega(self, link: int) -> float:
        """Angular velocity of a link, rad/s."""
        return float(self.motion.links[link].omega[self.k])

    def image(self, name: str, pole: str) -> str:
        """Name a point's image on a plan: the pole for a fixed point."""
        return pole if name in self.mechanism.links[FRAME].points else self.letters.small(name)

    def _turning(self, vector: Turning) -> Iterator[tuple[Arrow, complex]]:
        """A tip over a start: its velocity, the normal part of its acceleration, and the tangential one from there."""
        link, start, tip = vector
        yield ("velocities", self.image(start, "p"), self.letters.small(tip)), self.v(tip) - self.v(start)
        image = self.image(start, "π")
        end = self.letters.normal(tip, "" if image == "π" else start)
        normal = -(self.omega(link) ** 2) * (self.r(tip) - self.r(start))
        yield ("accelerations", image, end), normal
        yield ("accelerations", end, self.letters.small(tip)), self.a(tip) - self.a(start) - normal

    def _slotted(self, vector: Slotted) -> Iterator[tuple[Arrow, complex]]:
        link, pivot, pin = vector
        under, spin = self.letters.under(pin, link), self.omega(link)
        arm = self.r(pin) - self.r(pivot)
        turning = 1j * spin * arm
        slip = self.v(pivot) + turning - self.v(pin)
        yield ("velocities", self.image(pivot, "p"), under), turning
        yield ("velocities", self.image(pin, "p"), under), slip
        yield ("velocities", "p", under), self.v(pivot) + turning
        yield ("accelerations", self.image(pin, "π"), self.letters.coriolis(pin, link)), 2j * spin * slip
        yield ("accelerations", self.image(pivot, "π"), self.letters.normal(under.upper())), -(spin**2) * arm


NORMAL, TANGENTIAL, CORIOLIS, RELATIVE = "n", "t", "k", "r"


class VectorPart(NamedTuple):
    """A vector of a plan beside those of its points: its letters, where the plan shows it, its value by analysis."""

    order: Order
    name: str  # "v_BA", "a^n_BA"
    span: Span
    analysis: Complexes


def quantities_of(study: "Study") -> tuple[Quantity, ...]:
    """Give what is compared of a scene's motion, and the parts of its velocities and accelerations."""
    linkage = study.of(LinkageStudy)
    compared = study.of(MotionComparison)
    if compared.construction.order < ACCELERATIONS.number:
        return compared.findings
    return *compared.findings, *findings(linkage, compared, unnamed(linkage.scene, linkage.mechanism.links))


def findings(study: LinkageStudy, comparison: MotionComparison, masses: Masses = NONE) -> tuple[Quantity, ...]:
    """Compare the parts of all velocities and accelerations over the positions of a study, (N,) m/s or m/s2.

    `masses` are the mass centres that no point names, by their letters: link, and place in its own frame.
    """
    drafts, made = study.drafts(), comparison.construction
    gone = np.any([np.isnan(point[made.order]) for point in made.points.values()], axis=0)
    parts = _PlanParts(study, drafts, comparison.analysis, masses).all()
    bounds = errors(*(mark for part in parts for mark in part.span))
    found = []
    for part in parts:
        ours = np.where(gone, np.nan, between(*part.span))
        theirs = np.where(gone, np.nan, part.analysis)
        drawn_error = sum((bounds[mark].place for mark in part.span), np.zeros(1))
        largest = comparison.of(part.order.plan)[0].largest
        allowed = with_analysis(drawn_error, part.order.number, comparison.kappa, largest)
        named = part.order.plan, part.name, part.order.point.unit
        found.append(Quantity.of(named, (ours, theirs), allowed, largest, part.span))
    return tuple(found)


def spans(study: LinkageStudy, drafts: Drafts, motion: Motion, masses: Masses = NONE) -> dict[str, Span]:
    """Give where the plans of some positions show each part, by its letters."""
    return {part.name: part.span for part in _PlanParts(study, drafts, motion, masses).all()}


def alike(findings: Iterable[Quantity], mechanism: Mechanism, masses: Masses = NONE) -> list[tuple[Quantity, ...]]:
    """Put together what is one vector or one rate by its cause: of a link that never turns, of links joined by a slide.

    `told` are findings of velocities and accelerations; each stays in the place of the first that it is put with.
    """
    turning = mechanism.turning_with
    carried = {name: link for name, (link, _) in masses.items() if turning[link] == FRAME}
    carried |= {name: n for n, link in mechanism.links.items() if turning[n] == FRAME for name in link.points}
    found: dict[tuple[str, object], list[Quantity]] = {}
    for finding in findings:
        symbol, _, index = finding.name.partition("_")
        rate = symbol in (VELOCITIES.link.symbol, ACCELERATIONS.link.symbol)
        found.setdefault((symbol, turning[int(index)] if rate else carried.get(index, index)), []).append(finding)
    return [tuple(same) for same in found.values()]


def carried_from(line: Mark, direction: Mark) -> bool:
    """Tell whether a line was drawn along a direction of the plan of positions."""
    return line.step.inputs[1].step.inputs == (direction,)


class _PlanParts(NamedTuple):
    study: LinkageStudy
    drafts: Drafts
    motion: Motion
    masses: Masses

    def all(self) -> list[VectorPart]:
        """List the parts, each once, in the order in which the plans are drawn."""
        vectors = vectors_of(self.study.mechanism, self.study.groups)
        parts = [*self._centres(), *(part for vector in vectors for part in self._of(vector))]
        return list({part.name: part for part in parts}.values())

    def _centres(self) -> Iterator[VectorPart]:
        """Tell mass centres by the first point of their link."""
        for order in ORDERS[1:]:
            plan = self.drafts.plan(order.number)
            for name, (link, place) in self.masses.items():
                span = Span(plan.pole, plan.place(link, place, plan.letter(name)))
                origin, first = next(iter(self.study.mechanism.links[link].points.items()))
                turned = (place - first) * np.exp(1j * self._rate(link, 0))
                found = self._over(link, origin, turned, order.number)
                yield VectorPart(order, f"{order.point.symbol}_{name}", span, found)

    def _of(self, vector: Vector) -> Iterator[VectorPart]:
        match vector:
            case Turning():
                yield from self._turning(vector)
            case Slotted():
                yield from self._slotted(vector)
            case SpecialPoint():
                yield from self._special(vector)
            case _:
                yield from self._sliding(vector)

    def _special(self, vector: SpecialPoint) -> Iterator[VectorPart]:
        for row in special_rows(self.study.mechanism, self.motion, self.drafts.accelerations.written, vector):
            board = self.drafts.plan(row.order.number).board
            yield VectorPart(row.order, row.letter, Span(board[row.start], board[row.end]), row.values)

    def _turning(self, vector: Turning) -> Iterator[VectorPart]:
        """Tell a tip about its start: by omega and epsilon of their link over the arm between them."""
        speeds, plan = self.drafts.velocities, self.drafts.accelerations
        arm = self._at(vector.tip, 0) - self._at(vector.start, 0)
        n = plan.board[plan.written.normal(vector.tip, "" if plan.point(vector.start) is plan.pole else vector.start)]
        over = vector.tip if self._still(vector.start) else vector.tip + vector.start
        if not self._still(vector.start):
            span = Span(speeds.point(vector.start), speeds.point(vector.tip))
            yield VectorPart(VELOCITIES, f"v_{over}", span, 1j * self._rate(vector.link, 1) * arm)
        yield from self._about(vector.link, arm, (over, plan.point(vector.start), n, plan.point(vector.tip)))

    def _about(self, link: int, arm: Complexes, marks: tuple[str, Mark, Mark, Mark]) -> Iterator[VectorPart]:
        """Tell the normal and the tangential part of an acceleration about a point of a link."""
        over, start, normal, end = marks
        omega, epsilon = self._rate(link, 1), self._rate(link, 2)
        yield VectorPart(ACCELERATIONS, f"a^{NORMAL}_{over}", Span(start, normal), -(omega**2) * arm)
        yield VectorPart(ACCELERATIONS, f"a^{TANGENTIAL}_{over}", Span(normal, end), 1j * epsilon * arm)

    def _slotted(self, vector: Slotted) -> Iterator[VectorPart]:
        link, pivot, pin = vector
        speeds, plan = self.drafts.velocities, self.drafts.accelerations
        under, letter = plan.written.under(pin, link), self._under(pin, link)
        arm = self._at(pin, 0) - self._at(pivot, 0)
        over = letter if self._still(pivot) else letter + pivot
        speed = 1j * self._rate(link, 1) * arm
        yield VectorPart(VELOCITIES, f"v_{over}", Span(speeds.point(pivot), speeds.board[under]), speed)
        if not self._still(pivot):
            span = Span(speeds.pole, speeds.board[under])
            yield VectorPart(VELOCITIES, f"v_{letter}", span, self._carried(link, pin, 1))
        whole = Span(plan.pole, plan.board[under])
        yield VectorPart(ACCELERATIONS, f"a_{letter}", whole, self._carried(link, pin, 2))
        normal = plan.board[plan.written.normal(under.upper())]
        yield from self._about(link, arm, (over, plan.point(pivot), normal, plan.board[under]))

    def _sliding(self, vector: Sliding) -> Iterator[VectorPart]:
        """Tell a pin over the point of a moving guide that lies under it, or that point over the pin."""
        host, pin, sense = vector.host, vector.pin, -1.0 if vector.held else 1.0
        letters = (self._under(pin, host), pin)
        over = "".join(letters if vector.held else reversed(letters))
        speed, whole = (sense * (self._at(pin, k) - self._carried(host, pin, k)) for k in (1, 2))
        span, _ = self._slip(self.drafts.velocities, vector)
        yield VectorPart(VELOCITIES, f"v_{over}", span, speed)
        turned = 2j * self._rate(host, 1) * speed
        span, coriolis = self._slip(self.drafts.accelerations, vector)
        if coriolis is not None:
            yield VectorPart(ACCELERATIONS, f"a^{CORIOLIS}_{over}", coriolis, turned)
        yield VectorPart(ACCELERATIONS, f"a^{RELATIVE}_{over}", span, whole - turned)

    def _slip(self, plan: Plan, vector: Sliding) -> tuple[Span, Span | None]:
        """Find the vector along the guide in the line it was drawn by, and the Coriolis part on which that stands."""
        if vector.pair in plan.slips:
            start, end = plan.slips[vector.pair].step.inputs
        else:
            end = plan.board[plan.written.under(vector.pin, vector.host)] if vector.held else plan.point(vector.pin)
            direction = plan.positions.units[vector.pair]
            assert direction is not None  # every guide has a direction on the plan of positions
            parallels = (locus for locus in end.step.inputs if locus.step.op == "parallel")
            start = next(locus for locus in parallels if carried_from(locus, direction)).step.inputs[0]
        drawn = start.name == plan.written.coriolis(vector.pin, vector.host, vector.pair) and start.step.op == "lay_off"
        return Span(start, end), Span(start.step.inputs[0], start) if drawn else None

    def _at(self, point: str, order: int) -> Complexes:
        return self.motion.points[point][order]

    def _rate(self, link: int, order: int) -> Floats:
        return self.motion.links[link][order]

    def _carried(self, link: int, pin: str, order: int) -> Complexes:
        """Give velocity or acceleration of the point of a link that lies under a pin."""
        origin = next(name for name in self.study.mechanism.links[link].points if name in self.motion.points)
        return self._over(link, origin, self._at(pin, 0) - self._at(origin, 0), order)

    def _over(self, link: int, origin: str, arm: Complexes, order: int) -> Complexes:
        """Give velocity or acceleration of the end of an arm that a link turns about one of its points."""
        omega, epsilon = self._rate(link, 1), self._rate(link, 2)
        turning = 1j * omega * arm if order == 1 else (1j * epsilon - omega**2) * arm
        return np.asarray(self._at(origin, order) + turning)

    def _under(self, pin: str, link: int) -> str:
        return self.drafts.velocities.written.under(pin, link).upper().replace("_", "")

    def _still(self, point: str) -> bool:
        return point in self.study.mechanism.links[FRAME].points


class MotionByHand(NamedTuple):
    """The velocities, accelerations and rates of a linkage as they are read off plans that a hand draws.

    `masses` are the mass centres that no point names, by their letters: link, and place in its own frame.
    """

    study: LinkageStudy
    comparison: MotionComparison
    masses: Masses

    @property
    def parts(self) -> tuple[Quantity, ...]:
        """The parts of all velocities and accelerations by both roads."""
        return findings(self.study, self.comparison, self.masses)

    @property
    def given(self) -> set[str]:
        """What the scene states, by its letters."""
        drive = self.study.mechanism.drive
        if drive.ram is not None:
            return set()  # what a cylinder gives the crank is found
        return {f"{k}_{drive.end}" for k in "va"} if drive.pushed else {f"{k}_{drive.link}" for k in "ωε"}

    def errors(
        self, positions: Sequence[int], scales: Mapping[str, Floats], by: Slipping = slopes
    ) -> dict[str, Floats]:
        """Give within what 95 of 100 drawings are of each quantity, (positions,), in its own unit.

        The names are those of the findings: "v_B", "ω_3", "a^n_BA"; of a vector it is the size. `scales` are those of
        the plans, true units a mm, one for each position. NaN: so near a dead centre that slips tell nothing.
        """
        return errors_by_hand(self.read(self.study.drafts(list(positions))), SlippingHand(SLIP, scales), by)

    def on_sheet(
        self, positions: Sequence[int], scales: Mapping[str, float], by: Slipping = slopes
    ) -> dict[tuple[str, int], float]:
        """Give the errors on drawn figures, by name and position; a position without its plans has none.

        `scales` are those of the figures, true units a mm, by their names: "positions", "velocities-3".
        """
        figures = {k: [o.plan if o is POSITIONS else f"{o.plan}-{k}" for o in ORDERS] for k in positions}
        whole = [k for k in positions if set(figures[k]) <= set(scales) and not self.study.lost[k]]
        if not whole:
            return {}
        rows = {order.plan: np.array([scales[figures[k][order.number]] for k in whole]) for order in ORDERS}
        found = self.errors(whole, rows, by)
        return {(name, k): float(error) for name, row in found.items() for k, error in zip(whole, row, strict=True)}

    def read(self, drafts: Drafts) -> dict[str, Shown]:
        """Give where the plans of some positions show what is read off them, by its letters."""
        found: dict[str, Shown] = {}
        fixed = self.study.mechanism.links[FRAME].points
        for order in ORDERS[1:]:
            plan = drafts.plan(order.number)
            moving = [name for name in self.comparison.construction.points if name not in fixed]
            found |= {f"{order.point.symbol}_{name}": Span(plan.pole, plan.point(name)) for name in moving}
            found |= {f"{order.link.symbol}_{link}": reading for link, reading in plan.readings.items()}
        return found | spans(self.study, drafts, self.comparison.analysis, self.masses)

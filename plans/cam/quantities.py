"""Cams by both roads: laws, their diagrams, sizes, profile, extremes, beside each other (сравнение кулачков)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from plans.analytic.cam.contour import ContourValues, forces_of
from plans.analytic.cam.findings import cam_found
from plans.analytic.cam.laws import travel
from plans.analytic.cam.sizes import sizes
from plans.cam.numbers import results
from plans.cam.study import LAWS, PROFILE, SIZES, CamDrawing, CamStudy
from plans.cam.verdicts import TERM, Slack, Verdicts
from plans.model.cam import SHAPE, TABLE, Cam, dimensions
from plans.model.cam_motion import ANALYSIS, CONSTRUCTION, CamFlaw, CamFound, Extreme, Points, Pressing
from plans.model.motion import Floats, Gap
from plans.quantity import Comparison, Quantity
from plans.study import Study

EQUAL = 1e-9  # of an extreme value: what is as large is another place of the same extreme
NEAR = 1e-6  # of the turn: a place where something is level is known to half of the digits
Value = Callable[[ContourValues], Floats]


def settled(theirs: CamFound, ours: CamFound) -> CamFound:
    """Give what the analysis found with each extreme where the construction has it, if it finds it as large there."""
    pressure = {
        kind: _settled(theirs, extreme, ours.pressure.get(kind), lambda curve: curve.pressure)
        for kind, extreme in theirs.pressure.items()
    }
    same = [flaw.kind for flaw in theirs.flaws] == [flaw.kind for flaw in ours.flaws]
    pairs = zip(theirs.flaws, ours.flaws, strict=True) if same else ()
    return replace(
        theirs,
        pressure={kind: extreme for kind, extreme in pressure.items() if extreme is not None},
        sharpest=_settled(theirs, theirs.sharpest, ours.sharpest, lambda curve: curve.radius),
        hollow=_settled(theirs, theirs.hollow, ours.hollow, lambda curve: curve.radius),
        flaws=tuple(_flaw(theirs, *pair) for pair in pairs) if same else theirs.flaws,
        pressing=_pressing(theirs, ours),
    )


def _pressing(theirs: CamFound, ours: CamFound) -> Pressing | None:
    """Give the contact's forces so: under a steady load they are as large in many places of a dwell."""
    pressing, other = theirs.pressing, ours.pressing
    forces = forces_of(theirs.cam, theirs.roller)
    if pressing is None or other is None or forces is None:
        return pressing
    return pressing._replace(
        least=_settled(theirs, pressing.least, other.least, forces.normal) or pressing.least,
        most=_settled(theirs, pressing.most, other.most, forces.normal) or pressing.most,
        wear=_settled(theirs, pressing.wear, other.wear, forces.wear) or pressing.wear,
    )


def _settled(found: CamFound, extreme: Extreme | None, ours: Extreme | None, value: Value) -> Extreme | None:
    """Give an extreme at the other place, if it is as large there; a pressure angle may have the other sign."""
    if extreme is None or ours is None:
        return extreme
    for there in _sides(found, ours.turned, value):
        if math.isclose(abs(there), abs(extreme.value), rel_tol=EQUAL) and there * ours.value > 0:
            return Extreme(there, ours.turned)
    return extreme


def _sides(found: CamFound, turned: float, value: Value) -> list[float]:
    """Give a value after a turn of the cam and before it."""
    curves = (ContourValues(found.cam, found.sizes, np.array([turned]), before) for before in (False, True))
    return [float(value(curve)[0]) for curve in curves]


def _flaw(found: CamFound, flaw: CamFlaw, ours: CamFlaw) -> CamFlaw:
    """Give a flaw with its worst place so: of one by its radius anywhere, of others only hard by."""
    turned, near = ours.worst.turned, NEAR * found.cam.turn
    beside = abs(turned - flaw.worst.turned) <= near
    radii = _sides(found, turned, lambda curve: curve.radius) if flaw.kind in ("undercut", "hollow") else []
    equal = any(math.isclose(abs(radius), abs(flaw.worst.value), rel_tol=EQUAL) for radius in radii)
    return flaw._replace(worst=flaw.worst._replace(turned=turned)) if beside or equal else flaw


@dataclass(frozen=True)
class CamRoad:
    """What one road found of all cams of a scene."""

    by: str
    cams: tuple[CamFound, ...]

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """Where nothing is found: a cam has a profile at every turn."""
        return ()


def compare_cams(cams: CamStudy, plans: frozenset[str] = frozenset({LAWS, SIZES, PROFILE})) -> Comparison:
    """Find each cam by analysis too, and put every quantity beside that of the construction."""
    drawings = [*cams.drawings.values()]
    theirs = tuple(settled(cam_found(made.cam, sizes(made.cam), made.turned), made.found) for made in drawings)
    pairs = zip(drawings, theirs, strict=True)
    lone = len(drawings) == 1
    findings = [finding for drawing, exact in pairs for finding in ComparedCam(drawing, exact, lone).findings(plans)]
    return Comparison(CamRoad(CONSTRUCTION, cams.found), CamRoad(ANALYSIS, theirs), tuple(findings))


def quantities_of(study: Study) -> tuple[Quantity, ...]:
    """Give what is compared of a scene's cams, and what the tables of their sizes tell."""
    found: Comparison = study.comparison("cam")
    ours, theirs = found.construction.cams, found.analysis.cams
    names = ["" if len(ours) == 1 else f" {cam.cam.name}" for cam in ours]
    return *found.findings, *(row for both in zip(ours, theirs, names, strict=True) for row in _table_rows(*both))


def _table_rows(ours: CamFound, theirs: CamFound, of: str) -> Iterator[Quantity]:
    pairs = zip(results(ours), results(theirs), strict=True)
    for result, exact in ((result, exact) for result, exact in pairs if not result.where):
        yield Quantity.of((SIZES, f"{result.letter}{of}", result.unit), (result.value, exact.value), np.inf)


@dataclass(frozen=True)
class ComparedCam:
    """One cam by both roads; beside others its quantities bear its name."""

    drawing: CamDrawing
    theirs: CamFound
    lone: bool = True

    @property
    def ours(self) -> CamFound:
        """The cam by construction."""
        return self.drawing.found

    @cached_property
    def slack(self) -> Slack:
        """How far rounding can move it."""
        return Slack(self.ours, self.drawing.sizing, self.ours.contour)

    def near(self, extreme: Extreme | None) -> tuple[Slack, ...]:
        """How far rounding can move it at the place of an extreme, on either side of it."""
        if extreme is None:
            return (self.slack,)
        sides = (self.drawing.profile(np.array([extreme.turned]), before).contour for before in (False, True))
        return tuple(Slack(self.ours, self.drawing.sizing, contour) for contour in sides)

    def bent(self, extreme: Extreme | None) -> float:
        """How far rounding can move 1/ρ at the place of an extreme, 1/m; under a flat face ρ itself, m."""
        flat = self.ours.cam.flat
        return max(float(np.max(slack.radius if flat else slack.curvature)) for slack in self.near(extreme))

    def findings(self, plans: frozenset[str]) -> Iterator[Quantity]:
        """Compare what is asked for."""
        if LAWS in plans:
            yield from self.laws()
            yield from map(self._of, self.verdicts.shocks())
            yield from self.diagrams()
        if SIZES in plans:
            yield from self.sizes()
        if PROFILE in plans:
            yield from self.profile()
            yield from self.extremes()
            yield from self.said()

    @property
    def verdicts(self) -> Verdicts:
        """What both roads say of it beside its shape."""
        return Verdicts(self.drawing, self.theirs, self.slack, self.near)

    def said(self) -> Iterator[Quantity]:
        """Compare contact forces, flaws, and what would mend those."""
        verdicts = self.verdicts
        yield from map(self._of, (*verdicts.forces(), *verdicts.flaws(), *verdicts.remedies()))

    def _of(self, quantity: Quantity) -> Quantity:
        return quantity if self.lone else quantity._replace(name=f"{quantity.name} {self.ours.cam.name}")

    def laws(self) -> Iterator[Quantity]:
        """Compare S, S', S'' at the numbered positions, and the largest S' and S'' of all."""
        ours, theirs = self.ours.contour.travel, self.theirs.contour.travel
        for order, name in enumerate(("S", "S'", "S''")):
            yield self._row(LAWS, name, self._units[order], ours[order], theirs[order], self.slack.travel(order))
        for order, (name, extreme) in enumerate(self.ours.peaks.items(), 1):
            size, true = abs(extreme.value), abs(self.theirs.peaks[name].value)
            yield self._quantity(LAWS, f"{name}_max", self._units[order], size, true, self.slack.travel(order))

    def diagrams(self) -> Iterator[Quantity]:
        """Compare the chords with the same chords by the ordinates of the analysis."""
        drawn = self.drawing.diagrams
        edges, slope, s = drawn.strips.edges, *self.chords
        sums = TERM * len(edges)
        first = self.slack.travel(1) + self.slack.travel(2) * self.ours.cam.turn + sums * _most(slope)
        second = self.slack.travel(0) + first * self.ours.cam.turn + sums * _most(s)
        yield self._row(LAWS, "S' chords", self._units[1], drawn.slope[1], slope, first)
        yield self._row(LAWS, "S chords", self._units[0], drawn.travel.values, s, second)

    @property
    def chords(self) -> tuple[Floats, Floats]:
        """S' at the ends of the strips and S at their edges, as chords find them from the analysis's S''."""
        drawn, cam = self.drawing.diagrams, self.theirs.cam
        edges = drawn.strips.edges
        (gains, bends), slope = _gains(cam, edges), np.empty(len(edges) - 1)
        for run in drawn.runs:
            slope[run] = travel(cam, edges[run.start : run.start + 1]).slope + np.cumsum(gains[run])
        steps = (slope - gains / 2 + np.diff(edges) * bends / 12) * np.diff(edges)
        return slope, np.concatenate([[0.0], np.cumsum(steps)]) + float(travel(cam, edges[:1]).s[0])

    @property
    def gains(self) -> Floats:
        """What S' gains over the strips by the mean ordinates of the analysis's S''."""
        return _gains(self.theirs.cam, self.drawing.diagrams.strips.edges)[0]

    def sizes(self) -> Iterator[Quantity]:
        """Compare the main sizes and the roller."""
        ours, theirs = self.ours, self.theirs
        if not ours.cam.translates:
            yield self._quantity(SIZES, "R_0", "m", ours.sizes.base, theirs.sizes.base, self.slack.centre)
        if ours.cam.rocks and not ours.cam.translates:
            yield self._quantity(SIZES, "L", "m", ours.sizes.centre, theirs.sizes.centre, self.slack.centre)
            turned = self.slack.centre / ours.sizes.centre
            yield self._quantity(SIZES, "ψ_0", "rad", ours.sizes.initial, theirs.sizes.initial, turned + TERM)
            yield self._quantity(SIZES, "O1", "m", ours.sizes.pivot, theirs.sizes.pivot, self.slack.centre)
        elif not ours.cam.flat and not ours.cam.translates:
            yield self._quantity(SIZES, "e", "m", ours.sizes.offset, theirs.sizes.offset, self.slack.centre)
        if ours.roller:
            radius = ours.sharpest.value**2 * self.bent(ours.sharpest) if ours.sharpest else 0.0
            yield self._quantity(SIZES, "r_r", "m", ours.roller, theirs.roller, radius + self.slack.centre)

    def profile(self) -> Iterator[Quantity]:
        """Compare the profile at the numbered positions."""
        ours, theirs, slack = self.ours.contour, self.theirs.contour, self.slack
        yield self._row(PROFILE, "K", "m", ours.tip, theirs.tip, slack.lever)
        yield self._row(PROFILE, "P", "m", ours.pitch, theirs.pitch, slack.lever)
        if self.ours.roller:
            yield self._row(PROFILE, "Q", "m", ours.profile, theirs.profile, slack.profile)
        if ours.outer is not None and theirs.outer is not None:
            yield self._row(PROFILE, "Q'", "m", ours.outer, theirs.outer, slack.profile)
        yield self._row(PROFILE, "α", "rad", ours.pressure, theirs.pressure, slack.angle)
        edge = 0.0 if self.ours.cam.flat else np.nan  # under a flat face ρ itself is compared
        bends = _over(self.ours.contour.radius, edge), _over(self.theirs.contour.radius, edge)
        yield self._row(PROFILE, "1/ρ", "1/m", *bends, slack.curvature)
        if self.ours.cam.flat:
            yield self._row(PROFILE, "ρ", "m", ours.radius, theirs.radius, slack.radius)
        yield self._row(PROFILE, "v_sl/ω", "m", ours.sliding, theirs.sliding, slack.lever)

    def extremes(self) -> Iterator[Quantity]:
        """Compare the largest pressure angles and the sharpest places."""
        ours, theirs = self.ours, self.theirs
        for kind, extreme in ours.pressure.items():
            angle = max(float(np.max(slack.angle)) for slack in self.near(extreme))
            pair = abs(extreme.value), abs(theirs.pressure[kind].value)
            yield self._quantity(PROFILE, f"α_{kind}", "rad", *pair, angle)
        unit, long = ("m", _most(ours.contour.radius)) if ours.cam.flat else ("1/m", None)  # a cusp has no 1/ρ
        for name, *both in (("ρ_min", ours.sharpest, theirs.sharpest), ("ρ_hollow", ours.hollow, theirs.hollow)):
            one, two = (0.0 if found is None else found.value if unit == "m" else 1 / found.value for found in both)
            yield self._of(Quantity.of((PROFILE, name, unit), (one, two), self.bent(both[0]), long))
        for k, side in enumerate(("back", "front") if ours.cam.flat else ()):
            yield self._quantity(PROFILE, f"face_{side}", "m", ours.face[k], theirs.face[k], self.slack.lever)

    @property
    def _units(self) -> Sequence[str]:
        return dimensions(self.ours.cam)

    def _quantity(self, plan: str, name: str, unit: str, ours: complex, theirs: complex, allowed: float) -> Quantity:
        return self._row(plan, name, unit, np.array([ours]), np.array([theirs]), allowed)

    def _row(
        self, plan: str, name: str, unit: str, ours: Floats | Points, theirs: Floats | Points, allowed: Floats | float
    ) -> Quantity:
        return self._of(Quantity.of((plan, name, unit), (ours, theirs), allowed, _most(ours)))


def _gains(cam: Cam, edges: Floats) -> tuple[Floats, Floats]:
    """Give what S' gains over strips, and how much S'' falls over them.

    A mean ordinate of S'' is read from three, at both ends and at mid-strip; of a law by points it is the true one.
    """
    middles, width = (edges[:-1] + edges[1:]) / 2, np.diff(edges)
    first, last = travel(cam, edges[:-1]), travel(cam, edges[1:], before=True)
    by_points = [phase for phase in cam.moving() if phase.law is not None and phase.law.name in (TABLE, SHAPE)]
    straight = [(phase.start < middles) & (middles < phase.end) for phase in by_points]
    read = (first.bend + 4 * travel(cam, middles).bend + last.bend) / 6 * width
    exact = np.any([np.zeros(len(middles), dtype=bool), *straight], axis=0)
    return np.where(exact, last.slope - first.slope, read), first.bend - last.bend


def _most(values: Floats | Points) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def _over(radius: Floats, edge: float) -> Floats:
    """Give 1/ρ; of a straight place 0, and what is said of an edge."""
    bent = np.where(np.isinf(radius), 0.0, 1 / np.where(radius == 0, np.nan, radius))
    return np.where(radius == 0, edge, bent)

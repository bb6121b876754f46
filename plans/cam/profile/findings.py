"""All that the construction finds of one cam's profile (кулачок, итог построения)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from plans.cam.course import FollowerCourse
from plans.cam.profile.contact import (
    Contact,
    ProfileExtremes,
    base_convex,
    base_needed,
    contact_of,
    on,
    pressing,
    pressure,
    sizes_advised,
)
from plans.cam.profile.profile import Roller, curvature, profile, roller_of
from plans.cam.profile.resting import ProfileEdge, crossings, loss
from plans.cam.profile.touch import FaceTouch, Stretches, Tip, TurnSide, TurnSpan, Value
from plans.model.cam import FORCE, GROOVE, RETURN, RISE, ROLLER, Cam, interval_of
from plans.model.cam_motion import HARD, CamFlaw, CamFound, CamSizes, Extreme
from plans.model.motion import Floats

# Sizes that were found by a limit touch it, and a roller may be as large as a radius: the same within this share of the
# limit or of the radius. Rounding makes less of it, and no workshop as little.
TOUCHES: Final = 1e-9
LEAST: Final = ("undercut", "concave", "sharp", "lift-off")  # of which the worst is the least value


@dataclass(frozen=True)
class Search:
    """The search for flaws of one profile."""

    extremes: ProfileExtremes
    roller: float  # m
    contact: Contact | None

    @property
    def stretches(self) -> Stretches:
        """The stretches of the turn."""
        return self.extremes.stretches

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.stretches.course.cam

    def flaws(self) -> tuple[CamFlaw, ...]:
        """Give all flaws by their kinds, those of a kind as the cam turns."""
        worst = self.extremes.outrun
        if worst:
            return (CamFlaw("outrun", worst.turned, worst.turned, worst),)
        ways = (self._undercut, self._concave, self._crossing, self._pressure, self._face, self._off)
        found = [flaw for way in ways for flaw in way()]
        found = found if self.cam.translates else round_the_turn(found, self.cam.turn)
        return tuple(sorted(found, key=lambda flaw: (flaw.kind, flaw.start)))

    def _undercut(self) -> Iterator[CamFlaw]:
        """Find where the roller is larger than the curve bears: convex, or of a groove's outer side hollow."""
        yield from self._sharp("undercut", 1.0)
        if self.cam.closure == GROOVE:
            yield from self._sharp("hollow", -1.0)

    def _sharp(self, kind: str, side: float) -> Iterator[CamFlaw]:
        if self.roller == 0 or self.cam.flat:
            return
        spans = self._too_sharp(side)
        yield from (self._flaw(kind, span, lambda tip: side * curvature(tip), 1 / side) for span in spans)
        extreme = self.extremes.sharpest if side > 0 else self.extremes.hollow
        if extreme and not spans and abs(abs(extreme.value) / self.roller - 1) <= TOUCHES:
            yield CamFlaw(kind, extreme.turned, extreme.turned, extreme)
        for turned in self.corners(side):
            yield CamFlaw(kind, turned, turned, Extreme(0.0, turned))

    def _too_sharp(self, side: float) -> list[TurnSpan]:
        """Give where the curve is bent more than the roller, to one side."""
        return list(self.stretches.spans(lambda tip: side * self.roller * curvature(tip) - 1, self.extremes.bends))

    def corners(self, side: float = 1.0) -> list[float]:
        """Give where hard shocks make corners of the theoretical profile: convex ones (1.0), or hollow ones (-1.0)."""
        hard = [shock.turned for shock in self.stretches.course.shocks if shock.order == HARD]
        ends = np.array(hard if self.cam.translates else [turned or self.cam.turn for turned in hard])
        tips = (Tip(self.stretches.course, self.stretches.sizes, *at) for at in ((np.array(hard),), (ends, True)))
        after, before = (tip.lever for tip in tips)
        turns = np.angle(after / before) * -self.cam.sense * side
        return [turned for turned, turn in zip(hard, turns.tolist(), strict=True) if turn > 0]

    def _concave(self) -> Iterator[CamFlaw]:
        """Find where the profile under a flat face would be hollow, or sharper than was asked."""
        if not self.cam.flat:
            return
        spans = self._hollows
        yield from (self._flaw("concave", span, lambda tip: -FaceTouch(tip).radius, least=True) for span in spans)
        # A hard shock makes contact jump back along the face: an edge is left there.
        falls = [shock.turned for shock in self.stretches.course.shocks if shock.order == HARD and shock.jump < 0]
        yield from (CamFlaw("concave", turned, turned, Extreme(0.0, turned)) for turned in falls)
        least, asked = self.extremes.sharpest, self.cam.limits.curvature
        if not spans and least and asked > 0 and least.value < asked * (1 - TOUCHES):
            yield CamFlaw("sharp", least.turned, least.turned, least)

    @property
    def _hollows(self) -> list[TurnSpan]:
        return list(self.stretches.spans(_hollow, self.extremes.bends))

    def _crossing(self) -> Iterator[CamFlaw]:
        """Find where the profile crosses itself, and what is lost where the loop is cut away."""
        spans = self._hollows if self.cam.flat else self._too_sharp(1.0)
        for crossing in crossings(ProfileEdge(self.stretches, self.roller), spans):
            yield CamFlaw("crossing", crossing.start, crossing.end, loss(self.stretches, self.roller, crossing))

    def _pressure(self) -> Iterator[CamFlaw]:
        """Find where the pressure angle is beyond its limit; a spring drives the return, which has none then."""
        for kind in (RISE, RETURN):
            interval = interval_of(self.cam, kind)
            if interval is not None:
                yield from self._beyond(kind, 1, interval.high)
                yield from self._beyond(kind, -1, -interval.low)

    def _beyond(self, kind: str, side: int, limit: float) -> Iterator[CamFlaw]:
        def beyond(tip: Tip) -> Floats:
            return np.where(on(tip, kind), side * pressure(tip) - limit * (1 + TOUCHES), -1.0)

        def pressed(tip: Tip) -> Floats:
            return np.where(on(tip, kind), side * pressure(tip), 0.0)

        spans = self.stretches.spans(beyond, self.extremes.turning)
        yield from (self._flaw("pressure", span, pressed, least=side < 0) for span in spans)

    def _face(self) -> Iterator[CamFlaw]:
        """Find where contact goes off a face that is too short."""
        reach = self.cam.follower.reach
        if not self.cam.flat or reach is None:
            return
        places = self.stretches.places(lambda tip: FaceTouch(tip).place_slope)
        off = self.stretches.spans(lambda tip: np.abs(FaceTouch(tip).place) - reach * (1 + TOUCHES), places)
        yield from (self._flaw("short face", span, lambda tip: np.abs(FaceTouch(tip).place)) for span in off)

    def _off(self) -> Iterator[CamFlaw]:
        """Find where nothing holds the follower on the cam."""
        contact = self.contact
        if contact is None or self.cam.closure != FORCE:
            return
        places = self.stretches.places(contact.force_slope)
        for span in self.stretches.spans(lambda tip: -contact.resistance(tip), places):
            yield self._flaw("lift-off", span, lambda tip: -contact.force(tip), least=True)

    def _flaw(self, kind: str, span: TurnSpan, value: Value, over: float | None = None, least: bool = False) -> CamFlaw:
        """Make a flaw of a span with the place where a value is greatest, told as it is, over 1, or turned about."""
        ends = (TurnSide(span.start, False), TurnSide(span.end, True))
        found = self.stretches.most(value, (*span.places, *ends)) or Extreme(np.nan, span.start)
        worst = over / found.value if over else -found.value if least else found.value
        return CamFlaw(kind, span.start, span.end, Extreme(worst, found.turned))


def round_the_turn(found: Sequence[CamFlaw], turn: float) -> list[CamFlaw]:
    """Join a flaw that ends with the turn to one of its kind that begins with it: it starts late and ends early.

    >>> round_the_turn([CamFlaw("undercut", 0, 1, Extreme(2, 0)), CamFlaw("undercut", 5, 6, Extreme(2, 5))], 6)
    [CamFlaw(kind='undercut', start=5, end=1, worst=Extreme(value=2, turned=0))]
    """
    last = {flaw.kind: flaw for flaw in found if flaw.end == turn and flaw.start > 0}
    first = {flaw.kind: flaw for flaw in found if flaw.start == 0 and flaw.end < turn and flaw.kind in last}
    kept = [flaw for flaw in found if flaw is not last.get(flaw.kind) or flaw.kind not in first]
    return [_whole(last[flaw.kind], flaw) if flaw is first.get(flaw.kind) else flaw for flaw in kept]


def _whole(late: CamFlaw, early: CamFlaw) -> CamFlaw:
    """Give the flaw of both with the worse of their places."""
    both = early.worst, late.worst
    worst = min(both) if early.kind in LEAST else max(both, key=lambda place: abs(place.value))
    return early._replace(start=late.start, worst=worst)


def _hollow(tip: Tip) -> Floats:
    """Give what is above 0 where the profile under a face is hollow, or the face turns faster than the cam."""
    touch = FaceTouch(tip)
    if not tip.cam.rocks:
        return -touch.radius
    return np.where(touch.lead > 0, -touch.sweep, tip.sizes.base)


def cam_found(course: FollowerCourse, sizes: CamSizes, turned: Floats) -> CamFound:
    """Find a cam's profile at some turns, rad, its extremes over the whole turn, and its flaws."""
    extremes = ProfileExtremes(Stretches(course, sizes))
    roller, rule = roller_for(extremes)
    contact = contact_of(course.cam, roller)
    flaws = Search(extremes, roller, contact).flaws()
    return CamFound(
        cam=course.cam,
        sizes=sizes,
        roller=roller,
        contour=profile(course, sizes, roller, turned).contour,
        shocks=course.shocks,
        peaks=extremes.peaks,
        pressure=extremes.pressure,
        sharpest=extremes.sharpest,
        hollow=extremes.hollow,
        face=extremes.face,
        flaws=flaws,
        rule=rule,
        pressing=pressing(contact, extremes.stretches) if contact and not extremes.outrun else None,
        mending=base_needed(extremes.stretches) or base_convex(extremes),
        advised=sizes_advised(course.cam) if any(flaw.kind == "pressure" for flaw in flaws) else None,
    )


def roller_for(extremes: ProfileExtremes) -> Roller:
    """Take the roller of a cam, by its rule where none is given; a pointed or a flat follower has none."""
    cam, sharpest = extremes.stretches.course.cam, extremes.sharpest
    if cam.follower.end != ROLLER:
        return Roller(0.0, "given")
    hollow = extremes.hollow if cam.closure == GROOVE else None
    bends = sharpest.value if sharpest else None, -hollow.value if hollow else None
    return roller_of(cam.roller, bends[0], extremes.stretches.sizes.base, bends[1])

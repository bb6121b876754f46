"""The study of a scene's cams: laws, sizes, profile of each, made once, on demand (исследование кулачков)."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from decimal import Decimal
from functools import cached_property, partial, reduce
from itertools import repeat
from typing import TypeAlias

import numpy as np

from plans.cam.centre.place import Sizing
from plans.cam.centre.sizes import sizing
from plans.cam.course import FollowerCourse, positions
from plans.cam.diagrams import THREE, LawDiagrams, law_diagrams
from plans.cam.hub import wall
from plans.cam.profile.findings import cam_found
from plans.cam.profile.profile import Profile, profile
from plans.cam.reading.cams import cams_of
from plans.cam.reading.keyways import keyway
from plans.model.cam import MM, Cam, Hub
from plans.model.cam_motion import CamError, CamFound, Contour, large_roller, pivot_passed, thin_wall
from plans.model.cyclogram import Window
from plans.model.motion import Floats
from plans.scene.faults import Path, dotted
from plans.scene.scene import Scene
from plans.words.words import message, placed

LAWS, SIZES, PROFILE = "laws", "sizes", "profile"
CYCLOGRAM = "cyclogram"
Place: TypeAlias = Callable[[Path], str]  # a key of a cam -> where the file has it
CLOSE = 720  # turns of a curve that is drawn: half a degree from one to the next


class CamDrawing:
    """One cam, and what is constructed of it."""

    def __init__(self, cam: Cam, made: dict[str, None] | None = None, place: Place | None = None) -> None:
        self.cam, self.course, self.place = cam, FollowerCourse(cam), place
        self.made: dict[str, None] = {} if made is None else made

    @cached_property
    def turned(self) -> Floats:
        """The turns of the numbered positions, rad, (N,)."""
        return positions(self.cam)

    @cached_property
    def diagrams(self) -> LawDiagrams:
        """S'', S' and S by graphical integration."""
        self.made.setdefault(LAWS)
        return law_diagrams(self.cam, THREE)

    @cached_property
    def sizing(self) -> Sizing:
        """The main sizes."""
        self.made.setdefault(SIZES)
        with self._placing():
            return sizing(self.course)

    @cached_property
    def found(self) -> CamFound:
        """Profile, extremes and flaws at the numbered positions."""
        self.made.setdefault(PROFILE)
        found = cam_found(self.course, self.sizing.sizes, self.turned)
        with self._placing():
            self._refuse(found)
        return found

    def _refuse(self, found: CamFound) -> None:
        """Refuse a roller larger than the cam, a rocker whose pivot the profile passes, a bore without a wall."""
        if not self.cam.translates and found.roller >= found.sizes.base:
            bears = [found.sizes.base, *(extreme.value for extreme in (found.sharpest,) if extreme)]
            raise large_roller(self.cam, found.roller, found.sizes.base, min(bears))
        if self.cam.flat and self.cam.rocks and not found.flaws:
            turned = np.linspace(0.0, self.cam.turn, CLOSE + 1)
            farthest = float(np.abs(profile(self.course, found.sizes, 0.0, turned).contour.profile).max())
            if farthest >= found.sizes.centre:
                raise pivot_passed(self.cam, farthest, found.sizes.centre)
        if (hub := self.cam.hub) is not None and (left := wall(found)) < hub.wall:
            raise thin_wall(found, left, self._larger(hub, found.sizes.base, left), _fitting(found, hub))

    def _larger(self, hub: Hub, base: float, left: float) -> float:
        """Give how much larger a least radius leaves the wall, m: a roller by rule grows with it."""
        more = lacking = hub.wall - left
        for _ in range(3):  # a secant: the wall grows all but in proportion
            larger = replace(
                self.cam, given=self.cam.given._replace(base=base + more), hub=hub._replace(wall=-math.inf)
            )
            try:
                more *= lacking / (wall(CamDrawing(larger).found) - left)
            except CamError:
                return lacking
        return more

    @contextmanager
    def _placing(self) -> Iterator[None]:
        """Say of a cam that cannot be made where the file asks for it."""
        try:
            yield
        except CamError as error:
            if self.place is None:
                raise
            raise CamError(placed(self.place(error.key), error.message), *error.key) from error

    @cached_property
    def curve(self) -> Contour:
        """The profile at many turns, from 0 to a whole one, among them all joints of the law."""
        even = np.linspace(0.0, self.cam.turn, CLOSE + 1)
        return self.profile(self.course.with_joints(even)).contour

    def profile(self, turned: Floats, before: bool = False) -> Profile:
        """Draw the profile at any turns of the cam, rad, (N,)."""
        return profile(self.course, self.sizing.sizes, self.found.roller, turned, before)


class CamStudy:
    """The cams of a scene."""

    def __init__(self, cams: Collection[Cam], places: Iterable[Place | None] = repeat(None)) -> None:
        self.made: dict[str, None] = {}
        drawings = (CamDrawing(cam, self.made, place) for cam, place in zip(cams, places, strict=False))
        self.drawings: Mapping[str, CamDrawing] = {drawing.cam.name: drawing for drawing in drawings}

    def construct(self, plans: Collection[str]) -> None:
        """Make what is asked for, and tell of all cams that cannot be made at once."""
        wrong = list[CamError]()
        made = [name for plan, name in ((LAWS, "diagrams"), (SIZES, "sizing"), (PROFILE, "found")) if plan in plans]
        for drawing in self.drawings.values():
            try:
                [getattr(drawing, name) for name in made]
            except CamError as error:
                wrong.append(error)
        if wrong:
            faults = reduce(lambda first, then: message("lines", first=first, then=then), (e.message for e in wrong))
            raise CamError(faults, *wrong[0].key)

    @property
    def found(self) -> tuple[CamFound, ...]:
        """What was found of each cam."""
        return tuple(drawing.found for drawing in self.drawings.values())


def study_of(scene: Scene, window: Window | None) -> CamStudy:
    """Make the study of a scene's cams; some take their phases from the window of a cyclogram."""
    cams = cams_of(scene, window)
    return CamStudy(cams, [partial(_place, scene, number) for number in range(len(cams))])


def _place(scene: Scene, number: int, key: Path) -> str:
    """Give file, line and column of a key of a cam, and the key; of one that is not there the table's."""
    path = "cam", number, *key
    line, column = scene.place(path)
    return f"{scene.file}:{line}:{column}: {dotted(path)}"


def _fitting(found: CamFound, hub: Hub) -> int:
    """Give the largest bore in whole mm that leaves its wall, with its keyway by the standard or this one; or 0."""
    for bore in range(int(MM * hub.bore), 0, -1):
        own, usual = hub._replace(bore=bore / MM), keyway(Decimal(bore))
        if hub.standard:
            width, depth = float(usual.width) / MM, float(usual.depth) / MM
            own = own._replace(width=width, depth=depth, wall=depth)
        if wall(replace(found, cam=replace(found.cam, hub=own))) >= own.wall:
            return bore
    return 0

"""The study of a scene's cams: laws, sizes, profile of each, made once, when first asked for (исследование кулачков)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from plans.cam.course import Course, positions
from plans.cam.diagrams import Diagrams, diagrams
from plans.cam.profile import Profile, profile
from plans.cam.reading import cams_of
from plans.cam.sizes import Sizing, sizing
from plans.model.cam import Cam
from plans.model.cam_motion import CONSTRUCTION, CamFound
from plans.model.motion import Floats

if TYPE_CHECKING:
    from plans.study import Study

LAWS, SIZES, PROFILE = "laws", "sizes", "profile"


class CamDrawing:
    """One cam and all that is constructed of it."""

    def __init__(self, cam: Cam) -> None:
        self.cam, self.course = cam, Course(cam)

    @cached_property
    def turned(self) -> Floats:
        """The turns of the numbered positions, rad."""
        return positions(self.cam)

    @cached_property
    def diagrams(self) -> Diagrams:
        """S'', S', S by graphical integration."""
        return diagrams(self.course)

    @cached_property
    def sizing(self) -> Sizing:
        """The main sizes by tangents."""
        return sizing(self.course)

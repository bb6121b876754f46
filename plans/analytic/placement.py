"""Placements: where poses of the links put the joints (расположение кинематических пар)."""

from __future__ import annotations

from typing import NamedTuple

from plans.model.motion import Complexes

X, Y, TURN = range(3)  # of a pose


class Placement(NamedTuple):
    """Where N poses put the joints, hinges before slides; arms run from a link's origin to the joint."""

    turns: Complexes  # (N, links): unit directions of the links' own +x axes
    arms: Complexes  # (N, 2, joints): of a slide, to a point of its line
    apart: Complexes  # (N, joints): from the second link's point to the first's
    ways: Complexes  # (N, 2, S): directions of slider's and owner's line

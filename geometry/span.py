"""What is read off a record between two of its marks: a vector, or a rate as one vector over another (отсчёт)."""

from __future__ import annotations

from typing import NamedTuple

from geometry.board import Mark


class Span(NamedTuple):
    """A vector of a plan between two of its marks."""

    start: Mark
    end: Mark


class Reading(NamedTuple):
    """What an angular velocity or acceleration is read from: a vector of the link and its turning part on the plan."""

    arm: Mark
    turning: Mark

"""The vectors of main points by sums over the paths from each mass to the frame (главные точки, M7.4).

Every mass gives each link on its path the vector from where that link begins to where the next one does, times itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Protocol

import numpy as np

from plans.model.machine import Body
from plans.model.mechanism import FRAME


class Begun(Protocol):
    """Where a link begins: its place in the link's own frame, and in that of the link which it follows."""

    @property
    def link(self) -> int: ...  # noqa: D102
    @property
    def parent(self) -> int: ...  # noqa: D102
    @property
    def origin(self) -> complex: ...  # noqa: D102
    @property
    def at(self) -> complex: ...  # noqa: D102


def vectors(solid: Sequence[Body], begun: Iterable[Begun]) -> dict[int, complex]:
    """Give the vector h of each link in its own frame, m."""
    stems = {one.link: one for one in begun}
    terms: dict[int, list[complex]] = {link: [] for link in stems}
    for body in solid:
        for link, arm in _path(stems, body):
            terms[link].append(body.mass * arm)
    whole = sum(body.mass for body in solid)
    return {link: complex(np.sum(told)) / whole for link, told in terms.items()}


def _path(stems: Mapping[int, Begun], body: Body) -> Iterator[tuple[int, complex]]:
    """Give the links from a mass down to the frame, each with the vector through it."""
    link, place = body.link, body.centre
    while link != FRAME:
        yield link, place - stems[link].origin
        link, place = stems[link].parent, stems[link].at

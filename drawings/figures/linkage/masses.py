"""Mass centres of links: named points S_1, S_2 ..., and the centres that a scene's masses give (центры масс)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, cast

from plans.model.mechanism import FRAME, Link
from plans.scene.scene import Scene

if TYPE_CHECKING:
    from plans.forces.reading.form import ForceForm

NEAR = 1e-3  # share of a link's length: a mass centre nearer to a named point than this is that point
_LETTER = re.compile(r"S\d*")


def is_centre(name: str) -> bool:
    """Tell whether a point is a mass centre by its letter.

    >>> is_centre("S2"), is_centre("S"), is_centre("SB")
    (True, True, False)
    """
    return bool(_LETTER.fullmatch(name))


def unnamed(scene: Scene, links: Mapping[int, Link]) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene names, by their letter: link, and place in its own frame."""
    taken = {name for link in links.values() for name in link.points}
    centres = {}
    form = cast("ForceForm | None", scene.part("forces"))
    for number, mass in sorted(form.masses.items()) if form else ():
        places, centre = links[number].points.values(), mass.place(links[number])
        size = max(abs(place - centre) for place in places)
        if number != FRAME and f"S{number}" not in taken and min(abs(p - centre) for p in places) > NEAR * size:
            centres[f"S{number}"] = number, centre
    return centres

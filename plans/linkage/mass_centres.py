"""Mass centres that no point of a scene is or names, S2 of link 2: they are drawn as points of it are (центры масс)."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Protocol, TypeAlias, cast

from plans.model.mechanism import FRAME, Link
from plans.scene.scene import Scene

NEAR = 1e-3  # share of a link's length: a mass centre nearer to a named point than this is that point
Masses: TypeAlias = Mapping[str, tuple[int, complex]]  # by their letters: link, and place in its own frame
NONE: Masses = MappingProxyType({})


class _Mass(Protocol):
    def place(self, link: Link) -> complex: ...


class _Weighed(Protocol):
    """What a scene says of forces: the masses of its links."""

    masses: Mapping[int, _Mass]


def unnamed(scene: Scene, links: Mapping[int, Link]) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene names, by their letters."""
    taken = {name for link in links.values() for name in link.points}
    form, centres = cast("_Weighed | None", scene.part("forces")), {}
    for number, mass in sorted(form.masses.items()) if form else ():
        places, centre = links[number].points.values(), mass.place(links[number])
        size = max(abs(place - centre) for place in places)
        if number != FRAME and f"S{number}" not in taken and min(abs(p - centre) for p in places) > NEAR * size:
            centres[f"S{number}"] = number, centre
    return centres

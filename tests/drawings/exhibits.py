"""Single figures laid out on a sheet of their own, written and read back."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Any

from drawings.layout.contents import Panel
from drawings.lettering.lettering import lettered
from drawings.page.page import drafting_of
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.reading.measure import Measured, check, measure
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, Exhibit
from plans.scene.scene import parse_scene

SHEET = (
    'sheets = ["rotor"]\nrotor.masses = [{{ moment = 1, angle = 0 }}]\n'
    '[sheet]\nformat = "{format}"\nlanguage = "{language}"\n'
)


def exhibited(figures: Iterable[tuple[Any, Any]], size: str = "A3", language: str = "en") -> Leaf:
    """Lay figures out, each given by its module and by what it shows."""
    scene = parse_scene(SHEET.format(format=size, language=language))
    drafting, shows = drafting_of(scene), []
    for module, shown in figures:
        room = module.measure(shown, drafting)
        shows.append(Exhibit(Panel(room), partial(module.draw, shown, room, drafting=drafting)))
    (leaf,) = lay_out(scene, [Draft("rotor", "figures", tuple(shows), (), ("note",), lambda names: {})])
    return leaf


def read_back(leaf: Leaf) -> Measured:
    """Write a sheet and measure it: every mark is what it says."""
    measured = measure(svg(lettered(leaf)))
    assert check(measured) == []
    return measured

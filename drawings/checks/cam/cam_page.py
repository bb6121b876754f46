"""The paper, the title block and the headings of figures on the sheets of cams (формат, заголовки)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.documents_old import title_block
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.formats import SIZES
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Circle, Leaf
from drawings.paper.walk import groups
from plans.scene.scene import Scene
from plans.words.words import message


def paper(leaf: Leaf, scene: Scene, kind: str, subtitle: str, scale: str) -> Iterator[Wrong]:
    """Hold the paper and the title block."""
    yield from title_block.faults(leaf, scene, kind, subtitle, scale)


def smaller(leaf: Leaf, scene: Scene) -> Scene:
    """Give a scene by the format that a sheet has, up to its own: a cam to be made takes the smallest."""
    names = [*SIZES]
    for name in names[names.index(scene.sheet.format) :]:
        if (
            max(abs(one - own) for one, own in zip(sorted(SIZES[name]), sorted((leaf.width, leaf.height)), strict=True))
            <= QUANTUM
        ):
            return scene.changed(sheet=scene.sheet.changed(format=name))
    return scene


def headed(strokes: FigureStrokes, plan: str, title: str, mu: float, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the title of a figure with its scale of lengths in full."""
    if read(title) not in strokes.texts:
        yield on("title", plan, text=title)
    scale = read(scale_line(mu, "l", "m", drafting))
    if scale not in strokes.texts:
        yield message("wrong.scale", text=scale)


def pole_of(strokes: FigureStrokes) -> tuple[complex, float] | None:
    """Give where O is on paper, mm, and the scale, m/mm; None where it has no circle, as on a sheet that was edited."""
    poles = (one for one in groups((strokes.group,)) if one.data.get("kind") == "pole")
    circles = ((own.centre, one) for one in poles for own in one.strokes if isinstance(own, Circle))
    return next(((centre, float(one.data["scale"])) for centre, one in circles), None)

"""The order of an equation of forces in a note, held to the polygon that is drawn of it (порядок слагаемых)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks.forces.cut_equations import CutEquationsCheck
from drawings.checks.forces.polygon_chain import PolygonChain
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.wrong import Wrong
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Group, Leaf, Line
from drawings.paper.walk import groups
from plans.words.words import message


def faults(cut: CutEquationsCheck, leaves: Sequence[Leaf], position: int) -> Iterator[Wrong]:
    """See that the sides of the polygon of a cut follow one another as its equation has them, wherever it is drawn."""
    for figure in (one for leaf in leaves for one in leaf.groups if one.name == f"forces-{cut.label}-{position}"):
        chain = PolygonChain(FigureStrokes(figure), cut.bill, [*_vectors(figure)], cut.order, cut.floor.force)
        yield from (message("wrong.equation", text=name, cut=cut.label) for name in chain.out_of_turn())


def _vectors(figure: Group) -> Iterator[MeasuredVector]:
    """Give the vectors of a figure as they lie on paper."""
    for one in groups((figure,)):
        if one.data.get("kind") == "vector" and isinstance(line := one.strokes[0], Line):
            named = one.data["plan"], "", one.data["name"], None
            yield MeasuredVector(*named, 0j, 0j, "", float(one.data["scale"]), line.start, line.end)

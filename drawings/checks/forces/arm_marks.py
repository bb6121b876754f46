"""The self-check of how arms are drawn: the line of action to the foot, the mark of the right angle, arrows (плечи)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.forces.laid_scheme import FINE
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Fill, Group, Line
from drawings.paper.walk import groups
from drawings.symbols.arms import LEAST, SQUARE
from drawings.symbols.symbols import ARROW_LENGTH

ARM = "h"  # how the names of arms begin
CORNERS = 3  # of the mark of a right angle


def faults(strokes: FigureStrokes, plan: str, symbol: float) -> Iterator[Wrong]:
    """Hold each arm of a scheme or a lever: from its point, or from a line beside it, square to a line of action.

    `symbol` is the factor of the sizes of symbols: a short arm has room for neither arrows nor the mark.
    """
    for group in groups((strokes.group,)):
        name, arm = group.data.get("name", ""), group.strokes[0] if group.strokes else None
        if group.data.get("kind") != "vector" or not name.startswith(ARM) or not isinstance(arm, Line):
            continue
        if not _is_whole(strokes, group, arm, symbol):
            yield on("arm", plan, name=name)


def _is_whole(strokes: FigureStrokes, group: Group, arm: Line, symbol: float) -> bool:
    length = abs(arm.end - arm.start)
    if not length > LEAST + FINE:
        return True
    square = 1j * (arm.end - arm.start)
    marked = any(abs(one.centre - arm.start) <= FINE for one in strokes.circles)
    begun = marked or bool(strokes.through(arm.start, square, FINE))
    headed = sum(isinstance(one, Fill) for one in group.strokes) == 2 * (length > 3 * ARROW_LENGTH * symbol)
    cornered = length <= 2 * SQUARE * symbol + FINE or _cornered(strokes, arm)
    return begun and headed and cornered and bool(strokes.through(arm.end, square, FINE))


def _cornered(strokes: FigureStrokes, arm: Line) -> bool:
    """Tell whether the mark of a right angle stands at the foot of an arm."""
    along = (arm.end - arm.start) / abs(arm.end - arm.start)
    for points in (one.points for one in strokes.chains if len(one.points) == CORNERS and not one.closed):
        first, middle, last = ((point - arm.end) / along for point in points)
        even = abs(first + last - middle) <= FINE
        if even and abs(first.real) <= FINE and abs(last.imag) <= FINE and last.real < -FINE:
            return True
    return False

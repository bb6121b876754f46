"""The self-check of the dimensions of all sliders' strokes on a plan of positions (размеры ходов)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.linkage.laid import LaidMechanism
from drawings.checks.linkage.position_marks import EXACT, named
from drawings.checks.wrong import on
from drawings.lettering.words import fixed
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Leaf, Line, Text
from plans.analytic.kinematics import Analysis
from plans.linkage.strokes import other_sliders
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME, Output, Slide
from plans.model.order import POSITIONS
from plans.words.words import Message

SETS = 4  # strokes of a dimension that are looked at: its text, its line, both extension lines


class DueStroke(NamedTuple):
    """A slider's stroke by the analysis: its text, and its ends on the guide on paper, mm."""

    text: str
    ends: tuple[complex, complex]

    def is_drawn(self, text: Text, line: Line, *extensions: Line) -> bool:
        """Tell whether a dimension is of it: its text, its line along the guide, its extension lines from the ends."""
        along = (self.ends[1] - self.ends[0]) / abs(self.ends[1] - self.ends[0])
        level = abs(((line.end - line.start) * along.conjugate()).imag) <= EXACT
        feet = sorted(((one.start - self.ends[0]) * along.conjugate()).real for one in extensions)
        square = all(abs(((one.end - one.start) * along.conjugate()).real) <= EXACT for one in extensions)
        size = abs(self.ends[1] - self.ends[0])
        return text.plain == self.text and level and square and abs(feet[0]) <= EXACT and abs(feet[1] - size) <= EXACT


def faults(leaf: Leaf, laid: LaidMechanism, road: Analysis) -> Iterator[Message]:
    """See that each slider's stroke has its dimension, and that no other dimension stands there."""
    drawn = [stroke for group in named(leaf, "stroke") for stroke in group.strokes]
    begins = [k for k, stroke in enumerate(drawn) if isinstance(stroke, Text)]
    sets = [drawn[k : k + SETS] for k in begins]
    expected = list(_strokes(laid, road))
    for one in expected:
        if not any(_is(one, dimension) for dimension in sets):
            yield on("stroke", POSITIONS.plan, name=one.text)
    if len(sets) > len(expected):
        yield on("stroke", POSITIONS.plan, name="H")


def _is(one: DueStroke, dimension: Sequence[object]) -> bool:
    match dimension:
        case [Text() as text, Line() as line, Line() as first, Line() as second]:
            return one.is_drawn(text, line, first, second)
    return False


def _strokes(laid: LaidMechanism, road: Analysis) -> Iterator[DueStroke]:
    """Find the stroke of each slider on the frame: of the output, and of the others by their points' letters."""
    mechanism, out = laid.mechanism, laid.study.output
    slide = frame_slide(mechanism, out.link)
    others = [(one, Output(one.slider, one.point)) for one in other_sliders(mechanism, out)]
    own = [(slide, out)] if slide is not None and slide.owner == FRAME else []
    found = [(slide, output, road.extremes(output)) for slide, output in (*own, *others)]
    moving = [(slide, output.point or slide.point, told) for slide, output, told in found if told is not None]
    several = sum(slide != own[0][0] for slide, _, _ in moving) if own else len(moving)
    for slide, point, told in moving:
        ends = _ends(laid, slide, point, told.reach)
        if abs(ends[1] - ends[0]) > SEEN or slide in [one for one, _ in own]:
            letter = f"H{point}" if several else "H"
            size = fixed(1000 * told.stroke, laid.study.language).rstrip("0").rstrip(".,")
            yield DueStroke(f"{letter} = {size}", ends)


def _ends(laid: LaidMechanism, slide: Slide, point: str, reach: tuple[float, float]) -> tuple[complex, complex]:
    """Place both ends of a stroke on the guide's own line, in the order in which their paper has them."""
    way = slide.way(FRAME)
    first, last = (laid.at.on(way.through + one * way.direction) for one in sorted(reach))
    return first, last

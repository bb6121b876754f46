"""The self-check of the dimensions of all sliders' strokes on a plan of positions (размеры ходов)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from drawings.checks.linkage.laid import LaidMechanism
from drawings.checks.linkage.position_marks import EXACT, named
from drawings.checks.wrong import on
from drawings.lettering.extent import bounds
from drawings.lettering.words import fixed
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Fill, Leaf, Line, Stroke, Text
from plans.analytic.kinematics import Analysis
from plans.linkage.strokes import other_sliders
from plans.linkage.travel import frame_slide
from plans.model.mechanism import FRAME, Output, Slide
from plans.model.order import POSITIONS
from plans.words.words import Message

PAST = 2.0  # mm that an extension line goes past the line of its dimension
ABOVE = 2.0  # sizes of its letters that a number stands off its line at the most


class DueStroke(NamedTuple):
    """A slider's stroke by the analysis: its text, and its ends on the guide on paper, mm."""

    text: str
    ends: tuple[complex, complex]

    def is_drawn(self, text: Text, line: Line, heads: Sequence[Fill], *extensions: Line) -> bool:
        """Tell whether a dimension is of it: its text, its line, its heads, its extension lines from the ends."""
        along = (self.ends[1] - self.ends[0]) / abs(self.ends[1] - self.ends[0])
        level = abs(((line.end - line.start) * along.conjugate()).imag) <= EXACT
        feet = sorted(((one.start - self.ends[0]) * along.conjugate()).real for one in extensions)
        square = all(abs(((one.end - one.start) * along.conjugate()).real) <= EXACT for one in extensions)
        size = abs(self.ends[1] - self.ends[0])
        right = text.plain == self.text and abs(feet[0]) <= EXACT and abs(feet[1] - size) <= EXACT
        over = (abs(((one.end - line.start) * along.conjugate()).imag) - PAST for one in extensions)
        past = all(abs(one) <= EXACT for one in over)
        return right and level and square and past and self._lined(text, line, heads, along)

    def _lined(self, text: Text, line: Line, heads: Sequence[Fill], along: complex) -> bool:
        """Tell whether the line goes from foot to foot, its number on it, and both heads point at the feet."""
        own = [((spot - self.ends[0]) / along) for spot in (line.start, line.end, middle(text))]
        size, (low, high) = abs(self.ends[1] - self.ends[0]), sorted(one.real for one in own[:2])
        reaches = low <= EXACT and high >= size - EXACT
        above = 0.0 < abs(own[2].imag - own[0].imag) <= ABOVE * text.size and low <= own[2].real <= high
        tips = sorted((_tip(head, along, self.ends[0]) for head in heads), key=lambda one: one[0].real)
        pointed = len(tips) == 2 and all(
            abs(tip - complex(foot, own[0].imag)) <= EXACT for (tip, _), foot in zip(tips, (0.0, size), strict=True)
        )
        within = pointed and tips[0][1] < 0 and 0.0 <= own[2].real <= size  # arrows and number between the feet
        whole = not within or (low >= -EXACT and high <= size + EXACT)
        return reaches and above and pointed and whole and abs(tips[0][1] + tips[1][1]) <= EXACT


def faults(leaf: Leaf, laid: LaidMechanism, road: Analysis, others: bool = True) -> Iterator[Message]:
    """See that each slider's stroke has its dimension, of `others` than the output too, and that there is no other."""
    own = _strokes(laid, road) if others else _of_output(laid, road)
    return held([stroke for group in named(leaf, "stroke") for stroke in group.strokes], list(own))


def held(drawn: Sequence[Stroke], expected: Sequence[DueStroke]) -> Iterator[Message]:
    """See that strokes are the dimensions that are due, and no other."""
    begins = [k for k, stroke in enumerate(drawn) if isinstance(stroke, Text)]
    sets = [drawn[k:end] for k, end in pairwise([*begins, len(drawn)])]
    for one in expected:
        if not any(_is(one, dimension) for dimension in sets):
            yield on("stroke", POSITIONS.plan, name=one.text)
    if len(sets) > len(expected):
        yield on("stroke", POSITIONS.plan, name="H")


def _is(one: DueStroke, dimension: Sequence[object]) -> bool:
    match dimension:
        case [Text() as text, Line() as line, Line() as first, Line() as second, *heads]:
            return one.is_drawn(text, line, [head for head in heads if isinstance(head, Fill)], first, second)
    return False


def middle(text: Text) -> complex:
    """Give the middle of a lettering."""
    left, bottom, right, top = bounds(text)
    return complex(left + right, bottom + top) / 2


def _tip(head: Fill, along: complex, origin: complex) -> tuple[complex, int]:
    """Give the sharp corner of a head along a line and across it, and which way it points."""
    spots = [(spot - origin) / along for spot in head.points]
    tip = max(spots, key=lambda spot: min(abs(spot - other) for other in spots if other != spot))
    back = sum(spot for spot in spots if spot != tip) / 2
    return tip, 1 if (tip - back).real > 0 else -1


def _of_output(laid: LaidMechanism, road: Analysis) -> Iterator[DueStroke]:
    """Find the stroke of the output alone, if it slides on the frame."""
    out, found = laid.study.output, road.extremes(laid.study.output)
    slide = frame_slide(laid.mechanism, out.link)
    if slide is not None and found is not None:
        ends = on_guide(laid, slide, found.reach)
        yield DueStroke(f"H = {length(found.stroke, laid.study.language)}", ends)


def length(size: float, language: str) -> str:
    """Write a length m in millimetres, of two decimals those that are not zero."""
    return fixed(1000 * size, language).rstrip("0").rstrip(".,")


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
        ends = on_guide(laid, slide, told.reach)
        if abs(ends[1] - ends[0]) > SEEN or slide in [one for one, _ in own]:
            letter = f"H{point}" if several else "H"
            yield DueStroke(f"{letter} = {length(told.stroke, laid.study.language)}", ends)


def on_guide(laid: LaidMechanism, slide: Slide, reach: tuple[float, float]) -> tuple[complex, complex]:
    """Place both ends of a stroke on the guide's own line, in the order in which their paper has them."""
    way = slide.way(FRAME)
    first, last = (laid.at.on(way.through + one * way.direction) for one in sorted(reach))
    return first, last

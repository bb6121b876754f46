"""What a report must say of a linkage first: what the scene gives, and how it is built (исходные данные, строение)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.checks.precise import ALL_DIGITS
from drawings.lettering.words import number
from drawings.lettering.words import word as lettered
from drawings.page.drafting import drafting_of
from drawings.report.formula import Formula
from drawings.report.markdown import header
from plans.checks.compare import MotionComparison
from plans.checks.ram_law import stroke_of
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import pairs
from plans.model.mechanism import FRAME, Ram, Slide
from plans.model.motion import Floats
from plans.model.structure import formula, mechanism_class
from plans.words.words import Message, message, word

MM = 1000.0


class MotionData(NamedTuple):
    """A linkage as the scene gives it, its drive as the analysis has it."""

    study: LinkageStudy
    comparison: MotionComparison

    def data(self) -> Iterator[str]:
        """Give links, lengths, places, slides and the drive, numbers with all digits."""
        mechanism, letters = self.study.mechanism, self._formula
        yield from header([self._word("table.link"), self._word("table.points")])
        for link in mechanism.links.values():
            name = str(link.number) if link.number != FRAME else self._say("frame")
            yield f"| {name} | {', '.join(f'${letters.line(point)}$' for point in link.points)} |"
        yield from self._sizes()
        yield from map(self._slide, mechanism.slides)
        yield self._drive()
        if mechanism.drive.ram is not None:
            yield self._cylinder(mechanism.drive.ram)

    def structure(self) -> Iterator[str]:
        """Give the pairs, the mobility, the groups with their class and side, the formula of structure."""
        mechanism, groups = self.study.mechanism, self.study.groups
        yield from header([self._word(f"table.{head}") for head in ("pair", "pair_kind", "point")])
        for pair in pairs(mechanism, groups):
            kind = self._say("turning_pair" if pair.joint in mechanism.hinges else "sliding_pair")
            yield f"| {pair.key} | {kind} | {pair.point} |"
        n, p = len(mechanism.links) - 1, sum(len(own) - 1 for own in mechanism.hinges.values()) + len(mechanism.slides)
        yield self._say("counted_pairs", n=n, p=p)
        yield rf"$$W = 3n - 2p_{{5}} - p_{{4}} = 3 \cdot {n} - 2 \cdot {p} - 0 = {3 * n - 2 * p}$$"
        for group, side in zip(groups, self.study.sweep.sides, strict=True):
            yield self._say("group", group=group.label, joints=group.kind, order=group.order, side=f"{side:+.0f}")
        told = formula(mechanism, groups).replace("->", "→")
        yield self._say("formula", formula=told, klass=mechanism_class(groups))

    def _word(self, key: str, **parts: object) -> str:
        return word(self.study.language, key, **parts)

    def _say(self, key: str, **parts: object) -> str:
        return self._word(f"report.{key}", **parts)

    def _full(self, value: float) -> str:
        return number(value, self.study.language, ALL_DIGITS)

    @property
    def _formula(self) -> Formula:
        return Formula(drafting_of(self.study.scene))

    def _sizes(self) -> Iterator[str]:
        """Give the lengths, the fixed points, and the points that links have by their places."""
        letters, given = self._formula, self.study.form.mechanism
        sizes = (
            f"${letters.letter(f'l_{{{name}}}')} = {letters.quantity(MM * float(size), 'mm')}$"
            for name, size in given.lengths.items()
        )
        if given.lengths:
            yield self._say("lengths", lengths=", ".join(sizes))
        fixed = (self._place(name, place) for name, place in given.frame.items())
        yield self._say("fixed_points", points=", ".join(fixed))
        for name, point in given.points.items():
            yield self._say("own_point", link=point.on, place=self._place(name, point.at))

    def _place(self, name: str, place: Sequence[object]) -> str:
        return f"${self._formula.line(name)} {self._spot(*(float(str(part)) for part in place))}$"

    def _spot(self, *place: float) -> str:
        x, y = (self._formula.number(MM * part) for part in place)
        return rf"({x}; {y})\text{{ {lettered(self.study.language, 'mm')}}}"

    def _slide(self, slide: Slide) -> str:
        line = self._line(slide) if slide.label else self._at_angle(slide)
        return self._say("slide", link=slide.slider, line=line, point=f"${self._formula.line(slide.point)}$")

    def _line(self, slide: Slide) -> Message:
        return message("report.line_of", owner=slide.owner, line=f"${self._formula.line(slide.label)}$")

    def _at_angle(self, slide: Slide) -> Message:
        """Give a guide by a place and an angle: of the frame in the scene's axes, else by a point of its link."""
        through, mechanism = slide.on_owner.through, self.study.mechanism
        angle = self._full(math.degrees(cmath.phase(slide.on_owner.direction)))
        if slide.owner == FRAME:
            x, y = (
                self._full(MM * (part + float(off)))
                for part, off in zip((through.real, through.imag), mechanism.datum, strict=True)
            )
            return message("report.line_through", x=x, y=y, angle=angle)
        points = mechanism.links[slide.owner].points
        named = [self._formula.line(name) for name, spot in points.items() if spot == through]
        place = named[0] if named else self._spot(through.real, through.imag)
        return message("report.line_of_link", owner=slide.owner, place=f"${place}$", angle=angle)

    def _drive(self) -> str:
        drive, turn = self.study.mechanism.drive, self.study.turn
        rates = (np.ravel(rate) * drive.unit for rate in self.comparison.road.rates(turn.phi))
        told = dict(zip(("omega", "epsilon"), map(self._span, rates), strict=True))
        return self._say("drive_way" if drive.pushed else "drive", link=drive.link, count=len(turn), **told)

    def _cylinder(self, ram: Ram) -> str:
        """Tell the law of the cylinder that drives, by its lengths over the stroke."""
        lengths, *law = stroke_of(self.study.mechanism, len(self.study.turn))
        told = dict(zip("va", map(self._span, law), strict=True))
        stroke = " … ".join(self._full(MM * float(end)) for end in lengths[[0, -1]])
        return self._say("cylinder", line=f"{ram.foot}{ram.point}", stroke=stroke, **told)

    def _span(self, rates: Floats) -> str:
        """Write the least and the greatest rate, once where they are written alike."""
        ends = [float(rates.min()), float(rates.max())]
        alike = number(ends[0], self.study.language) == number(ends[1], self.study.language)
        return " … ".join(self._full(end) for end in (ends[:1] if alike else ends))

"""What a cyclogram's sheet and report say in words: turns, strokes, windows, settings (циклограмма словами)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.kinds.course import decimals, degrees, label
from drawings.page.page import Drafting
from plans.cyclogram.rows import rows_of_cams
from plans.model.cam import Cam
from plans.model.cyclogram import BACK, ENTRY, EXIT, LEAVE, PRESSURE, TURN, Cyclogram, within


class CyclogramNotes(NamedTuple):
    """The notes on a cyclogram by one road, with so many digits."""

    found: Cyclogram
    cams: tuple[Cam, ...]
    drafting: Drafting

    @property
    def all(self) -> tuple[str, ...]:
        """All notes of the sheet in their order; phases and settings stand in its chart."""
        return *self.machine(), *self.window(), *self.reading()

    def machine(self) -> Iterator[str]:
        """Tell the stroke, its angles, and the pressure angle where it is extreme."""
        found = self.found
        begin, end = (found.positions[found.number(role)].turned for role in ("begin", "end"))
        signs = (1, -1) if (end - begin) % TURN >= math.pi else (-1, 1)  # the working stroke may be the slower one
        work, idle = (self._degrees(math.pi + sign * found.overlap) for sign in signs)
        strokes = {"work": work, "idle": idle, "theta": self._degrees(found.overlap)}
        if found.sliding:
            stroke = decimals(1000 * found.stroke, self.drafting)
            yield self.drafting.word("cyclogram stroke", stroke=stroke, **strokes)
        else:
            yield self.drafting.word("cyclogram swing", stroke=self._degrees(found.stroke), **strokes)
        extreme = [(k, position.angle) for k, position in enumerate(found.positions) if position.role == PRESSURE]
        if extreme:
            angles = ",  ".join(f"α_{{{k}}} = {self._degrees(angle or 0.0)}" for k, angle in extreme)
            yield self.drafting.word("cyclogram pressure", angles=angles)

    def window(self) -> Iterator[str]:
        """Tell when the tool is off the work: the phase of rise that it leaves, and what is left of the turn."""
        window = self.found.window
        start, end = (LEAVE, ENTRY) if self.found.of(LEAVE) else (EXIT, BACK)
        numbers = {"start": self.found.number(start), "end": self.found.number(end)}
        leaves, comes = window.start, within(window.end)
        angles = {"leaves": self._degrees(leaves), "comes": self._degrees(comes)}
        angles |= {"rise": self._degrees(window.angle), "rest": self._degrees(window.rest)}
        angles["sum"] = "φ_1 − φ_2" if comes > leaves else "360° − (φ_2 − φ_1)"
        yield self.drafting.letter(self.drafting.word("cyclogram window", **numbers, **angles))

    def settings(self) -> Iterator[str]:
        """Tell the phases and the setting angle of each cam; without cams that of one which rises in the window."""
        if not self.cams:
            yield self.drafting.word("cyclogram set", setting=self._degrees(self.found.window.start))
        for row in rows_of_cams(self.cams):
            phases = ",  ".join(label(span, self.drafting) for span in row.spans)
            setting = self._degrees(within(row.setting or 0.0))
            yield self.drafting.word("cyclogram cam set", phases=phases, name=row.name, setting=setting)

    def reading(self) -> Iterator[str]:
        """Say from where angles are counted, and what was not notched."""
        if self.found.sense < 0:
            yield self.drafting.word("cyclogram clockwise")
        if not all(position.notched for position in self.found.positions):
            yield self.drafting.word("cyclogram by trial")

    def _degrees(self, angle: float) -> str:
        return degrees(angle, self.drafting)

"""The notes that the sheet of a cyclogram must bear, composed of what the analysis found (пояснения циклограммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.cyclogram.due_rows import cam_rows
from drawings.page.drafting import Drafting
from plans.model.cam import Cam
from plans.model.cyclogram import BACK, BEGIN, END, ENTRY, EXIT, LEAVE, PRESSURE, TURN, Cyclogram, within


class DueNotes(NamedTuple):
    """What must be said of the main mechanism, with all digits of the numbers of its drafting.

    Whether all positions were `notched` only the construction knows.
    """

    found: Cyclogram
    notched: bool
    cams: Sequence[Cam]
    drafting: Drafting

    def all(self) -> Iterator[str]:
        """Give them in their order."""
        yield self._stroke()
        yield from self._pressure()
        yield self.window()
        if not self.cams:
            yield self._word("cyclogram set", setting=self._degrees(self._rise[0]))
        yield from settings(self.cams, self.drafting)
        if self.found.sense < 0:
            yield self._word("cyclogram clockwise")
        yield self._word("cyclogram condition")
        if not self.notched:
            yield self._word("cyclogram by trial")

    def _stroke(self) -> str:
        """Write the stroke and how long it lasts there and back."""
        found = self.found
        work = (found.of(END)[0].turned - found.of(BEGIN)[0].turned) % TURN
        angles = {"work": work, "idle": TURN - work, "theta": found.overlap}
        told = {name: self._degrees(angle) for name, angle in angles.items()}
        if found.sliding:
            return self._word("cyclogram stroke", stroke=self.drafting.number(1e3 * found.stroke), **told)
        return self._word("cyclogram swing", stroke=self._degrees(found.stroke), **told)

    def _pressure(self) -> Iterator[str]:
        own = [(k, one.angle) for k, one in enumerate(self.found.positions) if one.role == PRESSURE]
        if own:
            told = (f"α_{{{k}}} = {self._degrees(angle or 0.0)}°" for k, angle in own)
            yield self._word("cyclogram pressure", angles=",  ".join(told))

    @property
    def _rise(self) -> tuple[float, float]:
        """From which turn to which the tool is off the work, rad."""
        first, last = (LEAVE, ENTRY) if self.found.of(LEAVE) else (EXIT, BACK)
        return self.found.of(first)[0].turned, self.found.of(last)[0].turned

    def window(self) -> str:
        """Tell when the tool is off the work."""
        start, end = self._rise
        turns = [one.turned for one in self.found.positions]
        parts = {"leaves": start, "comes": end, "rise": (end - start) % TURN, "rest": (start - end) % TURN}
        told = {name: self._degrees(angle) for name, angle in parts.items()}
        said = self._word("cyclogram window", start=turns.index(start), end=turns.index(end), **told)
        return self.drafting.letter(said)

    def _word(self, key: str, **parts: object) -> str:
        return self.drafting.word(key, **parts)

    def _degrees(self, angle: float) -> str:
        return self.drafting.number(math.degrees(angle))


def settings(cams: Sequence[Cam], drafting: Drafting) -> Iterator[str]:
    """Give what must be said of each cam that turns: its setting angle, and its phases by their letters."""
    for row in cam_rows(cams):
        sizes = (drafting.number(math.degrees(one.end - one.start)) for one in row.spans)
        told = (f"φ_{{{one.label}}} = {size}°" for one, size in zip(row.spans, sizes, strict=True))
        angle = drafting.number(math.degrees(within(row.setting or 0.0)))
        yield drafting.letter(drafting.word("cyclogram cam set", name=row.name, setting=angle, phases=",  ".join(told)))

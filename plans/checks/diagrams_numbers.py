"""The numbers of the kinematic diagrams as plain data, by either road (числа диаграмм); null at gaps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plans.analytic.diagrams import alone
from plans.checks.diagrams_comparison import LETTERS
from plans.checks.motion_numbers import solved
from plans.checks.plain_numbers import plain
from plans.diagrams.study import DiagramsStudy
from plans.linkage.travel import frame_slide
from plans.model.diagrams import FEWEST, Diagrams
from plans.model.order import ACCELERATIONS
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True)
class DiagramsNumbers:
    """The diagrams by one road with the output's letters; None and why where there are none."""

    diagrams: Diagrams | None
    left_out: Message | None
    link: int
    letters: tuple[str, str, str]

    @property
    def flawed(self) -> bool:
        """Nothing is missing that is not missing in the motion."""
        return False

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data; nothing where the diagrams are not wanted."""
        if self.diagrams is None:
            return {} if self.left_out is None else {"diagrams": {"left_out": str(self.left_out)}}
        found, axis = self.diagrams, self.diagrams.axis
        at = dict(zip(self.letters, map(plain, found.at), strict=True))
        chords = {
            f"{self.letters[1]}_chords": {"turned": plain(axis.middles), "values": plain(found.speeds)},
            f"{self.letters[2]}_chords": {"turned": plain(axis.places), "values": plain(found.growths)},
        }
        positions = {"positions": list(axis.numbers), "turned": plain(axis.turned)}
        return {"diagrams": {"output": self.link, **positions, **at, **chords}}


def numbers(study: Study, by: str) -> DiagramsNumbers:
    """Find the diagrams of a scene by a road (row of the table of techniques)."""
    own: DiagramsStudy = study["diagrams"]
    link = own.linkage.output.link
    if not own.wanted or own.unfit:
        return DiagramsNumbers(None, own.unfit if own.wanted else None, link, LETTERS[True])
    letters = LETTERS[frame_slide(own.linkage.mechanism, link) is not None]
    if by == "construction":
        return DiagramsNumbers(own.diagrams, own.left_out, link, letters)
    found = analysed(own)
    left_out = None if found is not None else message("diagrams.few", least=FEWEST)
    return DiagramsNumbers(found, left_out, link, letters)


def analysed(own: DiagramsStudy) -> Diagrams | None:
    """Find the diagrams by analysis alone."""
    motion, extremes, road = solved(own.linkage, ACCELERATIONS.number, True)
    return alone(road, own.linkage.output, extremes, motion, own.whole)

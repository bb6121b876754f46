"""The diagrams of a law with the pressure angle under them, over one axis of the turn (диаграммы столбцом)."""

from __future__ import annotations

from drawings.cam import law_diagrams, pressure_graph
from drawings.cam.law_frame import LawPlate
from drawings.cam.pressure_graph import PressureView
from drawings.kinds.axes import Parts
from drawings.layout.picture import Picture, Spot
from drawings.page.page import Field
from drawings.page.scale import Drafting
from plans.cam.diagrams import LawDiagrams


def measure(shown: tuple[LawDiagrams, PressureView], drafting: Drafting) -> Picture:
    """Measure the room of both: as wide as the diagrams, as high as both; it is known by the name of the diagrams."""
    law, low = _rooms(shown, drafting)
    around = law.margins._replace(
        above=law.margins.above + law.margins.below + low.margins.above, below=low.margins.below
    )
    high = law.high + low.high
    least = law.least * max(law.wide, high) / law.wide  # the axis stays as long
    return law._replace(high=high, middle=complex(law.wide, high) / 2, margins=around, least=least)


def draw(shown: tuple[LawDiagrams, PressureView], room: Picture, spot: Spot, drafting: Drafting) -> Parts:
    """Draw the diagrams above, the graph under them: its axis begins where theirs do."""
    (law, low), (box, scale) = _rooms(shown, drafting), spot
    level = box.top - law.size(scale)[1]
    middle = box.left + LawPlate.proportions.left * drafting.hand.letter + law.wide / scale.mu / 2
    half = low.size(scale)[0] / 2
    under = Spot(Field(middle - half, box.bottom, middle + half, level), scale)
    over = Spot(box._replace(bottom=level), scale)
    return Parts(
        (), (law_diagrams.draw(shown[0], law, over, drafting), pressure_graph.draw(shown[1], low, under, drafting))
    )


def _rooms(shown: tuple[LawDiagrams, PressureView], drafting: Drafting) -> tuple[Picture, Picture]:
    law, angle = shown
    return law_diagrams.measure(law, drafting), pressure_graph.measure(angle, drafting)

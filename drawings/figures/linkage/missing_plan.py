"""A sentence that stands where a plan cannot be drawn, and says why (план не строится)."""

from __future__ import annotations

from drawings.layout.figure import StillFigure
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Text


def measure(why: str, name: str, drafting: Drafting) -> Picture:
    """Measure the room of the sentence."""
    size = drafting.hand.text
    return picture(name, [0j], ("v", "m/s"), Margins(size, size, size), text_width(Text(0j, why, size)))


def draw(why: str, name: str, spot: Spot, drafting: Drafting) -> StillFigure:
    """Write the sentence in the middle of its spot, under the name of the plan."""
    return StillFigure((Group((Text(spot.box.centre, why, drafting.hand.text, "middle", True),), name),))

"""The page: a format with its frame, margins and title block, by GOST or by ISO (лист)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType

from drawings.page import frame
from drawings.page.blocks import form1, iso7200
from drawings.page.frame import FRAME, borders
from drawings.page.title_cell import NUMBERS
from drawings.paper.formats import BLOCKS, BORDERS, PORTRAIT, Field, lies, size_of
from drawings.paper.hand import Hand, hand_of
from drawings.paper.strokes import INK, Circle, Group, LineStyle, SheetError, Stroke, stated
from plans.scene.scene import Scene
from plans.words.words import placed

BLOCK, EXTRA = "title-block", "extra-graphs"  # the names of their groups

__all__ = ["Field", "Page", "page_of"]  # figures take their fields from the page


@dataclass(frozen=True)
class Page:
    """A format laid by a standard; an orientation that the standard does not have is refused."""

    name: str
    orientation: str | None = None  # the standard's customary one
    standard: str = "GOST"
    language: str = "en"
    designation: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "orientation", lies(self.name, self.standard, self.orientation))

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        return size_of(self.name, str(self.orientation))

    @property
    def hand(self) -> Hand:
        """Line widths and letter sizes."""
        return hand_of(self.name, self.standard)

    @property
    def field(self) -> Field:
        """The field inside the frame."""
        width, height = self.size
        left, other = BORDERS[self.standard]
        return Field(left, other, width - other, height - other)

    @property
    def block(self) -> Field:
        """The place of the title block."""
        field, (width, height) = self.field, BLOCKS[self.standard]
        return Field(field.right - width, field.bottom, field.right, field.bottom + height)

    @property
    def taken(self) -> tuple[Field, ...]:
        """The places inside the frame where no figure may stand: the title block, and by GOST graph 26."""
        return (self.block, self._repeated) if self.standard == "GOST" else (self.block,)

    @property
    def _repeated(self) -> Field:
        return form1.repeated(self.field, self.orientation == PORTRAIT and self.name != "A4")

    def frame(self) -> Group:
        """Draw the paper, its edge, the frame, and what stands in the margins."""
        edge, bar = frame.paper(self.size, self.hand), frame.control_bar(self.hand, self.language)
        folds = tuple(frame.folds(self.size, self.hand))
        marks = (Group(folds, "folding-marks"),) if folds else ()
        return Group((edge, *self._margins(), *marks, bar), "frame")

    def _margins(self) -> tuple[Stroke, ...]:
        """Draw the frame, and what the standard has around it; GOST asks for no centring marks."""
        if self.standard == "ISO":
            line = frame.rectangle(self.field, LineStyle(FRAME))
            return line, Group(tuple(borders(self.name, self.size, self.field, self.block)), "borders")
        extra = form1.extra(self.field, self._repeated, self.designation, self.name, self.hand, self.language)
        return frame.rectangle(self.field, LineStyle(self.hand.main)), Group(tuple(extra), EXTRA)

    def corners(self) -> Group:
        """Mark three corners of the frame, by which a reader finds the sheet's own millimetres again."""
        field = self.field
        places = (
            complex(field.left, field.bottom), complex(field.right, field.bottom), complex(field.left, field.top),
        )  # fmt: skip
        marks = tuple(
            Group((Circle(at, 0.35, INK),), f"corner-{k + 1}", {"kind": "corner", "value": stated(at)})
            for k, at in enumerate(places)
        )
        return Group(marks, "corners")

    def title_block(self, entries: Mapping[str, str], language: str) -> Group:
        """Draw the title block, filled: title, designation, names, date, organisation, scale, sheet numbers."""
        return Group(tuple(self._form.block(self._corner, entries, self.hand, language)), BLOCK)

    def numbers(self, sheet: int, sheets: int) -> Group:
        """Write what the title block says of the sheet among those of its document."""
        return Group(tuple(self._form.numbers(self._corner, str(sheet), str(sheets))), NUMBERS)

    @property
    def _form(self) -> ModuleType:
        return iso7200 if self.standard == "ISO" else form1

    @property
    def _corner(self) -> complex:
        return complex(self.block.left, self.block.bottom)


def page_of(scene: Scene, kind: str = "") -> Page:
    """Give the page that a scene asks for, of a kind of sheet; one that its standard does not have is refused."""
    sheet = scene.sheet
    try:
        return Page(sheet.format, sheet.orientation, sheet.standard, sheet.language, sheet.designated(kind))
    except SheetError as error:
        line, column = scene.place(("sheet", "orientation"))
        raise SheetError(placed(f"{scene.file}:{line}:{column}", error.args[0])) from None

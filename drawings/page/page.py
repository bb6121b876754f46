"""The page and how it is drawn: format, frame, title block; hand, language, standard; scales (лист, масштабы)."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Final, NamedTuple

from drawings.lettering.words import Phrase, Slot, letter, number, numbered, phrase, word
from drawings.page import frame
from drawings.page.blocks import form1
from drawings.page.frame import FRAME, NUMBERS, borders
from drawings.paper.hand import BLOCKS, BORDERS, PORTRAIT, Field, Hand, hand_of, lies, size_of
from drawings.paper.strokes import INK, Circle, Group, LineStyle, SheetError, Stroke, stated
from plans.scene.scene import Scene
from plans.words.words import message, placed

BLOCK, EXTRA = "title-block", "extra-graphs"  # the names of their groups

__all__ = ["Field", "Page", "page_of"]  # figures take their fields from the page


@dataclass(frozen=True, repr=False)
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
        left, bottom, right, top = self.field
        places = complex(left, bottom), complex(right, bottom), complex(left, top)
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
        if self.standard != "ISO":
            return form1
        from drawings.page.blocks import iso7200  # noqa: PLC0415  (a page by GOST has none of it)

        return iso7200

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


# Of scale factors as courses take them; and of lengths the series of ISO 5455, which speaks of nothing else.
MANTISSAS, LENGTHS = (1.0, 2.0, 2.5, 4.0, 5.0), (1.0, 2.0, 5.0)
# GOST 2.302-68: reductions 1:b, those from 2000 for master plans, and enlargements a:1.
REDUCTIONS: Final = (
    1, 2, 2.5, 4, 5, 10, 15, 20, 25, 40, 50, 75, 100, 200, 400, 500, 800, 1000,
    2000, 5000, 10000, 20000, 25000, 50000,
)  # fmt: skip
ENLARGEMENTS: Final = (2, 2.5, 4, 5, 10, 20, 40, 50, 100)
# Beyond the tables, as mu. By GOST a picture is enlarged (100 n):1, n whole: 400:1, but no 250:1, so that mu has no 4.
# It says nothing of reductions beyond 1:50 000; these go on as the last ones do.
BEYOND: Final = (1.0, 2.0, 2.5, 5.0)


class Scale(NamedTuple):
    """A scale factor: `mu` true units per millimetre, of a letter such as l, v or a, in a unit such as m/s."""

    mu: float
    letter: str
    unit: str

    def written(self, language: str, notation: str = "mu") -> str:
        """Write the scale as the textbook does, mu in units a millimetre, or K = 1/mu in millimetres a unit.

        >>> Scale(0.02, "v", "m/s").written("en"), Scale(0.0025, "l", "m").written("ru", "K")
        ('μ_v = 0.02 (m/s)/mm', 'K_l = 400 мм/м')
        """
        unit, mm = word(language, self.unit), word(language, "mm")
        true = f"({unit})" if "/" in unit else unit
        if notation == "K":
            return f"K_{self.letter} = {number(1 / self.mu, language)} {mm}/{true}"
        ratio = f" ({self.ratio(language)})" if self.letter == "l" else ""
        return f"μ_{self.letter} = {number(self.mu, language)} {true}/{mm}{ratio}"

    def ratio(self, language: str) -> str:
        """Write a scale of lengths as a ratio such as 1:2.5."""
        reduction = self.mu * 1000
        if reduction >= 1:
            return f"1:{number(reduction, language)}"
        return f"{number(1 / reduction, language)}:1"


def fitting(extent: float, room: float, letter: str, unit: str, standard: str = "GOST") -> Scale:
    """Choose the largest standard picture of an extent (true units) that fits into some room (mm).

    >>> fitting(0.7, 380.0, "l", "m").mu, fitting(12.0, 150.0, "a", "m/s2").mu, fitting(0.7, 380.0, "l", "m", "ISO").mu
    (0.002, 0.1, 0.002)
    """
    if room <= 0:
        raise SheetError(message("refused.scale", letter=letter))
    if extent <= 0 or not math.isfinite(extent):
        return Scale(1.0 if letter != "l" else 0.001, letter, unit)
    least = extent / room * (1 - 1e-12)  # a picture that fits exactly is not lost to a rounding
    if letter == "l":
        return Scale(_of_lengths(least) if standard == "GOST" else _next(least, LENGTHS), letter, unit)
    return Scale(_next(least, MANTISSAS), letter, unit)


def _of_lengths(least: float) -> float:
    """Give the scale of lengths by GOST that is not less than some mu."""
    table = [0.001 / a for a in reversed(ENLARGEMENTS)] + [b / 1000 for b in REDUCTIONS]
    if table[0] / 2 < least <= table[-1]:  # 200:1 is the first beyond the table
        return next(mu for mu in table if mu >= least)
    return _next(least, BEYOND)


def _next(least: float, mantissas: tuple[float, ...]) -> float:
    power = math.floor(math.log10(least))
    mu = next(m * 10.0**p for p in (power, power + 1) for m in mantissas if m * 10.0**p >= least)
    return float(f"{mu:.12g}")


class Drafting(NamedTuple):
    """The hand that draws, and how it letters: language, standard, notation of scales, letter of reactions."""

    hand: Hand
    language: str = "en"
    standard: str = "GOST"
    notation: str = "mu"
    reactions: str = "R"

    def word(self, key: str, **values: object) -> str:
        """Give a phrase in the sheet's language."""
        return word(self.language, key, **values)

    def phrase(self, key: str, **parts: object) -> Phrase:
        """Say a sentence in the sheet's language whose numbers are slots of quantities."""
        return phrase(self.language, key, **parts)

    def slot(self, slot: Slot) -> Phrase:
        """Write the number of a quantity."""
        return numbered(self.language, slot)

    def number(self, value: float, digits: int = 4) -> str:
        """Write a number with some significant digits."""
        return number(value, self.language, digits)

    def letter(self, markup: str) -> str:
        """Write a letter as courses of the sheet's language do; a phrase stays one."""
        text = letter(self.language, markup)
        return Phrase(text, letter(self.language, markup.template)) if isinstance(markup, Phrase) else text

    def scale(self, *scales: Scale) -> str:
        """Write scales as the sheet does."""
        return ";  ".join(scale.written(self.language, self.notation) for scale in scales)

    def true(self, segment: str, letter: str) -> str:
        """Write in letters how a true size is read off a segment at the scale of a letter."""
        return f"{segment}/K_{letter}" if self.notation == "K" else f"{segment}·μ_{letter}"


def drafting_of(scene: Scene) -> Drafting:
    """Give what a scene asks for."""
    sheet = scene.sheet
    return Drafting(page_of(scene).hand, sheet.language, sheet.standard, sheet.notation)

"""The leaves of a sheet (листы): what every sheet does alike, from its contents to lines, letters and title block."""

import math
import re
from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from typing import Any, NamedTuple

from drawings.layout.composer import compose, fits
from drawings.layout.contents import Composition, Contents
from drawings.layout.filling import Loose, fill
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import NARROW, SMALLER, Figure, Notes, Picture, Spot, TextBlock
from drawings.layout.room import size_of_room
from drawings.layout.slicing import Cuts
from drawings.layout.table import Later, RuledTable
from drawings.layout.value_table import by_hand
from drawings.lettering.lettering import text_width
from drawings.lettering.words import SLOT, template_of
from drawings.page.page import Drafting, Field, Page, drafting_of, page_of
from drawings.paper.strokes import LEAN, Group, Kind, Leaf, SheetError, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, StatedScales
from plans.scene.scene import Scene
from plans.words.words import words as phrases

KEEP = "\N{NO-BREAK SPACE}"
TOGETHER = re.compile(r" (=|…|−|[+]) ")
ALONE = re.compile(r" (\S{1,2})$")  # a letter or a number does not end a note on a line of its own
NOTES = "notes"  # the name of their group
CLEAR = 0.5  # mm from a line of notes to the frame
STEP = 1.8  # sizes of the letters from line to line: GOST 2.304-81 asks for 1.7 at least


def measure(paragraphs: Sequence[str], size: float, language: str, least: float = 0.0) -> Notes:
    """Measure what notes need on paper, in columns of no less than `least` mm and none too narrow for their letters."""
    lengths = tuple(text_width(Text(0j, _marked(note, language), size)) for note in paragraphs)
    return Notes(lengths, STEP * size, max(least, NARROW * size))


def write(paragraphs: Sequence[str], field: Field, size: float, edge: float, language: str) -> Group:
    """Write notes from the top of their field downwards, a long one broken between its parts, clear of an edge, mm."""
    width = min(field.width, edge - CLEAR - LEAN * size - field.left)  # the last letter leans beyond its width
    broken = [_broken(_marked(note, language), width, size) for note in paragraphs]
    step = min(STEP * size, field.height / max(sum(map(len, broken)), 1))
    strokes, count = list[Stroke](), 0
    for note, lines in zip(paragraphs, broken, strict=True):
        feet = [complex(field.left, field.top - size - (count + k) * step) for k in range(len(lines))]
        plain = (_before_units(language).sub(" ", line) for line in lines)
        rows = [Text(foot, line, size, "start", True) for foot, line in zip(feet, plain, strict=True)]
        strokes += (
            [stating(Statement(Kind.PHRASE, NOTES, shape), *rows)] if SLOT.search(shape := template_of(note)) else rows
        )
        count += len(lines)
    return Group(tuple(strokes), NOTES)


def _broken(note: str, width: float, size: float) -> list[str]:
    """Break a note at its spaces where it is wider than its field, but no equation and no range."""
    kept = TOGETHER.sub(lambda sign: f"\N{NO-BREAK SPACE}{sign[1]}\N{NO-BREAK SPACE}", note)
    words, lines = [word for word in ALONE.sub("\N{NO-BREAK SPACE}\\1", kept).split(" ") if word], list[str]()
    while words:
        count = 1 + bisect_right(range(2, len(words) + 1), width, key=partial(_reach, words, size))
        lines.append(" ".join(words[:count]))
        words = words[count:]
    return lines


def _reach(words: Sequence[str], size: float, count: int) -> float:
    return text_width(Text(0j, " ".join(words[:count]), size))


@cache
def _before_units(language: str) -> re.Pattern[str]:
    """Find a space between a number and its unit, kept or not: no line ends there."""
    units = {str(text) for key, text in phrases(language).items() if key.startswith("unit.")}
    return re.compile(rf"(?<=\d)[ {KEEP}](?=(?:{'|'.join(map(re.escape, units - {''}))}|%)(?![^\W_]))")


def _marked(note: str, language: str) -> str:
    """Lower the kind's number in II2(4,5), and keep numbers with their units; the rest of a note stays as it is."""
    note, out, k = _before_units(language).sub(KEEP, note), [], 0
    while k < len(note):
        if note.startswith("II", k) and k + 2 < len(note) and note[k + 2].isdigit():
            out.append(f"II_{{{note[k + 2]}}}")
            k += 3
        else:
            out.append(note[k])
            k += 1
    return "".join(out)


EQUATION = 120.0  # mm: in a narrower column of notes the equations with numbers are broken at every sign
KEPT = 1.0  # mm inside the frame that letters keep clear of
ROUNDS = 4  # of composing: the remarks that follow from one composition are mostly those of the next
WELL = 1.25  # sizes that its letters need: a figure is read well a standard step above them
TIGHT = 0.75  # of the step of lines: where they stand nearer, an index comes near the letters below it
ENTRIES = ("drawn", "checked", "approved", "date", "group", "organisation")  # kept from [sheet]


def lay_out(scene: Scene, drafts: Sequence[Draft]) -> tuple[Leaf, ...]:
    """Lay out the sheets of drafts, and as many following ones as their figures need to stay readable."""
    return lay_out_each([(scene, draft) for draft in drafts])


def lay_out_each(drafts: Sequence[tuple[Scene, Draft]]) -> tuple[Leaf, ...]:
    """Lay out drafts whose sheets differ in what their scene says of them, such as the format."""
    chosen = [_chosen(scene, draft, k + 1 < len(drafts)) for k, (scene, draft) in enumerate(drafts)]
    composed = [(leaves, sheet) for leaves in chosen for sheet in leaves.sheets]
    return tuple(leaves.leaf(sheet, k + 1, len(composed)) for k, (leaves, sheet) in enumerate(composed))


def compositions(scene: Scene, draft: Draft) -> Sequence[Composition]:
    """Give where all that a draft shows would stand, sheet by sheet, before anything is drawn."""
    return _Leaves(scene, draft).settled.composed


def fits_on(scene: Scene, draft: Draft, count: int) -> bool:
    """Tell whether so many sheets keep every figure of a draft readable."""
    return _Leaves(scene, draft).fits(count)


def _chosen(scene: Scene, draft: Draft, followed: bool) -> "_Leaves":
    """Choose among a draft and those instead of it: the first whose figures are read best, on the fewest sheets.

    One of whose figures hardly any is larger than its letters need gives way to one that draws all of them well.
    """
    if not draft.instead:
        return _Leaves(scene, draft, followed).settled
    best, *others = (_Leaves(scene, way, followed) for way in (draft, *draft.instead))
    for way in others:
        lack, sheets = best.cost
        if lack or (sheets > 1 and way.fits(sheets - 1)):
            best = min(best, way, key=lambda leaves: leaves.cost)
        elif best.least(best) < WELL <= way.least(best) and way.cost <= best.cost:
            best = way
    return best


class _Inked(NamedTuple):
    """A sheet before its letters are placed: what stands still, its figures, their ink."""

    still: list[Group]
    figures: list[Figure]
    ink: Ink


@dataclass(frozen=True, eq=False, repr=False)
class _Leaves:
    """A draft on the pages of its scene."""

    scene: Scene
    draft: Draft
    followed: bool = False  # by the sheets of another draft
    reserved: tuple[str, ...] = ()  # remarks for which the notes have room
    known: Cuts | None = None  # from composing it with other remarks

    @cached_property
    def page(self) -> Page:
        return page_of(self.scene, self.draft.kind)

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.scene)

    @property
    def scales(self) -> StatedScales:
        return StatedScales(self.scene, self.draft.kind, self.page)

    @property
    def title(self) -> str:
        return self.scene.heading(self.drafting.language)

    @cached_property
    def contents(self) -> Contents:
        """All that the sheets must show, measured."""
        shown = [part.panel for part in self.draft.shows if isinstance(part, Exhibit) or not part.working]
        panels = self.scales.panels(shown)
        texts = *self.draft.notes, *self.reserved
        notes = measure(texts, self.page.hand.text, self.drafting.language, self.draft.narrow)
        return Contents(panels, self.draft.tables, notes, self.followed)

    @cached_property
    def composed(self) -> Sequence[Composition]:
        """Where all stands, sheet by sheet."""
        return compose(self.contents, self.page, self.cuts)

    @cached_property
    def cuts(self) -> Cuts:
        """The sizes of all runs of units in the room of the page."""
        return self.known or Cuts(size_of_room(self.page))

    @property
    def cost(self) -> tuple[float, int]:
        """Count the figures too small for their letters, by how much, and the sheets; infinite, if it has no room."""
        try:
            sizes = self.sizes.values()
        except SheetError:
            return math.inf, 0
        return sum(1 - size for size in sizes if size < SMALLER), len(self.composed)

    @cached_property
    def sizes(self) -> Mapping[str, float]:
        """How large the figures are, in the sizes that their letters need; a point has none."""
        pictures = [part.panel.item for part in self.draft.shows if isinstance(part.panel.item, Picture)]
        extents = [(picture, picture.extent(self.spots[picture.name].scale)) for picture in pictures]
        return {picture.name: size / picture.least for picture, size in extents if size and picture.least}

    def least(self, other: "_Leaves") -> float:
        """Give the size of the smallest figure that another draft shows too; none where this one has no room."""
        return min((self.sizes[name] for name in other.sizes), default=math.inf) if self.cost[1] else 0.0

    def fits(self, count: int) -> bool:
        """Tell whether so many sheets keep every figure readable; none do where one has no room."""
        try:
            return fits(self.contents, self.page, self.cuts, count)
        except SheetError:
            return False

    @cached_property
    def spots(self) -> Mapping[str, Spot]:
        """Where the figures of all sheets stand."""
        return {name: spot for composition in self.composed for name, spot in composition.spots.items()}

    @property
    def notes(self) -> tuple[str, ...]:
        """What is said in words, with the remarks on the figures as they stand."""
        said = self.draft.remarks(self.spots) if self.draft.remarks is not None else ()
        return (*self.draft.notes, *said)

    @property
    def settled(self) -> "_Leaves":
        """Compose anew until there is room for the remarks: with them the figures may stand otherwise."""
        current, known = self, {self.reserved: self}  # two compositions may each bring about the remarks of the other
        for _ in range(ROUNDS if self.draft.remarks is not None else 0):
            said = current.notes[len(current.draft.notes) :]
            other = known.setdefault(said, replace(current, reserved=said, known=current.cuts))
            if said == current.reserved or not other.better(current):
                break
            current = other
        return current

    def better(self, other: "_Leaves") -> bool:
        """Tell whether room for remarks is worth it: no further sheet, where they can be read without that room."""
        notes, boxes = self.contents.notes, (composition.notes for composition in other.composed)
        tight = any(notes and box and box.height < TIGHT * notes.height(box.width) for box in boxes)
        return tight or self.fits(len(other.composed))

    @property
    def sheets(self) -> Sequence[Composition]:
        """The composed sheets, the cells of their tables written that waited for the scales of the figures."""
        return [self._counted(composition) for composition in self.composed]

    def _counted(self, composed: Composition) -> Composition:
        """Write the cells of the tables of a sheet."""
        if self._later is None:
            return composed
        filled = (spot._replace(table=spot.table.filled(self._later)) for spot in composed.tables)
        return composed._replace(tables=tuple(filled))

    @cached_property
    def _later(self) -> Callable[[Later], str] | None:
        """What writes the cells that wait for the scales of the figures, if any do."""
        if self.draft.later is None:
            return None
        errors = self.draft.later({name: spot.scale.mu for name, spot in self.spots.items()})
        return by_hand(errors, self.drafting.language)

    def leaf(self, composed: Composition, number: int, count: int) -> Leaf:
        """Draw one sheet: the lines of all its figures first, then the letters among them."""
        page, draft = self.page, self.draft
        stood = self._inked(composed, number, count)
        labels = Labels(stood.ink, page.hand.drafted)
        letters = (group for figure in stood.figures for group in figure.letter(labels))
        facts = draft.facts(composed.spots.keys())
        graded = draft.later is not None or "vectors" in facts  # what a hand may be out is told or graded by the scales
        return Leaf(
            *page.size,
            (page.frame(), page.corners(), *stood.still, *letters),
            title=f"{self.title}: {draft.title}",
            description=" ".join(self.notes),
            metadata={
                "sheet": draft.kind,
                "title": self.title,
                **facts,
                **({"scales": {k: spot.scale.mu for k, spot in self.spots.items()}} if graded else {}),
                "notes": composed.notes is not None,
                "rows": _rows([spot.table for spot in composed.tables]),
                "number": number,
                "of": count,
            },
            cramped=tuple(self._cramped(composed)),
        )

    def _cramped(self, composed: Composition) -> Iterator[str]:
        """Name the figures that are drawn at less than half the size that their letters need."""
        pictures = (part.panel.item for part in self.draft.shows if isinstance(part.panel.item, Picture))
        for picture in (picture for picture in pictures if picture.name in composed.spots):
            if 0 < 2 * picture.extent(composed.spots[picture.name].scale) < picture.least:
                yield picture.name

    def _inked(self, composed: Composition, number: int, count: int) -> _Inked:
        """Draw the lines of a sheet, and workings where it would stay bare."""
        still, figures = list(self._still(composed, number, count)), list(self._figures(composed))
        ink = Ink(*self.page.size)
        ink.bar(self.page.field.inset(KEPT), self.page.taken)
        ink.draw([*still, *(stroke for figure in figures for stroke in figure.lines)])
        still += fill(ink, self.page, 1 < number == count, list(self._loose(composed)))
        return _Inked(still, figures, ink)

    def _still(self, composed: Composition, number: int, count: int) -> Iterator[Group]:
        """Draw what no letter is added to: the title block, tables, notes, lettering among the figures."""
        page = self.page
        yield page.title_block(self._entries(composed, number, count), self.drafting.language)
        counts = Counter[str]()
        for table, corner, setting in composed.tables:
            pieces = table.draw(corner, setting, self.drafting, counts[table.name])
            counts[table.name] += len(pieces)
            yield from pieces
        if composed.notes is not None:
            yield write(self.notes, composed.notes, page.hand.text, page.field.right, self.drafting.language)
        for part in self.draft.shows:
            if isinstance(part, Caption) and part.panel.item.name in composed.blocks:
                yield part.write(composed.blocks[part.panel.item.name], *self._awaited(part, composed))

    def _loose(self, composed: Composition) -> Iterator[Loose]:
        """Give the workings of the figures of a sheet that have no place on it yet."""
        for part in self.draft.shows:
            if isinstance(part, Caption) and part.working and part.of in composed.spots:
                assert isinstance(part.panel.item, TextBlock)
                yield Loose(part.panel.item, partial(part.write, spot=composed.spots[part.of]))

    def _awaited(self, caption: Caption, composed: Composition) -> Iterator[Any]:
        """Give what lettering is written by beside its box."""
        if caption.of in composed.spots:
            yield composed.spots[caption.of]
        if caption.waits and self._later is not None:
            yield self._later

    def _figures(self, composed: Composition) -> Iterator[Figure]:
        for part in self.draft.shows:
            if isinstance(part, Exhibit) and part.panel.item.name in composed.spots:
                yield part.draw(composed.spots[part.panel.item.name])

    def _entries(self, composed: Composition, number: int, count: int) -> dict[str, str]:
        """Fill the title block."""
        foremost = self.contents.foremost
        spot = composed.spots.get(self.draft.scaled or (foremost.item.name if foremost is not None else ""))
        return {
            "title": self.title,
            "subtitle": self.draft.title,
            "designation": self.page.designation,
            **{key: getattr(self.scene.sheet, key) for key in ENTRIES},
            "scale": spot.scale.ratio(self.drafting.language) if spot is not None and spot.scale.letter == "l" else "",
            "sheet": str(number),
            "sheets": str(count),
        }


def _rows(tables: Sequence[RuledTable]) -> dict[str, tuple[int, int]]:
    """Give which rows of each table a sheet bears, which may have two parts of one that no sheet holds."""
    rows: dict[str, list[int]] = {}
    for table in tables:
        rows.setdefault(table.name, []).extend(table.rows)
    return {name: (min(ends), max(ends)) for name, ends in rows.items()}

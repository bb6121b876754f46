"""The sheets of a form (бланк): laid out anew from what a scene gives, with places at a scale for what is sought."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from types import MappingProxyType
from typing import NamedTuple

from drawings import VERSION
from drawings.form.given_scheme import SIZES, given_scheme
from drawings.form.laid import CENTRED, PARTS, Given, LaidFigure, LaidTable, asked, blank, data, figures, given, tables
from drawings.kinds.axes import arrow
from drawings.layout.contents import EVEN, Panel
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot
from drawings.lettering.lettering import text_width
from drawings.lettering.words import with_index
from drawings.linkage.notes import assembly
from drawings.page.page import Drafting, Field, drafting_of
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Leaf, Line, SheetError, Stroke, Text, numeral, stated
from drawings.sheets.documents import bind, leaves_of
from drawings.sheets.kind import FRAME, GRAPH
from drawings.sheets.leaves import compositions, fits_on, lay_out
from drawings.sheets.stated_scales import Draft, Exhibit, key_of
from drawings.symbols import symbols
from drawings.symbols.figure import heading
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.linkage import described
from plans.model.mechanism import FRAME as GROUND
from plans.model.mechanism import Way
from plans.scene.scene import Scene
from plans.study import Study

MARGINS = (2.0, 2.0, 4.0)  # paper beside, under and over a place, in sizes of its letters
AXES = (28.0, 18.0)  # length of a graph's axes, in sizes of its letters
OFF = 2.5  # mm from a pole to its letter
TICKS = 12  # of an abscissa that is not numbered by positions
GROUNDED = 28.0  # mm of ground at each end of a guide
CORNER = 5.0  # mm of each line that marks a corner of a place


class Fixed(NamedTuple):
    """What the scene fixes of a mechanism: its points on the frame by their letters, and its guides there."""

    points: Mapping[str, complex]
    hinges: frozenset[str]
    guides: tuple[Way, ...]
    positions: int = TICKS
    sketch: Mapping[str, complex] = MappingProxyType({})  # where its points lie about


NOTHING = Fixed({}, frozenset(), ())


@dataclass(frozen=True)
class BlankFigure:
    """A place on paper: its lines, and the letters of what stands in it."""

    lines: tuple[Group, ...]
    letters: tuple[tuple[complex, str, float], ...]  # of what, and mm from it
    hand: Hand

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole place, its poles and fixed points lettered."""
        size, prefer = self.hand.letter, -3 * math.pi / 4
        texts = (labels.beside(at, with_index(name), size, gap, prefer) for at, name, gap in self.letters)
        return *self.lines, Group(tuple(texts))


def measure(figure: LaidFigure, drafting: Drafting) -> Picture:
    """Measure the room of a place: as far about its pole as is known coarsely."""
    hand = drafting.hand
    side, below, above = (share * hand.letter for share in MARGINS)
    margins = Margins(side, below, above + hand.title)
    width = text_width(Text(0j, figure.heading.title, hand.title))
    if figure.what == GRAPH:
        wide, high = (share * hand.letter for share in AXES)
        mid = complex(wide, high) / 2
        return Picture(f"axes-{figure.name}", wide, high, mid, "l", "mm", margins, width, 0.0, exact=1.0)
    left, low, right, high = figure.reach
    x, y = map(float, figure.pole.get("value", "0 0").split()) if figure.what == FRAME else (0.0, 0.0)
    middle = complex(x, y) + complex(right - left, high - low) / 2
    of = ("l", "m") if figure.times != 1 else (figure.letter, figure.unit)
    return Picture(figure.name, left + right, low + high, middle, *of, margins, width, 0.0)


def draw(figure: LaidFigure, fixed: Fixed, room: Picture, spot: Spot, drafting: Drafting) -> BlankFigure:
    """Draw a place in its spot."""
    if figure.what == GRAPH:
        return _graph(figure, fixed, spot, drafting)
    place, hand = room.place(*spot), drafting.hand
    marked = figure.marked(spot.scale)
    head = heading(spot.box, figure.heading.title, drafting.scale(*dict.fromkeys((marked, spot.scale))), hand)
    if figure.what == FRAME and fixed.points:
        marks, off = list(_frame(figure, fixed, place, hand)), OFF + symbols.HINGE * hand.symbol
        letters = [(place.on(at), name, off) for name, at in fixed.points.items()]
        lines = list(_guides(fixed, room, place, hand))
    else:
        marks, lines = list(_pole(figure, place)), []
        letters = [(place.on(at), name, OFF) for name, at in _poles(figure)]
    data = {"kind": "place", **figure.of, "scale": numeral(marked.mu), "unit": figure.unit}
    strokes = (*_corners(_box(room, place), hand), *lines, *marks)
    return BlankFigure((head, Group(strokes, figure.name, data)), tuple(letters), hand)


def _box(room: Picture, place: Place) -> Field:
    middle, half = place.on(room.middle), complex(room.wide, room.high) / place.scale.mu / 2
    low, high = middle - half, middle + half
    return Field(low.real, low.imag, high.real, high.imag)


def _corners(box: Field, hand: Hand) -> Iterator[Line]:
    """Mark the corners of a place thin, so that it is seen where the figure has room."""
    for x, inward in ((box.left, 1), (box.right, -1)):
        for y, up in ((box.bottom, 1j), (box.top, -1j)):
            at = complex(x, y)
            yield from (Line(at, at + CORNER * hand.symbol * way, hand.drafted) for way in (inward, up))


def _poles(figure: LaidFigure) -> Iterator[tuple[str, complex]]:
    """Give the zero, and the pole of rays where there is one, by their names."""
    yield from ((figure.pole["name"], 0j),) if figure.pole else ()
    yield from ((figure.rays["name"], complex(*map(float, figure.rays["value"].split()))),) if figure.rays else ()


def _pole(figure: LaidFigure, place: Place) -> Iterator[Group]:
    for name, value in _poles(figure):
        yield Group((symbols.pole(place.on(value)),), "", _data(figure, place, "pole", name, value), name)


def _frame(figure: LaidFigure, fixed: Fixed, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the fixed points: hinges with their stands."""
    for name, value in fixed.points.items():
        at = place.on(value)
        kind = "pole" if name == figure.pole.get("name") else "point"
        radius = symbols.HINGE * hand.symbol
        if name in fixed.hinges:
            yield from symbols.fixed_hinge(at, hand, radius)
        bare = Circle(at, symbols.POINT * hand.symbol, hand.body)
        circle = symbols.hinge(at, hand)[0] if name in fixed.hinges else bare
        yield Group((circle,), "", _data(figure, place, kind, name, value), name)


def _data(figure: LaidFigure, place: Place, kind: str, name: str, value: complex) -> dict[str, str]:
    place_data = {key: figure.pole[key] for key in ("plan", "quantity", "position") if key in figure.pole}
    scale = {"unit": figure.unit, "scale": numeral(figure.marked(place.scale).mu)}
    return {"kind": kind, "name": name, **place_data, "value": stated(value), **scale}


def _guides(fixed: Fixed, room: Picture, place: Place, hand: Hand) -> Iterator[Stroke]:
    box = _box(room, place)
    for guide in fixed.guides:
        ends = _across(place.on(guide.through), guide.direction, box)
        if ends is not None:
            yield Line(*ends, hand.axis)
            yield from _ground(ends, hand)


def _ground(ends: tuple[complex, complex], hand: Hand) -> Iterator[Stroke]:
    start, end = ends
    along = (end - start) / abs(end - start)
    long, under = min(GROUNDED * hand.symbol, abs(end - start) / 3), -1j * along * symbols.BLOCK[1] / 2 * hand.symbol
    under = under if under.imag <= 0 else -under
    into = under / abs(under)
    for foot in (start, end - long * along):
        yield from symbols.ground(foot + under, foot + under + long * along, into, hand)


def _across(at: complex, way: complex, box: Field) -> tuple[complex, complex] | None:
    """Give the ends of a line's part within a box; None where it passes by."""
    low, high = -math.inf, math.inf
    rows = ((at.real, way.real, box.left, box.right), (at.imag, way.imag, box.bottom, box.top))
    for start, step, least, most in rows:
        if abs(step) > 1e-9:  # a direction of length one: less rises by no width of a line on any sheet
            near, far = sorted(((least - start) / step, (most - start) / step))
            low, high = max(low, near), min(high, far)
        elif not least <= start <= most:
            return None
    return (at + low * way, at + high * way) if low < high else None


def _graph(figure: LaidFigure, fixed: Fixed, spot: Spot, drafting: Drafting) -> BlankFigure:
    """Draw bare axes: the abscissa with ticks in the middle of the height, for it is not told what is below zero."""
    hand, box = drafting.hand, spot.box
    wide, high = (share * hand.letter for share in AXES)
    zero = complex(box.centre.real - wide / 2, box.bottom + MARGINS[1] * hand.letter + high / 2)
    head = heading(box, figure.heading.title, ";  ".join(figure.scales) or " ", hand)
    ticks = [symbols.tick(zero + wide * (k + 1) / (fixed.positions + 1), 1 + 0j, hand) for k in range(fixed.positions)]
    axes = (*arrow(zero, zero + wide, hand), *arrow(zero - 0.5j * high, zero + 0.5j * high, hand))
    data = {"kind": "axes", "plan": figure.name}
    return BlankFigure((head, Group((*axes, *ticks), f"axes-{figure.name}", data), _axes(figure, zero, hand)), (), hand)


def _axes(figure: LaidFigure, zero: complex, hand: Hand) -> Group:
    wide, high = (share * hand.letter for share in AXES)
    up, along = zero + complex(1.5, high / 2 - hand.text), zero + complex(wide, 0.8 * hand.text)
    texts = (Text(up, "", hand.text, "start", True), Text(along, "", hand.text, "end", True))
    return Group(tuple(text._replace(content=axis) for text, axis in zip(texts, figure.axes, strict=False)))


FOREMOST = 1.5  # weight of the plan of positions
SHARE = 1 / 3  # of its sheet
APART = ("position", "cam")  # what the data of a sheet say that its figures are of
FINER = 20  # parts of a place, where the scene states a scale at which a coarser place does not fit its paper
# Keys of [sheet.scale] whose plans have one scale, unless the scene asks for each.
COMMON = ("velocity", "acceleration")


def form_of(study: Study) -> Mapping[str, Sequence[Leaf]]:
    """Lay out the form of a scene, by kinds of sheets: all that its task gives, and no answer."""
    scene = study.scene.changed(sheet=study.scene.sheet.changed(drawn="", date=""))
    task = _BlankTask(scene, given(scene), _fixed(study), leaves_of(study), study)
    found = bind(task.laid_out(CENTRED), scene)
    return {kind: tuple(_signed(leaf, kind) for leaf in leaves) for kind, leaves in found.items()}


class _BlankTask(NamedTuple):
    """What a form is laid out from: the scene and all that it gives, and the sheets with their answer."""

    scene: Scene
    known: Given
    fixed: Fixed
    sheets: Mapping[str, Sequence[Leaf]]
    study: Study

    def laid_out(self, parts: int) -> Mapping[str, Sequence[Leaf]]:
        """Lay out its sheets; where a scale that the scene states leaves places no room, with less room to spare."""
        try:
            return {kind: lay_out(self.scene, [*self._drafts(kind, parts)]) for kind in self.sheets}
        except SheetError:
            if parts == FINER:
                raise
            return self.laid_out(PARTS if parts == CENTRED else FINER)

    def _drafts(self, kind: str, parts: int) -> Iterator[Draft]:
        """Give a draft for each position or cam that a kind has sheets of its own for."""
        for _, group in groupby(self.sheets[kind], lambda leaf: [leaf.metadata.get(key) for key in APART]):
            leaves = tuple(group)
            places = {figure.name: figure for leaf in leaves for figure in figures(leaf, kind, self.known, parts)}
            bands = [table for leaf in leaves for table in tables(leaf, kind, self.known)]
            title = leaves[0].title.removeprefix(f"{self.scene.heading(self.scene.sheet.language)}: ")
            yield self._draft(kind, title, tuple(places.values()), bands)

    def _draft(self, kind: str, title: str, places: Sequence[LaidFigure], bands: Sequence[LaidTable]) -> Draft:
        drafting, language = drafting_of(self.scene), self.scene.sheet.language
        shows = tuple(_exhibit(kind, place, self.fixed, self.scene, drafting) for place in places)
        large, small = ((*given_scheme(self.study, drafting, size), *shows) for size in SIZES)
        lesser = tuple(show._replace(panel=show.panel._replace(share=show.panel.share / 2)) for show in small)
        notes = (*data(self.scene), *assembly(self.fixed.sketch, language), *asked(places, bands, language))
        bare = Draft(kind, title, shows, blank(bands, drafting), notes, lambda _: {})
        ways = [bare._replace(shows=way) for way in (large, small, lesser)]
        if large == shows or fits_on(self.scene, ways[0], 1):
            return ways[0]
        most = len(compositions(self.scene, bare))  # for the scheme no sheet more is taken, where that can be
        return next((way for way in ways if fits_on(self.scene, way, most)), ways[0])


def _fixed(study: Study) -> Fixed:
    """Give what the scene fixes of its mechanism, if it has one."""
    if "linkage" not in study.scene.techniques:
        return NOTHING
    mechanism, positions = described(study.scene), study.scene.of(LinkageForm).drive.count
    points = mechanism.links[GROUND].points
    guides = (slide.on_owner for slide in mechanism.slides if slide.owner == GROUND)
    hinges = frozenset(name for name in points if name in mechanism.hinges)
    return Fixed(dict(points), hinges, tuple(guides), positions, mechanism.sketch)


def _exhibit(kind: str, figure: LaidFigure, fixed: Fixed, scene: Scene, drafting: Drafting) -> Exhibit:
    """Give the place of a figure, and what it wants on the sheet."""
    room = measure(figure, drafting)
    key = key_of(kind, figure.name)
    shared = key if key in COMMON and scene.sheet.scales == "common" else ""
    weight, share = (FOREMOST, SHARE) if figure.what == FRAME else (EVEN, 0.0)
    together = figure.name.rpartition("-")[0] if figure.what == GRAPH else ""
    panel = Panel(room, weight, together, shared, share)
    return Exhibit(panel, partial(draw, figure, fixed, room, drafting=drafting))


def _signed(leaf: Leaf, kind: str) -> Leaf:
    """Say in the data of a sheet that it is a form, of which kind, and how it is numbered; nothing else."""
    kept = {key: leaf.metadata[key] for key in ("title", "number", "of", "document") if key in leaf.metadata}
    return leaf._replace(metadata={"form": kind, **kept, "plandraft": VERSION})

"""Scales that the scene states (заданные масштабы): which figures they govern, and whether these fit at them."""

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import chain
from typing import Any, NamedTuple, Protocol, TypeVar

from drawings.kinds.working import Workings
from drawings.layout.contents import Panel
from drawings.layout.picture import SMALLER, Figure, Picture, Spot
from drawings.layout.room import corner_of, room_of
from drawings.layout.slicing import GAP, Size
from drawings.layout.table import RuledTable
from drawings.page.page import Drafting, Page, Scale
from drawings.paper.strokes import Group, SheetError
from drawings.sheets.documents import of_scale
from drawings.sheets.kind import sheet_kind
from plans.scene.scene import Scene
from plans.words.words import Message, message


class Exhibit(NamedTuple):
    """A figure that a sheet shows: what it wants of its place, and how it is drawn in its spot."""

    panel: Panel
    draw: Callable[[Spot], Figure]


Shown_contra = TypeVar("Shown_contra", contravariant=True)


class Figures(Protocol[Shown_contra]):
    """The figures of a kind: the file that measures and draws them."""

    def measure(self, shown: Shown_contra, drafting: Drafting, /) -> Picture:
        """Measure the room that one needs."""
        ...

    def draw(self, shown: Shown_contra, room: Picture, spot: Spot, /, drafting: Drafting) -> Figure:
        """Draw it in its spot."""
        ...


def exhibit(
    figures: Figures[Shown_contra], shown: Shown_contra, drafting: Drafting, largest: float = 0.0, **wants: Any
) -> Exhibit:
    """Show a figure, given by its file and by what it shows, with what it `wants` of its place as a panel does.

    It may be drawn so many times as large as it must be to be read, where a `largest` is named.
    """
    room = figures.measure(shown, drafting)
    room = room._replace(most=largest * room.least or math.inf) if largest else room
    return Exhibit(Panel(room, **wants), partial(figures.draw, shown, room, drafting=drafting))


class Caption(NamedTuple):
    """Lettering that stands with figures: what it wants of its place, and how it is written in its box.

    One `of` a figure is written by the spot of that figure too, where both stand on one sheet: lengths as drawn. One
    that `waits` is written by what writes the cells of the tables that wait for the scales of the figures. A `working`
    of its figure is written only where paper beside that would stay bare.
    """

    panel: Panel
    write: Callable[..., Group]  # of a field, and of a spot
    of: str = ""
    waits: bool = False
    working: bool = False


def captions(workings: Iterable[Workings]) -> Iterator[Caption]:
    """Give workings that have anything to say as lettering of their figures that only bare paper calls for."""
    return (Caption(block.panel, block.write, of=block.of, working=True) for block in workings if block.lines(None))


class Draft(NamedTuple):
    """What the sheets of one kind show: figures and lettering in their order, tables, notes.

    `facts` gives what the data of a sheet say of it beside title and number, by the names of the figures that it bears.
    `scaled` is the figure whose scale the title block states: the foremost one, unless it is named. The notes stand in
    no column of less than `narrow` mm. The drafts `instead` show the same in other ways, where that can be read better
    or takes fewer sheets. By the scales of all figures `later` gives what a hand may be out, which the cells that wait
    tell, by the names and positions of their quantities; `remarks` says, by the spots of all figures, what follows the
    notes.
    """

    kind: str
    title: str
    shows: tuple[Exhibit | Caption, ...]
    tables: tuple[RuledTable, ...]
    notes: tuple[str, ...]
    facts: Callable[[Collection[str]], Mapping[str, Any]]
    scaled: str = ""
    narrow: float = 0.0
    instead: "tuple[Draft, ...]" = ()
    later: Callable[[Mapping[str, float]], Mapping[tuple[str, int], float]] | None = None
    remarks: Callable[[Mapping[str, Spot]], tuple[str, ...]] | None = None


def figures_facts(names: Collection[str], **others: Any) -> dict[str, Any]:
    """Say in the data of a sheet which figures it shows, with what else is said of it."""
    return {**others, "figures": list(names)}


GRAPHS = ("balancing",)  # their own scale is that of the angle: the key of such a figure governs its ordinates
READABLE = 20.0  # mm: a figure of four large letters, or ordinates of so much, are a blot whose course is not seen
NEAREST = 3  # standard scales that a refusal names
ROUNDED = 1e-12  # of a scale of two digits: what its quotient by a power of ten leaves, some thousand roundings


def key_of(kind: str, figure: str) -> str:
    """Give the key of [sheet.scale] that governs a figure of a kind of sheet, or nothing.

    >>> key_of("kinematics", "velocities-4"), key_of("kinematics", "values")
    ('velocity', '')
    """
    return next((key for begin, key in sheet_kind(kind).scales.items() if figure.startswith(begin)), "")


class StatedScales(NamedTuple):
    """What a scene says of the scales of one kind of sheet on its page."""

    scene: Scene
    kind: str
    page: Page

    @property
    def stated(self) -> Mapping[str, float]:
        """The scales that the scene states, by their keys."""
        return dict(self.scene.sheet.scale.stated)

    def panels(self, panels: Sequence[Panel]) -> tuple[Panel, ...]:
        """Give the figures that are governed the scale that they must have; one at which they do not fit is refused."""
        governed = [self._governed(panel) for panel in panels]
        for name in self.stated:
            self._see(name, [picture for picture in self._pictures(panels) if key_of(self.kind, picture.name) == name])
        return tuple(governed)

    def _governed(self, panel: Panel) -> Panel:
        mu = self.stated.get(key_of(self.kind, panel.item.name), 0.0)
        if not mu or not isinstance(panel.item, Picture) or panel.item.name in GRAPHS:
            return panel
        return panel._replace(item=panel.item.at(mu))

    def _pictures(self, panels: Sequence[Panel]) -> Iterator[Picture]:
        """Give all figures that are more than a point, without those whose ordinates alone are governed."""
        items = (panel.item for panel in panels if panel.item.name not in GRAPHS)
        return (item for item in items if isinstance(item, Picture) and (item.wide or item.high))

    def _see(self, name: str, pictures: Sequence[Picture]) -> None:
        """See that the largest of the figures of a scale is large enough to be lettered, and that each fits."""
        mu = self.stated[name]
        for picture in pictures:
            size = picture.size(Scale(mu, picture.letter, picture.unit))
            if not any(_holds(room, size) for room in self._rooms):
                raise self._refused(
                    name, picture, "refused.scale_large", **_millimetres(wide=size[0], high=size[1]), **self._room(size)
                )
        largest = max(pictures, key=lambda picture: max(picture.wide, picture.high), default=None)
        if largest is not None and max(largest.wide, largest.high) / mu < (largest.least * SMALLER or READABLE):
            sizes = _millimetres(max(largest.wide, largest.high) / mu, largest.least or READABLE, ("size", "least"))
            raise self._refused(name, largest, "refused.scale_small", **sizes)

    @property
    def _rooms(self) -> tuple[Size, ...]:
        """The rooms beside and above the title block, mm."""
        room, (wide, high) = room_of(self.page), corner_of(self.page)
        return (room.width - GAP - wide, room.height), (room.width, room.height - GAP - high)

    def _room(self, size: Size) -> dict[str, str]:
        """Give the room that a figure fits best."""
        best = max(self._rooms, key=lambda room: min(room[0] / size[0], room[1] / size[1]))
        return _millimetres(*best, ("across", "up"))

    def _refused(self, name: str, picture: Picture, why: str, **parts: object) -> SheetError:
        mu, length = self.stated[name], picture.letter == "l"
        scales = tuple(_written(fit, length) for fit in self._fitting(picture)) or (_written(mu, length),)
        said = message(why, name=name, scale=_written(mu, length), scales=scales, larger=larger(self.scene), **parts)
        return SheetError(of_scale(self.scene, name, said))

    def _fitting(self, picture: Picture) -> list[float]:
        """Give the standard scales at which a figure fits and can be read, nearest to what is stated first."""
        rungs = chain.from_iterable(picture.rungs(*room, self.page.standard) for room in self._rooms)
        fit = {rung.scale.mu for rung in rungs if rung.extent >= (picture.least * SMALLER or READABLE)}
        mu = self.stated[key_of(self.kind, picture.name)]
        return sorted(sorted(fit, key=lambda size: max(size / mu, mu / size))[:NEAREST])


def larger(scene: Scene) -> Message | str:
    """Advise a larger format where there is one."""
    return "" if scene.sheet.format == "A1" else message("refused.larger")


def see_ordinates(scene: Scene, name: str, span: float, high: float) -> None:
    """See that ordinates of a span in true units stand in a graph so many mm high, at the scale that is stated."""
    mu = dict(scene.sheet.scale.stated)[name]
    if span / mu > high:
        parts = {"scale": _written(mu, False), "least": _written(_rounded(span / high, up=True), False)}
        sizes, more = _millimetres(span / mu, high, ("high", "up")), larger(scene)
        said = message("refused.scale_ordinates", name=name, larger=more, **parts, **sizes)
        raise SheetError(of_scale(scene, name, said))
    if 0 < span / mu < READABLE:
        parts = {"scale": _written(mu, False), "most": _written(_rounded(span / READABLE, up=False), False)}
        sizes = _millimetres(span / mu, READABLE, ("high", "needed"))
        raise SheetError(of_scale(scene, name, message("refused.scale_flat", name=name, **parts, **sizes)))


def _rounded(mu: float, up: bool) -> float:
    """Round a scale up or down to two digits.

    >>> _rounded(0.01234, up=True), _rounded(0.01234, up=False), _rounded(250.0, up=True)
    (0.013, 0.012, 250.0)
    """
    step = 10.0 ** (math.floor(math.log10(mu)) - 1)
    count = math.ceil(mu / step * (1 - ROUNDED)) if up else math.floor(mu / step * (1 + ROUNDED))
    return float(f"{count * step:.12g}")


def _holds(room: Size, size: Size) -> bool:
    return room[0] >= size[0] and room[1] >= size[1]


def _millimetres(wide: float, high: float, names: tuple[str, str] = ("wide", "high")) -> dict[str, str]:
    """Write two sizes in whole millimetres."""
    return {name: f"{size:.0f}" for name, size in zip(names, (wide, high), strict=True)}


def _written(mu: float, length: bool) -> str:
    """Write a scale as the scene would."""
    return f'"{Scale(mu, "l", "m").ratio("en")}"' if length else f"{mu:.6g}"

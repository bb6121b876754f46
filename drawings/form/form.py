"""The sheets of a form (бланк): laid out anew from what a scene gives, with places at a scale for what is sought."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import groupby
from typing import Any, NamedTuple

from drawings import VERSION
from drawings.form.blank_figure import NOTHING, Fixed, draw, fixed, measure
from drawings.form.blank_table import blank
from drawings.form.given import Given, data, given
from drawings.form.laid import PARTS, LaidFigure, LaidTable, figures, tables
from drawings.form.task import FRAME, GRAPH
from drawings.layout.contents import EVEN, Panel
from drawings.original.edition import leaves_of
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf, SheetError
from drawings.sheets.documents import bind
from drawings.sheets.draft import Draft, Exhibit
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import key_of
from plans.scene.scene import Scene
from plans.study import Study

FOREMOST = 1.5  # weight of the plan of positions
SHARE = 1 / 3  # of its sheet
APART = ("position", "cam")  # what the data of a sheet say that its figures are of
FINER = 20  # parts of a place, where the scene states a scale at which a coarser place does not fit its paper
COMMON = (
    "velocity",
    "acceleration",
)  # keys of [sheet.scale] whose plans have one scale, unless the scene asks for each


def form_of(study: Study) -> Mapping[str, Sequence[Leaf]]:
    """Lay out the form of a scene, by kinds of sheets: all that its task gives, and no answer."""
    scene = study.scene.changed(sheet=study.scene.sheet.changed(drawn="", date=""))
    own = _Task(scene, given(scene), _fixed(study), leaves_of(study))
    found = bind(own.laid_out(PARTS), scene)
    return {kind: tuple(_signed(leaf, kind) for leaf in leaves) for kind, leaves in found.items()}


class _Task(NamedTuple):
    """What a form is laid out from: the scene and all that it gives, and the sheets with their answer."""

    scene: Scene
    known: Given
    own: Fixed
    sheets: Mapping[str, Sequence[Leaf]]

    def laid_out(self, parts: int) -> Mapping[str, Sequence[Leaf]]:
        """Lay out its sheets; where a scale that the scene states leaves places no room, with less room to spare."""
        try:
            return {kind: lay_out(self.scene, [*self._drafts(kind, parts)]) for kind in self.sheets}
        except SheetError:
            if parts == FINER:
                raise
            return self.laid_out(FINER)

    def _drafts(self, kind: str, parts: int) -> Iterator[Draft]:
        """Give a draft for each position or cam that a kind has sheets of its own for."""
        for _, leaves in groupby(self.sheets[kind], lambda leaf: [leaf.metadata.get(key) for key in APART]):
            own = tuple(leaves)
            places = {one.name: one for leaf in own for one in figures(leaf, kind, self.known, parts)}
            bands = [one for leaf in own for one in tables(leaf, kind, self.known)]
            title = own[0].title.removeprefix(f"{self.scene.heading(self.scene.sheet.language)}: ")
            yield self._draft(kind, title, tuple(places.values()), bands)

    def _draft(self, kind: str, title: str, places: Sequence[LaidFigure], bands: Sequence[LaidTable]) -> Draft:
        drafting = drafting_of(self.scene)
        shows = tuple(_exhibit(kind, one, self.own, self.scene, drafting) for one in places)
        return Draft(kind, title, shows, blank(bands, drafting), tuple(data(self.scene)), _facts)


def _fixed(study: Study) -> Fixed:
    """Give what the scene fixes of its mechanism, if it has one."""
    if "linkage" not in study.scene.techniques:
        return NOTHING
    linkage = study["linkage"]
    return fixed(linkage.mechanism, len(linkage.turn))


def _exhibit(kind: str, laid: LaidFigure, own: Fixed, scene: Scene, drafting: Drafting) -> Exhibit:
    """Give the place of a figure, and what it wants on the sheet."""
    room = measure(laid, own, drafting)
    key = key_of(kind, laid.name)
    shared = key if key in COMMON and scene.sheet.scales == "common" else ""
    weight, share = (FOREMOST, SHARE) if laid.what == FRAME else (EVEN, 0.0)
    together = laid.name.rpartition("-")[0] if laid.what == GRAPH else ""
    panel = Panel(room, weight, together, shared, share)
    return Exhibit(panel, partial(draw, laid, own, room, drafting=drafting))


def _facts(_: Collection[str]) -> dict[str, Any]:
    """Say nothing more in the data of a form."""
    return {}


def _signed(leaf: Leaf, kind: str) -> Leaf:
    """Say in the data of a sheet that it is a form, of which kind, and how it is numbered; nothing else."""
    kept = {key: leaf.metadata[key] for key in ("title", "number", "of", "document") if key in leaf.metadata}
    return replace(leaf, metadata={"form": kind, **kept, "plandraft": VERSION})

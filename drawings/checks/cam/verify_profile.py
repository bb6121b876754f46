"""The self-check of the sheet of a cam to be made: curves, radii, table, notes against the analysis (проверка)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.checks import reading
from drawings.checks.cam import cam_page
from drawings.checks.cam.cam_blank import blank
from drawings.checks.cam.cam_units import ratio
from drawings.checks.cam.profiles import Analysed, wrong
from drawings.checks.documents import ruled
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on, within
from drawings.figures.cam.manufacturing import PLAN, TabledProfile, tabled
from drawings.figures.cam.manufacturing_notes import notes
from drawings.figures.cam.outlines import SHOWN
from drawings.figures.cam.radius_table import NAME, told
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import groups, texts
from plans.analytic.cam.contour import contour
from plans.model.cam_motion import CamFound
from plans.study import Study
from plans.words.words import message

ROLLED = 181  # turns at which the curves are held to the law
# The headings of its table by whether the cam translates.
HEADS = {
    False: ("φ of cam, °", "polar radius, mm", "polar angle, °"),
    True: ("x of cam, mm", "abscissa, mm", "ordinate, mm"),
}
FAR = 1e-9  # of a radius: both roads take it from one law


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a cam shows against the analysis (row of the table of sheets)."""
    cams = study.comparison("cam").analysis.cams
    found = next(one for one in cams if one.cam.name == leaf.metadata["cam"])
    own = cam_page.smaller(leaf, study.scene)
    yield from check(measured, leaf, found, drafting_of(own), leaf.metadata["of"] == len(cams))
    drawn = next((one for one in measured.marks if one.plan == PLAN), None)
    title = drafting_of(own).word("cam profile sheet title") + (f" {found.cam.name}" if len(cams) > 1 else "")
    yield from cam_page.paper(
        leaf, own, "profile", title, "" if drawn is None else ratio(drawn.scale, drafting_of(own))
    )


def check(measured: Measured, leaf: Leaf, found: CamFound, drafting: Drafting, whole: bool = True) -> Iterator[Wrong]:
    """Hold a sheet against what the analysis found of its cam; a `whole` one bears figure and table."""
    exact = TabledProfile(found, contour(found.cam, found.sizes, found.roller, tabled(found.cam)))
    if whole or PLAN in leaf.metadata["figures"]:
        yield from wrong(measured.profiles, PLAN, _analysed(found))
        yield from _radii(measured, exact)
        yield from blank(leaf, exact, drafting)
    if whole or leaf.metadata["notes"]:
        yield from _notes(leaf, exact, drafting)
    yield from reading.marked_scales(leaf)
    yield from _table(leaf, exact, drafting, whole)


def _analysed(found: CamFound) -> Analysed:
    turned = np.linspace(0.0, found.cam.turn, ROLLED)
    # A curve of a cam that translates ends where it is rounded on paper: a follower over its very end may miss it.
    turned = turned[1:-1] if found.cam.translates else turned
    own = contour(found.cam, found.sizes, found.roller, turned)
    return Analysed(found.cam, found.sizes, found.roller, own, any(one.kind in SHOWN for one in found.flaws))


def _radii(measured: Measured, exact: TabledProfile) -> Iterator[Wrong]:
    """Hold the drawn radii, or ordinates, to the analysis: each that must be there."""
    seen = {one.position: one for one in measured.vectors if one.plan == PLAN}
    for number, (k, name) in enumerate(exact.rays()):
        one, true = seen.get(number), complex(exact.told[k])
        true = 1j * true.imag if exact.cam.translates else true
        if one is None:
            yield on("missing_on", PLAN, name=f"r {name:g}")
        elif not abs(one.value - true) <= 2 * measured.quantum * one.scale + FAR * abs(true):
            yield on("differs_on", PLAN, name=f"r {name:g}")


def _table(leaf: Leaf, exact: TabledProfile, drafting: Drafting, whole: bool) -> Iterator[Wrong]:
    """Read the table of radii back: every cell, and every row that a sheet with the table must have."""
    true, seen = dict(_rows(exact, drafting)), set[str]()
    parts = [one for one in groups(leaf.groups) if one.name.startswith(f"{NAME}-")]
    turn, *words = HEADS[exact.cam.translates]
    for part in parts:
        yield from ruled.faults(part, NAME, [read(drafting.word(key)) for key in (turn, *words)])
    for name, *cells in ([text.plain for text in row] for part in parts for row in list(reading.rows(part))[1:]):
        seen.add(name)
        if name not in true or len(cells) != len(true[name]):
            yield within("row", NAME, name=name)
            continue
        pairs = zip(cells, true[name], strict=True)
        yield from (within("cell", NAME, name=name, text=text) for text, own in pairs if not reads(text, own, 0.0))
    every = leaf.metadata["every"]
    if whole or parts:
        missing = (name for k, name in enumerate(true) if k % every == 0 and name not in seen)
        yield from (within("missing_from", NAME, name=name) for name in missing)


def _rows(exact: TabledProfile, drafting: Drafting) -> Iterator[tuple[str, tuple[float, float]]]:
    """Give what each row must say by its name."""
    yield from ((drafting.number(name, 5), told(exact, k)) for k, name in enumerate(exact.names))


def _notes(leaf: Leaf, exact: TabledProfile, drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes back, on the sheet of a longer set that bears them: they say what the analysis has them say."""
    said = " ".join(text.plain for group in leaf.groups if group.name == "notes" for text in texts((group,)))
    due = " ".join(Text(0j, one).plain for one in notes(exact, drafting))
    bears = leaf.metadata["notes"] or leaf.metadata["of"] == 1
    if (said or bears) and said.split() != due.split():
        yield message("wrong.notes")

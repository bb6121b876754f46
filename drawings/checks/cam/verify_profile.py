"""The self-check of the sheet of a cam to be made: curves, radii, table, notes against the analysis (проверка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from drawings.checks import reading
from drawings.checks.cam import cam_page
from drawings.checks.cam.blank.cam_blank import blank
from drawings.checks.cam.blank.tabled_cam import FLAWS, PLAN, TabledCam, notes, tabled
from drawings.checks.cam.profiles import Analysed, wrong
from drawings.checks.documents_old import ruled, together, written_notes
from drawings.checks.documents_old.told_cell import Cell
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.scale_line import ratio
from drawings.checks.precise import precise
from drawings.checks.wrong import Wrong, on, within
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from plans.analytic.cam.contour import contour
from plans.model.cam_motion import CamFound
from plans.study import Study

NAME = "radii"  # the name of its table
DECIMALS, DIGITS = 3, 5  # decimals of its cells; digits of the numbers of the notes
TOLD_EVERY = (1, 2, 3, 6)  # every which tabled turn a sheet may tell
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
        leaf, own, "profile", title, "" if drawn is None else ratio(drawn.scale, drafting_of(own).language)
    )


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that every cam has its profile, its whole table and its notes on its sheets, and that no other has."""
    leaves, cams = [leaf for _, leaf in sheets], study.comparison("cam").analysis.cams
    for found in cams:
        own = [leaf for leaf in leaves if leaf.metadata["cam"] == found.cam.name]
        yield from together.figures(own, (PLAN,))
        names = (drafting_of(study.scene).number(name, 5) for name in tabled(found).names)
        yield from together.table(own, NAME, rows_due(own[0], names) if own else [])
        yield from together.notes(own)


def check(measured: Measured, leaf: Leaf, found: CamFound, drafting: Drafting, whole: bool = True) -> Iterator[Wrong]:
    """Hold a sheet against what the analysis found of its cam; a `whole` one bears figure and table."""
    exact = tabled(found)
    if whole or PLAN in leaf.metadata["figures"]:
        yield from wrong(measured.profiles, PLAN, _analysed(found))
        yield from _radii(measured, exact)
        yield from blank(leaf, exact, drafting)
    yield from _notes(leaf, exact, drafting)
    if whole:
        yield from together.notes([leaf])
    yield from reading.marked_scales(leaf)
    yield from _table(leaf, exact, drafting, whole)


def _analysed(found: CamFound) -> Analysed:
    turned = np.linspace(0.0, found.cam.turn, ROLLED)
    # A curve of a cam that translates ends where it is rounded on paper: a follower over its very end may miss it.
    turned = turned[1:-1] if found.cam.translates else turned
    own = contour(found.cam, found.sizes, found.roller, turned)
    return Analysed(found.cam, found.sizes, found.roller, own, any(one.kind in FLAWS for one in found.flaws))


def _radii(measured: Measured, exact: TabledCam) -> Iterator[Wrong]:
    """Hold the drawn radii, or ordinates, to the analysis: each that must be there."""
    seen = {one.position: one for one in measured.vectors if one.plan == PLAN}
    for number, (k, name) in enumerate(exact.rays()):
        one, true = seen.get(number), complex(exact.told[k])
        true = 1j * true.imag if exact.cam.translates else true
        if one is None:
            yield on("missing_on", PLAN, name=f"r {name:g}")
        elif not abs(one.value - true) <= 2 * measured.quantum * one.scale + FAR * abs(true):
            yield on("differs_on", PLAN, name=f"r {name:g}")


def _table(leaf: Leaf, exact: TabledCam, drafting: Drafting, whole: bool) -> Iterator[Wrong]:
    """Read the table of radii back: every cell to its last decimal, and every row that must be there, rising."""
    true, seen = dict(_rows(exact, drafting)), list[str]()
    parts = [one for one in groups(leaf.groups) if one.name.startswith(f"{NAME}-")]
    heads = [read(drafting.word(key)) for key in HEADS[exact.cam.translates]]
    for part in parts:
        yield from ruled.faults(part, NAME, heads)
    for name, *cells in ([text.plain for text in row] for part in parts for row in list(reading.rows(part))[1:]):
        seen.append(name)
        if name not in true or len(cells) != len(true[name]):
            yield within("row", NAME, name=name)
            continue
        pairs = zip(cells, true[name], strict=True)
        yield from (within("cell", NAME, name=name, text=text) for text, own in pairs if not own.holds(text))
    if leaf.metadata["every"] not in TOLD_EVERY or seen != sorted(set(seen), key=[*true, *seen].index):
        yield within("row", NAME, name=" ".join(seen[:1]))
    if whole or parts:
        yield from (within("missing_from", NAME, name=name) for name in rows_due(leaf, true) if name not in seen)


def rows_due(leaf: Leaf, names: Iterable[str]) -> list[str]:
    """Give the rows that must be told where a sheet tells every so many."""
    return [name for k, name in enumerate(names) if k % leaf.metadata["every"] == 0]


def _rows(exact: TabledCam, drafting: Drafting) -> Iterator[tuple[str, tuple[Cell, ...]]]:
    """Give what each row must say by its name."""
    for k, name in enumerate(exact.names):
        yield drafting.number(name, 5), tuple(Cell(value, DECIMALS) for value in exact.cells(k))


def _notes(leaf: Leaf, exact: TabledCam, drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes back: they say what the analysis has them say."""
    return written_notes.faults(leaf, notes(exact, precise(drafting), drafting), (DIGITS,))

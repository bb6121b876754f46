"""Cams in the report: what is asked, the travel and profile in every position, sizes, flaws (кулачки в отчёте)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

import numpy as np

from drawings.cam.hub import notes as hub_notes
from drawings.cam.notes import CamNotes, letters, table_units
from drawings.lettering.words import ROUNDING
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, entry, literal, plain, raised
from drawings.report.report import Report, TableSubject, column, header, row
from plans.cam.study import LAWS, CamDrawing, CamStudy
from plans.model.cam import MM
from plans.model.cam_motion import CamFound
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import Message, message, word

DEGREES = math.degrees(1)
ENGLISH = "en"  # of the gallery's page


def subject(study: Study) -> TableSubject:
    """Tell a scene's cams in a few words, for the gallery's page."""
    found, drafting = study.of(CamStudy).found, drafting_of(study.scene)._replace(language=ENGLISH)
    kinds = [drafting.word(f"cam {result.cam.follower.motion} {result.cam.follower.end}") for result in found]
    structure = kinds[0] if len(kinds) == 1 else f"{len(kinds)} cams on a shaft"
    cams = "A cam with a " if len(kinds) == 1 else "Cams, each with its follower: "
    laws = ", ".join(dict.fromkeys(phase.law.name for cam in found for phase in cam.cam.moving() if phase.law))
    return TableSubject(structure, f"law: {laws}", f"{cams}{'; '.join(kinds)} ({laws}).")


def headline(study: Study) -> str:
    """Say which sizes the cams have."""
    return "; ".join(plain(line) for notes in _all(study) for line in notes.sizes())


def _concluded(study: Study) -> Iterator[str]:
    """Say of each cam which sizes it has, its pressure angles, and what is wrong with it."""
    for notes in _all(study):
        lines = (raised(line) for line in (*notes.sizes(), *notes.pressure(), *notes.flaws()))
        text = "; ".join(f"{line[:1].lower()}{line[1:]}" for line in lines)
        yield word(notes.drafting.language, "report.cam_concluded", name=literal(notes.cam.name), told=text)


def remarks(study: Study) -> list[Message]:
    """Say what is wrong with the cams, and what would help."""
    lines = ((literal(notes.cam.name), line) for notes in _all(study) for line in notes.flaws())
    return [message("cam.flaw", cam=name, flaw=plain(line)) for name, line in lines]


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell each cam: its task, its numbers, what is right and wrong with it."""
    drafting = drafting_of(study.scene)
    pairs = [*zip(study.of(CamStudy).drawings.values(), _all(study), strict=True)]
    return Chapters(
        subject=[*chain.from_iterable(_task(notes) for _, notes in pairs)],
        values=[*chain.from_iterable(_values(notes.found, drafting) for _, notes in pairs)],
        conditions=[*chain.from_iterable(_conditions(*pair, LAWS in study.plans) for pair in pairs)],
        left_out=[word(drafting.language, "report.cam_left_out")],
    )


def _all(study: Study) -> Iterator[CamNotes]:
    return (CamNotes(found, drafting_of(study.scene), DIGITS) for found in study.of(CamStudy).found)


def _task(notes: CamNotes) -> Iterator[str]:
    yield word(notes.drafting.language, "report.cam", name=literal(notes.cam.name))
    yield from map(entry, (*notes.asked(), *notes.phases(), *notes.setting()))


def _values(found: CamFound, drafting: Drafting) -> Iterator[str]:
    """Tell every numbered position."""
    yield word(drafting.language, "report.cam_values", name=literal(found.cam.name))
    heads = (_head(name, found, drafting) for name in ("φ", "S", "S'", "S''", "x_P", "y_P", "α", "ρ"))
    yield from header(["i", *heads])
    yield from (row([str(k), *cells]) for k, cells in enumerate(_cells(found, drafting)))


def _head(name: str, found: CamFound, drafting: Drafting) -> str:
    """Head a column with its unit."""
    turn = letters(found.cam)[1]
    ways = dict(zip(("S", "S'", "S''"), table_units(found.cam), strict=True))
    units = {"φ": "mm" if found.cam.translates else "°", "α": "°", **{way: ways[way].unit for way in ways}}
    unit = units.get(name, "mm")
    return f"{name.replace('φ', turn)}, {drafting.word(unit)}" if unit else name


def _cells(found: CamFound, drafting: Drafting) -> Iterator[list[str]]:
    contour, cam = found.contour, found.cam
    with np.errstate(divide="ignore"):  # infinite where 1/ρ is nothing but rounding
        radius = np.asarray(1 / without_rounding(1 / contour.radius))
    columns = (
        contour.turned * (MM if cam.translates else DEGREES),
        *(way.size * column for way, column in zip(table_units(cam), contour.travel, strict=True)),
        MM * contour.pitch.real,
        MM * contour.pitch.imag,
        DEGREES * contour.pressure,
        MM * radius,
    )
    yield from map(list, zip(*(column(values, drafting.language) for values in columns), strict=True))


def without_rounding(values: Floats) -> Floats:
    """Give a column with 0 for what is nothing but rounding beside its largest number."""
    finite = np.abs(values[np.isfinite(values)])
    return np.asarray(np.where(np.abs(values) <= ROUNDING * np.max(finite, initial=0.0), 0.0, values))


def _conditions(drawing: CamDrawing, notes: CamNotes, laws: bool) -> Iterator[str]:
    """Tell sizes, angles, roller, shocks, flaws; of diagrams that are asked for what their chords leave out."""
    language = notes.drafting.language
    yield word(language, "report.cam_found", name=literal(notes.cam.name))
    parts = (notes.smoothed, notes.sizes, notes.pressure, notes.roller, notes.shocks, notes.pressing, notes.flaws)
    lines = (line for part in parts for line in part())
    yield from map(entry, lines)
    if notes.cam.hub is not None:
        yield from (entry(f"{line}") for line in hub_notes(notes.found, notes.drafting))
    if laws:
        shares = (drawing.diagrams.slope_departure.share, drawing.diagrams.travel_departure.share)
        slope, travel = (notes.drafting.number(100 * share if share > ROUNDING else 0.0, 3) for share in shares)
        strips = len(drawing.diagrams.strips.edges) - 1
        chords = word(notes.drafting.language, "report.cam_chords", count=strips, slope=slope, travel=travel)
        yield f"- {chords}"


REPORT = Report(chapters, headline, remarks, subject, _concluded)

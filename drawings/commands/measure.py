"""plandraft measure: the vectors and points of an SVG sheet, read back in true units."""

from __future__ import annotations

import argparse
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from drawings.commands.stderr import tell
from drawings.files.atomic_files import print_json
from drawings.files.sheet_set import manifest_beside
from drawings.lettering.words import letter
from drawings.paper.limits import SheetRefused
from drawings.reading.marks import MarkKey, MeasuredPoint, MeasuredVector
from drawings.reading.measure import Measured, MeasuredProfile, check, measure_file
from geometry.curve import CubicPiece, Piece
from plans.words.words import ENGLISH, message, placed, term, word, words, written

FAILED = 5


def run(options: argparse.Namespace) -> int:
    """Print what a sheet shows; give the exit code."""
    try:
        measured = measure_file(options.sheet)
    except SheetRefused as refused:
        raise type(refused)("file", sheet=options.sheet, why=refused.reason) from None
    if not measured.marks and not measured.profiles:
        raise SheetRefused("bare", sheet=options.sheet)
    language = ENGLISH
    if options.scene:
        from plans.scene.source import language_of  # a sheet alone needs no scene

        language = language_of(options.scene)
    manifest = manifest_beside(options.sheet)
    if manifest is not None:
        for name in manifest.strangers(options.sheet.parent):
            tell(placed(options.sheet.with_name(name), message("measure.stranger", set=manifest.name)).worded(language))
    wrong = check(measured)
    off = {miss.key for miss in wrong}
    astray = _astray(measured, options) if options.scene else {}
    if options.json:
        plain = {"vectors": _plain(measured, "vectors"), "points": _plain(measured, "points")}
        profiles = [_plain_profile(profile) for profile in measured.profiles]
        print_json(
            plain | {"profiles": profiles} | {how: [key._asdict() for key in keys] for how, keys in astray.items()}
        )
    else:
        for line in (*lines(measured, off, language), *_lines(astray, language)):
            print(line)
    return FAILED if wrong or any(astray.values()) else 0


def _lines(astray: Mapping[str, Sequence[MarkKey]], language: str) -> Iterator[str]:
    for how, key in ((how, key) for how, keys in astray.items() for key in keys):
        names = (
            plan_name(part, language) if part == key.plan else mark_name(str(part), language)
            for part in key
            if part is not None
        )
        yield word(language, f"measure.{how}", mark=" ".join(names))


def _astray(measured: Measured, options: argparse.Namespace) -> dict[str, list[MarkKey]]:
    """Name the marks that the sheet must have by its scene and has not, that it has and must not, and that differ."""
    from drawings.redrawn import Originals  # only a scene that is given has its sheets laid out

    originals = Originals(options.scene)
    must = [originals.read_back(sheet).measured for sheet in originals.of(options.sheet.name, measured.metadata)]
    drawn = {mark.key for mark in _all(measured)}
    right = max(must, key=lambda redrawn: len(drawn & {mark.key for mark in _all(redrawn)}))
    stated = {mark.key: mark.stated for mark in right.marks}
    known = [replace(mark, stated=stated[mark.key]) for mark in measured.marks if mark.key in stated]
    held = measured._replace(
        vectors=tuple(mark for mark in known if isinstance(mark, MeasuredVector)),
        points=tuple(mark for mark in known if isinstance(mark, MeasuredPoint)),
        profiles=(),
    )
    there = {mark.key for mark in _all(right)}
    return {
        "missing": [mark.key for mark in _all(right) if mark.key not in drawn],
        "added": [mark.key for mark in _all(measured) if mark.key not in there],
        "differs": [miss.key for miss in check(held)],
    }


def _all(measured: Measured) -> Sequence[MeasuredVector | MeasuredPoint | MeasuredProfile]:
    return (*measured.marks, *measured.profiles)


def _plain(measured: Measured, kind: str) -> list[dict[str, object]]:
    return [
        {
            "plan": mark.plan, "quantity": mark.quantity, "name": mark.name, "position": mark.position,
            "value": [mark.value.real, mark.value.imag], "size": abs(mark.value),
            "stated": [mark.stated.real, mark.stated.imag], "unit": mark.unit, "scale": mark.scale,
        }
        for mark in getattr(measured, kind)
    ]  # fmt: skip


def _plain_profile(profile: MeasuredProfile) -> dict[str, object]:
    return {
        "plan": profile.plan, "quantity": profile.quantity, "name": profile.name, "unit": "m", "scale": profile.scale,
        "deviation": profile.deviation, "quantum": profile.quantum,
        "pieces": [_plain_piece(piece) for piece in profile.pieces],
    }  # fmt: skip


def _plain_piece(piece: Piece) -> dict[str, object]:
    """Give a cubic by its four points, an arc by its start, centre and sweep in degrees."""
    if isinstance(piece, CubicPiece):
        return {"cubic": [[point.real, point.imag] for point in piece]}
    start, centre = ([point.real, point.imag] for point in piece[:2])
    return {"arc": start, "centre": centre, "sweep": math.degrees(piece.sweep)}


WIDTH = 14  # letters of the column of plans, at the least


def lines(measured: Measured, off: Collection[MarkKey], language: str) -> Iterator[str]:
    """Give a line of each mark in true units, of each profile, and of all that is left aside; `off` differ."""
    names = {mark.plan: plan_name(mark.plan, language) for mark in (*measured.marks, *measured.profiles)}
    wide = max((WIDTH, *map(len, names.values())))
    for mark in measured.marks:
        value = word(language, "measure.value", x=f"{mark.value.real:.6g}", y=f"{mark.value.imag:.6g}")
        position = "" if mark.position is None else str(mark.position)
        name, unit = mark_name(mark.name, language), term(language, "unit", mark.unit)
        sign = _sign(mark.key, off, language)
        yield f"{names[mark.plan]:<{wide}} {position:>4}  {name:<10} {value:<26} {unit:<6} {sign}".rstrip()
    for profile in measured.profiles:
        within, to = f"{profile.deviation:.2g}", f"{profile.quantum:.1g}"
        line = word(language, "measure.profile", count=len(profile.pieces), within=within, to=to)
        sign = _sign(profile.key, off, language)
        yield f"{names[profile.plan]:<{wide}} {'':>4}  {mark_name(profile.name, language):<10} {line}  {sign}".rstrip()
    yield from (message("aside.note", note=note).worded(language) for note in measured.notes)


def mark_name(name: str, language: str) -> str:
    """Letter a mark as sheets of a language do.

    >>> mark_name("R^t_12", "ru"), mark_name("P_bal", "ru"), mark_name("m_cw3", "ru")
    ('R^τ_12', 'P_ур', 'm_пр3')
    """
    return letter(language, written(name, language))


def plan_name(plan: str, language: str) -> str:
    """Name a plan, or a figure of a group, in the words of a language.

    >>> plan_name("velocities", "ru"), plan_name("forces-2-3", "ru"), plan_name("v", "ru")
    ('план скоростей', 'план сил 2-3', 'v')
    """
    kind, _, which = plan.partition("-")
    if which and f"figure.{kind}" in words(language) and f"plan.{plan}" not in words(language):
        return word(language, f"figure.{kind}", which=which)
    return term(language, "plan", plan)


def _sign(key: MarkKey, off: Collection[MarkKey], language: str) -> str:
    return word(language, "measure.off") if key in off else ""

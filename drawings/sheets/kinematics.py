"""Sheet 1, kinematics: plan of positions, velocity and acceleration plans, table of values (кинематика, лист 1)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from drawings import position_plan, value_table
from drawings.figure import Place, centred, extent
from drawings.layout import Ink, Labels
from drawings.page import FORMATS, Field, Page
from drawings.scale import Scale, fitting
from drawings.skeleton import Skeletons, skeletons
from drawings.strokes import Group, Leaf, SheetError, Stroke, Text, text_width
from drawings.value_table import ROW
from drawings.vector_plan import Figure, diagram, figure
from drawings.words import fixed, number, word
from plans.compare import Comparison
from plans.extreme import frame_slide
from plans.pressure import interval
from plans.structure import formula, mechanism_class
from plans.study import Study

LEFT_SHARE = 0.49  # of the field's width: the plan of positions takes about half the sheet
HEADING = 18.0  # mm above a figure for its title and scale
TEXT, LINE = 3.5, 6.5


def sheet(study: Study, comparison: Comparison) -> Leaf:
    """Lay out the kinematics sheet; nothing is drawn that the scene's sheet does not need."""
    scene, page = study.scene.sheet, Page(study.scene.sheet.format)
    if page.name not in FORMATS:
        raise SheetError(f"{study.scene.file}: sheet.format = {page.name}: not drawn yet. Fix: A1 or A2")
    language, ink = scene.language, Ink(*page.size)
    ink.bar(page.field.inset(1.0))
    shown = position(study, comparison)
    drawn = plans(study, comparison, shown)
    given = {f"{symbol}_{study.mechanism.drive.link}" for symbol in ("ω", "ε")}
    lines = value_table.rows(comparison, drawn, given, language)
    main, side, low = _fields(page, len(lines))
    bones = skeletons(study, comparison.construction, shown)
    scale, place, groups = _positions(bones, main, page, language)
    figures, missing = _vector_plans(study, comparison, drawn, side, page, language) if drawn else ([], [])
    ink.draw([*groups, *missing, *(stroke for figure in figures for stroke in figure.lines)])
    labels = Labels(ink)
    groups.append(position_plan.letters(bones, place, labels, page.hand))
    groups += [*(figure.lettered(labels) for figure in figures), *missing]
    if lines and drawn:
        groups.append(value_table.table(lines, drawn, low, page.hand, language))
    notes = _notes(study, comparison, language) + _why(study, comparison)
    left = Field(side.left, page.field.bottom, page.block.left, page.block.top)
    groups.append(_written(notes, left))
    block = page.title_block(_entries(study, scale, language), language)
    return Leaf(
        *page.size,
        (page.frame(), page.corners(), block, *groups),
        title=f"{study.scene.title}: {word(language, 'sheet title')}",
        description=" ".join(notes),
        metadata=_metadata(study, drawn, shown),
    )


def position(study: Study, comparison: Comparison) -> int:
    """Give the position drawn in full lines: the scene's own, or the output's fastest one."""
    wanted = study.scene.sheet.position
    free = ~study.lost
    if not free.any():
        return 0  # nothing can be assembled: the sheet explains why, in the first position
    if wanted is not None:
        if study.lost[wanted]:
            raise SheetError(
                f"{study.scene.file}: sheet.position = {wanted}: the mechanism cannot be assembled there. "
                f"Fix: choose one of {', '.join(str(k) for k in np.flatnonzero(free)[:12])}"
            )
        return int(wanted)
    named = [k for k in study.scene.sheet.plans if free[k]]
    return named[0] if named else _best(_telling(study, comparison, 1), free & _working(study), free)


def plans(study: Study, comparison: Comparison, shown: int) -> tuple[int, ...]:
    """Give the positions whose plans are drawn: the scene's own, or the shown one and one of a large acceleration."""
    if study.lost.all():
        return ()
    if study.scene.sheet.plans:
        return tuple(study.scene.sheet.plans)
    free = ~study.lost
    free[shown] = False
    telling = _telling(study, comparison, 1) * _telling(study, comparison, 2)  # both of its plans are open figures
    free &= ~np.isnan(telling)
    if not free.any():
        return (shown,)
    other = _best(telling, free & ~_working(study), free)
    return tuple(sorted((shown, other)))


def _telling(study: Study, comparison: Comparison, order: int) -> Any:
    """Rate the positions by what their plan shows: the output moves, and the plan is an open figure, not one line."""
    motions = comparison.construction.points.values()
    ends = np.array([np.zeros(len(study.turn)), *(m.v if order == 1 else m.a for m in motions)])
    spread = ends - ends.mean(axis=0)
    across = (np.abs(spread) ** 2).mean(axis=0), (spread**2).mean(axis=0)
    area = np.sqrt(np.maximum(across[0] ** 2 - np.abs(across[1]) ** 2, 0.0))  # of the ends' ellipse, times a constant
    return np.sqrt(area) * np.abs(_output_rate(study, comparison, 1))


def _working(study: Study) -> Any:
    """Tell the positions within the working stroke; all of them where the output has no extremes."""
    if study.found is None:
        return np.ones(len(study.turn), dtype=bool)
    start, end = study.found.extremes.phi
    ahead = np.mod(study.sense * (study.turn.phi - start), 2 * np.pi)
    return ahead < np.mod(study.sense * (end - start), 2 * np.pi)


def _best(sizes: Any, preferred: Any, allowed: Any) -> int:
    """Give the position of the largest size among the preferred, or else among the allowed."""
    chosen = preferred if (preferred & ~np.isnan(sizes)).any() else allowed
    return int(np.argmax(np.where(chosen & ~np.isnan(sizes), sizes, -1.0)))


def _output_rate(study: Study, comparison: Comparison, order: int) -> Any:
    """Give the output's velocity or acceleration over the positions, of its pin or of its turning."""
    out, motion = study.output, comparison.construction
    slide = frame_slide(study.mechanism, out.link)
    if slide is not None:
        found = motion.points[out.point or slide.point]
        return found.v if order == 1 else found.a
    turning = motion.links[out.link]
    return turning.omega if order == 1 else turning.epsilon


def _fields(page: Page, rows: int) -> tuple[Field, Field, Field]:
    """Divide the sheet: the plan of positions left, the other plans right, the table under the plan of positions."""
    field = page.field
    middle = field.left + LEFT_SHARE * field.width
    table_top = field.bottom + 6 + ROW * (min(rows, 20) + 2)
    main = Field(field.left + 10, table_top + 8, middle - 6, field.top - 4)
    side = Field(middle, page.block.top + 4, field.right - 4, field.top - 4)
    low = Field(field.left + 6, field.bottom + 4, middle - 6, table_top)
    return main, side, low


def _positions(bones: Skeletons, field: Field, page: Page, language: str) -> tuple[Scale, Place, list[Group]]:
    room = Field(field.left + 16, field.bottom + 16, field.right - 16, field.top - HEADING - 30)
    scale = fitting(*extent(bones.points, room), "l", "m")
    place = centred(bones.points, room, scale)
    title = _heading(field, word(language, "positions"), scale.written(language))
    return scale, place, [title, Group(tuple(position_plan.figure(bones, place, page.hand, language)), "positions")]


def _vector_plans(
    study: Study, comparison: Comparison, drawn: Sequence[int], field: Field, page: Page, language: str
) -> tuple[list[Figure], list[Group]]:
    """Draw the velocity plans in a row and the acceleration plans under them; say which have no place."""
    figures: list[Figure] = []
    missing: list[Group] = []
    drafts = study.drafts()
    half = field.height / 2
    for row, (subject, plan) in enumerate((("velocities", drafts.velocities), ("accelerations", drafts.accelerations))):
        top = field.top - row * half
        rooms = _cells(Field(field.left, top - half, field.right, top), len(drawn))
        shown = [diagram(plan, k) for k in drawn]
        for k, room, found in zip(drawn, rooms, shown, strict=True):
            if study.lost[k] or not np.isfinite(found.points).all():
                missing.append(_missing(study, comparison, subject, k, room, language))
            else:
                figures.append(figure(found, room, k, page.hand, language))
    return figures, missing


def _cells(field: Field, count: int) -> list[Field]:
    width = field.width / count
    return [
        Field(
            field.left + k * width + 14, field.bottom + 12, field.left + (k + 1) * width - 14, field.top - HEADING - 8
        )
        for k in range(count)
    ]


def _missing(study: Study, comparison: Comparison, subject: str, k: int, cell: Field, language: str) -> Group:
    """Say in words why a plan is not drawn."""
    gap = next((g for g in comparison.construction.gaps if g.position == k), None)
    reason = word(language, gap.reason) if gap else ""
    text = word(language, "no plan", plan=word(language, f"{subject} plan"), position=k, reason=reason)
    return Group((Text(cell.centre, text, TEXT, "middle", True),))


def _heading(field: Field, title: str, scale: str) -> Group:
    at = complex((field.left + field.right) / 2, field.top)
    return Group((Text(at - 7j, title, 7.0, "middle", True), Text(at - 16j, scale, 5.0, "middle", True)))


def _notes(study: Study, comparison: Comparison, language: str) -> list[str]:
    """Write what the sheet says in words: structure, drive, stroke, time ratio, pressure angles, gaps, agreement."""
    mechanism, drive = study.mechanism, study.mechanism.drive
    notes = [
        word(
            language, "structure", n=mechanism.moving_links, p=mechanism.lower_pairs, w=mechanism.mobility,
            formula=formula(mechanism, study.groups).replace("->", "→"), klass=mechanism_class(study.groups),
        ),
        word(
            language, "crank", link=drive.link, omega=number(drive.omega, language),
            epsilon=number(drive.epsilon, language),
        ),
    ]  # fmt: skip
    if study.found is not None:
        notes.append(_travel(study, language))
    for group in study.groups:
        found = interval(study.sweep, group, study.nodes)
        low, high = (fixed(float(np.degrees(angle)), language) for angle in (found.low, found.high))
        if low != high:
            notes.append(word(language, "pressure", group=group.label, low=low, high=high))
    return notes + _gaps(comparison, language)


def _gaps(comparison: Comparison, language: str) -> list[str]:
    """Name the gaps, those of one reason together, runs of positions as first-last."""
    reasons: dict[tuple[str, str], list[int]] = {}
    for gap in comparison.construction.gaps:
        reasons.setdefault((gap.reason, gap.where), []).append(gap.position)
    return [
        word(language, "gap", positions=_runs(positions), reason=word(language, reason), where=where)
        for (reason, where), positions in reasons.items()
    ]


def _why(study: Study, comparison: Comparison) -> list[str]:
    """Say on a sheet without any position what would mend the mechanism."""
    return [comparison.construction.gaps[0].advice] if study.lost.all() else []


def _runs(positions: list[int]) -> str:
    """Write numbers with runs joined.

    >>> _runs([1, 2, 3, 7, 9, 10])
    '1–3, 7, 9–10'
    """
    runs: list[list[int]] = []
    for k in positions:
        if runs and k == runs[-1][-1] + 1:
            runs[-1].append(k)
        else:
            runs.append([k])
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}–{run[-1]}" for run in runs)


def _travel(study: Study, language: str) -> str:
    found = study.found
    assert found is not None  # asked only where there are extremes
    extremes = found.extremes
    overlap = word(
        language, "overlap", overlap=fixed(float(np.degrees(extremes.overlap)), language),
        ratio=fixed(extremes.ratio, language, 3),
    )  # fmt: skip
    if len(found.rests) > 2:  # a stroke between two reversals of several has no time ratio
        overlap = word(language, "reversals", count=len(found.rests))
    if extremes.sliding:
        return f"{word(language, 'stroke', stroke=number(extremes.stroke, language))};  {overlap}"
    swing = fixed(float(np.degrees(extremes.stroke)), language)
    return f"{word(language, 'swing', link=study.output.link, stroke=swing)};  {overlap}"


def _written(notes: Sequence[str], field: Field) -> Group:
    """Write the notes from the top of their field downwards, a long one broken between its parts."""
    lines = [line for note in notes for line in _broken(_marked(note), field.width - 6)]
    step = min(LINE, (field.height - 4) / max(len(lines), 1))
    strokes: list[Stroke] = [
        Text(complex(field.left + 2, field.top - 5 - k * step), line, TEXT, "start", True)
        for k, line in enumerate(lines)
    ]
    return Group(tuple(strokes), "notes")


def _broken(note: str, width: float) -> list[str]:
    """Break a note at its spaces where it is wider than its field."""
    lines = [""]
    for part in note.split(" "):
        trial = f"{lines[-1]} {part}".strip()
        if lines[-1] and text_width(Text(0j, trial, TEXT)) > width:
            lines.append(part)
        else:
            lines[-1] = trial
    return lines


def _marked(note: str) -> str:
    """Lower the kind's number in II2(4,5); the rest of a note stays as it is."""
    out, k = [], 0
    while k < len(note):
        if note.startswith("II", k) and k + 2 < len(note) and note[k + 2].isdigit():
            out.append(f"II_{{{note[k + 2]}}}")
            k += 3
        else:
            out.append(note[k])
            k += 1
    return "".join(out)


def _entries(study: Study, scale: Scale, language: str) -> dict[str, str]:
    table = study.scene.sheet
    return {
        "title": study.scene.title,
        "subtitle": word(language, "sheet title"),
        "designation": table.designation,
        "drawn": table.drawn,
        "checked": table.checked,
        "group": table.group,
        "organisation": table.organisation,
        "scale": scale.ratio(language),
        "sheet": "1",
        "sheets": str(len(study.scene.sheets)),
    }


def _metadata(study: Study, drawn: Sequence[int], shown: int) -> dict[str, Any]:
    return {
        "sheet": "kinematics",
        "title": study.scene.title,
        "structure": formula(study.mechanism, study.groups),
        "positions": len(study.turn),
        "shown": shown,
        "plans": list(drawn),
    }

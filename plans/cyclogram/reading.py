"""The form and the task of the cyclogram made from the scene, its faults and its notes (задача циклограммы)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal

from plans.forces.loading import output_at
from plans.forces.reading import fields as h
from plans.forces.reading.fields import Metres
from plans.forces.reading.form import ForceForm
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.cyclogram import Along, CyclogramTask
from plans.model.machine import IDLE
from plans.model.mechanism import FRAME
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import Fault, Path, wrong
from plans.scene.readers import either, many, one
from plans.scene.scene import Meaning, Scene, TechniqueForm
from plans.scene.tables import Missing, Table, key, table

EXAMPLE = "overrun = 0.1"


def along(value: object) -> Decimal:
    """Read a part of the stroke: a share of it from 0 to less than 1, per cent, or a length.

    >>> along("10 %"), along("48 mm")
    (Decimal('0.10'), Decimal('0.048'))
    """
    found = h.place(value)
    if found < 0 and isinstance(found, Metres):
        raise wrong("negative", kind="length")
    if not isinstance(found, Metres) and not 0 <= found < 1:
        raise wrong("share")
    return found


def _along_form() -> forms.Form:
    length = {"type": "string", "pattern": forms.text_with_unit(units.LENGTH)}
    return {"anyOf": [h.SHARE.form(), forms.text(units.PER_CENT.pattern), length]}


ALONG = one(along, _along_form, "share or m")
OVERRUN = either(list, f.pair(ALONG, "[start, end]"), ALONG)
Overrun = Decimal | tuple[Decimal, Decimal]


class CyclogramTable(Table):
    """The tool of the main mechanism: its point, its overrun at the ends of its stroke, where its load changes."""

    point: str | None = key(f.POINT, None, meaning="The point of the tool; default: that of the output.")
    overrun: Overrun = key(
        OVERRUN,
        meaning="How far the tool goes past the work at both ends of its stroke (перебег), or [start, end]: shares of "
        'the stroke, per cent, or lengths, "48 mm".',
        missing=Missing("overrun of the tool", EXAMPLE, 0.1),
    )
    breaks: tuple[Decimal, ...] = key(
        many(ALONG, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="Where the load changes on the working stroke, counted from its beginning; default: where the diagram "
        "of the output's load in [loads] has its points.",
    )

    @property
    def ends(self) -> tuple[Decimal, Decimal]:
        """The overrun where the working stroke begins, and where it ends."""
        return self.overrun if isinstance(self.overrun, tuple) else (self.overrun, self.overrun)

    def check(self) -> None:
        """See that the tool goes past the work somewhere, and that some of the stroke is left for it."""
        if not any(self.ends):
            raise wrong("no_overrun", at=("overrun",))
        if not any(isinstance(end, Metres) for end in self.ends) and sum(self.ends) >= 1:
            raise wrong("no_stroke_left", at=("overrun",))


class CyclogramForm(TechniqueForm):
    """What a scene says of the cyclogram of its machine."""

    cyclogram: CyclogramTable = key(
        table(CyclogramTable),
        meaning="The cyclogram of a machine (циклограмма): its tool, the overrun, where the load changes.",
        missing=Missing("table", f"[cyclogram] with {EXAMPLE}", {}),
    )

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive: it is."""
        return True


POINT: Path = ("cyclogram", "point")


def task_of(scene: Scene) -> CyclogramTask:
    """Make the task; where the load changes the scene says itself, or the diagram of the output's load does."""
    form = scene.of(CyclogramForm).cyclogram
    first, last = map(_along, form.ends)
    breaks = tuple(map(_along, form.breaks)) if "breaks" in form.given else tuple(_of_loads(scene))
    return CyclogramTask(form.point or "", (first, last), breaks)


def _along(place: Decimal) -> Along:
    return Along(float(place), isinstance(place, Metres))


def _of_loads(scene: Scene) -> Iterator[Along]:
    """Give the inner points of the diagram of the first load that works on the output's stroke."""
    forces = scene.part("forces")
    loads = forces.loads if isinstance(forces, ForceForm) else None
    tables = (table for table in (loads.forces if loads else ()) if table.diagram is not None and not table.owns_stroke)
    load = next((table for table in tables if table.phase != IDLE), None)
    if load is not None and load.diagram is not None:
        inner = dict.fromkeys(share for share in load.diagram.shares if 0 < share < 1)
        yield from (Along(float(share)) for share in inner)


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """Examine a scene's cyclogram."""
    linkage = meaning.of(LinkageSurvey)
    survey, form = replace(linkage, faults=[]), meaning.scene.of(CyclogramForm).cyclogram
    if form.point is not None and survey.know(POINT, (form.point,)):
        if survey.owners((form.point,))[:1] == [FRAME]:
            survey.report(POINT, "fixed_output", name=form.point)
        elif survey.mechanism is not None and output_at(survey.mechanism, form.point) is None:
            survey.report(POINT, "floating_tool", name=form.point)
    return survey


def asked_of(scene: Scene) -> tuple[str, ...]:
    """Name the techniques whose tables it shows (row of the table): cams, by their phases and setting angles."""
    return ("cam",) if scene.has(("cam",)) else ()


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's cyclogram: load changes in the overrun, where the tool meets no work."""
    form = scene.of(CyclogramForm).cyclogram
    for index, place in enumerate(form.breaks):
        if _beyond(form, place):
            yield scene.fault(("cyclogram", "breaks", index), "break_in_overrun")


def _beyond(form: CyclogramTable, place: Decimal) -> bool:
    """Tell whether a share of the stroke lies in an overrun that is a share too."""
    first, last = form.ends
    if isinstance(place, Metres):
        return isinstance(first, Metres) and place < first
    before = not isinstance(first, Metres) and place < first
    return before or (not isinstance(last, Metres) and place > 1 - last)

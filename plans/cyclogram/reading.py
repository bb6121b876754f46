"""The task of the cyclogram made from the scene, its faults and its notes (задача циклограммы)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal

from plans.cyclogram.form import CyclogramForm, CyclogramTable
from plans.forces.reading.fields import Metres
from plans.forces.reading.form import ForceForm
from plans.forces.stroke import output_at
from plans.linkage.reading.survey import Survey
from plans.model.cyclogram import Along, CyclogramTask
from plans.model.machine import IDLE
from plans.model.mechanism import FRAME
from plans.scene.faults import Fault, Path
from plans.scene.scene import Meaning, Scene

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
    told = (one for one in (loads.forces if loads else ()) if one.diagram is not None and not one.owns_stroke)
    load = next((one for one in told if one.phase != IDLE), None)
    if load is not None and load.diagram is not None:
        inner = dict.fromkeys(share for share in load.diagram.shares if 0 < share < 1)
        yield from (Along(float(share)) for share in inner)


def survey_of(meaning: Meaning) -> Survey:
    """Examine a scene's cyclogram (row of the table of techniques)."""
    linkage: Survey = meaning["linkage"]
    survey, form = replace(linkage, faults=[]), meaning.scene.of(CyclogramForm).cyclogram
    if form.point is not None and survey.know(POINT, (form.point,)):
        _check_point(survey, form.point)
    return survey


def _check_point(survey: Survey, name: str) -> None:
    """See that the tool is not fixed, and that its link slides on the frame or swings about it."""
    if survey.owners((name,))[:1] == [FRAME]:
        survey.report(POINT, "fixed_output", name=name)
    elif survey.mechanism is not None and output_at(survey.mechanism, name) is None:
        survey.report(POINT, "floating_tool", name=name)


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

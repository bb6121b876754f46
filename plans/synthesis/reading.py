"""The task made from a scene, and why no mechanism meets it, with the nearest demand that one meets (задание)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from decimal import Decimal
from typing import NamedTuple

from plans.model.synthesis import (
    BEYOND,
    PAIR,
    QUARTER,
    TOWARDS,
    RockerTask,
    SliderTask,
    circle,
    end_of_arc,
    overlap_of,
    start_of_arc,
)
from plans.scene.faults import Fault, Path
from plans.scene.scene import Meaning, Scene
from plans.synthesis.form import DemandTable, RockerTable, SliderTable, SynthesisForm
from plans.synthesis.rocker import rocker_of
from plans.synthesis.study import SynthesisStudy

ROCKER: Path = ("synthesis", "crank_rocker")
SLIDER: Path = ("synthesis", "slider_crank")
MILLIMETRES = 1000.0


class SynthesisSurvey(NamedTuple):
    """What the examination of a task found: the task with its free parameter, whether that was sought, its faults."""

    task: RockerTask | SliderTask | None
    sought: bool
    faults: list[Fault]


def survey_of(meaning: Meaning) -> SynthesisSurvey:
    """Make the task of a scene, and see that some mechanism meets it."""
    scene, form = meaning.scene, meaning.scene.of(SynthesisForm).synthesis
    if form.crank_rocker is not None:
        return _rocker(scene, rocker_task(form.crank_rocker))
    assert form.slider_crank is not None  # the form has asked for one
    task = slider_task(form.slider_crank)
    faults = [*_slider_faults(scene, task)]
    return SynthesisSurvey(None if faults else task, False, faults)


def rocker_task(form: RockerTable) -> RockerTask:
    """Make the task of a crank-rocker."""
    place = _radians(form.place)
    side = None if place is None else BEYOND if form.beyond else TOWARDS
    overlap = _overlap(form)
    assert overlap is not None  # the form has asked for it
    return RockerTask(float(form.rocker), math.radians(form.swing), overlap, _float(form.frame), place, side)


def slider_task(form: SliderTable) -> SliderTask:
    """Make the task of a slider-crank; no offset and no overlap are one demand."""
    task = SliderTask(
        float(form.stroke), _float(form.offset), _overlap(form), _float(form.ratio), _radians(form.pressure)
    )
    return task._replace(overlap=None) if task.overlap == 0 and task.offset == 0 else task


def _overlap(form: DemandTable) -> float | None:
    return _radians(form.overlap) if form.time_ratio is None else overlap_of(float(form.time_ratio))


def _radians(value: Decimal | None) -> float | None:
    return None if value is None else math.radians(value)


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def _rocker(scene: Scene, task: RockerTask) -> SynthesisSurvey:
    sought = task.frame is None and task.place is None
    if sought and not task.overlap:
        return SynthesisSurvey(None, False, [scene.fault(ROCKER, "synthesis_centric", least=_mm(task.rocker))])
    whole = rocker_of(task)
    assert whole is not None  # the circle on the rocker's side has always an arc
    if _met(whole):
        return SynthesisSurvey(whole, sought, [])
    name = "frame" if task.place is None else "place"
    within = "; ".join(f"{low:.10g} … {high:.10g}" for low, high in _within(task))
    return SynthesisSurvey(None, False, [scene.fault((*ROCKER, name), f"synthesis_{name}", within=within or "—")])


def _met(task: RockerTask | SliderTask) -> bool:
    return any(reading.found for reading in SynthesisStudy(task).synthesis.readings)


def _within(task: RockerTask) -> Iterator[tuple[float, float]]:
    """Give the frames mm, or the places in degrees, that some mechanism has."""
    if not task.overlap:
        yield MILLIMETRES * task.rocker, math.inf
        return
    for side in task.sides:
        end = end_of_arc(task, side)
        if end is None:
            continue
        start, (radius, middle) = start_of_arc(task, side), circle(task, side)
        if task.place is None:
            frames = [abs(complex(0, middle) + cmath.rect(radius, place)) for place in (start, end)]
            yield MILLIMETRES * min(frames), MILLIMETRES * max(frames)
        else:
            low, high = sorted((math.degrees(start), math.degrees(end)))
            yield low, high
            yield (180 - high) % 360, (180 - low) % 360


def _mm(length: float) -> str:
    return f"{MILLIMETRES * length:.6g}"


def _slider_faults(scene: Scene, task: SliderTask) -> Iterator[Fault]:
    """Say what is too little, what contradicts, and by how much a demand is beyond what can be met."""
    known = frozenset(task.demands)
    if "pressure" in known and known & {"offset", "overlap"} and (task.offset or task.overlap):
        yield scene.fault((*SLIDER, "pressure"), "synthesis_pressure")
    elif not _enough(task):
        yield scene.fault(SLIDER, "synthesis_free")
    elif task.overlap is not None and task.offset is not None and bool(task.overlap) != bool(task.offset):
        yield scene.fault((*SLIDER, "offset"), "synthesis_axial")
    elif not _met(task):
        yield _beyond(scene, task)


def _enough(task: SliderTask) -> bool:
    """Tell whether the demands fix the mechanism: two, or one that does so with no offset."""
    if len(task.demands) >= PAIR:
        return True
    return task.ratio is not None or task.pressure is not None


def _beyond(scene: Scene, task: SliderTask) -> Fault:
    """Tell how much of a demand can be met beside the others."""
    stroke, ratio = task.stroke, task.ratio
    if task.pressure is not None and ratio is not None:
        least = f"{math.degrees(math.asin(1 / ratio)):.6g}"
        return scene.fault((*SLIDER, "pressure"), "synthesis_least_pressure", least=least)
    if task.overlap is None:
        assert ratio is not None  # else too little is told
        return scene.fault((*SLIDER, "offset"), "synthesis_offset", most=_mm(stroke * (ratio**2 - 1) / (4 * ratio)))
    if ratio is not None:
        most = math.acos((ratio - 1) / (ratio + 1))
    else:
        most = math.atan(stroke / task.offset) if task.offset else QUARTER
    return scene.fault((*SLIDER, _told(scene)), "synthesis_overlap", most=f"{math.degrees(most):.6g}")


def _told(scene: Scene) -> str:
    return "time_ratio" if scene.has((*SLIDER, "time_ratio")) else "overlap"

"""Mechanisms with a slot that are asked for (задания на кулисные, синусный и тангенсный механизмы)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Final

from plans.model.synthesis.design import Design
from plans.model.synthesis.pace import Pace
from plans.model.synthesis.slots import LeverTask, SineTask, TangentTask, WhitworthTask
from plans.scene.faults import Fault, Path
from plans.scene.scene import Scene
from plans.synthesis.asked import degrees, met, millimetres, number, overlap, radians
from plans.synthesis.slotted import drawn_levers, drawn_whitworths
from plans.synthesis.tables.slots import LeverTable, SineTable, SlotTable, TangentTable
from plans.synthesis.written import SPEED, MechanismText

LEVER: Path = ("synthesis", "slotted_lever")
WHITWORTH: Path = ("synthesis", "whitworth")
MINUTE: Final = 60.0  # s
LONGER: Final = 1.25  # a slot, than it must be
STATIONS: Final = 9  # of a lever that does not turn fully


def pace(table: Any) -> Pace:
    """Make what is asked of a stroke in time."""
    return Pace(number(table.mean_speed), None if table.output is None else float(table.output) / MINUTE)


def overlap_in(table: Any, stroke: float | None, pace: Pace) -> float | None:
    """Give the overlap rad as it is told, or as mean speed, output and stroke make it."""
    told = overlap(table)
    return pace.overlap(stroke) if told is None and stroke is not None and pace.both else told


def lever_task(table: LeverTable) -> LeverTask:
    """Make the task of an oscillating slotted link."""
    stroke, known = number(table.stroke), pace(table)
    angle = overlap_in(table, stroke, known) if table.swing is None else math.radians(table.swing)
    lengths = number(table.crank), number(table.frame), stroke, number(table.lever)
    return LeverTask(angle, *lengths, radians(table.pressure), known)


def whitworth_task(table: SlotTable) -> WhitworthTask:
    """Make the task of a rotating slotted link."""
    stroke, known = number(table.stroke), pace(table)
    lengths = number(table.crank), number(table.frame), stroke
    return WhitworthTask(overlap_in(table, stroke, known), *lengths, radians(table.pressure), known)


def sine_task(table: SineTable) -> SineTask:
    """Make the task of a sine mechanism."""
    return SineTask(float(table.stroke), pace(table))


def tangent_task(table: TangentTable) -> TangentTask:
    """Make the task of a tangent mechanism."""
    return TangentTask(number(table.stroke), radians(table.pressure), number(table.distance), table.one_sided)


def pace_faults(scene: Scene, path: Path, stroke: float | None, pace: Pace) -> Iterator[Fault]:
    """Say whether the stroke that a speed is asked of is missing, or the overlap told twice, or beyond what can be."""
    name = "output" if pace.speed is None else "mean_speed"
    if pace == Pace():
        return
    if stroke is None:
        yield scene.fault((*path, name), "synthesis_no_ram")
    elif pace.both:
        theta = pace.overlap(stroke)
        twice = [(*path, key) for key in ("overlap", "time_ratio", "swing") if scene.has((*path, key))]
        if not 0 <= theta < math.pi / 2:
            assert pace.output is not None  # both are told
            least, most = (f"{times * stroke * pace.output:.6g}" for times in (4 / 3, 2))
            yield scene.fault((*path, name), "synthesis_pace", least=least, most=most)
        elif twice:
            yield scene.fault(twice[0], "synthesis_pace_twice", overlap=degrees(theta))


def _common(scene: Scene, path: Path, task: LeverTask | WhitworthTask, driven: bool) -> Iterator[Fault]:
    """Say what is too little of a slotted link, and what contradicts itself."""
    if task.pressure is not None and not driven:
        yield scene.fault((*path, "pressure"), "synthesis_no_ram")
    yield from pace_faults(scene, path, task.stroke, task.pace)
    if not task.readings:
        yield scene.fault(path, "synthesis_lever_free" if path == LEVER else "synthesis_whitworth_free")
    elif task.overlap == 0:
        at = next((key for key in ("overlap", "time_ratio", "mean_speed") if scene.has((*path, key))), "mean_speed")
        yield scene.fault((*path, at), "synthesis_no_overlap")


def lever_faults(scene: Scene, task: LeverTask) -> Iterator[Fault]:
    """Say why no oscillating slotted link meets a task, and what one can meet."""
    if common := [*_common(scene, LEVER, task, task.driven)]:
        yield from common
    elif not met(drawn_levers(task)):
        yield _unmet(scene, task)


def _unmet(scene: Scene, task: LeverTask) -> Fault:
    if task.crank is not None and task.frame is not None and task.crank >= task.frame:
        return scene.fault((*LEVER, "crank"), "synthesis_oscillating", most=millimetres(task.frame))
    if task.stroke is not None and task.lever is not None and task.stroke >= 2 * task.lever:
        return scene.fault((*LEVER, "stroke"), "synthesis_chord", most=millimetres(2 * task.lever))
    ((design,), *_) = (one.found for one in drawn_levers(task._replace(pressure=None)))
    most = math.pi / 2 - design.design.sizes["ψ"] / 2
    return scene.fault((*LEVER, "pressure"), "synthesis_ram_pressure", most=degrees(most))


def whitworth_faults(scene: Scene, task: WhitworthTask) -> Iterator[Fault]:
    """Say why no rotating slotted link meets a task, and what one can meet."""
    if common := [*_common(scene, WHITWORTH, task, task.stroke is not None)]:
        yield from common
    elif not met(drawn_whitworths(task)):
        assert task.crank is not None  # no overlap is told, so both lengths are
        yield scene.fault((*WHITWORTH, "frame"), "synthesis_rotating", most=millimetres(task.crank))


def sine_faults(scene: Scene, task: SineTask) -> Iterator[Fault]:
    """Say nothing: any stroke has its crank."""
    return iter(())


def tangent_faults(scene: Scene, task: TangentTask) -> Iterator[Fault]:
    """Say what is too little."""
    if not task.readings:
        yield scene.fault(("synthesis", "tangent"), "synthesis_tangent_free")


def drive(made: Design, *, extreme: bool = True) -> dict[str, Any]:
    """Give the drive of the crank, as fast as it is asked to be; position 0 is where an extreme is, if there is one."""
    speed = f"{made.sizes['ω_1']!r} rad/s" if "ω_1" in made.sizes else SPEED
    return {"link": 1, "speed": speed, "start": "extreme" if extreme else 0, "positions": 12}


def slotted(made: Design) -> MechanismText:
    """Give the tables of a slotted link, with the ram that its end drives."""
    size, place = made.sizes, made.places
    lengths = {"OA": size["l_1"], "CB": size.get("l_3", size["l_0"] + size["l_1"])}  # as far as the stone comes
    end = place.get("B_1", place["A_1"])
    links, sketch = ["OA", "A", "CB"], {"A": place["A_1"], "B": end}
    slides: list[dict[str, Any]] = [{"link": 2, "along": "CB"}]
    if "l_4" in size:
        links += ["BD", "D"]
        lengths["BD"], sketch["D"] = size["l_4"], place["D_1"]
        slides.append({"link": 5, "along": {"through": complex(0, place["D"].imag), "angle": 0}})
    frame = {name: place[name] for name in "OC"}
    swings = "ψ" in size or "l_4" in size
    return MechanismText(frame, tuple(links), lengths, sketch, tuple(slides), drive(made, extreme=swings))


def sine(made: Design) -> MechanismText:
    """Give the tables of a sine mechanism: its block slides in the yoke, the yoke along the guide."""
    crank = made.sizes["l_1"]
    slides = {"link": 2, "along": {"link": 3, "angle": 90}}, {"link": 3, "along": {"through": 0j, "angle": 0}}
    return MechanismText({"O": 0j}, ("OA", "A", "B"), {"OA": crank}, {"B": complex(crank)}, slides, drive(made))


def tangent(made: Design) -> MechanismText:
    """Give the tables of a tangent mechanism; its lever stands at angles from one end of the stroke to the other."""
    place, lean = made.places, math.degrees(made.sizes["α_max"])
    least = -lean if "A_2" in place else 0.0
    angles = [least + (lean - least) * k / (STATIONS - 1) for k in range(STATIONS)]
    slides = {"link": 2, "along": "OK"}, {"link": 3, "along": {"through": 0j, "angle": 90}}
    lengths = {"OK": LONGER * abs(place["A_1"] - place["O"])}
    turned = {"link": 1, "speed": SPEED, "positions": angles}
    return MechanismText({"O": place["O"]}, ("OK", "A", "A"), lengths, {"A": place["E"]}, slides, turned)


def slotted_notes(task: LeverTask | WhitworthTask) -> Iterator[str]:
    """Name what the sheet says of a slotted link."""
    yield from _readings(task)
    yield "synthesis lever" if isinstance(task, LeverTask) else "synthesis rotating"
    if task.pressure is not None:
        yield "synthesis ram"
    yield from pace_notes(task.pace)


def sine_notes(task: SineTask) -> Iterator[str]:
    """Name what the sheet says of a sine mechanism."""
    yield "synthesis sine"
    yield from pace_notes(task.pace)


def tangent_notes(task: TangentTask) -> Iterator[str]:
    """Name what the sheet says of a tangent mechanism."""
    yield from _readings(task)
    yield "synthesis one-sided" if task.one_sided else "synthesis tangent"


def _readings(task: LeverTask | WhitworthTask | TangentTask) -> Iterator[str]:
    if len(task.readings) > 1:
        yield "synthesis choices"


def pace_notes(pace: Pace) -> Iterator[str]:
    """Name what the sheet says of speeds."""
    if pace != Pace():
        yield "synthesis pace"

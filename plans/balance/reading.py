"""The task of balancing made from the scene, its faults and its notes (задача уравновешивания)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import NamedTuple

from plans.balance.form import COUNTERWEIGHT, BalanceForm, BalanceTable, CounterweightTable
from plans.forces.reading.form import ForceForm
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.balance.linkage import FORCE, FULL, NONE, PARTIAL, SHARE, BalanceTask, Site
from plans.model.decomposition import decompose
from plans.model.dyad import Assur, Dyad
from plans.model.mechanism import FRAME, Mechanism, StructureError
from plans.scene.faults import Fault, Path
from plans.scene.notes import HUNDREDS, odd_lengths
from plans.scene.scene import Meaning, Scene
from plans.scene.units import WORKING
from plans.words.words import Message, message

LIGHTEST = 100  # kg/m3: half of cork; no metal has so many g/cm3


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's balancing."""
    form = scene.of(BalanceForm).balance
    yield from odd_lengths(scene, dict(_lengths(form)))
    yield from _heavy(scene, form)
    # Find densities that no solid weight has: a bare number of g/cm3.
    for number, weight in enumerate(form.counterweights):
        if "density" in weight.given and weight.density < LIGHTEST:
            path = ("balance", "counterweights", number, "density")
            yield scene.fault(path, "light_density", density=f"{weight.density.normalize():f}")
    if form.aim == NONE and form.counterweights:
        yield scene.fault(("balance", "counterweights"), "idle_counterweights")
    survey = scene.meaning.of(LinkageSurvey)
    if form.aim == PARTIAL and survey.mechanism is not None and not guided(survey.mechanism):
        yield scene.fault(("balance", "aim"), "nothing_guided")


def _lengths(form: BalanceTable) -> Iterator[tuple[Path, Decimal]]:
    for number, weight in enumerate(form.counterweights):
        sizes = {"radius": weight.radius, "at": weight.at, "thickness": weight.thickness}
        path: Path = ("balance", "counterweights", number)
        yield from (((*path, name), abs(size)) for name, size in sizes.items() if size and name in weight.given)


def _heavy(scene: Scene, form: BalanceTable) -> Iterator[Fault]:
    """Find counterweights a hundred times as heavy as all links together."""
    whole = sum((mass for _, mass in masses(scene)), Decimal(0))
    for number, weight in enumerate(form.counterweights):
        if weight.mass is not None and whole and weight.mass >= HUNDREDS * whole:
            ratio = f"{WORKING.divide(weight.mass, whole):.0f}"
            yield scene.fault(("balance", "counterweights", number, "mass"), "heavy_counterweight", ratio=ratio)


def carriers(mechanism: Mechanism, aim: str) -> list[int]:
    """Give the links that would do for an aim: the crank, and one of each group that needs one."""
    return [mechanism.drive.link, *(link for group in _groups(mechanism) or () for link in _of_group(group, aim))]


def reciprocating(mechanism: Mechanism) -> bool:
    """Tell whether a slider on the frame has its rod on the crank, so that the crank can balance a share of it.

    Of links that form no groups nothing is told against it: what studies the linkage says so.
    """
    groups, hosts = _groups(mechanism), (mechanism.drive.link, FRAME)
    return groups is None or any(isinstance(g, Dyad) and (g.kind, g.hosts) == ("RRP", hosts) for g in groups)


def guided(mechanism: Mechanism) -> bool:
    """Tell whether a link slides on the frame: its mass is what a partial balancing leaves."""
    return any(slide.owner == FRAME for slide in mechanism.slides)


def stated(links: Sequence[int]) -> Message:
    """Say which links would do; of a mechanism that is not known yet, which of any."""
    written = tuple(f"on = {link}" for link in links)
    return message("advice.carriers", links=written) if links else message("advice.any_carriers")


def _groups(mechanism: Mechanism) -> tuple[Assur, ...] | None:
    """Give the groups; None of links that form none."""
    try:
        return decompose(mechanism) if mechanism.mobility == 1 else None
    except StructureError:
        return None


def _of_group(group: Assur, aim: str) -> Iterator[int]:
    """Give the link of a group that would do: of two that could the one hinged to the frame."""
    if group.kind in ("RRR", "RPR"):
        ends = [pair.taker for pair in group.outer_pairs if pair.giver == FRAME]
        yield (ends or [group.links[-1 if group.kind == "RPR" else 0]])[0]
    elif group.kind == "RRP" and (aim == FULL or group.outer_pairs[1].giver != FRAME):
        yield group.links[0]


AIM: Path = ("balance", "aim")
COMMON = "S"  # the letter of the common mass centre


class BalanceSurvey(NamedTuple):
    """What the examination of a scene's balancing found: what is asked, and the faults."""

    task: BalanceTask
    faults: list[Fault]


def task_of(form: BalanceTable) -> BalanceTask:
    """Make the task."""
    sought = isinstance(form.share, str)
    share, least = (None, str(form.share)) if sought else (float(form.share), FORCE)
    return BalanceTask(form.aim, tuple(map(_place, form.counterweights)), share, least)


def _place(entry: CounterweightTable) -> Site:
    return Site(
        entry.on,
        mass=_float(entry.mass),
        radius=_float(entry.radius),
        at=_float(entry.at),
        shape=entry.shape,
        density=float(entry.density),
        thickness=float(entry.thickness),
        half_angle=math.radians(float(entry.half_angle)),
    )


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def survey_of(meaning: Meaning) -> BalanceSurvey:
    """Examine a scene's balancing."""
    survey, form = replace(meaning.of(LinkageSurvey), faults=[]), meaning.scene.of(BalanceForm).balance
    for number, weight in enumerate(form.counterweights):
        _check_carrier(survey, ("balance", "counterweights", number), weight)
    if form.aim != NONE:
        _check_aim(survey, form)
    # See that no point has the letter of the common mass centre: both stand on one scheme.
    link = next((number for number, points in survey.points_of.items() if COMMON in points), None)
    if link is not None:
        tables = ("mechanism", "frame", COMMON), ("mechanism", "points", COMMON), ("mechanism", "links", str(link))
        survey.report(next(path for path in tables if survey.scene.has(path)), "common_centre", letter=COMMON)
    check_moving(survey, ("balance",))
    return BalanceSurvey(task_of(form), survey.faults)


def _check_carrier(survey: LinkageSurvey, path: Path, entry: CounterweightTable) -> None:
    """See that a link exists, that it turns, and that it has the line that a place is told on."""
    where = (*path, "on")
    if not survey.know_link(where, entry.on):
        return
    if any(slide.owner == FRAME and slide.slider == entry.on for slide in survey.slides):
        survey.report(where, "carrier_slides", link=entry.on, advice=_would_do(survey))
    elif entry.at is not None and len(survey.points_of[entry.on]) == 1:
        survey.report((*path, "at"), "carrier_line", link=entry.on)


def _check_aim(survey: LinkageSurvey, form: BalanceTable) -> None:
    """See that something may be put on for an aim, and that a share is of masses that the crank can balance."""
    links, crank = [weight.on for weight in form.counterweights], survey.form.drive.link
    if form.aim != NONE and any(
        not isinstance(g, Dyad) for g in (survey.mechanism and _groups(survey.mechanism)) or ()
    ):
        survey.report(AIM, "not_substituted")
    elif form.aim == SHARE and survey.mechanism is not None and not reciprocating(survey.mechanism):
        survey.report(AIM, "no_reciprocating")
    elif not links:
        if not survey.doubtful(("balance", "counterweights")):
            survey.report(AIM, "no_carriers", example=COUNTERWEIGHT, advice=_would_do(survey, form.aim))
    elif form.aim == SHARE and crank not in links:
        survey.report(("balance", "counterweights"), "crank_carries", link=crank)


def _would_do(survey: LinkageSurvey, aim: str = PARTIAL) -> Message:
    return stated(carriers(survey.mechanism, aim) if survey.mechanism else [])


def check_moving(survey: LinkageSurvey, path: Path) -> None:
    """See that the crank turns, and that a moving link has a mass: nothing shakes the frame otherwise."""
    scene = survey.scene
    if survey.form.drive.omega == 0 and survey.form.drive.stroke is None:
        survey.report(("drive", "speed"), "crank_at_rest")
    if not any(mass for _, mass in masses(scene)):
        survey.report(("masses",) if scene.has(("masses",)) else path, "massless")


def masses(scene: Scene) -> Iterator[tuple[int, Decimal]]:
    """Give the links that the scene gives a mass, with the mass kg."""
    yield from ((link, mass.mass) for link, mass in scene.of(ForceForm).masses.items())

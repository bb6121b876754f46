"""Notes on balancing (замечания): what is allowed, but may well be a slip, or leaves something unused."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

from plans.balance.form import BalanceForm, BalanceTable
from plans.balance.reading import guided, masses
from plans.linkage.reading.survey import Survey
from plans.model.balance.linkage import NONE, PARTIAL
from plans.scene.faults import Fault, Path
from plans.scene.notes import HUNDREDS, odd_lengths
from plans.scene.scene import Scene
from plans.scene.units import WORKING

LIGHTEST = 100  # kg/m3: half of cork; no metal has so many g/cm3


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's balancing (row of the table of techniques)."""
    form = scene.of(BalanceForm).balance
    yield from odd_lengths(scene, dict(_lengths(form)))
    yield from _heavy(scene, form)
    yield from _light(scene, form)
    if form.aim == NONE and form.counterweights:
        yield scene.fault(("balance", "counterweights"), "idle_counterweights")
    survey: Survey = scene.meaning["linkage"]
    if form.aim == PARTIAL and survey.mechanism is not None and not guided(survey.mechanism):
        yield scene.fault(("balance", "aim"), "nothing_guided")


def _lengths(form: BalanceTable) -> Iterator[tuple[Path, Decimal]]:
    """Give the lengths m that a scene states."""
    for number, one in enumerate(form.counterweights):
        sizes = {"radius": one.radius, "at": one.at, "thickness": one.thickness}
        path: Path = ("balance", "counterweights", number)
        yield from (((*path, name), abs(size)) for name, size in sizes.items() if size and name in one.given)


def _light(scene: Scene, form: BalanceTable) -> Iterator[Fault]:
    """Find densities that no solid weight has: a bare number of g/cm3."""
    for number, one in enumerate(form.counterweights):
        if "density" in one.given and one.density < LIGHTEST:
            path = ("balance", "counterweights", number, "density")
            yield scene.fault(path, "light_density", density=f"{one.density.normalize():f}")


def _heavy(scene: Scene, form: BalanceTable) -> Iterator[Fault]:
    """Find counterweights a hundred times as heavy as all links together."""
    whole = sum((mass for _, mass in masses(scene)), Decimal(0))
    for number, one in enumerate(form.counterweights):
        if one.mass is not None and whole and one.mass >= HUNDREDS * whole:
            ratio = f"{WORKING.divide(one.mass, whole):.0f}"
            yield scene.fault(("balance", "counterweights", number, "mass"), "heavy_counterweight", ratio=ratio)

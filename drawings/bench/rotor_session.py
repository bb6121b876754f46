"""A session at the bench on a rotor: both roads and the drawn sheet, error against run time (испытание ротора)."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from drawings.bench.session import BUDGET, Order
from drawings.bench.sheet import MEASURED
from drawings.measure.measure import measure_file
from drawings.pens.svg import svg
from drawings.sheets.rotor import leaves
from plans.bench import rotor
from plans.bench.clock import interleaved
from plans.bench.computer import machine
from plans.bench.result import Bench, Row
from plans.rotor.balancing import UNBALANCES
from plans.scene.scene import Scene
from plans.study import Study

ONCE = "a rotor has no positions: --positions does nothing here"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the rotor of a scene."""
    there, study = machine(), Study(scene)
    found = study["rotor"].rotor
    true = rotor.truth(found)
    with tempfile.TemporaryDirectory(prefix="plandraft-bench-") as folder:
        ways = rotor.ways(found)
        errors = [rotor.errors(run(), true) for _, run in ways]
        errors.append(rotor.judge(_measured(scene, Path(folder)), true))
        tell("the rotor")
        runs = [*(run for _, run in ways), lambda: _measured(scene, Path(folder))]
        taken = interleaved(runs, order.rounds, BUDGET)
    names = [*(name for name, _ in ways), MEASURED]
    rows = (Row(name, None, 0, errors, times=times) for name, errors, times in zip(names, errors, taken, strict=True))
    tell("")
    return Bench(scene.heading(), there, tuple(rows), (), tuple(_words(order)), order.accepted)


def _measured(scene: Scene, folder: Path) -> dict[str, complex]:
    """Draw, write and measure the sheets; give the counterweights' static moments as they are read."""
    found: dict[str, complex] = {}
    study = Study(scene)
    planes = {one.mark.name for one in study["rotor"].drawing.corrections}
    for number, leaf in enumerate(leaves(study)):
        path = folder / f"{number}.svg"
        path.write_bytes(svg(leaf))
        vectors = [one for one in measure_file(path).vectors if one.plan == UNBALANCES and one.name in planes]
        found |= {one.name: one.value for one in vectors}
    return found


def _words(order: Order) -> Iterator[str]:
    yield rotor.DEFINED
    yield rotor.TRUE
    yield ONCE
    yield f"accepted: an error of at most {order.accepted:.0e} of the largest of its kind"
    yield f"time: wall time of one run, techniques in turns, {order.rounds} times each; a first run is not timed"

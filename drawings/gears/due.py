"""What must stand on the sheet of a gear train, by exact equations alone: velocities, speeds, ratios (лист)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

from drawings.checks.expected import NOTES, Expected, by_hand, cells
from drawings.gears import due_synthesis
from drawings.lettering.gear_letters import link_letters
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.gears import TrainSpeeds, ratio_with, speeds, velocity
from plans.gears.kutzbach import ANGULAR, LINEAR, LINES, board_of
from plans.gears.quantities import GearsComparison, tabled
from plans.gears.study import GEARS, GearsStudy, of_gear
from plans.model.gears import FRAME, BoxGear, Train
from plans.quantity import Quantity
from plans.quantity import by_hand as slipping
from plans.study import Study

DIGITS = 5
SHORT = 0.6  # mm: a shorter velocity is a point
SAME = 1e-9  # of the largest: ends that are one


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's gear train."""
    found, drafting = study.of(GearsStudy), drafting_of(study.scene)
    scales = {name: mu for leaf in leaves for name, mu in leaf.metadata["scales"].items()}
    gears = found.train.gears
    plans = (one for gear in gears for of in (_linear, _angular) for one in of(found, gear, scales))
    findings = tabled(study.of(GearsComparison))
    slips = slipping(study.comparison(GEARS).findings, scales)
    results = (row for one in findings for row in _result(one, slips, drafting))
    told = _speeds(study.of(GearsComparison).analysis), due_synthesis.expected(found)
    yield from chain(plans, results, *told, _notes(found))


def _linear(study: GearsStudy, gear: BoxGear, scales: Mapping[str, float]) -> Iterator[Expected]:
    """Give the velocities of mesh points and of planets' centres, m/s."""
    name, exact = board_of(LINEAR, gear), speeds(study.train, gear)
    for spot in (spot for spot in study.spots if spot.links[0] != FRAME):
        value = velocity(study.train, exact, spot.links[0], spot.height)
        short = abs(value) * study.plans[0].tau < SHORT * 2 * scales[board_of(LINES, gear)]
        yield Expected(Kind.VECTOR, name, f"v_{spot.letter}", complex(value), may_lack=short)


def _angular(study: GearsStudy, gear: BoxGear, scales: Mapping[str, float]) -> Iterator[Expected]:
    """Give the ends of the segments of links, rad/s; of links that turn alike the first may stand for all."""
    name, found = board_of(ANGULAR, gear), TrainSpeeds(study.train).true(gear)
    every = {link: speed for link, speed in found.items() if link not in study.train.crossing}
    largest = max(map(abs, every.values()))
    for k, (link, speed) in enumerate(every.items()):
        others = (0.0, *[*every.values()][:k])
        near = any(abs(speed - other) < SAME * largest + scales[name] for other in others)
        yield Expected(Kind.POINT, name, f"ω_{link}", complex(speed), SAME * largest, may_lack=near)
    yield Expected(Kind.PHRASE, name, f"K {name}", 1 / study.plans[0].tau / scales[name])


def label(one: Quantity, drafting: Drafting) -> str:
    """Name a quantity with its unit."""
    letters = drafting.letter(with_index(one.name))
    return f"{letters}, {drafting.word(one.unit)}" if one.unit else letters


def _result(one: Quantity, slips: Mapping[tuple[str, int], float], drafting: Drafting) -> Iterator[Expected]:
    value = float(one.analysis[0]), float(one.allowed[0])
    error = by_hand(slips.get((one.name, 0), math.nan), one.largest)
    yield from cells("results", label(one, drafting), (value, value, error), digits=DIGITS)


def _speeds(found: TrainSpeeds) -> Iterator[Expected]:
    for link in found.train.links:
        row: list[tuple[float, float] | str] = []
        for gear in found.train.gears:
            row.append((found.true(gear)[link] * 30 / math.pi, 0.0))
            row += [str(found.shares(gear)[link][0]).replace("-", "−")] if found.train.single else []
        yield from cells("speeds", link_letters(link), row, digits=DIGITS)


def _notes(study: GearsStudy) -> Iterator[Expected]:
    """Give the numbers of the notes by the names of their quantities."""
    train, numbers = study.train, dict[str, float]()
    found = TrainSpeeds(train)
    numbers |= {f"z_{name}": float(abs(wheel.teeth)) for name, wheel in train.wheels.items()}
    for module in {wheel.module for wheel in train.wheels.values()}:
        first = next(wheel for wheel in train.wheels.values() if wheel.module == module)
        numbers[f"m {first.name}"] = 1000 * float(module)
    for link, speed in train.drives:
        numbers |= {f"n_{link}": speed * 30 / math.pi, f"given ω_{link}": speed}
    for one, other in train.pairs:
        if one.side:
            both = (one, other), (other, one)
            numbers |= {f"δ_{a.name}": math.degrees(math.atan2(a.teeth, b.teeth)) for a, b in both}
            numbers[f"R_{one.name}{other.name}"] = 500 * float(one.module) * math.hypot(one.teeth, other.teeth)
            continue
        numbers[f"a_{one.name}{other.name}"] = 500 * float(one.module * abs(one.teeth + other.teeth))
    for gear in train.gears:
        ratio, speed = found.ratio(gear), found.true(gear)[train.output]
        numbers[of_gear(f"n_{train.output}", gear)] = speed * 30 / math.pi
        told = (f"ω_{train.output}", speed) if ratio is None else (study.ratio_name, float(ratio))
        numbers[of_gear(told[0], gear)] = told[1]
        numbers |= {of_gear(f"v_{rack}", gear): found.rack(gear, rack) for rack in train.racks}
        travels = {of_gear(f"h_{rack}", gear): found.travel(gear, rack) for rack in train.racks}
        numbers |= {name: travel for name, travel in travels.items() if travel is not None}
    if train.single:
        numbers |= {f"given J_{link}": size for link, size in train.inertia.items()}
        numbers |= {f"given m_{link}": size for link, size in train.masses.items()}
    for gear in (gear for gear in train.gears if study.closed(gear) or not train.single):
        numbers |= {of_gear(f"P_{one}", gear): power for one, power in TrainSpeeds(train).powers(gear).items()}
    numbers |= {"load": train.load} if train.load is not None else {}
    numbers |= {"force": study.force[1]} if study.force else {}
    yield from (Expected(Kind.PHRASE, NOTES, name, value, digits=DIGITS) for name, value in numbers.items())
    yield from _ratios(train)
    yield from _friction(study)
    yield from _planets(study)


def _friction(study: GearsStudy) -> Iterator[Expected]:
    """Give the efficiencies of meshes and of the train, and its ratios with friction, by the forces of meshes."""
    train, found = study.train, TrainSpeeds(study.train)
    first = {part: mesh for mesh, part in reversed([*train.efficiency.items()])}  # the first of those that are alike
    numbers = {f"η {'-'.join(mesh)}": float(part) for part, mesh in first.items()}
    for gear in train.gears:
        friction, ratio = found.friction(gear), found.ratio(gear)
        if friction:
            part = friction.efficiency
            numbers |= {of_gear(study.efficiency_name, gear): part} if ratio or not friction.locks else {}
            numbers |= {of_gear(f"{study.ratio_name}'", gear): part / train.slides * float(ratio)} if ratio else {}
            yield from _ratios(friction.train, of_gear("'", gear))
    yield from (Expected(Kind.PHRASE, NOTES, name, value, digits=DIGITS) for name, value in numbers.items())


def _ratios(train: Train, mark: str = "") -> Iterator[Expected]:
    """Give the ratios with a carrier stopped: speeds of the analysis over that of the carrier."""
    for one in train.willis:
        name = f"U_{one.first.name}{one.other.name}^{one.carrier}{mark}"
        value = float(ratio_with(train, one.first.link, one.other.link, one.carrier or FRAME))
        yield Expected(Kind.PHRASE, NOTES, name, value, may_lack=bool(mark), digits=DIGITS)


def _planets(study: GearsStudy) -> Iterator[Expected]:
    train = study.train
    for link, carrier in train.carrier_of.items() if (train.planets or 0) > 1 else ():
        far = float(train.heights[link] - train.heights[carrier])
        for name, row in {row.cross.name: row for row in train.crossing.get(link, ())}.items():
            cone = math.atan(row.cross.radius / row.level.radius)
            cone += math.atan2(2, abs(complex(row.cross.teeth, row.level.teeth)))
            for key, value in (("share", 180 / (train.planets or 1)), ("tip", math.degrees(cone))):
                yield Expected(Kind.PHRASE, NOTES, f"{key} {name}", value, digits=DIGITS)
        for wheel in (wheel for wheel in train.wheels.values() if wheel.link == link and not wheel.side):
            chord = 2000 * far * math.sin(math.pi / (train.planets or 1))
            yield Expected(Kind.PHRASE, NOTES, f"chord {wheel.name}", chord)
            yield Expected(Kind.PHRASE, NOTES, f"tips {wheel.name}", 1000 * float(wheel.module) * (wheel.teeth + 2))

"""A gear train by both roads: speeds of links and points by Kutzbach's plan and by exact equations (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

from geometry.board import Mark, Reading, behind
from geometry.precision import Error, errors
from plans.analytic.gears import TrainSpeeds, speeds, velocity
from plans.explanation import Explanation, NoMark, explained_by
from plans.gears.efficiency import lossy
from plans.gears.kutzbach import ANGULAR, AXIS, LINEAR, KutzbachPlan
from plans.gears.study import GEARS, GearsStudy, of_gear
from plans.gears.synthesis import listed
from plans.model.gears import Train
from plans.model.motion import Gap
from plans.quantity import Comparison, Numbers, Quantity, numbers_of
from plans.words.words import because, message

if TYPE_CHECKING:
    from plans.study import Study

DATA = 2.0  # times the bound of the record: heights and speeds that it is given are rounded themselves
TURN = 2000 * math.pi  # of a rate, to millimetres in a turn
ROUNDED = 16 * 2.0**-52  # of a sum of some squares


class GearsRoad(NamedTuple):
    """What the construction found; a train that is read has no gaps."""

    by: str = "construction"
    unanswered: tuple[Gap, ...] = ()


class GearsComparison(Comparison):
    """A gear train by both roads; its analysis tells all speeds exactly."""

    analysis: TrainSpeeds


def compare_gears(study: GearsStudy) -> GearsComparison:
    """Find the speeds of all links and points, and the ratio of each gear, by both roads."""
    found = tuple(one for plan in study.plans for one in _gear(study, plan))
    return GearsComparison(GearsRoad(), TrainSpeeds(study.train), found)


def _gear(study: GearsStudy, plan: KutzbachPlan) -> Iterator[Quantity]:
    true, bound = speeds(study.train, plan.gear), errors(*plan.speeds.values(), *plan.velocities.values())
    most = float(max(map(abs, true.values())))
    for link, mark in plan.speeds.items():
        if study.train.body_of[link] == link:  # shafts that are one have one speed
            named = ANGULAR, of_gear(f"ω_{link}", plan.gear), "rad/s"
            pair = complex(mark.point).real, float(true[link])
            yield Quantity.of(named, pair, DATA * float(bound[mark].place.max()), most, mark)
    yield from _ratio(study, plan, bound)
    yield from _racks(study, plan, bound)
    yield from _inertia(study, plan, bound)
    moments = TrainSpeeds(study.train).moments(plan.gear)
    yield from _moments(study, plan, study.train, moments)
    yield from _friction(study, plan, bound)
    spots = {spot.letter: spot for spot in study.spots}
    values = {name: velocity(study.train, true, spots[name].links[0], spots[name].height) for name in plan.velocities}
    most = max(map(abs, values.values()))
    for name, mark in plan.velocities.items():
        named, pair = (LINEAR, of_gear(f"v_{name}", plan.gear), "m/s"), (complex(mark.point).real, values[name])
        yield Quantity.of(named, pair, DATA * float(bound[mark].place.max()), most, mark)


def _inertia(study: GearsStudy, plan: KutzbachPlan, bound: Mapping[Mark, Error]) -> Iterator[Quantity]:
    """Compare the inertia reduced to the driving and to the driven link: by speeds and velocities read off the plan."""
    train, found = study.train, TrainSpeeds(study.train)
    for link in dict.fromkeys((train.drives[0][0], train.output)):
        true, over = found.inertia(plan.gear, link), plan.speeds[link]
        if true is None:
            continue
        parts = [(size, plan.speeds[one], one) for one, size in train.inertia.items()]
        parts += [(mass, plan.velocities[f"{AXIS}{one}"], one) for one, mass in train.masses.items()]
        total, off = 0.0, 0.0
        for size, mark, one in parts:
            ratio, out = _quotient(mark, over, bound)
            total += train.count(one) * size * ratio**2
            off += train.count(one) * size * 2 * abs(ratio) * out
        named = ANGULAR, of_gear(f"J_red,{link}", plan.gear), "kg*m2"
        yield Quantity.of(named, (total, true), DATA * off + ROUNDED * true, true)


def _moments(study: GearsStudy, plan: KutzbachPlan, train: Train, true: Mapping[str, float]) -> Iterator[Quantity]:
    """Compare the moments that balance the load: by virtual speeds, of the plan itself or with a held link let go."""
    most, sign = max(map(abs, true.values()), default=0.0), "fr," if train.factors else ""
    size = (train.load or 1.0) / train.slides if train.factors else train.load or 0.0
    load = -math.copysign(size, complex(plan.speeds[train.output].point).real)
    for name, links, one in study.released(plan, train) if true else ():
        driven, over = one.speeds[train.output], one.speeds[links[0]]
        if len(links) > 1:  # the shafts of a joint turn against each other
            first, last = (one.angular[link] for link in links)
            over = one.angular.join(f"ω_{name}", last, first, because("gear_apart"))
        ratio, off = _quotient(driven, over, errors(over, driven))
        named = ANGULAR, of_gear(f"M_{sign}{name}", plan.gear), "N*m"
        turned = one.angular.turn(f"M{name}", driven, -load * 1j, because("gear_virtual", link=name))
        off = DATA * abs(load) * off + ROUNDED * most
        yield Quantity.of(named, (-load * ratio, true[name]), off, most, Reading(over, turned))


def _friction(study: GearsStudy, plan: KutzbachPlan, bound: Mapping[Mark, Error]) -> Iterator[Quantity]:
    """Compare the moments with friction, and the efficiency: of what is put in, how much is taken out."""
    train, found = study.train, TrainSpeeds(study.train).friction(plan.gear)
    if not found or found.locks:
        return
    moments = {one.name: one for one in _moments(study, plan, lossy(train, plan.gear), found.moments)}
    yield from moments.values() if train.load else ()
    rows = [(-(train.load or 1.0) / train.slides, 0.0, plan.speeds[train.output])]
    for link, _ in train.drives:
        moment, speed = moments[of_gear(f"M_fr,{link}", plan.gear)], plan.speeds[link]
        sense = 1 if complex(speed.point).real > 0 else -1
        rows.append((float(moment.construction[0]) * sense, float(moment.allowed[0]), speed))
    powers = [size * abs(complex(speed.point)) for size, _, speed in rows]
    put = sum(power for power in powers if power > 0)
    off = sum(abs(m) * bound[one].place.max() + out * abs(complex(one.point)) for m, out, one in rows)
    named, ratio = (ANGULAR, of_gear(study.efficiency_name, plan.gear), ""), train.slides * (1 - sum(powers) / put)
    shown = next(iter(moments.values())).shown
    yield Quantity.of(named, (ratio, found.efficiency), DATA * float(off) / put, 1.0, shown)


def _ratio(study: GearsStudy, plan: KutzbachPlan, bound: Mapping[Mark, Error]) -> Iterator[Quantity]:
    """Compare the ratio: on the plan it is that of two segments."""
    true = TrainSpeeds(study.train).ratio(plan.gear)
    if true is None:
        return
    driving, driven = (plan.speeds[link] for link in (study.train.drives[0][0], study.train.output))
    ratio, off = _quotient(driving, driven, bound)
    turned = plan.angular.turn(f"j{driving.name}", driving, 1j, because("gear_quotient"))
    named = ANGULAR, of_gear(study.ratio_name, plan.gear), ""
    yield Quantity.of(named, (ratio, float(true)), DATA * off, abs(float(true)), Reading(driven, turned))


def _quotient(top: Mark, under: Mark, bound: Mapping[Mark, Error]) -> tuple[float, float]:
    """Give the quotient of two lengths of a plan, and how far the errors of both put it off."""
    ratio = (complex(top.point) / complex(under.point)).real
    off = bound[top].place.max() + abs(ratio) * bound[under].place.max()
    return ratio, float(off) / abs(complex(under.point))


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark of the shown plans, of the first gear that has it, or of the one that is asked for.

    Of what is let go for a moment only the plan's own marks are told, with what they rest on.
    """
    letters, _, which = name.partition(",")
    plans = [plan for plan in study.of(GearsStudy).plans if which in ("", plan.gear.name)]
    rows = [(plan, found) for plan in plans if (found := _shown(plan, letters)) is not None]
    if not rows:
        return explained_by(study.quantities(GEARS), position, name)
    plan, mark = rows[0]
    units = {plan.linear.subject: "m", plan.angular.subject: "rad/s"} if mark.step.op != "turn" else {}
    others = ", ".join(f"{letters},{one.gear.name}" for one, _ in rows[1:] if one.gear != plan.gear)
    notes = (message("gears.also", gear=plan.gear.name, names=others),) if others else ()
    return Explanation(message("explain.name", mark=name), tuple(behind(mark)), units, notes)


def _shown(plan: KutzbachPlan, letters: str) -> Mark | None:
    """Find a mark of a plan by its letters; the velocity of a point that rests ends where the point is."""
    images = {name.lower(): mark for name, mark in plan.images.items()}
    boards = (board[letters] for board in (plan.linear, plan.angular) if letters in board)
    return images.get(letters) or next(boards, None)


def _racks(study: GearsStudy, plan: KutzbachPlan, bound: Mapping[Mark, Error]) -> Iterator[Quantity]:
    """Compare the velocity of each rack, and how far it goes in a turn of the driving link: h = 2 pi v/omega."""
    found, drive = TrainSpeeds(study.train), study.train.drives[0][0]
    for spot in (spot for spot in study.spots if spot.rack):
        mark, true = plan.velocities[spot.letter], found.rack(plan.gear, spot.rack)
        named, pair = (LINEAR, of_gear(f"v_{spot.rack}", plan.gear), "m/s"), (complex(mark.point).real, true)
        yield Quantity.of(named, pair, DATA * float(bound[mark].place.max()), abs(true), mark)
        if (travel := found.travel(plan.gear, spot.rack)) is not None:
            over, turned = plan.speeds[drive], plan.linear.turn(f"h_{spot.rack}", mark, 1j * TURN, because("gear_turn"))
            ratio, off = _quotient(mark, over, bound)
            named, pair = (LINEAR, of_gear(f"h_{spot.rack}", plan.gear), "mm"), (TURN * ratio, travel)
            yield Quantity.of(named, pair, DATA * TURN * off, abs(travel), Reading(over, turned))


def tabled(found: GearsComparison) -> list[Quantity]:
    """List what the table of results tells: what turns, the ratios, and the racks."""
    racks = {f"{letter}_{rack}" for rack in found.analysis.train.racks for letter in "vh"}
    slides = [one for one in found.of(LINEAR) if one.name.partition(",")[0] in racks]
    return [one for one in (*found.of(ANGULAR), *slides) if one.analysis[0]]


def numbers(study: Study, by: str) -> Numbers:
    """Give the speeds of a train by a road; of its ratios the fractions too, which are exact."""
    found = study.of(GearsStudy)
    data = numbers_of(study.quantities(GEARS), by)
    ratios = ((gear, TrainSpeeds(found.train).ratio(gear)) for gear in found.train.gears)
    fractions = {of_gear(found.ratio_name, gear): str(ratio) for gear, ratio in ratios if ratio is not None}
    teeth = {name: abs(wheel.teeth) for name, wheel in found.train.wheels.items()}
    told = data | {"teeth": teeth, "fractions": fractions}
    told |= {"solutions": listed(found.searched)} if found.searched else {}
    return Numbers({"scene": study.scene.heading(), "by": by, GEARS: told})

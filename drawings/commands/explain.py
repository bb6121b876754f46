"""plandraft explain: the drafting steps behind a mark, in order, each with its reason."""

from __future__ import annotations

import argparse
import difflib
import re

import numpy as np

from drawings.commands.talk import noted
from drawings.files.json_text import print_json
from geometry.board import Arc, Line, Mark, at, behind
from geometry.errors import DraftError
from geometry.meet import cross
from geometry.precision import condition
from plans.linkage.drafts import Drafts
from plans.linkage.plan import Plan
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.order import ORDERS
from plans.scene.scene import read_scene

PAIR = re.compile(r"[RPF]_(?P<giver>\d+?),?(?P<taker>\d+)")  # a reaction: of the first link on the second
UNITS = {**{order.plan: order.point.unit for order in ORDERS}, "forces": "N", "lever": "m/s"}


# What a reaction rests on besides the forces: the plans that it is found over.
LEFT_OUT = "{count} steps of positions, velocities and accelerations are left out: --all tells them"


class UnknownMark(DraftError, ValueError):  # noqa: N818  (the message's own word)
    """A name that no plan of the scene has."""


def run(options: argparse.Namespace) -> int:
    """Print the steps behind a mark at one position; give the exit code."""
    study = LinkageStudy(noted(read_scene(options.scene), forces=True))
    position = _position(study, options.position)
    drafts = study.drafts((position,))
    forces, opposite = _force(study, position, options.mark)
    targets = forces or find(study, drafts, options.mark)
    steps = behind(*targets)
    if forces and not options.all:
        whole, steps = len(steps), [mark for mark in steps if mark.subject == "forces" and mark.step.op != "transfer"]
        left = LEFT_OUT.format(count=whole - len(steps)) if len(steps) < whole else ""
        opposite = "\n     ".join(filter(None, (opposite, left)))
    if options.json:
        print_json([_plain(mark) for mark in steps])
        return 0
    print(
        f"{options.mark} in position {position} (φ = {np.degrees(study.turn.phi[position]):.4f}°), {len(steps)} steps"
    )
    for number, mark in enumerate(steps, 1):
        print(f"{number:>3}. {told(mark, steps)}")
    if opposite:
        print(f"     {opposite}")
    if len(targets) > 1:
        print(_rate(options.mark, *targets))
    return 0


def _force(study: LinkageStudy, position: int, name: str) -> tuple[list[Mark], str]:
    """Find a mark of the force plan: R_34, its parts R^t_34, a load, M_bal; and say so where its opposite was found."""
    if not (study.scene.masses or study.scene.loads) or name in _letters(study):
        return [], ""
    from plans.forces.cut import indices
    from plans.forces.statics import Statics

    board = Statics(study).drafts([position]).plans.plan.board
    told = name.replace("Phi", "Φ")
    if PAIR.fullmatch(told):
        told = "R" + told[1:]  # whichever letter a sheet has for reactions
    if told in board and board[told].step.inputs:
        return [board[told]], ""
    pair = PAIR.fullmatch(told)
    opposite = f"R_{indices(int(pair['taker']), int(pair['giver']))}" if pair else ""
    if opposite in board:
        return [board[opposite]], f"{name} is the opposite of {opposite}"
    return ([board[told]], "") if told in board and told != "0" else ([], "")


def _letters(study: LinkageStudy) -> set[str]:
    return {point for link in study.mechanism.links.values() for point in link.points}


def _rate(name: str, arm: Mark, turning: Mark) -> str:
    """Say how an angular velocity or acceleration is read off: the size of the turning part over the arm."""
    along, across = at(arm.point, 0), at(turning.point, 0)
    moment = float(cross(along, across))
    unit, rate = next((order.point.unit, order.link.unit) for order in ORDERS if order.plan == turning.subject)
    sense = "at rest" if moment == 0 else "counter-clockwise" if moment > 0 else "clockwise"
    value = moment / abs(along) ** 2
    return (
        f"     {name} = {turning.name}/{arm.name} = {abs(across):.10g} {unit} / {abs(along):.10g} m = "
        f"{value:.10g} {rate}, {sense}"
    )


def _position(study: LinkageStudy, wanted: int) -> int:
    if not 0 <= wanted < len(study.turn):
        raise UnknownMark(f"position {wanted} is none of 0 to {len(study.turn) - 1}")
    if study.lost[wanted]:
        gap = next(gap for gap in study.motion(0).gaps if gap.position == wanted)
        raise UnknownMark(f"position {wanted} is a gap: {gap.reason} at {gap.where}; {gap.advice}")
    return wanted


def find(study: LinkageStudy, drafts: Drafts, name: str) -> list[Mark]:
    """Find a mark: B, v_B, a_B for points; omega_3, epsilon_3 for links; any letter of a plan such as a3 or n_BA."""
    head, _, tail = name.partition("_")
    points = {point for link in study.mechanism.links.values() for point in link.points}
    if name in points:
        return [drafts.positions.point(name)]
    if head in ("v", "a") and tail in points:
        return [_plan(drafts, head).point(tail)]
    if head in ("omega", "epsilon", "ω", "ε") and tail.isdigit() and int(tail) in study.mechanism.links:
        plan = drafts.velocities if head in ("omega", "ω") else drafts.accelerations
        if int(tail) == FRAME or int(tail) not in plan.readings:
            raise UnknownMark(f"link {tail} does not turn: {name} is 0 and rests on no step")
        return [*plan.readings[int(tail)]]
    for plan in (drafts.positions, drafts.velocities, drafts.accelerations):
        for letter in (name, name.replace("_", "")):  # a3 is written with its index lowered: a_3
            if letter in plan.board:
                return [plan.board[letter]]
    known = [*points, *(f"v_{p}" for p in points), *(f"a_{p}" for p in points)]  # forces are found before
    near = difflib.get_close_matches(name, known, 1)
    hint = f"did you mean {near[0]}? " if near else ""
    listed = ", ".join(sorted(points))
    if study.scene.masses or study.scene.loads:
        raise UnknownMark(f"no mark is named {name}: {hint}points are {listed}; also v_B, a_B, omega_3, R_12, M_bal")
    raise UnknownMark(f"no mark is named {name}: {hint}points are {listed}; also v_B, a_B, omega_3")


def _plan(drafts: Drafts, symbol: str) -> Plan:
    return drafts.velocities if symbol == "v" else drafts.accelerations


def told(mark: Mark, steps: list[Mark]) -> str:
    """Say one step: what is drawn, from which marks, where it is, how sharply it meets, and why."""
    sources = ", ".join(_named(source) for source in mark.step.inputs)
    text = f"{_named(mark)}: {mark.step.op}" + (f" ({sources})" if sources else "") + f" = {_value(mark)}"
    if mark.sharpness is not None:
        text += f", crossing at {np.degrees(np.arcsin(min(at(mark.sharpness, 0).real, 1.0))):.2f}°"
        text += f" (kappa {float(condition(mark).flat[0]):.3g})"
    return f"{text}. {mark.step.why}" if mark.step.why else text


def _named(mark: Mark) -> str:
    return f"{mark.name} [{mark.subject}]" if mark.subject != "positions" else mark.name


def _value(mark: Mark) -> str:
    unit = UNITS.get(_drawn_on(mark), "")
    if isinstance(mark.value, Line):
        return f"line through {_pair(at(mark.value.through, 0))}, direction {_pair(at(mark.value.direction, 0))}"
    if mark.is_moment:
        return f"{at(mark.point, 0).real + 0.0:.10g} N*m{_armed(mark)}"
    if isinstance(mark.value, Arc):
        return f"arc about {_pair(at(mark.value.centre, 0))}, radius {at(mark.value.radius, 0).real:.10g} {unit}"
    return f"{_pair(at(mark.value, 0))} {unit}"


def _armed(mark: Mark) -> str:
    """Tell the arm of a force's moment: the moment over the force."""
    if mark.step.op != "moment":
        return ""
    force, moment = abs(at(mark.step.inputs[2].point, 0)), abs(at(mark.point, 0))
    return f" ({force:.6g} N with an arm of {moment / force:.6g} m)" if force else ""


def _drawn_on(mark: Mark) -> str:
    """Give the plan on which a mark was drawn: what is carried over keeps its unit."""
    while mark.step.op == "transfer":
        (mark,) = mark.step.inputs
    return mark.subject


def _pair(value: complex) -> str:
    return f"({value.real + 0.0:.10g}, {value.imag + 0.0:.10g})"


def _plain(mark: Mark) -> dict[str, object]:
    return {
        "plan": mark.subject,
        "name": mark.name,
        "op": mark.step.op,
        "from": [source.name for source in mark.step.inputs],
        "value": _value(mark),
        "why": mark.step.why,
    }

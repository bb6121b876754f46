"""What is found of a cam: plain data for `solve`, the rows of its table, what a hand may be out in (числа кулачка)."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from geometry.board import Board, Mark, between
from geometry.hand_error import SlippingHand, Slopes, number_error, size_error, slopes
from plans.cam.centre.bounds import PressureBound, SlopeDiagram
from plans.cam.centre.place import SIZES as BOARD
from plans.cam.centre.place import Sizing
from plans.cam.centre.sizes import laid_end
from plans.cam.study import LAWS, PROFILE, SIZES, CamDrawing, CamStudy
from plans.model.cam import MM, RATIO, RETURN, RISE, ROLLER, Cam, dimensions
from plans.model.cam_motion import CONSTRUCTION, CamFlaw, CamFound, CamSizes, Contour, Extreme, Pressing, Shock
from plans.model.motion import Floats
from plans.quantity import SLIP, Numbers, Slipping, pairs, plain
from plans.study import Study


def numbers(study: Study, by: str) -> Numbers:
    """Give the cams of a scene by a road."""
    cams = study.of(CamStudy)
    found: Sequence[CamFound] = cams.found if by == CONSTRUCTION else study.comparison("cam").analysis.cams
    by_name = {result.cam.name: _cam(result, study.plans) for result in found}
    return Numbers({"scene": study.scene.heading(), "by": by, "cams": by_name}, any(result.flaws for result in found))


def _cam(result: CamFound, plans: Collection[str]) -> dict[str, Any]:
    contour = result.contour
    data: dict[str, Any] = {"phi": plain(contour.turned)}
    if LAWS in plans:
        travel = contour.travel
        data |= {"S": plain(travel.s), "S'": plain(travel.slope), "S''": plain(travel.bend)}
        data["peaks"] = {name: _extreme(found) for name, found in result.peaks.items()}
        data["shocks"] = [{"phi": shock.turned, "order": shock.order, "jump": shock.jump} for shock in result.shocks]
    if SIZES in plans:
        data["sizes"] = _sizes(result.sizes, result)
        data["pressure"] = {kind: _extreme(found) for kind, found in result.pressure.items()}
    if PROFILE in plans:
        data |= _profile(contour)
        data["sharpest"], data["hollow"] = _extreme(result.sharpest), _extreme(result.hollow)
        if result.pressing is not None:
            data["forces"] = _forces(result.pressing, result.cam.follower.end == ROLLER)
        data["flaws"] = [_flaw(flaw) for flaw in result.flaws]
    return data


def _sizes(sizes: CamSizes, found: CamFound) -> dict[str, Any]:
    if found.cam.translates:
        return {"roller": found.roller}
    data: dict[str, Any] = {"R0": sizes.base, "roller": found.roller}
    if found.cam.rocks:
        pivot = [sizes.pivot.real, sizes.pivot.imag]
        return data | {"L": sizes.centre, "psi0": sizes.initial, "O1": pivot, **_face(found)}
    return data | ({} if found.cam.flat else {"e": sizes.offset}) | _face(found)


def _face(found: CamFound) -> dict[str, Any]:
    return {"face": list(found.face)} if found.cam.flat else {}


def _profile(contour: Contour) -> dict[str, Any]:
    data: dict[str, Any] = {
        "pitch": pairs(contour.pitch),
        "profile": pairs(contour.profile),
        "alpha": plain(contour.pressure),
        "rho": plain(contour.radius),
        "sliding": plain(contour.sliding),
    }
    return data if contour.outer is None else data | {"outer": pairs(contour.outer)}


def _forces(pressing: Pressing, rolls: bool) -> dict[str, Any]:
    """Give what presses the follower on the cam; what a roller would wear, stuck on its pin, is not told."""
    data = {"least": _extreme(pressing.least), "most": _extreme(pressing.most), "preload": pressing.preload}
    return data if rolls else data | {"wear": _extreme(pressing.wear)}


def _extreme(extreme: Extreme | None) -> dict[str, float] | None:
    return None if extreme is None else {"value": extreme.value, "phi": extreme.turned}


def _flaw(flaw: CamFlaw) -> dict[str, Any]:
    return {"kind": flaw.kind, "from": flaw.start, "to": flaw.end, "worst": _extreme(flaw.worst)}


Moves: TypeAlias = Mapping[Mark, Slopes]


class ReadSize(NamedTuple):
    """What is read off the diagram of the sizes: its letters, the marks that it lies between, how far those move it."""

    name: str
    marks: tuple[Mark, ...]
    error: Callable[[Moves], Floats]


def cam_by_hand(
    drawing: CamDrawing, scales: Mapping[str, float], by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give what a hand may be out in the sizes that are read off their diagram, mm or degrees, by their letters.

    `scales` are those of the figures, m a mm: "sizes". S and S' are known where a ruler touches; what is given and what
    is read off other curves, has no error here.
    """
    if BOARD not in scales:
        return {}
    read = list(readings(drawing))
    hand = SlippingHand(SLIP, {BOARD: np.array([scales[BOARD]])})
    found = by(hand, *(mark for reading in read for mark in reading.marks))
    return {(reading.name, 0): float(reading.error(found)[0]) for reading in read}


def readings(drawing: CamDrawing) -> Iterator[ReadSize]:
    """Give what is read off the diagram: the place of O, and under a roller or a point the angles at its tangents."""
    sizing = drawing.sizing
    start, centre = sizing.start, sizing.centre
    if start is None or centre is None:
        return
    yield from (_rocking if sizing.cam.rocks else _translating)(sizing, start, centre)
    if not sizing.cam.flat:
        yield from _angles(drawing, sizing, start, centre)


def _translating(sizing: Sizing, start: Mark, centre: Mark) -> Iterator[ReadSize]:
    cam, ends = sizing.cam, (start, centre)
    if cam.given.base is None:
        yield _distance("R_0", start, centre)
    if not cam.flat:
        if cam.given.offset is None:
            yield ReadSize("e", ends, lambda moved: MM * number_error(moved[centre] - moved[start]))
        yield ReadSize("S_0", ends, lambda moved: MM * number_error(-1j * (moved[centre] - moved[start])))


def _rocking(sizing: Sizing, start: Mark, centre: Mark) -> Iterator[ReadSize]:
    cam, pivot = sizing.cam, sizing.origin
    assert pivot is not None  # of every rocker
    if cam.given.base is None:
        yield _level(sizing, centre) if cam.flat else _distance("R_0", start, centre)
    if cam.given.centre is None:
        yield _distance("L", pivot, centre)
    first = () if cam.flat else (start,)  # the arm of a flat rocker is drawn where it is given
    yield _turned("ψ_0", ((pivot, centre), *((pivot, end) for end in first)))


def _level(sizing: Sizing, centre: Mark) -> ReadSize:
    """Read the distance of the face from O, along the face's normal."""
    leaning = complex(SlopeDiagram(sizing.cam).leaning(np.zeros(1))[0])
    return ReadSize("R_0", (centre,), lambda moved: MM * number_error(moved[centre] / (1j * leaning)))


def _angles(drawing: CamDrawing, sizing: Sizing, start: Mark, centre: Mark) -> Iterator[ReadSize]:
    """Read the largest pressure angles at D: between DO and the way of K, which on an arc leans with the arm."""
    for kind, most in drawing.found.pressure.items():
        touches = (
            tangent.point
            for tangent in sizing.binding
            if isinstance(tangent.bound, PressureBound)
            and tangent.bound.kind == kind
            and tangent.bound.side * most.value > 0
        )
        end = next(touches, None) or _end(drawing, sizing, start, most.turned)
        arm = ((sizing.origin, end.step.inputs[0]),) if sizing.cam.rocks and sizing.origin is not None else ()
        yield _turned(f"α_{{{kind}}}", ((end, centre), *arm))


def _end(drawing: CamDrawing, sizing: Sizing, start: Mark, turned: float) -> Mark:
    """Lay K and D off at a turn of the cam, beside the diagram."""
    board, diagram = Board(BOARD), SlopeDiagram(sizing.cam)
    at = drawing.course.at(np.array([turned]))
    track = sizing.board["l"] if sizing.cam.rocks else start
    return laid_end(board, diagram, track, (at.s[0], at.slope[0]))[1]


def _distance(name: str, start: Mark, end: Mark) -> ReadSize:
    vector = np.asarray(between(start, end))
    return ReadSize(name, (start, end), lambda moved: MM * size_error(vector, moved[end] - moved[start]))


def _turned(name: str, rays: tuple[tuple[Mark, Mark], ...]) -> ReadSize:
    """Read the angle of a ray, or from the second ray to the first, degrees."""

    def turn(moved: Moves, ray: tuple[Mark, Mark]) -> Slopes:
        start, end = ray
        return np.asarray(-1j * (moved[end] - moved[start]) / np.asarray(between(start, end)))

    def error(moved: Moves) -> Floats:
        first, *others = (turn(moved, ray) for ray in rays)
        return np.asarray(np.degrees(number_error(first - sum(others))))

    return ReadSize(name, tuple(mark for ray in rays for mark in ray), error)


class Result(NamedTuple):
    """A row of the table by one road: its letters, its unit, its value in that unit; whether the scene gives it."""

    letter: str
    unit: str
    value: float
    given: bool = False
    where: str = ""  # the word for the place of a value, of one that is a place


def results(found: CamFound) -> tuple[Result, ...]:
    """List what one road found."""
    return (*_main_sizes(found), *_curvature(found), *_pressure_rows(found), *_motion(found), *_shock_rows(found))


def _main_sizes(found: CamFound) -> Iterator[Result]:
    cam, sizes = found.cam, found.sizes
    if not cam.translates:
        yield Result("R_0", "mm", MM * sizes.base, cam.given.base is not None)
    if not (cam.rocks or cam.flat or cam.translates):
        yield Result("e", "mm", MM * sizes.offset, cam.given.offset is not None)
        yield Result("S_0", "mm", MM * math.sqrt(sizes.base**2 - sizes.offset**2))
    if cam.rocks:
        yield Result("L", "mm", MM * sizes.centre, cam.given.centre is not None)
        yield Result("ψ_0", "°", math.degrees(sizes.initial))
    if found.roller:
        yield Result("r_{rol}", "mm", MM * found.roller, cam.roller is not None)
    yield Result("Ψ", "°", math.degrees(cam.lift), True) if cam.rocks else Result("H", "mm", MM * cam.lift, True)


def _curvature(found: CamFound) -> Iterator[Result]:
    """Give the least radii of curvature of the pitch curve, convex and hollow; the breadth of a face."""
    for letter, extreme in (("ρ_{min}", found.sharpest), ("ρ_{hol}", found.hollow)):
        if extreme is not None:
            yield Result(letter, "mm", MM * extreme.value)
            yield _where(found.cam, letter, extreme.turned)
    if found.cam.flat:
        yield from (Result(f"b_{side + 1}", "mm", MM * abs(far)) for side, far in enumerate(found.face))


def _pressure_rows(found: CamFound) -> Iterator[Result]:
    """Give the largest pressure angles, where there is any."""
    for kind in (RISE, RETURN) if found.cam.pressed else ():
        if kind in found.pressure:
            letter = f"α_{{{kind}}}"
            yield Result(letter, "°", math.degrees(found.pressure[kind].value))
            yield _where(found.cam, letter, found.pressure[kind].turned)


def _where(cam: Cam, letter: str, turned: float) -> Result:
    """Give the place of a value: the cam's turn in degrees, or its travel in millimetres."""
    if cam.translates:
        return Result(letter, "mm", MM * turned, where="cam travel at")
    return Result(letter, "°", math.degrees(turned), where="cam angle at")


def _motion(found: CamFound) -> Iterator[Result]:
    """Give the follower's largest velocity and acceleration; at a hard shock the acceleration has no largest value."""
    if found.cam.speed is not None:
        letters = ("ω_{max}", "ε_{max}") if found.cam.rocks else ("v_{max}", "a_{max}")
        for order, peak in enumerate(found.peaks.values(), 1):
            yield Result(letters[order - 1], _units(found.cam)[order - 1], abs(peak.value) * found.cam.speed**order)


def _shock_rows(found: CamFound) -> Iterator[Result]:
    """Give the shocks, each by its jump: of the velocity a hard one, of the acceleration a soft one."""
    for number, shock in enumerate(found.shocks):
        jumps, unit = _jump(found.cam, shock)
        letter = f"Δ{jumps}_{{{number + 1}}}"
        yield Result(letter, unit, shock.jump * (found.cam.speed or 1.0) ** shock.order)
        yield _where(found.cam, letter, shock.turned)


def _jump(cam: Cam, shock: Shock) -> tuple[str, str]:
    """Name what jumps, and its unit; without a speed it is a derivative by the cam's turn."""
    if cam.speed is None:
        bare = dimensions(cam)[shock.order]
        return ("ψ" if cam.rocks else "S") + "'" * shock.order, "" if bare == RATIO else bare
    return ("ωε" if cam.rocks else "va")[shock.order - 1], _units(cam)[shock.order - 1]


def _units(cam: Cam) -> tuple[str, str]:
    return ("rad/s", "rad/s2") if cam.rocks else ("m/s", "m/s2")

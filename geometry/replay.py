"""Replay of a record: from other givens, or in 50-digit arithmetic, which tells each step's true rounding error."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from geometry.board import Arc, Board, Line, Mark, Value, at, behind
from geometry.three_leads import GUIDE, ROD

if TYPE_CHECKING:
    import mpmath

DIGITS = 50


def redraw(marks: list[Mark], givens: Mapping[Mark, Value]) -> dict[Mark, Mark]:
    """Draw the same steps again from other givens; each old mark is answered by its new one.

    Any mark may be given: it is then where another hand has drawn it, and what rests on it is drawn from there.

    >>> board = Board("positions")
    >>> a, c = board.given("A", 0j), board.given("C", 5 + 0j)
    >>> ac = board.join("AC", a, c)
    >>> complex(redraw([ac], {c: 7j})[ac].point)
    7j
    """
    boards: dict[str, Board] = {}
    done: dict[Mark, Mark] = {}
    for mark in behind(*marks):
        board = boards.setdefault(mark.subject, Board(mark.subject))
        done[mark] = _again(board, mark, tuple(done[source] for source in mark.step.inputs), givens)
    return done


def _again(board: Board, mark: Mark, inputs: tuple[Mark, ...], givens: Mapping[Mark, Value]) -> Mark:
    step = mark.step
    if mark in givens or step.op == "given":
        return board.given(mark.name, givens.get(mark, mark.value), step.why)
    match step.op:
        case "arc":
            return board.arc(mark.name, inputs[0], step.size.real, step.why)
        case "meet":
            return board.meet(mark.name, inputs[0], inputs[1], step.side, step.why)
        case "tangent":
            return board.tangent(mark.name, inputs[0], inputs[1], float(step.size.real), step.side, step.why)
        case "settle":
            assert step.settling is not None  # of this verb alone
            return board.settle(mark.name, step.settling, inputs[:-1], inputs[-1], step.why)
        case "direct":
            return board.direct(mark.name, inputs[0], step.why)
        case "turn":
            return board.turn(mark.name, inputs[0], step.size, step.why)
        case "couple":
            return board.couple(mark.name, inputs[0], inputs[1], float(step.size.real), step.why)
        case "similar":
            return board.similar(mark.name, inputs[0], inputs[1], inputs[2], float(step.size.real), step.why)
        case _:
            verb: Callable[..., Mark] = getattr(board, step.op)
            return verb(mark.name, *inputs, why=step.why)


class _Locus(NamedTuple):
    """A line or an arc in many digits: its point, and its direction or radius."""

    point: Any
    measure: Any


def exact(marks: list[Mark], position: int = 0, givens: Mapping[Mark, Any] | None = None) -> dict[Mark, Any]:
    """Carry out the steps behind some marks in 50-digit arithmetic, by formulas of their own, at one position.

    The formulas are the plain school ones: at 50 digits they need no care, so they check the careful ones. The answer
    holds mpmath numbers for points and vectors. `givens` replaces given marks. Needs the extra `verify` (mpmath).

    >>> board = Board("positions")
    >>> a, c = board.given("A", 0j), board.given("C", 5 + 0j)
    >>> b = board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 4.0), side=+1)
    >>> complex(exact([b])[b])
    (1.8+2.4j)
    """
    mp = digits()
    done: dict[Mark, Any] = {}
    for mark in behind(*marks):
        if givens is not None and mark in givens:
            done[mark] = givens[mark]
        else:
            done[mark] = _in_digits(mp, mark, [done[source] for source in mark.step.inputs], position)
    return done


@cache
def digits() -> mpmath.MPContext:
    """Give the arithmetic of 50 digits: one for all replays, for mpmath takes long to make one."""
    import mpmath  # noqa: PLC0415  (only a replay pays for it)

    mp = mpmath.mp.clone()
    mp.dps = DIGITS
    return mp


def _in_digits(mp: mpmath.MPContext, mark: Mark, inputs: list[Any], position: int) -> Any:  # noqa: PLR0912  (a verb each)
    step = mark.step
    size = mp.mpc(at(step.size, position))
    match step.op:
        case "given":
            return _given(mp, mark.value, position)
        case "lay_off":
            return inputs[0] + inputs[1]
        case "join":
            return inputs[1] - inputs[0]
        case "parallel":
            return _Locus(inputs[0], inputs[1])
        case "square":
            return _Locus(inputs[0], mp.j * inputs[1])
        case "arc":
            return _Locus(inputs[0], size.real)
        case "turn":
            return inputs[0] * size
        case "transfer":
            return inputs[0]
        case "similar":
            return inputs[2] * inputs[0] / inputs[1] * size
        case "divide":
            return inputs[0].point + inputs[0].measure * inputs[1]
        case "close":
            return -mp.fsum(inputs)
        case "tangent":
            return _tangent(mp, inputs[1] - inputs[0], size.real, at(step.side, position).real)
        case "settle":
            return _settled(mp, mark, inputs, position)[0]
        case "direct":
            return _settled(mp, mark.step.inputs[0], inputs[1:], position)[1]
        case "moment" | "couple" | "balance":
            return _of_moments(mp, step.op, inputs, size.real)
    return _meet(mp, mark, inputs, at(step.side, position).real)


def _given(mp: mpmath.MPContext, value: Value, position: int) -> Any:
    if isinstance(value, Line):
        return _Locus(mp.mpc(at(value.through, position)), mp.mpc(at(value.direction, position)))
    if isinstance(value, Arc):
        return _Locus(mp.mpc(at(value.centre, position)), mp.mpf(at(value.radius, position).real))
    return mp.mpc(at(value, position))


def _meet(mp: mpmath.MPContext, mark: Mark, inputs: list[Any], side: float) -> Any:
    first, second = inputs
    kinds = tuple(isinstance(source.value, Arc) for source in mark.step.inputs)
    base = second.point - first.point
    if kinds == (True, True):
        distance = abs(base)
        along = (distance**2 + first.measure**2 - second.measure**2) / (2 * distance)
        height = _root(mp, first.measure**2 - along**2)
        return first.point + base / distance * (along + side * mp.j * height)
    unit = first.measure / abs(first.measure)
    if kinds == (False, True):
        foot = first.point + unit * (mp.conj(unit) * base).real
        return foot + side * unit * _root(mp, second.measure**2 - abs(second.point - foot) ** 2)
    across = (mp.conj(first.measure) * second.measure).imag
    return first.point + first.measure * (mp.conj(base) * second.measure).imag / across


def _settled(mp: mpmath.MPContext, mark: Mark, inputs: list[Any], position: int) -> tuple[Any, Any]:
    """Settle a body on its leads by Newton's method, from where it was found in floating point."""
    assert mark.step.settling is not None and mark.meeting is not None  # of this verb alone
    body, known = mark.step.settling.body, mark.step.settling.known(inputs[:-1])
    place, turn = (at(value, position) for value in (mark.point, mark.meeting.second))

    def misses(x: Any, y: Any, angle: Any) -> list[Any]:
        found, axis = [], mp.mpc(mp.cos(angle), mp.sin(angle))
        for lead, begin, way in zip(body.leads, *known, strict=True):
            arm = mp.mpc(x, y) + axis * (lead.at - body.leads[0].at) - begin
            along = way if lead.kind == GUIDE else -axis * lead.slot
            found.append((abs(arm) if lead.kind == ROD else (mp.conj(along) * arm).imag) - lead.size)
        return found

    if cmath.isnan(place):
        return mp.nan, mp.nan
    x, y, angle = mp.findroot(misses, (place.real, place.imag, cmath.phase(turn)))
    return mp.mpc(x, y), mp.mpc(mp.cos(angle), mp.sin(angle))


def _of_moments(mp: mpmath.MPContext, op: str, inputs: list[Any], size: Any) -> Any:
    if op == "moment":
        about, place, force = inputs
        return (mp.conj(place - about) * force).imag
    if op == "couple":
        arm, turning = inputs
        return (turning / arm).imag * size
    about, line, *moments = inputs
    arm = (mp.conj(line.point - about) * line.measure).imag
    return -line.measure * mp.fsum(moments) / (arm if arm else mp.nan)  # through the fulcrum it balances nothing


def _tangent(mp: mpmath.MPContext, base: Any, offset: Any, side: float) -> Any:
    reach = side * _root(mp, abs(base) ** 2 - offset**2)
    return base / (reach + mp.j * offset)


def _root(mp: mpmath.MPContext, square: Any) -> Any:
    """Root of a square that a dead centre may leave a rounding below zero; a gap is NaN."""
    return mp.sqrt(square) if square >= 0 else mp.nan

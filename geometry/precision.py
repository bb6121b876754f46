"""Precision of a record: how far rounding can have moved each mark, derived from the conditions of its steps.

A meeting magnifies an error of its loci by kappa = 1/sharpness, and adds at most 4 kappa eps L of its own, L being the
longest length it used (docs of the stable forms: geometry.meet). The bounds are carried from step to step.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Arc, Line, Mark, behind, between, held_leads
from geometry.meet import EPS

Bound = npt.NDArray[np.float64]
OWN = 4.0  # a meeting's own rounding, in kappa eps L: measured at most 0.8 for arcs, see tests/geometry


class Error(NamedTuple):
    """How far a mark can be from the exact construction: of its point, and of its direction (rad) or radius."""

    place: Bound
    turn: Bound


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, a dead centre infinite
def errors(*marks: Mark) -> dict[Mark, Error]:
    """Bound the error of each mark behind some marks, at every position, in the unit of its board.

    >>> from geometry.board import Board
    >>> board = Board("positions")
    >>> a, c = board.given("A", 0j), board.given("C", 5 + 0j)
    >>> b = board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 4.0), side=+1)
    >>> 0 < errors(b)[b].place.item() < 1e-14
    True
    """
    done: dict[Mark, Error] = {}
    for mark in behind(*marks):
        done[mark] = _RULES[mark.step.op](mark, [done[source] for source in mark.step.inputs])
    return done


def condition(mark: Mark) -> Bound:
    """Give kappa = 1/sharpness of a meeting, infinite at a dead centre."""
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 / np.asarray(mark.sharpness, dtype=float))


def _size(mark: Mark) -> Bound:
    return np.asarray(np.abs(mark.point))


def _given(mark: Mark, _: list[Error]) -> Error:
    return Error(np.zeros(1), np.zeros(1))


def _sum(mark: Mark, inputs: list[Error]) -> Error:
    total = sum((error.place for error in inputs), np.zeros(1))
    return Error(np.asarray(total + EPS * _size(mark)), np.zeros(1))


def _same(_: Mark, inputs: list[Error]) -> Error:
    return inputs[0]


def _line(mark: Mark, inputs: list[Error]) -> Error:
    along = mark.step.inputs[1]
    turn = np.where(_size(along) > 0, inputs[1].place / _size(along), 0.0)
    return Error(inputs[0].place, turn + EPS)


def _turned(mark: Mark, inputs: list[Error]) -> Error:
    return Error(np.asarray(np.abs(mark.step.size) * inputs[0].place + 2 * EPS * _size(mark)), np.zeros(1))


def _similar(mark: Mark, inputs: list[Error]) -> Error:
    image, of, shape = (_size(source) for source in mark.step.inputs)
    times = np.abs(np.asarray(mark.step.size))
    grown = shape / of * inputs[0].place + image * shape / of**2 * inputs[1].place + image / of * inputs[2].place
    return Error(np.asarray(times * grown + 3 * EPS * _size(mark)), np.zeros(1))


def _divide(mark: Mark, inputs: list[Error]) -> Error:
    circle = mark.step.inputs[0].value
    radius = circle.radius if isinstance(circle, Arc) else 0.0
    rounding = 2 * EPS * radius + EPS * _size(mark)  # of the ray, and of the stored point
    return Error(np.asarray(inputs[0].place + radius * inputs[1].place + rounding), np.zeros(1))


def _meet(mark: Mark, inputs: list[Error]) -> Error:
    loci = mark.step.inputs
    arms = [np.abs(np.asarray(ray)) for _, ray in mark.rays]
    base = np.abs(np.asarray(between(loci[0].step.inputs[0], loci[1].step.inputs[0])))
    moved = np.zeros(1)
    for locus, error, arm in zip(loci, inputs, arms, strict=True):
        moved = moved + error.place + (error.turn * arm if isinstance(locus.value, Line) else 0.0)
    longest = np.maximum(np.maximum(arms[0], arms[1]), base)
    return Error(condition(mark) * (moved + OWN * EPS * longest) + EPS * _size(mark), np.zeros(1))


def _tangent(mark: Mark, inputs: list[Error]) -> Error:
    pivot, pin = mark.step.inputs
    base = np.abs(np.asarray(between(pivot, pin)))
    moved = (inputs[0].place + inputs[1].place) / base
    return Error(condition(mark) * (moved + OWN * EPS), np.zeros(1))


def _settle(mark: Mark, inputs: list[Error]) -> Error:
    """Bound a body's place and turn by what each lead's length is out, and by what a length moves it."""
    place, turn, leads = np.zeros(1), np.zeros(1), list(held_leads(mark))
    longest = np.maximum.reduce(np.broadcast_arrays(*(np.abs(np.asarray(lead.arm)) for lead in leads), _size(mark)))
    for lead in leads:
        out = inputs[lead.begin].place + OWN * EPS * longest
        if lead.way is not None:
            out = out + inputs[lead.way].place * np.abs(lead.arm)
        place, turn = place + np.abs(lead.shift) * out, turn + np.abs(lead.spin) * out
    return Error(np.asarray(place + EPS * _size(mark)), np.asarray(turn + EPS))


def _direct(mark: Mark, inputs: list[Error]) -> Error:
    return Error(inputs[0].turn, np.zeros(1))


def _moment(mark: Mark, inputs: list[Error]) -> Error:
    about, at, force = mark.step.inputs
    arm, size = np.abs(np.asarray(between(about, at))), _size(force)
    moved = inputs[0].place + inputs[1].place + EPS * np.maximum(_size(about), _size(at))
    # Each of the two products is rounded, and they are as large as arm times force though they may cancel.
    return Error(np.asarray(size * moved + arm * inputs[2].place + 2 * EPS * arm * size), np.zeros(1))


def _couple(mark: Mark, inputs: list[Error]) -> Error:
    arm, turning = mark.step.inputs
    times, size, part = abs(complex(mark.step.size)), _size(arm), _size(turning)
    moved = (inputs[1].place + part / size * inputs[0].place) / size
    return Error(np.asarray(times * (moved + 4 * EPS * part / size)), np.zeros(1))


def _balance(mark: Mark, inputs: list[Error]) -> Error:
    about, line, *moments = mark.step.inputs
    start = line.step.inputs[0]
    arm, size = np.abs(np.asarray(between(about, start))), _size(mark)
    of_each = (np.broadcast_to(_size(moment), np.shape(size)) for moment in moments)
    largest = np.maximum.reduce([np.zeros(np.shape(size)), *of_each])
    grown = sum((error.place for error in inputs[2:]), np.zeros(1)) + len(moments) * EPS * largest
    moved = inputs[0].place + inputs[1].place + EPS * np.maximum(_size(about), _size(start))
    rounding = condition(mark) * (moved / arm + inputs[1].turn + OWN * EPS) + inputs[1].turn
    return Error(np.asarray(condition(mark) * grown / arm + size * rounding), np.zeros(1))


_RULES: dict[str, Callable[[Mark, list[Error]], Error]] = {
    "given": _given,
    "lay_off": _sum,
    "join": _sum,
    "close": _sum,
    "transfer": _same,
    "arc": _same,
    "parallel": _line,
    "square": _line,
    "turn": _turned,
    "similar": _similar,
    "divide": _divide,
    "meet": _meet,
    "tangent": _tangent,
    "settle": _settle,
    "direct": _direct,
    "moment": _moment,
    "couple": _couple,
    "balance": _balance,
}

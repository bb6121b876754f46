"""The true crank angle of an extreme position, in 60 digits, near the one that a road tells."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import Any

import numpy as np

from plans.analytic.kinematics import Analysis
from plans.model.mechanism import FRAME, Mechanism, Output
from tests.trials.judge import EPS, MP, Answers, Case, Lost, answers, case, guess, roundings, solved

ROUNDS = 8  # of Newton, each doubling the digits


def off(mechanism: Mechanism, out: Output, phi: float) -> float:
    """Give how far a crank angle, rad, is from the rest next to it, in roundings of the data and of the angle."""
    mechanism = replace(mechanism, drive=mechanism.drive._replace(omega=1.0, epsilon=0.0))
    posed = Analysis(mechanism, first=False).motion(np.array([phi]))
    true = MP.mpf(phi)
    for _ in range(ROUNDS):
        own = case(mechanism, MP.expj(true), phi)
        q = solved(own, guess(own, posed, mechanism, 0))
        speed, growth = _rates(mechanism, out, _told(own, q))
        true -= speed / growth
        if abs(speed / growth) < MP.mpf(10) ** -30:
            break
    else:
        raise Lost("no rest is near")
    one = roundings(own, q)[_key(mechanism, out, 1)] / abs(float(growth)) + 2 * pi * EPS
    return abs(float(true - MP.mpf(phi))) / one


def _told(own: Case, q: Any) -> Answers:
    return answers(own, [MP.mpc(z) for z in own.data], q)


def _key(mechanism: Mechanism, out: Output, order: int) -> tuple[str, str]:
    """Name what tells how the output moves: the rate of a link, or how fast a slider goes along the frame's guide."""
    if _guide(mechanism, out) is None:
        return ("angle", "omega", "epsilon")[order], str(out.link)
    return ("r", "v", "a")[order], next(iter(mechanism.links[out.link].points))


def _guide(mechanism: Mechanism, out: Output) -> complex | None:
    ways = (s.way(FRAME).direction for s in mechanism.slides if {s.slider, s.owner} == {FRAME, out.link})
    return next(ways, None)


def _rates(mechanism: Mechanism, out: Output, told: Answers) -> tuple[Any, Any]:
    """Give the output's speed and what it gains, the crank turning at 1 rad/s."""
    speed, growth = (told[_key(mechanism, out, order)] for order in (1, 2))
    way = _guide(mechanism, out)
    if way is None:
        return speed, growth
    return (speed * MP.conj(MP.mpc(way))).real, (growth * MP.conj(MP.mpc(way))).real

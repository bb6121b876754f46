"""The whole force and moment of the bank over a turn: every mechanism drawn with its crank where it stands then."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from plans.bank.shaking import Shaking, Source
from plans.model.balance.bank import EPS, ROUNDING, STEPS, Member
from plans.model.motion import Complexes, Floats
from plans.rotor.heading import heading


class Whole(NamedTuple):
    """Force N and moment N*m of the bank over STEPS + 1 even positions of a turn, and how far each can be out."""

    phi: Floats  # (STEPS + 1,) rad
    force: Complexes
    moment: Complexes
    force_slack: float
    moment_slack: float
    largest: float  # N: of one mechanism
    largest_moment: float  # N*m: of one mechanism


def whole(source: Source, members: Sequence[Member]) -> Whole:
    """Add the forces of all mechanisms, and their moments about the plane of place 0."""
    found = {phase: source.shaking(phase, STEPS) for phase in {one.phase % 360 for one in members}}
    shares = [found[one.phase % 360] for one in members]
    force = [heading(one.axis) * share.force for one, share in zip(members, shares, strict=True)]
    places = [float(one.place) for one in members]
    moment = [place * each for place, each in zip(places, force, strict=True)]
    slacks = [_slack(source, share) for share in shares]
    lever = sum(abs(place) * slack for place, slack in zip(places, slacks, strict=True))
    phi = 2 * np.pi * np.arange(STEPS + 1) / STEPS
    largest = [float(np.max(np.abs(rows))) for rows in (force, moment)]
    return Whole(phi, _round(force), _round(moment), sum(slacks), lever, *largest)


def _slack(source: Source, share: Shaking) -> float:
    """Give how far one mechanism's force can be out anywhere, with the roundings of a sum."""
    largest = max(source.scale, float(np.max(np.abs(share.force))))
    return float(np.max(share.slack)) + ROUNDING * EPS * largest


def _round(terms: Sequence[Complexes]) -> Complexes:
    """Add the terms and close the turn."""
    total = np.sum(terms, axis=0)
    return np.concatenate([total, total[:1]])

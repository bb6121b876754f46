"""What the judge says of both roads: their errors in roundings of the data (приговор)."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from fractions import Fraction
from random import Random
from typing import Any, NamedTuple

import numpy as np

from geometry.errors import DraftError
from plans.linkage.quantities import MotionComparison, compare
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Mechanism
from plans.model.motion import LINK_ORDERS, POINT_ORDERS, Motion
from plans.scene.scene import parse_scene
from tests.trials.judge import MP, Case, Lost, answers, case, guess, roundings, solved
from tests.trials.rests import off
from tests.trials.trial import text_of

POSITIONS = 2  # judged of every scene
BORNE = 10.0  # roundings of the data: what an answer may be off
KEYS = (*POINT_ORDERS, *LINK_ORDERS)
EXTREME = "extreme"


class Judgement(NamedTuple):
    """The worst error of one road in one kind of quantity at one position, in roundings of the data."""

    kind: str
    number: int
    position: int
    road: str
    key: str  # "v", "epsilon"; "nothing" where the judge found no solution near the road's
    name: str  # of the point or link
    roundings: float
    kappa: float  # condition of the analysis's Jacobian there


def judged(kind: str, number: int) -> list[Judgement]:
    """Judge some positions of one scene; those that a road gives up are not judged, they are the trial's matter."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            study = LinkageStudy(parse_scene(text_of(kind, number)))
            comparison = compare(study)
        except DraftError:
            return []
        rows = [*comparison.construction.rows(), *comparison.analysis.rows()]
        whole = np.flatnonzero(
            np.all([np.isfinite(np.broadcast_to(r, len(study.turn))) for r in rows], axis=0)
        ).tolist()
        chosen = sorted(Random(number).sample(whole, min(POSITIONS, len(whole))))
        found = [Judgement(kind, number, k, *told) for k in chosen for told in _at(study, comparison, k)]
        return found + [Judgement(kind, number, 0, *told) for told in _extremes(study, comparison)]


def _at(
    study: LinkageStudy, comparison: MotionComparison, position: int
) -> Iterator[tuple[str, str, str, float, float]]:
    """Judge both roads at one position, each by the solution nearest to it."""
    phi = max(abs(float(study.turn.phi[k])) for k in (0, position))  # a position counted on from the first
    own, kappa = case(study.mechanism, _direction(study, position), phi), float(comparison.kappa[position])
    for road in (comparison.construction, comparison.analysis):
        try:
            apart = errors(own, road, study.mechanism, position)
        except Lost:
            yield road.by, "nothing", "", np.inf, kappa
            continue
        for key in KEYS:
            name = max((n for k, n in apart if k == key), key=lambda n: apart[key, n])
            yield road.by, key, name, apart[key, name], kappa


def errors(own: Case, road: Motion, mechanism: Mechanism, position: int) -> dict[tuple[str, str], float]:
    """Tell how far a road's answers at one position are off, in roundings of the data."""
    found = solved(own, guess(own, road, mechanism, position))
    true, one = answers(own, [MP.mpc(z) for z in own.data], found), roundings(own, found)
    return {key: float(abs(MP.mpc(_read(road, key, position)) - true[key])) / one[key] for key in true}


def _extremes(study: LinkageStudy, comparison: MotionComparison) -> Iterator[tuple[str, str, str, float, float]]:
    """Judge the extreme positions of the output by both roads."""
    roads = {"construction": study.extreme_positions.extremes if study.extreme_positions else None}
    roads["analysis"] = comparison.road.extremes(study.output) if study.extreme_positions else None
    for road, told in roads.items():
        for name, phi in zip(("start", "end"), told.phi if told else (), strict=False):
            try:
                wrong = off(study.mechanism, study.output, phi)
            except Lost:
                wrong = np.inf
            yield road, EXTREME, name, wrong, np.nan


def _direction(study: LinkageStudy, position: int) -> Any:
    """Give the crank's direction as the scene means it: listed, or a share of a turn from the first position."""
    drive = study.form.drive
    if isinstance(drive.positions, tuple):
        return _turned(Fraction(drive.positions[position]) / 360)
    share = Fraction(study.sense * position, drive.positions)
    if drive.first is not None:
        return _turned(Fraction(drive.first) / 360 + share)
    first = MP.mpc(complex(study.turn.directions[0]))  # an extreme position is where it was found
    return first / abs(first) * _turned(share)


def _turned(share: Fraction) -> Any:
    return MP.expjpi(2 * MP.mpf(share.numerator) / share.denominator)


def _read(road: Motion, key: tuple[str, str], position: int) -> complex:
    """Read a quantity off a road; of a link's direction its unit vector."""
    kind, name = key
    owner: Any = road.points[name] if kind in POINT_ORDERS else road.links[int(name)]
    value = complex(getattr(owner, kind)[position])
    return complex(MP.expj(MP.mpf(value.real))) if kind == "angle" else value

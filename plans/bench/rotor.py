"""Both roads to a balanced rotor, timed and judged against sums in 50 digits of exact places and angles (эталон)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from geometry.replay import DIGITS
from plans.analytic.rotor import balance
from plans.bench.error import Errors
from plans.bench.truth import REACTION, digits
from plans.model.rotor import Balance, Rotor
from plans.rotor.bearings import BEARINGS
from plans.rotor.letters import unbalance_letters
from plans.rotor.study import RotorStudy

CONSTRUCTED, ANALYSED = "construction: polygons", "analysis: sums"
STATIC = "mD"  # the kind of a static moment
DEFINED = (
    "error: the largest difference from the truth of the counterweights' static moments, in shares of the largest "
    "static moment of their polygon; of the reactions, in shares of the largest one"
)
TRUE = f"truth: sums in {DIGITS} digits of the static moments as they are read, at exact angles and places"
Truth = Mapping[str, tuple[complex, complex]]  # by its name what float64 holds, and the rest


def ways(rotor: Rotor) -> list[tuple[str, Callable[[], Balance]]]:
    """List the roads; each begins anew with every run."""
    return [(CONSTRUCTED, lambda: RotorStudy(rotor).balance), (ANALYSED, lambda: balance(rotor))]


def truth(rotor: Rotor) -> Truth:
    """Find the counterweights and the reactions before any correction in many digits."""
    mp = digits()
    loads = [(_moment(mp, one.moment, one.angle), one.place) for one in rotor.masses]
    found = {
        unbalance_letters(plane.name): _shared(mp, loads, plane.place, [p.place for p in rotor.planes])
        for plane in rotor.planes
    }
    if rotor.bearings and rotor.speed is not None:
        square = mp.mpf(rotor.speed) ** 2
        for name, place in zip(BEARINGS, rotor.bearings, strict=True):
            found[f"R_{name}"] = square * _shared(mp, loads, place, rotor.bearings)
    near = {name: complex(value) for name, value in found.items()}
    return {name: (near[name], complex(value - near[name])) for name, value in found.items()}


def errors(found: Balance, true: Truth) -> Errors:
    """Judge what a road has found."""
    values = {unbalance_letters(one.plane.name): one.moment.value for one in found.corrections}
    values |= {f"R_{name}": one.value for name, one in zip(BEARINGS, found.before, strict=False)}
    return judge(values, true)


def judge(values: Mapping[str, complex], true: Truth) -> Errors:
    """Give the largest errors of some values by their kinds, each in shares of the largest of its kind."""
    kinds: dict[str, float] = {}
    worst = ""
    for name, value in values.items():
        kind = REACTION if name.startswith("R_") else STATIC
        most = max((abs(near) for other, (near, _) in true.items() if other.startswith("R_") == (kind == REACTION)))
        near, rest = true[name]
        share = abs((value - near) - rest) / most if most else 0.0
        worst = name if share > max(kinds.values(), default=-1.0) else worst
        kinds[kind] = max(kinds.get(kind, 0.0), share)
    return Errors(kinds, worst)


def _moment(mp: Any, size: float, angle: Fraction) -> Any:
    share = mp.mpf(angle.numerator) / angle.denominator / 180
    return mp.mpf(size) * mp.expjpi(share)


def _shared(mp: Any, loads: Sequence[tuple[Any, Fraction]], here: Fraction, places: Sequence[Fraction]) -> Any:
    """Give what balances vectors at a place, by moments about the other one, or all of it where there is no other."""
    others = [place for place in places if place != here]
    shares = [(place - others[0]) / (here - others[0]) if others else Fraction(1) for _, place in loads]
    terms = [load * share.numerator / mp.mpf(share.denominator) for (load, _), share in zip(loads, shares, strict=True)]
    return -mp.fsum(terms)

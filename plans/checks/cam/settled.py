"""One place for each extreme: where a cam has the same extreme at several, both roads name that of the construction."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from plans.analytic.cam.contact import forces_of
from plans.analytic.cam.contour import Curve
from plans.model.cam_motion import CamFound, Extreme, Flaw, Pressing
from plans.model.motion import Floats

EQUAL = 1e-9  # of an extreme value: what is as large is another place of the same extreme
NEAR = 1e-6  # of the turn: a place where something is level is known to half of the digits
Value = Callable[[Curve], Floats]


def settled(theirs: CamFound, ours: CamFound) -> CamFound:
    """Give what the analysis found with each extreme where the construction has it, if it finds it as large there."""
    pressure = {
        kind: _settled(theirs, one, ours.pressure.get(kind), lambda curve: curve.pressure)
        for kind, one in theirs.pressure.items()
    }
    same = [one.kind for one in theirs.flaws] == [one.kind for one in ours.flaws]
    pairs = zip(theirs.flaws, ours.flaws, strict=True) if same else ()
    return replace(
        theirs,
        pressure={kind: one for kind, one in pressure.items() if one is not None},
        sharpest=_settled(theirs, theirs.sharpest, ours.sharpest, lambda curve: curve.radius),
        hollow=_settled(theirs, theirs.hollow, ours.hollow, lambda curve: curve.radius),
        flaws=tuple(_flaw(theirs, *pair) for pair in pairs) if same else theirs.flaws,
        pressing=_pressing(theirs, ours),
    )


def _pressing(theirs: CamFound, ours: CamFound) -> Pressing | None:
    """Give the contact's forces so: under a steady load they are as large in many places of a dwell."""
    own, other = theirs.pressing, ours.pressing
    forces = forces_of(theirs.cam, theirs.roller)
    if own is None or other is None or forces is None:
        return own
    return own._replace(
        least=_settled(theirs, own.least, other.least, forces.normal) or own.least,
        most=_settled(theirs, own.most, other.most, forces.normal) or own.most,
        wear=_settled(theirs, own.wear, other.wear, forces.wear) or own.wear,
    )


def _settled(found: CamFound, own: Extreme | None, ours: Extreme | None, value: Value) -> Extreme | None:
    """Give an extreme at the other place, if it is as large there; a pressure angle may have the other sign."""
    if own is None or ours is None:
        return own
    for there in _sides(found, ours.turned, value):
        if math.isclose(abs(there), abs(own.value), rel_tol=EQUAL) and there * ours.value > 0:
            return Extreme(there, ours.turned)
    return own


def _sides(found: CamFound, turned: float, value: Value) -> list[float]:
    """Give a value after a turn of the cam and before it."""
    curves = (Curve(found.cam, found.sizes, np.array([turned]), before) for before in (False, True))
    return [float(value(curve)[0]) for curve in curves]


def _flaw(found: CamFound, own: Flaw, ours: Flaw) -> Flaw:
    """Give a flaw with its worst place so: of one by its radius anywhere, of others only hard by."""
    turned, near = ours.worst.turned, NEAR * found.cam.turn
    beside = abs(turned - own.worst.turned) <= near
    radii = _sides(found, turned, lambda curve: curve.radius) if own.kind in ("undercut", "hollow") else []
    equal = any(math.isclose(abs(one), abs(own.worst.value), rel_tol=EQUAL) for one in radii)
    return own._replace(worst=own.worst._replace(turned=turned)) if beside or equal else own

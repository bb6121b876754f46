"""The self-check of the figure of a profile: its points, normals, sizes and phases against the analysis (проверка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.profile_view import NAME
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredMark
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts
from drawings.report.phase_letters import phase_letter
from plans.model.cam_motion import CamFound
from plans.model.motion import Complexes

FAR = 1e-9  # of a length: both roads take it from one law
LENGTHS = ("R_0", "ρ_min")  # sizes that are drawn in a direction of the figure's own


def wrong_marks(measured: Measured, leaf: Leaf, found: CamFound, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the figure of a profile against what the analysis found of its cam at the numbered positions."""
    places, vectors = points(found), normals(found)
    yield from _held(measured, measured.points, places)
    yield from _held(measured, (one for one in measured.vectors if one.position is not None), vectors)
    yield from _sizes(measured, found)
    yield from _phases(leaf, found, drafting)


def points(found: CamFound) -> Mapping[str, Complexes]:
    """Give the points of the numbered positions by their letters, (N,) m."""
    cam, own = found.cam, found.contour
    back = np.ones(len(own.turned)) if cam.translates else np.exp(-1j * cam.sense * own.turned)
    division = cam.sense * found.sizes.offset + 1j * own.tip.imag if cam.flat else own.tip
    curve = "P" if found.roller > 0 else "Q"
    return {curve: own.pitch, "K": np.asarray(division), "O_1": np.asarray(found.sizes.pivot * back)}


def normals(found: CamFound) -> Mapping[str, Complexes]:
    """Give what leads from the roller's centre to the profile, (N,) m; a follower without a roller has none."""
    return {"Q": np.asarray(found.contour.profile - found.contour.pitch)} if found.roller > 0 else {}


def _held(measured: Measured, marks: Iterable[MeasuredMark], true: Mapping[str, Complexes]) -> Iterator[Wrong]:
    """Hold the marks of numbered positions: each is where the analysis has it, and the first of a curve is there."""
    own = [one for one in marks if one.plan == NAME and one.position is not None]
    for one in own:
        spot = dict(enumerate(true.get(one.name, ()))).get(one.position or 0)
        if spot is None:
            yield on("stranger_on", NAME, name=f"{one.name} {one.position}")
        elif not abs(one.value - spot) <= _slack(measured, one):
            yield on("differs_at", NAME, name=one.name, position=one.position)
    seen = {one.name for one in own if one.position == 0}
    yield from (on("missing_on", NAME, name=f"{name} 0") for name in ("P", "Q") if name in true and name not in seen)


def _sizes(measured: Measured, found: CamFound) -> Iterator[Wrong]:
    """Hold the sizes that are drawn, and a rocker's pivot, which must be."""
    sizes, sharpest = found.sizes, found.sharpest
    true = {"R_0": complex(sizes.base), "e": complex(found.cam.sense * sizes.offset), "L": sizes.pivot}
    true |= {"O_1": sizes.pivot} | ({"ρ_min": complex(abs(sharpest.value))} if sharpest else {})
    own = {one.name: one for one in measured.marks if one.plan == NAME and one.position is None}
    for name, one in own.items():
        value = abs(one.value) if name in LENGTHS else one.value
        if name not in true:
            yield on("stranger_on", NAME, name=name)
        elif not abs(value - true[name]) <= _slack(measured, one):
            yield on("differs_on", NAME, name=name)
    due = ("O_1", "L") if sizes.pivot else ()
    yield from (on("missing_on", NAME, name=name) for name in due if name not in own)


def _slack(measured: Measured, one: MeasuredMark) -> float:
    """Give how far rounding on paper and in arithmetic can have moved a mark, m."""
    return float(2 * measured.quantum * one.scale + FAR * abs(one.value))


def _phases(leaf: Leaf, found: CamFound, drafting: Drafting) -> Iterator[Wrong]:
    """See that every phase bears its letter with its angle."""
    written = [text.plain for text in texts(leaf.groups)]
    for number in range(len(found.cam.phases)):
        letter = Text(0j, phase_letter(found.cam, number, drafting)).plain
        if letter not in written:
            yield on("missing_on", NAME, name=letter)

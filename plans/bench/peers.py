"""The peers: pylinkage and mechanism on the same four-bar, the only place where they are imported.

Both solve a crank with one RRR dyad and coupler points: what each can state in its own words, and no other scene.
"""

from __future__ import annotations

import cmath
import math
import warnings
from collections.abc import Callable, Mapping
from importlib.metadata import version
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np

from plans.bench.trial import NOT_INSTALLED
from plans.linkage.study import LinkageStudy
from plans.model.dyad import Dyad
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, LinkMotion, Motion, PointMotion

PYLINKAGE, MECHANISM = "pylinkage", "mechanism"
NEEDED = {PYLINKAGE: ("pylinkage", "numba"), MECHANISM: ("mechanism",)}
NOT_FOUR_BAR = "left out: no four-bar (a crank and one RRR dyad on the frame)"
GAPPED = "left out: some positions cannot be assembled, at which a peer stops"


class FourBar(NamedTuple):
    """A crank OA, a coupler AB with its points, a rocker CB; places from O, lengths m, points in the coupler's frame.

    `coupler` is the coupler's vector AB in its own frame, `rocker` the rocker's CB in its own.
    """

    letters: tuple[str, str, str, str]  # O, A, B, C
    links: tuple[int, int, int]
    crank: complex
    coupler: complex
    rocker: complex
    base: complex
    points: Mapping[str, complex]  # from A, in the direction of AB


class Peer(NamedTuple):
    """A peer ready to run: `run` is timed, `motion` reads its results and is not."""

    name: str
    run: Callable[[], Any]
    motion: Callable[[Any], Motion]

    @property
    def versions(self) -> str:
        """Its version, and those of what makes it fast."""
        return ", ".join(f"{library} {version(library)}" for library in NEEDED[self.name])


def four_bar(study: LinkageStudy) -> FourBar | None:
    """See the mechanism as a four-bar with coupler points; None if it is anything else."""
    mechanism, groups = study.mechanism, study.groups
    drive, links = mechanism.drive, mechanism.links
    dyad = groups[0] if len(groups) == 1 else None
    if not isinstance(dyad, Dyad) or mechanism.slides or set(dyad.hosts) != {drive.link, FRAME}:
        return None
    moved = dyad.hosts.index(drive.link)
    coupler, rocker = dyad.links[moved], dyad.links[1 - moved]
    a, c, b = dyad.hinge(moved), dyad.hinge(1 - moved), dyad.pin
    if a != drive.end or len(links[drive.link].points) > 2 or len(links[rocker].points) > 2:
        return None
    spots = links[coupler].points
    span = spots[b] - spots[a]
    points = {name: (place - spots[a]) / span * abs(span) for name, place in spots.items() if name not in (a, b)}
    return FourBar(
        (drive.pivot, a, b, c), (drive.link, coupler, rocker),
        links[drive.link].points[a] - links[drive.link].points[drive.pivot], span,
        links[rocker].points[b] - links[rocker].points[c],
        links[FRAME].points[c] - links[FRAME].points[drive.pivot], points,
    )  # fmt: skip


def peers(study: LinkageStudy) -> tuple[list[Peer], dict[str, str]]:
    """Make the peers ready for a study's positions; say of each that is left out why it is."""
    found = four_bar(study)
    if found is None or study.lost.any():
        return [], dict.fromkeys(NEEDED, NOT_FOUR_BAR if found is None else GAPPED)
    ready, out = [], {}
    for name, make in ((PYLINKAGE, _pylinkage), (MECHANISM, _mechanism)):
        if not all(find_spec(library) for library in NEEDED[name]):
            out[name] = NOT_INSTALLED
        else:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # theirs, at import
                ready.append(make(study, found))
    return ready, out


def _pylinkage(study: LinkageStudy, bar: FourBar) -> Peer:
    from pylinkage.actuators import Crank  # noqa: PLC0415  (only a bench with peers pays for them)
    from pylinkage.components import Ground  # noqa: PLC0415
    from pylinkage.dyads import FixedDyad, RRRDyad  # noqa: PLC0415
    from pylinkage.simulation import Linkage  # noqa: PLC0415

    count, drive = len(study.turn), study.mechanism.drive
    first = complex(study.motion(0).points[bar.letters[2]].r[0])  # pylinkage must be shown the assembly
    o, c = Ground(0.0, 0.0, name="O"), Ground(bar.base.real, bar.base.imag, name="C")
    step, start = study.sense * 2 * math.pi / count, float(study.turn.phi[0])
    crank = Crank(anchor=o, radius=abs(bar.crank), angular_velocity=step, initial_angle=start, name="A")
    lengths = abs(bar.coupler), abs(bar.rocker)
    b = RRRDyad(crank.output, c, *lengths, x=first.real, y=first.imag, name="B")
    ends = [FixedDyad(crank.output, b, abs(p), cmath.phase(p), name=name) for name, p in bar.points.items()]
    linkage = Linkage([o, c, crank, b, *ends], name="four-bar")
    linkage.set_input_velocity(crank, drive.omega, drive.epsilon)
    linkage.compile()

    def read(found: Any) -> Motion:
        # The crank steps before it is solved: the last of the turn is the first position.
        r, v, a = (np.roll(values[..., 0] + 1j * values[..., 1], 1, axis=0) for values in found)
        names = (bar.letters[1], bar.letters[2], *bar.points)
        points = {name: PointMotion(row[:, k] for row in (r, v, a)) for k, name in enumerate(names, 2)}
        return Motion(PYLINKAGE, study.turn.phi, points, {}, ())

    return Peer(PYLINKAGE, lambda: linkage.step_fast_with_kinematics(count), read)


def _mechanism(study: LinkageStudy, bar: FourBar) -> Peer:
    from mechanism import Mechanism, Vector, get_joints  # noqa: PLC0415

    names = (*bar.letters, *bar.points)
    joints = dict(zip(names, get_joints(" ".join(names)), strict=True))
    o, a, b, c = (joints[letter] for letter in bar.letters)
    crank, coupler = Vector((o, a), r=abs(bar.crank)), Vector((a, b), r=abs(bar.coupler))
    rocker = Vector((c, b), r=abs(bar.rocker))
    frame = Vector((o, c), r=abs(bar.base), theta=cmath.phase(bar.base))
    ends = [(Vector((a, joints[name]), r=abs(place)), cmath.phase(place)) for name, place in bar.points.items()]

    def loop(x: Any, given: Any) -> Any:
        for end, angle in ends:  # a coupler point turns with the coupler: only its angle is another
            end(x[0] + (angle if coupler.get == coupler.pos.get else 0.0))
        return crank(given) + coupler(x[0]) - rocker(x[1]) - frame()

    drive, phi, ones = study.mechanism.drive, study.turn.phi, np.ones(len(study.turn))
    made = Mechanism(
        vectors=[crank, coupler, rocker, frame, *(vector for vector, _ in ends)], origin=o, loops=loop,
        pos=phi, vel=drive.omega * ones, acc=drive.epsilon * ones, guess=_guess(study, bar),
    )  # fmt: skip

    def run() -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # fsolve's, of slow progress
            made.iterate()

    def read(_: Any) -> Motion:
        points = {name: _point(joint) for name, joint in joints.items()}
        spans = zip(bar.links[1:], (coupler, rocker), (bar.coupler, bar.rocker), strict=True)
        return Motion(MECHANISM, phi, points, {number: _link(vector, span) for number, vector, span in spans}, ())

    return Peer(MECHANISM, run, read)


def _guess(study: LinkageStudy, bar: FourBar) -> tuple[Floats, ...]:
    """Give mechanism the best guesses there are for its first position: coupler's and rocker's angles and rates."""
    found = study.motion(2).links
    spans = zip(bar.links[1:], (bar.coupler, bar.rocker), strict=True)
    angles = np.array([found[number].angle[0] + cmath.phase(span) for number, span in spans])
    rates = [np.array([found[number][order][0] for number in bar.links[1:]]) for order in (1, 2)]
    return angles, *rates


def _point(joint: Any) -> PointMotion:
    def vector(kind: str) -> Complexes:
        return np.asarray(getattr(joint, f"x_{kind}") + 1j * getattr(joint, f"y_{kind}"))

    return PointMotion(map(vector, ("positions", "velocities", "accelerations")))


def _link(vector: Any, span: complex) -> LinkMotion:
    angle = np.angle(np.exp(1j * (vector.pos.thetas - cmath.phase(span))))
    return LinkMotion(map(np.asarray, (angle, vector.vel.omegas, vector.acc.alphas)))

"""The motion of a linkage by other roads: its record in 50 digits, plans alone, looser tolerances, peers (движение)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from fractions import Fraction
from functools import partial
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Mark
from geometry.errors import DraftError
from geometry.replay import digits, exact
from plans.analytic.kinematics import Analysis
from plans.bench.peers import peers
from plans.bench.quantities import quantities
from plans.bench.trial import NOT_INSTALLED, Errors, Timing
from plans.forces.reading.form import ForceForm
from plans.linkage.drafts import Drafts
from plans.linkage.quantities import MotionComparison
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.linkage import described
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ORDERS, Motion
from plans.scene.scene import Scene
from plans.study import Study

PLANS = "linkage: plans, once assembled"
REPLAY, NEWTON = "replay in 50 digits", "Newton to {:.0e}"
# Newton's law makes nine digits of three: a tolerance under 1e-8 already ends at rounding, as the analysis does.
TOLERANCES = (1e-3, 1e-6)
SAMPLE = 24  # positions at which the record is replayed: each takes 2 ms and more, and more of them show no other error
TRUE = (
    f"{REPLAY}: the record of the three plans carried out at exact crank angles, by formulas of its own, at no more "
    f"than {SAMPLE} positions all over the turn; its row tells how far the construction is from it, those of the "
    "plans, of Newton to a tolerance and of peers how far they are"
)


class NothingToMeasure(DraftError):  # noqa: N818  (the message's own word)
    """A scene without a position that can be assembled."""

    exit_code = 4


def turns(scene: Scene) -> bool:
    """Tell whether a scene has a crank that turns, so that a turn may have any number of positions."""
    return scene.has(("mechanism",)) and described(scene).drive.turns


def with_positions(scene: Scene, count: int) -> Scene:
    """Give a scene another number of positions, equal steps of a turn from its own first crank angle."""
    form, loaded = scene.of(LinkageForm), scene.of(ForceForm)
    drive, sheet = form.drive, form.sheet
    start = drive.positions[0] if isinstance(drive.positions, tuple) else drive.start
    plans, forces = (tuple(k for k in chosen if k < count) for chosen in (sheet.plans, loaded.sheet.forces))
    shown = sheet.position if sheet.position is not None and sheet.position < count else None
    return scene.changed(
        form.changed(
            drive=drive.changed(positions=count, start=start), sheet=sheet.changed(plans=plans, position=shown)
        ),
        loaded.changed(sheet=loaded.sheet.changed(forces=forces)),
    )


def sample(lost: npt.NDArray[np.bool_], count: int = SAMPLE) -> list[int]:
    """Choose positions that are not lost: all where they are no more than `count`, else spread over the turn.

    The chosen ones are evenly spaced but for a jitter (seeded by their number): a step that divides the turn would
    meet the quarter turns alone, where sines and cosines are exact.
    """
    there = np.flatnonzero(~lost)
    if len(there) <= count:
        return [int(k) for k in there]
    edges = np.linspace(0, len(there), count + 1)
    chance = np.random.default_rng(len(there)).uniform(size=count)
    return [int(k) for k in there[(edges[:-1] + chance * np.diff(edges)).astype(int)]]


class Replay(NamedTuple):
    """The three plans of a linkage at some positions, to be in 50 digits; marks by the names of quantities."""

    study: LinkageStudy
    positions: Sequence[int]
    crank: Mark
    read: Mapping[str, tuple[Callable[..., Any], Sequence[Mark]]]  # how a quantity is read off marks

    @classmethod
    def of(cls, study: LinkageStudy, positions: Sequence[int], order: int) -> Replay:
        """Draw the plans up to an order at some positions of a study."""
        drafts = Drafts(study, study.turn.part(list(positions)))
        plans = [drafts.plan(k) for k in range(order + 1)]
        found: dict[str, tuple[Callable[..., Any], Sequence[Mark]]] = {}
        for symbols, plan in zip(ORDERS, plans, strict=False):
            links = {number: link for number, link in study.mechanism.links.items() if number != FRAME}
            moving = {name for link in links.values() for name in link.points} - {*study.mechanism.links[FRAME].points}
            found |= {f"{symbols.point.symbol}_{name}": (lambda point: point, [plan.point(name)]) for name in moving}
            for number in links:
                name = f"{symbols.link.symbol}_{number}"
                if symbols.number == 0:
                    found[name] = partial(_angle, complex(plan.images[number].span)), [plan.arm(number)]
                elif number in plan.readings:  # a link that does not turn has no rate that could be wrong
                    found[name] = _rate, plan.readings[number]
        return cls(study, positions, plans[0].board["φ"], found)

    def values(self, columns: int | None = None) -> list[dict[str, Any]]:
        """Carry the record out, in so many of its positions: the quantities by their names."""
        wanted = [mark for _, marks in self.read.values() for mark in marks]
        found = []
        for column, position in list(enumerate(self.positions))[:columns]:
            true = exact(wanted, column, {self.crank: direction(self.study, position)})
            found.append({name: reading(*(true[mark] for mark in used)) for name, (reading, used) in self.read.items()})
        return found


def _angle(span: complex, arm: Any) -> Any:
    return digits().arg(arm / digits().mpc(span))


def _rate(arm: Any, turning: Any) -> Any:
    return (digits().conj(arm) * turning).imag / abs(arm) ** 2


def direction(study: LinkageStudy, position: int) -> Any:
    """Give the crank's direction in 50 digits: an exact share of the turn from the first one, or as it is listed."""
    drive = study.form.drive
    if isinstance(drive.positions, tuple):
        return _turned(Fraction(drive.positions[position]) / 360)
    share = Fraction(study.sense * position, drive.positions)
    if drive.first is not None:
        return _turned(Fraction(drive.first) / 360 + share)
    found = digits().mpc(complex(study.turn.directions[0]))  # the extreme position is a direction that was constructed
    return found / abs(found) * _turned(share)


def _turned(share: Fraction) -> Any:
    return digits().expjpi(2 * digits().mpf(share.numerator) / share.denominator)


class Truth:
    """What the motion of a linkage truly is at some positions, and how large each quantity's plan is."""

    def __init__(self, study: Study) -> None:
        linkage = study.of(LinkageStudy)
        self.order: int = study.of(MotionComparison).construction.order
        found = linkage.motion(self.order)  # so near a dead centre that nothing bears rates there are none
        gone = np.any([np.isnan(row) for point in found.points.values() for row in point], axis=0)
        self.replay = Replay.of(linkage, sample(gone | linkage.lost), self.order)
        self.true = self.replay.values()
        self.largest = {quantity.name: quantity.largest for quantity in quantities(study, "linkage")}

    def judge(self, motion: Motion) -> Errors | None:
        """Judge a motion by its quantities that are truly known."""
        shares: dict[str, float] = {}
        for name, values in named(motion).items():
            if name in self.replay.read:
                pairs = zip(self.replay.positions, self.true, strict=True)
                off = max(self._off(name, values[k], true[name]) for k, true in pairs)
                shares[name] = off / (self.largest[name] or 1.0)
        return Errors.of(shares)

    def _off(self, name: str, value: Any, true: Any) -> float:
        """Give how far a value is from the true one; an angle's full turns are no difference, NaN is infinitely far."""
        mp = digits()
        off = mp.mpmathify(value) - true
        off -= 2 * mp.pi * mp.nint(off / (2 * mp.pi)) if name.startswith(ORDERS[0].link.symbol) else 0
        return float(abs(off)) if not np.isnan(value) else float("inf")


def named(motion: Motion) -> dict[str, Any]:
    """Give the quantities of a motion by their names."""
    found: dict[str, Any] = {}
    for k, order in enumerate(ORDERS):
        found |= {f"{order.point.symbol}_{name}": moved[k] for name, moved in motion.points.items() if k < len(moved)}
        found |= {f"{order.link.symbol}_{number}": moved[k] for number, moved in motion.links.items() if k < len(moved)}
    return found


def roads(study: Study, count: int | None) -> tuple[list[Timing], dict[str, str]]:
    """List the other roads to the motion at the positions of a study, and why some are left out."""
    if find_spec("mpmath") is None:
        return [], dict.fromkeys((PLANS, *map(NEWTON.format, TOLERANCES), REPLAY), NOT_INSTALLED)
    truth, linkage = Truth(study), LinkageStudy(study.scene, study.plans, study.pace)
    for part in ("groups", "sweep", "barriers", "turn"):
        getattr(linkage, part)
    replayed = min(len(truth.replay.positions), 4)  # each takes as long as any other
    drawn = truth.judge(study.of(LinkageStudy).motion(truth.order))
    ways: dict[str, Callable[[], Motion]] = {
        PLANS: lambda: copy(linkage).motion(truth.order),
        **{NEWTON.format(limit): partial(_solved, linkage, limit) for limit in TOLERANCES},
    }
    found = [Timing(run, count, {name: truth.judge}) for name, run in ways.items()]
    found.append(Timing(lambda: truth.replay.values(replayed), count, {REPLAY: lambda _: drawn}, of=replayed))
    ready, out = peers(study.of(LinkageStudy))
    for peer in ready:
        found.append(Timing(peer.run, count, {peer.name: partial(_read, truth, peer.motion)}, peer.versions))
    return found, out


def _solved(linkage: LinkageStudy, tolerance: float) -> Motion:
    return Analysis(linkage.mechanism, tolerance, linkage.first, pace=linkage.pace).motion(linkage.turn.phi)


def _read(truth: Truth, motion: Callable[[Any], Motion], found: Any) -> Errors | None:
    return truth.judge(motion(found))

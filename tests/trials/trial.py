"""A trial: one scene goes both roads as `plandraft draw` takes it, and what comes of it is told (испытание)."""

from __future__ import annotations

import re
import tempfile
import traceback
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path
from random import Random
from typing import NamedTuple

import numpy as np

from drawings.linkage.report import shallow
from geometry.errors import DraftError
from plans.checks.comparison import Comparison
from plans.linkage.quantities import MotionComparison, compare, compare_extremes
from plans.linkage.study import LinkageStudy
from plans.model.motion import FORCES, Motion
from plans.scene.scene import Scene, parse_scene
from tests.time_limit import limited
from tests.trials.chains import chain
from tests.trials.changes import change
from tests.trials.crank_rockers import crank_rocker

KINDS = {"crank-rockers": (crank_rocker, 10_000), "chains": (chain, 2_000), "changes": (change, 2_000)}
LONGEST = 60.0  # s: a scene that takes longer is told as too slow

DRAWN, NEAR, GAPS = "drawn", "drawn, too near a dead centre", "drawn with gaps"
REFUSED, WITHHELD, TRACEBACK = "refused", "withheld", "traceback"
ALONE, APART, SLOW, WARNED = "gap of one road alone", "gaps told apart", "too slow", "warning"
FAULTS = (WITHHELD, TRACEBACK, ALONE, APART, SLOW, WARNED)


class Verdict(NamedTuple):
    """What came of one scene: the outcome as the user meets it, why, and all that must not be."""

    kind: str
    number: int
    outcome: str
    reason: str
    faults: tuple[tuple[str, str], ...]  # what must not be, and its particulars


class _TooSlow(Exception):  # noqa: N818  (an end, not an error)
    """A scene took too long."""


def text_of(kind: str, number: int) -> str:
    """Write the scene of a trial: the same for ever by its kind and number."""
    return KINDS[kind][0](Random(f"{kind} {number}"))


def tried(kind: str, number: int, draw: bool = False) -> Verdict:
    """Try one scene, with `draw` as far as its sheets."""
    study = None
    try:
        with warnings.catch_warnings(record=True) as warned, limited(LONGEST, _TooSlow):
            warnings.simplefilter("always")
            study = _study(parse_scene(text_of(kind, number), f"{kind}-{number}.toml"))
            comparison = _compared(study)
            outcome, reason, faults = _judged(study, comparison)
            if draw and outcome != WITHHELD:
                _draw(kind, number)
    except DraftError as error:
        outcome, reason, faults = _refused(kind, error)
    except _TooSlow:
        outcome, reason, faults = SLOW, "", [(SLOW, f"more than {LONGEST:g} s")]
    except Exception as error:
        outcome, reason, faults = TRACEBACK, "", [(TRACEBACK, _where(error))]
    faults += [(WARNED, str(one.message)) for one in warned]
    return Verdict(kind, number, outcome, reason, tuple(dict.fromkeys(faults)))


def _study(scene: Scene) -> LinkageStudy:
    """Make the plans, as a sheet would."""
    study = LinkageStudy(scene)
    _ = study.extreme_positions, study.drafts().accelerations
    return study


def _compared(study: LinkageStudy) -> list[Comparison]:
    """Compare the motion, and the forces where they are asked for."""
    comparison = compare_extremes(study, compare(study))
    if "forces" not in study.scene.sheets:
        return [comparison]
    from plans.forces.quantities import compare_forces
    from plans.forces.statics import Statics

    return [comparison, compare_forces(Statics(study), comparison)]


def _judged(study: LinkageStudy, compared: Sequence[Comparison]) -> tuple[str, str, list[tuple[str, str]]]:
    faults = [*_one_sided(study, compared[0]), *(fault for one in compared for fault in _unanswered(one))]
    if not all(one.agrees for one in compared):
        worst = max(
            (finding for one in compared for finding in one.findings), key=lambda finding: float(finding.excess.max())
        )
        told = f"{worst.name} ({worst.plan}): {float(worst.excess.max()):.3g} of the allowed difference"
        return WITHHELD, told, [(WITHHELD, told), *faults]
    told = sorted({f"{gap.plan}: {gap.reason}" for gap in compared[0].construction.gaps})
    if told or study.met:
        return GAPS, "; ".join(told) or "barrier between positions", faults
    return NEAR if shallow(study) else DRAWN, "", faults


def _one_sided(study: LinkageStudy, comparison: Comparison) -> Iterator[tuple[str, str]]:
    """Tell where the two roads give up different positions, or the same with another reason, before any is left out."""
    ours = study.motion(2)
    assert isinstance(comparison, MotionComparison)
    theirs = comparison.road.motion(study.turn.phi, 2) if comparison.analysis.gaps or ours.gaps else comparison.analysis
    mine, other = _states(ours), _states(theirs)
    for k in np.flatnonzero(mine != other):
        one, two = (f"{STATES[has[k]]} ({_told(road, k)})" for has, road in ((mine, ours), (other, theirs)))
        yield ALONE, f"position {k}: construction has {one}, analysis {two}"
    for k in np.flatnonzero(mine == other):
        if _told(ours, k) != _told(theirs, k):
            yield APART, f"position {k}: construction {_told(ours, k)}, analysis {_told(theirs, k)}"


def _unanswered(comparison: Comparison) -> Iterator[tuple[str, str]]:
    """Tell where one road has forces and the other none, or none for another reason."""
    for by, gap in comparison.alone:
        if gap.plan == FORCES:
            yield ALONE, f"position {gap.position}: the {by} alone has no forces ({gap.reason})"


STATES = ("nothing", "places", "velocities", "accelerations")  # the best that a road may have


def _states(motion: Motion) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
    """Count at every position how many orders of the motion are whole."""
    have = np.ones(len(motion.phi), dtype=bool)
    orders = np.zeros(len(motion.phi), dtype=np.intp)
    for order in range(3):
        rows = [row[order] for row in (*motion.points.values(), *motion.links.values())]
        have = have & np.all([np.isfinite(np.broadcast_to(row, have.shape)) for row in rows if row is not None], axis=0)
        orders += have
    return orders


def _told(motion: Motion, position: int) -> str:
    """Give plan and reason of a gap as a road tells them."""
    told = sorted({f"{gap.plan}: {gap.reason}" for gap in motion.gaps if gap.position == position})
    return ", ".join(told) or "no gap"


def _refused(kind: str, error: DraftError) -> tuple[str, str, list[tuple[str, str]]]:
    """Tell a refusal by its kind and its words without the numbers; a crank-rocker by Grashof is never refused."""
    text = str(error).splitlines()[0]
    words = re.sub(r"^\S+?:\d+:(?:\d+:)? ", "", text)
    words = re.sub(r"\b[A-Z]\d?\b|u\d", "@", re.sub(r"-?\d+(\.\d+)?(e-?\d+)?", "#", words))
    outcome = WITHHELD if error.exit_code == 5 else REFUSED
    reason = f"{type(error).__name__}: {words}"[:110]
    wrong = outcome == WITHHELD or kind == "crank-rockers"
    return outcome, reason, [(outcome, f"{type(error).__name__}: {text}")] if wrong else []


def _where(error: Exception) -> str:
    frame = traceback.extract_tb(error.__traceback__)[-1]
    return f"{type(error).__name__}: {error} ({Path(frame.filename).name}:{frame.lineno})"


def _draw(kind: str, number: int) -> None:
    """Lay out, write and verify the sheets in a folder that is thrown away."""
    from drawings.commands.draw import draw

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{kind}-{number}.toml"
        path.write_text(text_of(kind, number), encoding="utf-8")
        draw(path, Path(folder))

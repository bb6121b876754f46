"""The marks of the force plan by their names, and what a hand may be out in them (точки плана сил)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

import numpy as np

from geometry.board import Board, Mark, behind
from geometry.hand_error import SlippingHand, slopes
from plans.explanation import Explanation, NoMark
from plans.forces.cut import CutGroup, ForcePlan, indices
from plans.forces.drive import BALANCING, DRIVING, balancing_quantity
from plans.forces.force_template import ForcePlans
from plans.forces.reading.form import ForceForm
from plans.forces.statics import Statics
from plans.linkage import marks as motion
from plans.linkage.study import LinkageStudy
from plans.model.motion import Floats
from plans.quantity import SLIP, Slipping, errors_by_hand
from plans.study import Study
from plans.words.words import Message, message

PAIR = re.compile(r"[RPF]_(?P<giver>\d+?),?(?P<taker>\d+)")  # a reaction: of the first link on the second
PART = re.compile(r"[RPF](?=\^[nt]_)")  # of a reaction, whichever letter a sheet has for reactions
UNITS = {**motion.UNITS, "forces": "N", "lever": "m/s"}
NONE = NoMark((), None, ("R_12", "M_bal"))


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps on the force plan behind a mark of it in one position; `study.whole` asks for those below too."""
    form, linkage = study.scene.of(ForceForm), study.of(LinkageStudy)
    if not (form.masses or form.loads) or name in motion.letters(linkage):
        return NoMark((), None, ()) if not (form.masses or form.loads) else NONE
    wanted = motion.position_of(linkage, position)
    plans: ForcePlans = study.of(Statics).drafts([wanted]).plans
    target, opposite = _find(plans.plan.board, name)
    if target is None and plans.lever is not None:
        target, opposite = _find(plans.lever.board, name.removesuffix("'") if name not in plans.lever.board else name)
    if target is None:
        return NONE
    steps, notes = behind(target), [opposite] if opposite else []
    if not study.whole:
        drawn = [mark for mark in steps if mark.subject in ("forces", "lever") and mark.step.op != "transfer"]
        # What a reaction rests on besides the forces: the plans that it is found over.
        notes += [message("explain.left_out", count=len(steps) - len(drawn))] if len(drawn) < len(steps) else []
        steps = drawn
    return Explanation(motion.title(linkage, name, wanted), tuple(steps), UNITS, tuple(notes), motion.HOME)


def _find(board: Board, name: str) -> tuple[Mark | None, Message | None]:
    """Find a mark of the force plan: R_34, its parts R^t_34, a load, M_bal; and say so where its opposite was found."""
    letter = PART.sub("R", name.replace("Phi", "Φ"))
    pair = PAIR.fullmatch(letter)
    letter = "R" + letter[1:] if pair else letter  # whichever letter a sheet has for reactions
    if letter in board and board[letter].step.inputs:
        return board[letter], None
    opposite = f"R_{indices(int(pair['taker']), int(pair['giver']))}" if pair else ""
    if opposite in board:
        return board[opposite], message("explain.opposite", mark=name, opposite=opposite)
    return (board[letter] if letter in board and letter != "0" else None), None


# The figures of a force sheet on which each board of the record is drawn.
FIGURES = {"positions": "scheme", "forces": "forces"}


def forces_by_hand(
    statics: Statics, position: int, scales: Mapping[str, float], by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give what a hand may be out on the force sheet of one position, by the names of the findings.

    Arms are measured on the schemes of the groups, and polygons drawn, each at its own scale or that of one before it
    which is coarser: `scales` are those of the figures, true units a mm: "scheme-4-5", "forces-4-5", "lever". Inertia
    forces and the lever's images are known from the kinematics.
    """
    drawn = statics.drafts([position]).plans
    coarsest: dict[str, float] = {}
    alike: dict[tuple[tuple[str, float], ...], dict[str, Mark]] = {}  # what is found at the same scales
    for cut in drawn.plan.cuts:
        for board, figure in FIGURES.items():
            if (mu := scales.get(f"{figure}-{cut.label}")) is not None:
                coarsest[board] = max(mu, coarsest.get(board, mu))
        alike.setdefault(tuple(coarsest.items()), {}).update(_forces_read(drawn.plan, cut))
    if drawn.lever is not None:
        name, _, share = balancing_quantity(statics.study.mechanism.drive)
        rows = {"lever": scales["lever"], **coarsest} if "lever" in scales else coarsest
        alike.setdefault(tuple(rows.items()), {})[f"{name} lever"] = drawn.lever.moment
    found: dict[str, Floats] = {}
    for drawn_at, read in alike.items():
        found |= errors_by_hand(read, SlippingHand(SLIP, {board: np.array([mu]) for board, mu in drawn_at}), by)
    if drawn.lever is not None:
        found[f"{name} lever"] = share * found[f"{name} lever"]
    return {(name, position): float(error[0]) for name, error in found.items()}


def _forces_read(plan: ForcePlan, cut: CutGroup) -> Iterator[tuple[str, Mark]]:
    """Give what is read off the polygon of a cut, by the names of the findings."""
    for support in cut.reactions:
        index = indices(*sorted((support.giver, support.taker)))
        yield f"R_{index}", support.force
        if support.moment is not None:
            yield f"M_{index}", support.moment
    if cut.group is None:
        yield BALANCING, plan.balancing
        if plan.drive is not None:
            yield DRIVING, plan.drive

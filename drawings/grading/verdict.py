"""Verdicts: what is said of one vector, of one plan and of how it is drawn (оценка)."""

from __future__ import annotations

from typing import Final, NamedTuple

RIGHT, FOLLOWS = "right", "follows"
MISSING, REVERSED, WRONG = "missing", "reversed", "wrong"
NORMAL, CORIOLIS = "normal", "coriolis"  # reversed parts, which have names of their own
LONG, TURNED = "long", "turned"  # only the size, only the direction
SIMILAR, BRANCH = "similar", "branch"
DEAD, SMALL = "dead", "small"  # too near a dead centre, too short to be found by its letter: not graded
INERTIA, UPWARD, REACTION = "inertia", "upward", "reaction"  # reversed forces, which have names of their own
MOMENT, COUPLE, FORGOTTEN, SLANT = "moment", "couple", "forgotten", "slant"  # in an equation of moments, of an arm
HEAVY, PRODUCT, BEYOND = "heavy", "product", "beyond"  # of a counterweight, of what is multiplied, of an arm's sign
ORDER = "order"  # of a harmonic
# Of a plan as a whole.
SCALE, MIRRORED, OPPOSITE, ASKEW = "scale", "mirrored", "opposite", "askew"
# Of a curve, or of all of it.
ASIDE, UNREAD = "aside", "unread"
UNGROUPED = "ungrouped"  # the arrows of a scheme that an editor has taken apart: not graded
SHIFTED, LEVEL, IDLE, UNDRIVEN = "shifted", "level", "idle", "undriven"
AXES, EXCHANGED, PHASES = "axes", "exchanged", "phases"
SIDE, BACKWARDS, BASE = "side", "backwards", "base"
STRAIGHT, FLYWHEEL, UNSET = "straight", "flywheel", "unset"
# Of how it is drawn.
UNSCALED, OPEN, UNLETTERED, SWAPPED, OUTSIDE = "unscaled", "open", "unlettered", "swapped", "outside"
APART = "apart"
UNCLOSED = "unclosed"  # of a polygon
# Of a cell of a table, or of all of it.
SIGN, DECADE, DEGREES, TURNS, TWICE, ROW, PLACE = "sign", "decade", "degrees", "turns", "twice", "row", "place"
ILLEGIBLE, UNTABLED = "illegible", "untabled"
# Of what stands there twice and differs, and of a plan whose arrows are not all found by their letters.
DOUBLED, UNNAMED = "doubled", "unnamed"

GOOD: Final = (RIGHT, FOLLOWS)
OF_PLANS: Final = (
    SCALE, MIRRORED, OPPOSITE, ASKEW,
    SHIFTED, LEVEL, IDLE, UNDRIVEN, AXES, EXCHANGED, PHASES, SIDE, BACKWARDS, BASE, STRAIGHT, FLYWHEEL, UNSET,
)  # fmt: skip
OF_DRAWING: Final = (UNSCALED, OPEN, UNCLOSED, UNLETTERED, SWAPPED, OUTSIDE, APART)
UNSEEN: Final = (UNREAD, UNGROUPED, ILLEGIBLE, UNTABLED, DOUBLED, UNNAMED)  # what somebody has to look at himself
UNGRADED: Final = (DEAD, SMALL, *UNSEEN)
# By which a quantity is wrong that may keep a share of its points.
OF_QUANTITIES: Final = (
    MISSING, REVERSED, WRONG, NORMAL, CORIOLIS, LONG, TURNED, SIMILAR, BRANCH, ASIDE,
    INERTIA, UPWARD, REACTION, MOMENT, COUPLE, FORGOTTEN, SLANT, HEAVY, PRODUCT, BEYOND, ORDER,
    SIGN, DECADE, DEGREES, TURNS, TWICE, ROW, PLACE,
)  # fmt: skip


class Verdict(NamedTuple):
    """What is said of a vector, or of a plan (without a name): its kind, by how much it is out of what is allowed.

    `off` and `allowed` are in the plan's unit; `at` is the place on paper, mm, y up; `step` names the mark of the
    record to look at again.
    """

    plan: str
    position: int | None
    name: str
    kind: str
    off: float | None = None
    allowed: float | None = None
    unit: str = ""
    at: tuple[complex, complex] | None = None
    letters: tuple[str, str] = ("", "")
    of: str = ""  # in which quantity the mistake is, if not in this one
    frames: tuple[tuple[complex, ...], ...] = ()  # corners on paper, mm: of a cell, or about all of a table's

    @property
    def good(self) -> bool:
        """Whether nothing is lost by it."""
        return self.kind in GOOD

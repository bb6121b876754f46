"""Names of plans and figures as the trade has them, for what is told of their data (названия планов)."""

from __future__ import annotations

import re
from typing import Final

from plans.words.words import Message, message

# By what the data of a figure are called: the key of its name, and what of it is a part of that.
_NAMED: Final = tuple(
    (re.compile(pattern), key)
    for pattern, key in (
        (r"velocities", "velocities"),
        (r"accelerations", "accelerations"),
        (r"positions", "positions"),
        (r"forces-(?P<of>\d+)", "forces_of_link"),
        (r"forces-(?P<of>.+)", "forces_of_group"),
        (r"scheme (?P<of>\d+)", "scheme_of_link"),
        (r"scheme (?P<of>.+)", "scheme_of_group"),
        (r"diagrams-(?P<of>\w+)", "diagram"),
        (r"load_diagram-(?P<of>.+)", "load"),
        (r"circle", "rings"),
        (r"law-(?P<cam>.+)-(?P<of>\w+)", "law"),
        (r"order_(?P<of>forces|moments)-(?P<order>\d+)", "order"),
        (r"order_(?P<of>forces|moments)-(?P<order>\d+)-back", "order_back"),
        (r"compensator-(?P<order>\d+)", "compensator"),
    )
)  # fmt: skip


def plan_named(plan: str) -> Message:
    """Name a plan as a draughtsman does; one that has no name of its own by the words for figures.

    >>> str(plan_named("forces-4-5")), str(plan_named("loop"))
    ('force plan of group 4-5', "Wittenbauer's loop")
    """
    for pattern, key in _NAMED:
        if (found := pattern.fullmatch(plan)) is not None:
            return message(f"grade.named.{key}", **found.groupdict())
    return message("grade.named.other", of=plan)

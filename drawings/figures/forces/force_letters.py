"""The letters of forces: a name of the force plan as a sheet writes it (обозначения сил)."""

from __future__ import annotations

import re

from drawings.figures.linkage.vector_plan import written
from drawings.lettering.words import letter

REACTION = "R"  # as the force plan names reactions
_REACTION = re.compile(r"R(?=(\^.)?_(\d\d|\d+,\d+)$)")


def lettered(name: str, language: str = "en", reactions: str = REACTION) -> str:
    """Write a force's name with its index lowered, in the sheet's letter for reactions.

    >>> lettered("R^t_34"), lettered("M^Φ_4/BD"), lettered("R^t_34", "ru", "P"), lettered("R_05", reactions="F")
    ('R^t_{34}', 'M^Φ_{4}/BD', 'P^τ_{34}', 'F_{05}')
    """
    name, slash, arm = name.partition("/")
    return letter(language, written(_REACTION.sub(reactions, name))) + slash + arm

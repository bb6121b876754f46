"""The letters of forces: a name of the force plan as a sheet writes it (обозначения сил)."""

from __future__ import annotations

import re

from drawings.lettering.indices import with_index
from drawings.lettering.words import letter
from drawings.page.drafting import Drafting

REACTION = "R"  # as the force plan names reactions
_REACTION = re.compile(r"R(?=(\^.)?_(\d\d|\d+,\d+)$)")


def force_letter(name: str, language: str = "en", reactions: str = REACTION) -> str:
    """Write a force's name with its index lowered, in the sheet's letter for reactions.

    >>> force_letter("R^t_34"), force_letter("M^Φ_4/BD"), force_letter("R^t_34", "ru", "P")
    ('R^t_{34}', 'M^Φ_{4}/BD', 'P^τ_{34}')
    """
    name, slash, arm = name.partition("/")
    return letter(language, with_index(_REACTION.sub(reactions, name))) + slash + arm


def letter_of(name: str, drafting: Drafting) -> str:
    """Write a force's name as a sheet does."""
    return force_letter(name, drafting.language, drafting.reactions)

"""Forces by their kinds, and as they are lettered (виды и обозначения сил)."""

from __future__ import annotations

import re

from drawings.lettering.words import letter, with_index
from drawings.page.page import Drafting
from plans.forces.cut import CLOSING, KNOWN, PART

__all__ = ["BALANCE", "CLOSING", "KNOWN", "LAID", "LOAD", "PAIR", "PART", "PRESSING", "UNKNOWN", "WHOLE"]

# Of a polygon, beside the kinds of its sides: both parts of a reaction, or a group's inner reaction, as a diagonal.
WHOLE = "whole"
LAID = KNOWN, PART  # sides that are laid off: what moments gave is known too
# Of a scheme: a load is KNOWN; a reaction is not, nor is that of a guide, which presses on its slider.
UNKNOWN, PRESSING = "unknown", "pressing"
# Of a lever: a load, half of a couple, what the drive gives.
LOAD, PAIR, BALANCE = "load", "pair", "balance"


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

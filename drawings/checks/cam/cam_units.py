"""The units of a follower's travel and of its derivatives, and how a scale is written with one (размерности)."""

from __future__ import annotations

from drawings.lettering.words import number
from drawings.page.drafting import Drafting

# Units of S, S' and S'' by whether the follower rocks and whether the cam translates; "1" of what has none.
UNITS = {
    (False, False): ("m", "m/rad", "m/rad2"),
    (False, True): ("m", "1", "1/m"),
    (True, False): ("rad", "1", "1/rad"),
    (True, True): ("rad", "rad/m", "rad/m2"),
}
MM = 1000.0  # in a metre


def written_scale(letter: str, mu: float, unit: str, drafting: Drafting) -> str:
    """Write a scale of a letter, mu true units a mm with the ratio of lengths, or K mm a unit."""
    true, mm = drafting.word(unit), drafting.word("mm")
    true = f"({true})" if "/" in true else true
    if drafting.notation == "K":
        return f"K_{letter} = {number(1 / mu, drafting.language)} {mm}/{true}"
    told = f"μ_{letter} = {number(mu, drafting.language)} {true}/{mm}"
    return f"{told} ({ratio(mu, drafting)})" if letter == "l" else told


def ratio(mu: float, drafting: Drafting) -> str:
    """Write a scale of lengths, m/mm, as a ratio."""
    times = MM * mu
    return f"1:{number(times, drafting.language)}" if times >= 1 else f"{number(1 / times, drafting.language)}:1"

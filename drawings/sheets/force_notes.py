"""What a force sheet says in words: masses, drive, agreement of the roads, friction and efficiency (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.force_letters import lettered
from drawings.words import number, word
from plans.compare import Comparison
from plans.primary import BALANCING
from plans.statics import Statics

DIGITS = 5


def notes(statics: Statics, comparison: Comparison, position: int, language: str) -> list[str]:
    """Write what the sheet says in words."""
    drive = statics.study.mechanism.drive
    crank = word(
        language, "crank", link=drive.link, omega=number(drive.omega, language), epsilon=number(drive.epsilon, language)
    )
    return [crank, *_masses(statics, language), *_balancing(comparison, position, language)]


def _masses(statics: Statics, language: str) -> Iterator[str]:
    told = []
    for link, body in sorted(statics.machine.bodies.items()):
        if body.mass:
            told.append(f"m_{{{link}}} = {number(body.mass, language)} {word(language, 'kg')}")
        if body.inertia:
            told.append(f"J_{{S{link}}} = {number(body.inertia, language)} {word(language, 'kg*m2')}")
    if told:
        yield ",  ".join(told)


def _balancing(comparison: Comparison, position: int, language: str) -> Iterator[str]:
    """Tell the balancing moment by all the ways in which it was found."""
    told = []
    for finding in comparison.of("forces"):
        name, _, how = finding.name.partition(" ")
        if name == BALANCING and how in ("power", "energy"):
            value = number(float(finding.analysis[position]), language, DIGITS)
            told.append(f"{word(language, f'by {how}')} {value}")
    if told:
        yield f"{lettered(BALANCING, language)}, {word(language, 'N*m')}: {', '.join(told)}"

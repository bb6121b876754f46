"""What a force sheet says in words: masses, drive, agreement of the roads, friction and efficiency (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.words import number, runs, word
from plans.statics import Statics

NBSP = "\N{NO-BREAK SPACE}"
INDEX = ("friction index", "useful index")  # of powers


def notes(statics: Statics, position: int, language: str) -> list[str]:
    """Write what the sheet says in words."""
    drive = statics.study.mechanism.drive
    crank = word(
        language, "crank", link=drive.link, omega=number(drive.omega, language), epsilon=number(drive.epsilon, language)
    )
    return [crank, *_masses(statics, language), *_friction(statics, position, language)]


def _masses(statics: Statics, language: str) -> Iterator[str]:
    told = []
    for link, body in sorted(statics.machine.bodies.items()):
        if body.mass:
            told.append(f"m_{{{link}}} = {number(body.mass, language)}{NBSP}{word(language, 'kg')}")
        if body.inertia:
            told.append(f"J_{{S{link}}} = {number(body.inertia, language)}{NBSP}{word(language, 'kg*m2')}")
    if told:
        yield ",  ".join(told)


def _friction(statics: Statics, position: int, language: str) -> Iterator[str]:
    """Tell powers, efficiency and wear, the most worn pairs first; and where the machine jams."""
    found = statics.friction
    if found is None or not np.isfinite(found.lost[position]):
        return
    watt, power = word(language, "W"), (float(found.lost[position]), float(found.useful[position]))
    told = [
        f"N_{{{word(language, symbol)}}} = {number(one, language)}{NBSP}{watt}"
        for symbol, one in zip(INDEX, power, strict=True)
    ]
    if np.isfinite(found.efficiency[position]):
        told.append(f"η = {number(float(found.efficiency[position]), language, 3)}")
    if found.cycle is not None:
        told.append(word(language, "cycle efficiency", eta=number(found.cycle, language, 3)))
    yield f"{word(language, 'friction')}: {', '.join(told)}"
    if found.wear:
        worn = [f"{key}{NBSP}{number(100 * share, language, 3)}{NBSP}%" for key, share in found.wear.items()]
        yield f"{word(language, 'wear')}: {', '.join(worn)}"
    if found.jams:
        pairs = ", ".join(dict.fromkeys(jam.pair for jam in found.jams))
        yield word(language, "jams", pairs=pairs, positions=runs(sorted({jam.position for jam in found.jams})))

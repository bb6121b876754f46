"""The letters of a cam's phases with their angles, as a sheet writes them (обозначения фаз кулачка)."""

from __future__ import annotations

import math

from drawings.lettering.phrase import Phrase, Slot, joined
from drawings.page.drafting import Drafting
from plans.model.cam import Cam, Phase

DIGITS = 5
REST = "rest"


def phase_indices(cam: Cam) -> tuple[str, ...]:
    """Give the index of each phase: a dwell at the lowest level is a rest, several of one kind are numbered."""
    kinds = [_kind(cam, one) for one in cam.phases]
    return tuple(
        kind if kinds.count(kind) == 1 else f"{kind}\N{NO-BREAK SPACE}{kinds[: k + 1].count(kind)}"
        for k, kind in enumerate(kinds)
    )


def phase_letter(cam: Cam, number: int, drafting: Drafting) -> Phrase:
    """Letter a phase with its angle in degrees, or with its travel in millimetres where the cam translates."""
    index, angle = phase_indices(cam)[number], cam.phases[number].angle
    letter, size, unit = ("x", 1000 * angle, "") if cam.translates else ("φ", math.degrees(angle), "°")
    told = drafting.letter(f"{letter}_{{{index}}} = "), drafting.slot(Slot(f"φ_{number}", size, DIGITS)), unit
    return joined("", told)


def _kind(cam: Cam, one: Phase) -> str:
    lowest = min(min(own.level, own.level + own.change) for own in cam.phases)
    return REST if one.change == 0 and one.level == lowest else one.kind

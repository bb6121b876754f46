"""The self-check of workings on the sheets of machines: vectors and links laid off, tangents of the loop (выкладки)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.dynamics.dynamics_expected import KNOWN
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.workings.due_line import DueLine, Quantity, faults, laid_off
from drawings.checks.wrong import Wrong, on
from drawings.figures.workings.working import LENGTHS, SEGMENTS, TANGENTS
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from plans.model.dynamics import Flywheel

KINDS = (LENGTHS, SEGMENTS, TANGENTS)


def held(leaf: Leaf, due: Mapping[str, Sequence[DueLine]], drafting: Drafting) -> Iterator[Wrong]:
    """Hold the workings of a sheet by the lines that are due of each kind and figure."""
    for group in leaf.groups:
        kind, _, figure = group.name.partition("-")
        if kind in KINDS and group.name not in due:
            yield on("stranger_on", figure, name=kind)
        elif kind in KINDS:
            yield from faults(group, due[group.name], figure, drafting)


def named(kind: str, figure: str) -> str:
    """Name a working of a figure."""
    return f"{kind}-{figure}"


def segments(sizes: Mapping[str, Quantity], symbol: str, mu: float, drafting: Drafting) -> list[DueLine]:
    """Give the lines by which the vectors of a polygon are laid off, by their letters as they are marked up."""
    own = ((read(letter), size) for letter, size in sizes.items())
    return [laid_off(letter, f"[{letter}]", symbol, size, mu, drafting) for letter, size in own]


def tangents(wheel: Flywheel, inertia: float, energy: float, drafting: Drafting) -> list[DueLine]:
    """Give the lines by which the tangents are steep, at the scales of inertia and of energy, a mm."""
    k, (least, most) = drafting.notation == "K", wheel.slopes
    letters, scales = (("KT", "KJ"), (1 / energy, 1 / inertia)) if k else (("μJ", "μT"), (inertia, energy))
    return [
        DueLine(
            f"tg ψ{end}",
            f"ω{end}2·{letters[0]}/(2·{letters[1]})",
            (_known(2 * slope), Quantity(scales[0]), Quantity(2.0), Quantity(scales[1])),
            _known(slope * inertia / energy),
        )
        for end, slope in (("max", most), ("min", least))
    ]


def _known(value: float) -> Quantity:
    return Quantity(value, KNOWN * abs(value))

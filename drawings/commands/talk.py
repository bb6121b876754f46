"""Talk (сообщения): what the command says on stderr, in the scene's language."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from drawings.commands.process import tell
from drawings.lettering.words import runs
from plans.linkage.barrier import Barrier
from plans.model.motion import Gap
from plans.scene.faults import SceneError
from plans.scene.notes import notes_of
from plans.scene.scene import Scene
from plans.scene.source import language_of
from plans.scene.wording import said

__all__ = ["language_of", "noted", "verdict", "worded"]


def worded(error: Exception, language: str) -> str:
    """Word an error that ends the command; a file that cannot be read or written by its name and the reason."""
    if isinstance(error, SceneError):
        return error.worded(language)
    text = str(error)
    if isinstance(error, OSError) and error.strerror:
        text = f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    return "\n".join(said(line, language) for line in text.splitlines())


def noted(scene: Scene, forces: bool = False) -> Scene:
    """Say what is odd about a scene, and give it back; `forces` are asked for whatever its sheets are."""
    for note in notes_of(scene, forces):
        tell(note.worded(scene.sheet.language))
    return scene


def verdict(gaps: Sequence[Gap], met: Iterable[Barrier], near: Sequence[int], language: str) -> list[str]:
    """Say why a sheet is not whole: gaps, those of one reason together, else barriers between positions; dead centres.

    Positions of one gap are told with the advice for the first of them.
    """
    lines = [_gap(together) for together in _alike(gaps)]
    if not gaps:
        lines += [f"{barrier.kind} at {barrier.where} between two positions: see the report" for barrier in met]
    if near:
        lines.append(f"{_positions(near)}: too near a dead centre to be graded: see Conditions in the report")
    return [said(line, language) for line in lines]


def _alike(gaps: Sequence[Gap]) -> list[list[Gap]]:
    """Put gaps of one plan, reason and place together."""
    kinds: dict[tuple[str, str, str], list[Gap]] = {}
    for gap in gaps:
        kinds.setdefault((gap.plan, gap.reason, gap.where), []).append(gap)
    return list(kinds.values())


def _gap(together: Sequence[Gap]) -> str:
    first = together[0]
    alone = len({gap.advice for gap in together}) == 1
    where = first.where if alone else f"{first.where}, in position {first.position}"
    numbers = _positions([gap.position for gap in together])
    return f"{numbers}: {first.plan}: {first.reason} at {where}: {first.advice}"


def _positions(numbers: Sequence[int]) -> str:
    return f"position {numbers[0]}" if len(numbers) == 1 else f"positions {runs(numbers, '-')}"

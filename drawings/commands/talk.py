"""Talk (сообщения): what the command says on stderr, in the scene's language."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from drawings.commands.process import tell
from drawings.files.file_error import of_system
from drawings.lettering.words import runs
from plans.linkage.barrier import Barrier
from plans.model.motion import Gap
from plans.scene.faults import SceneError
from plans.scene.notes import notes_of
from plans.scene.scene import Scene
from plans.scene.source import language_of
from plans.words.words import Message, message, placed, said

__all__ = ["language_of", "noted", "verdict", "worded"]


def worded(error: Exception, language: str) -> str:
    """Word an error that ends the command; a file that cannot be read or written by its name and the reason."""
    if isinstance(error, SceneError):
        return error.worded(language)
    if isinstance(error, OSError) and error.strerror:
        reason = of_system(error)
        return said(placed(error.filename, reason) if error.filename else reason, language)
    return said(error, language)


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
        lines += [message("verdict.between", reason=barrier.kind, where=barrier.where) for barrier in met]
    if near:
        lines.append(message("verdict.near", count=len(near), positions=runs(near, "-")))
    return [line.worded(language) for line in lines]


def _alike(gaps: Sequence[Gap]) -> list[list[Gap]]:
    """Put gaps of one plan, reason and place together."""
    kinds: dict[tuple[str, str, object], list[Gap]] = {}
    for gap in gaps:
        kinds.setdefault((gap.plan, gap.reason, gap.where), []).append(gap)
    return list(kinds.values())


def _gap(together: Sequence[Gap]) -> Message:
    first, numbers = together[0], [gap.position for gap in together]
    parts = {"plan": first.plan, "reason": first.reason, "where": first.where, "advice": first.advice}
    key = "verdict.gap" if len({gap.advice for gap in together}) == 1 else "verdict.gap_in"
    return message(key, count=len(numbers), positions=runs(numbers, "-"), first=first.position, **parts)

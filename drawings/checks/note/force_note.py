"""The self-check of a note on forces: equations and friction against the analysis (проверка силового расчёта)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.checks.verify_friction import report_of
from plans.study import Study
from plans.words.words import Message

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Read what the report of a scene says of its friction."""
    yield from report_of(text, study.comparison("forces"), study.scene.sheet.language)

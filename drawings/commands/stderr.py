"""What is said on stderr, in the language of the scene, also of a run whose own files fail it (сообщения)."""

from __future__ import annotations

import contextlib
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plans.study import Study

FILES = 7
UNREADABLE = "plandraft itself cannot be read: {error}. Fix: install it again"


def tell(message: str) -> None:
    """Say a message on stderr; where nobody can hear it, the work goes on, and the exit code tells how it ended."""
    with contextlib.suppress(OSError, ValueError):
        print(message, file=sys.stderr)


def noted(study: Study) -> None:
    """Say what is odd about a scene, given what is asked of it."""
    from plans.scene.notes import notes_of

    for note in notes_of(study.scene, study.techniques):
        tell(note.worded(study.scene.sheet.language))


def worded(error: Exception, language: str) -> str:
    """Word an error that ends the command; a file that cannot be read or written by its name and the reason."""
    from drawings.files.atomic_files import of_system
    from plans.scene.faults import SceneError
    from plans.words.words import placed, said

    if isinstance(error, SceneError):
        return error.worded(language)
    if isinstance(error, OSError) and error.strerror:
        reason = of_system(error)
        return said(placed(error.filename, reason) if error.filename else reason, language)
    return said(error, language)

"""Talk (сообщения): what the command says on stderr, in the scene's language."""

from __future__ import annotations

from drawings.commands.stderr import tell
from drawings.files.atomic_files import of_system
from plans.scene.faults import SceneError
from plans.scene.notes import notes_of
from plans.scene.source import language_of
from plans.study import Study
from plans.words.words import placed, said

__all__ = ["language_of", "noted", "worded"]


def worded(error: Exception, language: str) -> str:
    """Word an error that ends the command; a file that cannot be read or written by its name and the reason."""
    if isinstance(error, SceneError):
        return error.worded(language)
    if isinstance(error, OSError) and error.strerror:
        reason = of_system(error)
        return said(placed(error.filename, reason) if error.filename else reason, language)
    return said(error, language)


def noted(study: Study) -> None:
    """Say what is odd about a scene, given what is asked of it."""
    for note in notes_of(study.scene, study.techniques):
        tell(note.worded(study.scene.sheet.language))

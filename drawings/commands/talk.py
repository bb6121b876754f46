"""Talk (сообщения): what the command says on stderr, in the scene's language."""

from __future__ import annotations

from drawings.commands.process import tell
from plans.scene.faults import SceneError
from plans.scene.notes import notes_of
from plans.scene.source import language_of
from plans.scene.wording import said
from plans.study import Study

__all__ = ["language_of", "noted", "worded"]


def worded(error: Exception, language: str) -> str:
    """Word an error that ends the command; a file that cannot be read or written by its name and the reason."""
    if isinstance(error, SceneError):
        return error.worded(language)
    text = str(error)
    if isinstance(error, OSError) and error.strerror:
        text = f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    return "\n".join(said(line, language) for line in text.splitlines())


def noted(study: Study) -> None:
    """Say what is odd about a scene, given what is asked of it."""
    for note in notes_of(study.scene, study.techniques):
        tell(note.worded(study.scene.sheet.language))

"""Hints: which step to look at again, told in the language of the sheet alone, and no value."""

from __future__ import annotations

import re

import pytest

from drawings.grading.curves.figure_records import figures_asked
from drawings.grading.graded import SheetTask
from tests.drawings.students import task
from tests.gallery import SCENES
from tests.rows import over

# An English word; a quantity such as v_max, or a letter with the number of a group of links, is in every language.
ENGLISH = re.compile(r"(?<![\w_^{])[a-z]{3,}", re.ASCII)


def in_russian(scene: str) -> set[str]:
    """Give the hints of a scene, told in Russian."""
    asked = task(scene)
    hints = SheetTask(asked.plans, figures_asked(asked.originals)).hints
    return {hint.worded("ru") for steps in hints.values() for hint in steps}


def test_a_hint_has_no_word_of_another_language() -> None:
    every = in_russian("slider-crank")
    assert every and not any(map(ENGLISH.search, every))


@pytest.mark.rest
@over("scene", [path.stem for path in SCENES if path.stem != "slider-crank"])
def test_no_hint_of_the_gallery_has_a_word_of_another_language(scene: str) -> None:
    """A sheet that asks for no drawn plan or curve has no hint."""
    assert [text for text in in_russian(scene) if ENGLISH.search(text)] == []

"""Wording: every message stands in both languages, with the same data, and no English is left in a Russian one."""

from __future__ import annotations

import ast
import re
import string
from collections.abc import Iterator
from pathlib import Path

import pytest

from plans.scene.faults import Fault
from plans.scene.messages import english, russian
from plans.scene.messages.sentences import SENTENCES
from plans.scene.wording import said, table

ROOT = Path(__file__).parent.parent.parent
KINDS = [(kind, name) for name in ("FAULTS", "NOTES") for kind in getattr(english, name)]
# Words that only an English sentence has; keys of the scene, units and letters of points are in both languages.
ENGLISH = re.compile(
    r"\b(the|of|to|is|are|or|and|write|but|found|this|expected|Fix|cannot|each|that|it|not|which|there|with|does|more"
    r"|than|as|lines?|links?(?= \d)|no)\b"
)


def placeholders(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}


def test_both_languages_word_the_same_kinds() -> None:
    assert english.FAULTS.keys() == russian.FAULTS.keys()
    assert english.NOTES.keys() == russian.NOTES.keys()
    assert not english.FAULTS.keys() & english.NOTES.keys()


@pytest.mark.parametrize(("kind", "name"), KINDS)
def test_a_kind_has_the_same_data_in_both_languages(kind: str, name: str) -> None:
    ours, theirs = (getattr(words, name)[kind] for words in (english, russian))
    assert set().union(*map(placeholders, ours)) == set().union(*map(placeholders, theirs))
    for text in (*ours, *theirs):
        assert text
        assert not text.endswith(".")  # the sentence around it ends so


@pytest.mark.parametrize(("kind", "name"), KINDS)
def test_a_russian_message_is_a_russian_sentence(kind: str, name: str) -> None:
    for text in getattr(russian, name)[kind]:
        bare = re.sub(r"\{\w*\}|\"[^\"]*\"", "", text)
        assert re.search(r"[а-яё]{3}", bare) or not bare.strip("{} ")
        assert not ENGLISH.search(bare)


@pytest.mark.parametrize("text", SENTENCES)
def test_a_sentence_keeps_its_data_in_russian(text: str) -> None:
    assert placeholders(text) == placeholders(SENTENCES[text])
    assert not ENGLISH.search(re.sub(r"\{\w*\}|\"[^\"]*\"|\[.*\]|= .*", "", SENTENCES[text]))


@pytest.mark.parametrize("text", SENTENCES)
def test_a_sentence_is_found_by_its_form(text: str) -> None:
    data = {name: f"Q{number}" for number, name in enumerate(sorted(placeholders(text)))}
    assert said(text.format_map(data), "ru") == SENTENCES[text].format_map(data)
    assert said(text.format_map(data), "en") == text.format_map(data)


def test_where_a_message_stands_is_kept() -> None:
    where = "C:\\сцены\\a: b.toml:4:1: mechanism.sketch: "
    assert said(f"{where}delete it", "ru") == f"{where}удалите его"


@pytest.mark.parametrize("name", ["length", "text", "none", "link 3", "AB or CD"])
def test_a_name_of_the_scene_is_not_translated(name: str) -> None:
    fault = Fault("scene.toml", 1, 1, (), "", "unknown_point", {"name": name, "suggestion": "delete it"})
    assert f"точки {name} нет. Исправьте: удалите его." in fault.worded("ru")


def test_a_language_without_a_table_is_told_in_english() -> None:
    assert table("fr") is table("en")
    assert said("delete it", "fr") == "delete it"


# The files whose errors end a command that was given a scene; a sheet that is measured has none.
RAISING = sorted(
    path
    for folder in ("plans", "drawings/commands", "drawings/sheets")
    for path in (ROOT / folder).rglob("*.py")
    if path.name != "faults.py"
) + [ROOT / f"drawings/{name}.py" for name in ("layout/value_table", "page/scale", "checks/verify")]
# Errors with sentences of their own; a TypeError and a SceneError are none.
ERRORS = re.compile(r"LimitError|SheetError|SketchError|StructureError|SelfCheckFailed|NoExtreme|UnknownMark|OSError")


def raised(path: Path) -> Iterator[str]:
    """Give the sentences that a file raises, with a number for whatever is filled in."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and node.exc.args:
            name = ast.unparse(node.exc.func)
            text = filled(node.exc.args[-1 if name == "OSError" and len(node.exc.args) == 2 else 0])
            if ERRORS.fullmatch(name) and re.search(r"[a-z]{3} [a-z]", text):
                yield text


def filled(node: ast.expr) -> str:
    if isinstance(node, ast.Constant):
        return str(node.value)
    parts = node.values if isinstance(node, ast.JoinedStr) else []
    return "".join(filled(part) if isinstance(part, ast.Constant) else "Q7" for part in parts)


@pytest.mark.parametrize("path", RAISING, ids=lambda path: path.stem)
def test_every_sentence_that_ends_a_command_has_its_russian(path: Path) -> None:
    """A new message needs a line in plans/scene/messages/sentences.py."""
    for text in raised(path):
        assert not ENGLISH.search(said(text, "ru")), text


def test_sentences_are_found_in_the_files() -> None:
    assert sum(1 for path in RAISING for _ in raised(path)) > 15

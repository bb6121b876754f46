"""Words: every language has every phrase, with the same parts, and none is in another language."""

from __future__ import annotations

import ast
import json
import re
import string
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest

from plans.model.dyad import NUMBERS
from plans.scene.faults import Fault
from plans.scene.source import language_of
from plans.techniques import techniques
from plans.words.words import ENGLISH, FOLDER, flat, languages, message, own_words, placed, said, term, word, words
from tests.own_text import Asked, parsed

ROOT = Path(__file__).parent.parent.parent
KEYS = [key for key in words(ENGLISH) if key != "plural"]
OTHERS = [language for language in languages() if language != ENGLISH]
# Words that only an English sentence has; keys of the scene, units and letters of points are in every language.
JOINS = [key.removeprefix("join.") for key in words(ENGLISH) if key.startswith("join.")]
ENGLISH_WORDS = re.compile(
    r"\b(the|of|to|is|are|or|and|write|but|found|this|expected|Fix|cannot|each|that|it|not|which|there|with|does|more"
    r"|than|as|lines?|links?(?= \d)|no)\b"
)


def forms(language: str, key: str) -> list[str]:
    phrase = words(language)[key]
    return [phrase] if isinstance(phrase, str) else phrase


def parts(text: str) -> set[tuple[str, str]]:
    return {(name, wish or "") for _, name, wish, _ in string.Formatter().parse(text) if name is not None}


@pytest.mark.parametrize("language", OTHERS)
def test_every_language_has_every_phrase(language: str) -> None:
    assert words(language).keys() == words(ENGLISH).keys()
    for key in words(ENGLISH):
        assert isinstance(words(language)[key], str) == isinstance(words(ENGLISH)[key], str), key


@pytest.mark.parametrize("language", OTHERS)
def test_a_phrase_has_the_same_parts_in_every_language(language: str) -> None:
    """Of a fault what was expected and the advice have them together: a language may turn them about."""
    for key in KEYS:
        stem = re.sub(r"^((?:fault|note)\..*)\.(expected|advice)$", r"\1", key)
        both = [f"{stem}.{part}" for part in ("expected", "advice")] if stem != key else [key]
        ours, theirs = (
            {name for part in both for form in forms(known, part) for name, _ in parts(form)}
            for known in (ENGLISH, language)
        )
        assert ours == theirs, key


def test_no_key_is_said_twice() -> None:
    def once(pairs: list[tuple[str, object]]) -> dict[str, object]:
        assert len(pairs) == len(dict(pairs)), pairs
        return dict(pairs)

    groups = [json.loads(path.read_text("utf-8"), object_pairs_hook=once) for path in own_words()]
    for language in languages():
        common = json.loads((FOLDER / f"{language}.json").read_text("utf-8"), object_pairs_hook=once)
        said = [key for group in (common, *(own[language] for own in groups)) for key, _ in flat(group)]
        assert len(said) == len(set(said)) == len(words(language))


@pytest.mark.parametrize("language", languages())
def test_a_list_of_words_is_one_that_is_there(language: str) -> None:
    """{name:group} asks for a group of words, {name:and} for a list."""
    groups = {key.partition(".")[0] for key in words(ENGLISH)}
    for key in KEYS:
        assert {wish for form in forms(language, key) for _, wish in parts(form)} <= groups | {"", *JOINS}, key


def test_a_russian_phrase_is_in_russian() -> None:
    for key in KEYS:
        for form in forms("ru", key):
            bare = re.sub(r"\{.*?\}|\"[^\"]*\"|\[.*\]|= .*", "", form)
            assert not ENGLISH_WORDS.search(bare), key
            if key.startswith(("fault.", "note.")):
                assert re.search(r"[а-яё]{3}", bare) or not bare.strip("{} ")
                assert form and not form.endswith(".")  # the sentence around it ends so


def compared(found: Iterable[ast.AST]) -> tuple[int, ...]:
    """Give the lines of a file that compare something with the name of a language."""
    return tuple(
        part.lineno
        for node in found
        if isinstance(node, ast.Compare)
        for part in ast.walk(node)
        if isinstance(part, ast.Constant) and part.value in languages()
    )


def test_a_language_is_never_compared_by_name() -> None:
    quoted = re.compile("|".join(f"[\"']{name}[\"']" for name in languages()))
    naming = [path for path in FILES if quoted.search(path.read_text("utf-8"))]
    assert naming  # the only files that can compare one
    assert [(path.name, lines) for path in naming if (lines := compared(nodes(path)))] == []
    assert compared(parsed('if drawing.language == "ru":\n    pass').asked) == (1,)
    assert compared(parsed('one = 1 if language in ("ru", "en") else 2').asked) == (1, 1)


def test_a_message_is_said_in_the_language_that_is_asked_for() -> None:
    lost = placed("a: b.toml:4:1", message("advice.meant", names=("AB", "CD", "EF")))
    assert str(lost) == "a: b.toml:4:1: did you mean AB or CD or EF?"
    assert lost.worded("ru") == said(ValueError(lost), "ru") == "a: b.toml:4:1: возможно, AB, CD или EF?"
    assert said("as it is", "ru") == said(ValueError("as it is"), "ru") == "as it is"


@pytest.mark.parametrize(("count", "shown"), [(1, "положение"), (2, "положения"), (21, "положение"), (11, "положения")])
def test_a_language_counts_as_it_does(count: int, shown: str) -> None:
    assert word("ru", "verdict.near", count=count, positions="3").startswith(f"{shown} 3:")


@pytest.mark.parametrize("name", ["length", "text", "none", "link 3", "AB or CD"])
def test_a_name_of_the_scene_is_not_translated(name: str) -> None:
    fault = Fault("s.toml", 1, 1, (), "", "unknown_point", {"name": name, "suggestion": message("advice.delete")})
    assert f"точки {name} нет. Исправьте: удалите его." in fault.worded("ru")
    assert term("ru", "plan", name) == name


def test_a_language_without_words_is_told_in_english(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text('[sheet]\nlanguage = "fr"\n', "utf-8")
    assert language_of(scene) == ENGLISH


# Errors that end a command whose scene has a language; a TypeError is a bug of ours, and a fault has words of its own.
ERRORS = re.compile(r"(Limit|Sheet|Sketch|Structure|File|Draft)Error|SelfCheckFailed|NoExtreme|UnknownMark|UnknownName")
# What a user cannot bring about, or what no scene is at hand for: the pens' own demands.
ASIDE = re.compile(r"drawings/(pens|bench)/|plans/bench/|(strokes|lettering|words)\.py")
FILES = [path for top in ("plans", "drawings") for path in sorted((ROOT / top).rglob("*.py"))]


def called(node: ast.expr) -> str:
    """Give the name that a call goes by: no longer path than of two words is asked for."""
    if isinstance(node, ast.Attribute):
        return f"{node.value.id}.{node.attr}" if isinstance(node.value, ast.Name) else ""
    return node.id if isinstance(node, ast.Name) else ast.unparse(node)


@cache
def nodes(path: Path) -> tuple[Asked, ...]:
    """Give what a file raises, calls and compares; it is read once for all that is asked of it."""
    return parsed(path.read_text("utf-8")).asked


def sentences(path: Path) -> Iterator[str]:
    """Give what a file raises that is a text of its own, and not words by their key."""
    for node in nodes(path):
        error = node.exc if isinstance(node, ast.Raise) else None
        if isinstance(error, ast.Call) and ERRORS.fullmatch(ast.unparse(error.func)):
            yield from (ast.unparse(text) for text in error.args if isinstance(text, ast.JoinedStr | ast.Constant))


def test_what_ends_a_command_is_raised_by_its_key() -> None:
    found = {path.relative_to(ROOT).as_posix(): list(sentences(path)) for path in FILES}
    assert {path: texts for path, texts in found.items() if texts and not ASIDE.search(path)} == {}


# A sheet that cannot be read is refused by a key of its own group.
REFUSALS = ("SheetRefused", "OverLimit", "type(refused)")


def keys(path: Path) -> Iterator[str]:
    """Give the keys that a file names as they are; the reason of a step and that of a refused sheet by its own name."""
    for node in nodes(path):
        name = called(node.func) if isinstance(node, ast.Call) else ""
        if isinstance(node, ast.Call) and name in REFUSALS and path.name != "limits.py":
            yield from (
                f"unreadable.{one.value}" for one in ast.walk(node.args[0]) if isinstance(getattr(one, "value", 0), str)
            )
        if isinstance(node, ast.Call) and name in ("message", "words.word", "word", "say", "because"):
            named = (one.value for part in node.args for one in ast.walk(part) if isinstance(one, ast.Constant))
            texts = [one for one in named if isinstance(one, str)]
            yield from (f"step.{one}" if name == "because" else one for one in texts)


def test_every_key_that_is_named_is_there() -> None:
    named = {key for path in FILES for key in keys(path) if re.fullmatch(r"[a-z]+\.[a-z_0-9]*[a-z0-9]", key)}
    assert len(named) > 150
    assert named <= words(ENGLISH).keys()
    assert sum(key.startswith("unreadable.") for key in named) > 60


def test_no_phrase_is_left_over() -> None:
    """Of groups whose keys are named as they are, every one is asked for."""
    groups = ("step", "advice", "limit", "gap", "refused", "structure", "sketch", "stroke", "extreme", "mark", "wrong",
              "unreadable", "aside")  # fmt: skip
    texts = "\n".join(path.read_text("utf-8") for path in FILES)
    own = [key for key in words(ENGLISH) if key.partition(".")[0] in groups]
    bare = {key: re.sub(r"^(step|wrong|unreadable)\.", "", key) for key in own}
    assert [key for key in own if f'"{bare[key]}"' not in texts and f'"{key}"' not in texts] == []


def terms(path: Path) -> Iterator[str]:
    """Give what a file says of a key that is missing or wrong: names of things, which every language has as terms."""
    for node in nodes(path):
        if not isinstance(node, ast.Call):
            continue
        name, given = called(node.func), [word.value for word in node.keywords if word.arg in ("wanted", "kind")]
        if name in ("Missing", "Kind", "_kind"):
            given = node.args[:1]
        elif name not in ("wrong", "fault", "source.fault", "survey.report"):
            given = []
        yield from (one.value for one in given if isinstance(one, ast.Constant) and isinstance(one.value, str))


def test_what_is_said_of_a_key_is_a_term() -> None:
    told = {one for path in FILES for one in terms(path) if path.parts[-2] != "bench"}
    assert len(told) > 30
    assert {one for one in told if f"term.{one}" not in words(ENGLISH)} == set()


def test_plans_and_sheets_have_names() -> None:
    for row in techniques().values():
        named = [*(f"plan.{plan}" for plan in row.plans), *(f"kind.{sheet}" for sheet in row.sheets)]
        assert set(named) <= words(ENGLISH).keys()
    assert {f"untitled.{name}" for name, row in techniques().items() if not row.needs} <= words(ENGLISH).keys()
    assert {f"dyad.{kind}" for kind in NUMBERS} <= words(ENGLISH).keys()


# What is written with a hyphen between spaces: the sign itself, among those that a name may have.
HYPHENS = {"fault.bare_key.expected"}


@pytest.mark.parametrize("language", languages())
def test_a_hyphen_stands_for_no_dash_and_no_minus(language: str) -> None:
    phrases = {key: [phrase] if isinstance(phrase, str) else phrase for key, phrase in words(language).items()}
    hyphened = {key for key, own in phrases.items() if any(re.search(r"(?<=\S) - ", text) for text in own)}
    assert hyphened <= HYPHENS, hyphened - HYPHENS

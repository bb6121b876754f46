"""Words (слова): every phrase of plandraft by its key, in a file for each language: `en.json`, `ru.json`.

What one technique alone says may stand in the `words.json` of its folder, by languages.

All languages have the same keys with the same parts. In a phrase {name} stands for a part as it is; {name:term} for the
word that the group "term" has for it; {size:number} for a number's text with the decimal mark of the language;
{names:or} for a list, joined as "join.or" says. A phrase in several forms is a plural: by the language's patterns of
numbers under "plural" the part `count` chooses one of them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

FOLDER = Path(__file__).parent
ENGLISH = "en"
ALONE = "cw"  # the index of the only counterweight, which each language writes in its own letters
Phrase = str | list[str]


@cache
def languages() -> tuple[str, ...]:
    """Give the languages that there are words in."""
    return tuple(sorted(file.stem for file in FOLDER.glob("*.json")))


class Message(NamedTuple):
    """What is to be said, by its key and its parts; in English where nobody asks for a language."""

    key: str
    parts: tuple[tuple[str, object], ...] = ()

    def worded(self, language: str) -> str:
        """Say it in a language."""
        return word(language, self.key, **dict(self.parts))

    def __str__(self) -> str:
        return self.worded(ENGLISH)


def message(key: str, /, **parts: object) -> Message:
    """Make what is to be said; parts may be messages themselves, lists are tuples.

    >>> str(message("advice.meant", names=('"AB"', '"CB"')))
    'did you mean "AB" or "CB"?'
    """
    return Message(key, tuple(parts.items()))


def because(key: str, /, **parts: object) -> Message:
    """Give the reason of a drafting step, by its key among the steps.

    >>> because("link", link=4).worded("ru")
    'звено 4'
    """
    return Message(f"step.{key}", tuple(parts.items()))


def placed(where: object, what: object) -> Message:
    """Say of which place in a file something is said."""
    return message("placed", where=where, what=what)


def said(thing: object, language: str) -> str:
    """Say a thing in a language: a message by its words, an error by what it was raised with, all else as it is."""
    if isinstance(thing, Exception) and len(thing.args) == 1:
        thing = thing.args[0]
    worded: Callable[[str], str] | None = getattr(thing, "worded", None)
    return str(thing) if worded is None else worded(language)


def word(language: str, key: str, /, **parts: object) -> str:
    """Give the phrase of a key in a language, with its parts.

    >>> word("ru", "sheet.velocities", position=2), word("en", "fault.missing.expected", thing="mass")
    ('План скоростей, положение 2', 'this mass')
    """
    phrase = words(language)[key]
    if not isinstance(phrase, str):
        phrase = phrase[min(_plural(language, parts["count"]), len(phrase) - 1)]
    return phrase.format_map({name: _PhrasePart(part, language) for name, part in parts.items()})


def term(language: str, group: str, name: str) -> str:
    """Give the word of a language for one of the names of a group; a name that the group has not is the scene's own.

    >>> term("ru", "unit", "rad/s"), term("ru", "symbol", "F_us"), term("ru", "symbol", "F_D")
    ('рад/с', 'F_п.с', 'F_D')
    """
    phrase = words(language).get(f"{group}.{name}")
    return phrase.format() if isinstance(phrase, str) else name


PRINTED = ("natural", "form_value", "during", "rod_on")  # groups of words that sheets and reports print for a choice


def spoken(language: str, name: str, group: str = "kind") -> tuple[str, ...]:
    """Give what a language calls a word of a fixed choice: in short, and as it is printed.

    >>> spoken("ru", "roller")
    ('ролик', 'роликовый')
    """
    said = (one.strip() for part in (group, *PRINTED) for one in term(language, part, name).split(","))
    return tuple(dict.fromkeys(one for one in said if one != name))


def written(name: str, language: str) -> str:
    """Write the letters of a vector as a language does.

    >>> written("m_cwD_cwh_cw", "ru"), written("m_IID_II", "ru")
    ('m_прD_прh_пр', 'm_IID_II')
    """
    return name.replace(f"_{ALONE}", f"_{word(language, 'sheet.counterweight index')}")


@cache
def words(language: str) -> Mapping[str, Phrase]:
    """Read the phrases of a language, by keys such as "fault.missing.advice": those of all, and those of techniques."""
    groups = [json.loads((FOLDER / f"{language}.json").read_text("utf-8"))]
    groups += (json.loads(path.read_text("utf-8")).get(language, {}) for path in own_words())
    return {key: phrase for group in groups for key, phrase in flat(group)}


def own_words() -> list[Path]:
    """List the files of words that techniques have in their folders."""
    return sorted(Path(__file__).parents[1].glob("*/words.json"))


def flat(group: Mapping[str, object], path: str = "") -> Iterator[tuple[str, Phrase]]:
    """Give the phrases of a group and of those within it by their whole keys."""
    for key, entry in group.items():
        if isinstance(entry, dict):
            yield from flat(entry, f"{path}{key}.")
        elif isinstance(entry, str | list):
            yield path + key, entry


def _plural(language: str, count: object) -> int:
    """Choose the form in which a language counts so many."""
    patterns = words(language)["plural"]
    return next((k for k, pattern in enumerate(patterns) if re.search(pattern, str(count))), len(patterns))


class _PhrasePart:
    """A part of a phrase, written as the phrase asks for it."""

    __slots__ = ("language", "value")

    def __init__(self, value: object, language: str) -> None:
        self.value, self.language = value, language

    def __format__(self, wish: str) -> str:
        value = self.value
        if not wish or isinstance(value, Message):
            return said(value, self.language)
        if wish == "choice" and isinstance(value, tuple):  # words of a file, English, beside those of another language
            known = ((name, *spoken(self.language, name)[: self.language != ENGLISH]) for name in value)
            value = tuple(f"{name} ({said[0]})" if said else name for name, *said in known)
        if isinstance(value, tuple):
            return _joined([said(name, self.language) for name in value], *words(self.language)[f"join.{wish}"])
        if wish == "number":
            minus, decimal = (word(self.language, f"number.{sign}") for sign in ("minus", "decimal"))
            return re.sub("^-", minus, str(value)).replace(".", decimal)
        if wish == "quoted":  # a name of the scene's own; a number needs no quotes
            return str(value) if str(value).isdigit() else word(self.language, "quoted", name=value)
        return term(self.language, wish, str(value))


def _joined(names: list[str], between: str, last: str) -> str:
    return last.join(filter(None, (between.join(names[:-1]), *names[-1:])))

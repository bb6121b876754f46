"""Wording: what plandraft says, in the reader's language (формулировки).

Faults and notes of a scene are data, worded by their kind from the language's table. Every other message is an English
sentence where it arises; here it is found by its form, and said in the other language with the same data.
"""

from __future__ import annotations

import re
import string
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Protocol

# Placeholders and details that hold a phrase of ours, to be said in the language too; all others hold the scene's own
# words: a point may be named "length".
PHRASES = frozenset(
    (
        *("advice", "either", "example", "found", "hint", "kind", "lengths", "links", "message", "others", "plan"),
        *("reason", "suggestion", "table", "tables", "thing", "twin", "wanted", "why"),
    )
)
# Faults that are raised as sentences, within another error.
RAISED = ("mobility",)


class Words(Protocol):
    """The table of one language."""

    CODE: str
    FAULT: str
    NOTE: str
    MORE: str
    FAULTS: Mapping[str, tuple[str, str]]
    NOTES: Mapping[str, tuple[str, str]]


def table(language: str) -> Words:
    """Give the table of a language; English where there is no other."""
    if language == "ru":
        from plans.scene.messages import russian  # noqa: PLC0415  (only a message in that language pays for it)

        return russian
    from plans.scene.messages import english  # noqa: PLC0415  (only a message pays for it)

    return english


def said(text: str, language: str) -> str:
    """Say a message in a language; what is no message of plandraft, such as a name of the scene, stays as it is.

    Where it stands comes first and is no language.

    >>> said("scene.toml:4:1: mechanism.links: did you mean \\"AB\\"?", "ru")
    'scene.toml:4:1: mechanism.links: возможно, "AB"?'
    >>> said('Fix: did you mean "working stroke"?', "ru")
    'Fix: возможно, "working stroke"?'
    """
    if language != "ru":
        return text
    for start in _starts(text):
        for english, russian in _sentences():
            found = _match(english, text[start:])
            if found is not None:
                details = {name: said(value, language) if name in PHRASES else value for name, value in found.items()}
                return text[:start] + russian.format_map(details)
    return text


def _starts(text: str) -> Iterator[int]:
    yield 0
    yield from (match.end() for match in re.finditer(": ", text))


@cache
def _sentences() -> list[tuple[str, str]]:
    """Give all sentences, those with the most words of their own first: "{a} or {b}" fits what others say better."""
    from plans.scene.messages.sentences import SENTENCES  # noqa: PLC0415  (see table)

    sentences = {**SENTENCES, **{_whole(table("en"), kind): _whole(table("ru"), kind) for kind in RAISED}}
    return sorted(sentences.items(), key=lambda pair: -len(re.sub(r"\{\w*\}", "", pair[0])))


def _whole(words: Words, kind: str) -> str:
    """Give the whole sentence of a kind of fault."""
    expected, advice = words.FAULTS[kind]
    return words.FAULT.replace("{expected}", expected).replace("{advice}", advice) + "."


def _match(sentence: str, text: str) -> Mapping[str, str] | None:
    """Find a sentence's data in a text of its form."""
    if not text.startswith(sentence.split("{", 1)[0]):
        return None  # without a pattern made for it
    found = _form(sentence).fullmatch(text)
    return found.groupdict() if found else None


@cache
def _form(sentence: str) -> re.Pattern[str]:
    """Turn a sentence into a pattern; a placeholder of one letter stands for one word, or for what is in quotes."""
    form = ""
    for literal, name, _, _ in string.Formatter().parse(sentence):
        form += re.escape(literal)
        if name:
            word = '[^"]+' if literal.endswith('"') else "[^ ]+"
            form += f"(?P<{name}>{word if len(name) == 1 else '.+?'})"
    return re.compile(form, re.DOTALL)

"""Every letter that a sheet or its tables state is explained as it stands there, in either language."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from drawings.commands.explain import explained
from drawings.commands.on_sheet import levelled
from drawings.gallery.catalogue import Entry, catalogue
from drawings.paper.strokes import Kind, Leaf
from drawings.paper.walk import groups, texts
from drawings.sheets.kind import sheet_kind
from plans.explanation import UnknownMark
from plans.scene.scene import Scene, read_scene
from plans.study import Study
from tests import parts

# One of each technique is asked every day, in Russian; the others, and all in English, with `--whole`.
EVERYDAY = {"shaper-loaded", "four-masses", "press", "automaton", "lanchester", "four-bar-balance", "coupled-wheels"}
SYMBOL = re.compile(r"[ΣΔ]*[^\W\d_]['′]*([_^].+|[\w'·{}^π()]{0,3}|/.+)")
CELL = re.compile(r"(, [^,]+)? \[\d+\]$")  # behind the name of a row: its unit, and the column
# What a sheet letters, though it rests on no step and is no quantity: axes, dimensions that are given, times.
GIVEN = ("load_diagram", "flywheel_sketch", "tachogram", "manufacturing", "bars")
WORDLESS = {"riveter"}  # its table of the reduction has angles alone for rows
EQUAL = re.compile(r"(?<![\w^·])([ΣΔ]*[^\W\d_][′']*(?:[_^]\w+)*)\s*=")  # what a phrase gives the value of: no factor


def letters(leaf: Leaf) -> Iterator[tuple[int, str]]:
    """Give position and letters of vectors and points of a sheet, of the rows of its tables, and in its phrases."""
    for group in groups(leaf.groups):
        kind, plan = group.data.get("kind"), group.data.get("plan", "")
        if kind in ("vector", "point") and not plan.startswith(GIVEN):
            yield int(group.data.get("position") or 0), group.title.partition(" = ")[0]
        if group.states and group.states.kind == Kind.NUMBER:
            for one in CELL.sub("", group.states.name).split(" = "):
                yield group.states.position or 0, one.partition(" (")[0]
    yield from ((0, found) for text in texts(leaf.groups) for found in EQUAL.findall(levelled(text)))


def asked(scene: Scene) -> Iterator[tuple[int, str]]:
    """Give what is asked of a scene: letters alone, those of one of several cams with its name."""
    study = Study(scene)
    for sheet in scene.sheets:
        for leaf in sheet_kind(sheet).leaves(study):
            of = f"{leaf.metadata['cam']}:" if leaf.metadata.get("cam") else ""
            for position, letter in letters(leaf):
                ends = letter.split(" ")  # "p a": of a vector of a plan; what has more parts is said in words
                if len(ends) < 3 and all(map(SYMBOL.fullmatch, ends)):
                    yield position, f"{of}{letter}"


def rows() -> Iterator[object]:
    for one in catalogue():
        for language in ("ru", "en"):
            daily = one.name in EVERYDAY and language == "ru"
            if daily or parts.whole:
                yield pytest.param(one, language, id=f"{one.name}-{language}", marks=() if daily else pytest.mark.rest)


@pytest.mark.parametrize(("entry", "language"), list(rows()))
def test_every_letter_of_a_sheet_is_explained_as_it_stands(entry: Entry, language: str) -> None:
    scene = read_scene(entry.path)
    scene = scene.changed(sheet=scene.sheet.changed(language=language))
    study, refused = Study.of_all(scene), []
    told = dict.fromkeys(asked(scene))
    for position, letter in told:
        try:
            found = explained(study, position, letter)
        except UnknownMark as unknown:
            refused.append((letter, str(unknown)[:80]))
        else:
            assert found.steps or found.notes
    assert refused == []
    assert told or entry.name in WORDLESS

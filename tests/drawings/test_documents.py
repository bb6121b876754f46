"""Documents of a set: sheets of one designation are numbered through; a wrong number or designation is withheld."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import pytest

from drawings.checks.readers import block_faults
from drawings.page.frame import NUMBERS
from drawings.page.page import Page, page_of
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import groups, texts
from drawings.sheets.documents import bind, cuts
from plans.scene.faults import SceneError
from plans.scene.scene import Scene, parse_scene

ROTOR = "[rotor]\nspeed = 100\n[[rotor.masses]]\nmass = 1\nradius = 0.1\nangle = 0\n"
SHEETS = {"kinematics": 2, "forces": 1, "cam": 2}
OWN = '[sheet.designations]\nforces = "ТММ.05.12.002"\n'


def scene_of(more: str = "") -> Scene:
    return parse_scene(f'{ROTOR}[sheet]\ndesignation = "TMM 05.12"\n{more}')


def laid_out(scene: Scene) -> Mapping[str, Sequence[Leaf]]:
    """Lay out sheets that bear a title block alone, counted kind by kind as they are before they are bound."""
    return {kind: [leaf(page_of(scene, kind), k + 1, count) for k in range(count)] for kind, count in SHEETS.items()}


def leaf(page: Page, number: int, count: int) -> Leaf:
    entries = {"designation": page.designation, "sheet": str(number), "sheets": str(count)}
    return Leaf(*page.size, (page.title_block(entries, "en"),), metadata={"sheet": "kinematics"})


def numbers(leaves: Mapping[str, Sequence[Leaf]]) -> list[list[str]]:
    found = (group for own in leaves.values() for one in own for group in groups(one.groups) if group.name == NUMBERS)
    return [[text.plain for text in texts(group.strokes)] for group in found]


def wrong(leaves: Mapping[str, Sequence[Leaf]], scene: Scene) -> list[str]:
    return [str(fault) for own in leaves.values() for one in own for fault in block_faults(one, scene.sheet)]


def test_all_sheets_of_a_scene_are_one_document_unless_it_says_otherwise() -> None:
    bound = bind(laid_out(scene_of()), scene_of())
    assert numbers(bound) == [["1", "5"], ["2"], ["3"], ["4"], ["5"]]
    assert bound["forces"][0].metadata["document"] == {"designation": "TMM 05.12", "sheet": 3, "sheets": 5}
    assert wrong(bound, scene_of()) == []


def test_sheets_with_a_designation_of_their_own_are_a_document_of_their_own() -> None:
    scene = scene_of(OWN)
    bound = bind(laid_out(scene), scene)
    assert numbers(bound) == [["1", "4"], ["2"], ["1"], ["3"], ["4"]]
    assert "ТММ.05.12.002" in [text.plain for text in texts(bound["forces"][0].groups)]
    assert "ТММ.05.12.002" not in [text.plain for text in texts(bound["cam"][0].groups)]
    assert wrong(bound, scene) == []


def misnumbered(one: Leaf, page: Page) -> Group:
    return page.numbers(2, 7)


def misnamed(one: Leaf, page: Page) -> Group:
    return replace(page, designation="TMM 05.21").title_block(
        {"designation": "TMM 05.21", "sheet": "1", "sheets": "5"}, "en"
    )


@pytest.mark.parametrize(
    ("plant", "says"),
    [(misnumbered, "number 1 of 5 in the title block"), (misnamed, "designation TMM 05.12 in the title block")],
)
def test_a_title_block_that_says_otherwise_is_withheld(plant: Callable[[Leaf, Page], Group], says: str) -> None:
    scene = scene_of()
    bound = dict(bind(laid_out(scene), scene))
    first = bound["kinematics"][0]
    other = first._replace(groups=(plant(first, page_of(scene)),))
    told = wrong({**bound, "kinematics": (other, *bound["kinematics"][1:])}, scene)
    assert any(says in one for one in told)


LONG = "Kinematics, forces and motion of a machine that slots gears with a swinging guide"


def told(**table: str) -> list[str]:
    """Say what a title block cuts of a scene."""
    text = f"title = {table.pop('title', '')!r}\n{ROTOR}[sheet]\n" + "\n".join(f"{k} = {v!r}" for k, v in table.items())
    scene = parse_scene(text)
    page = page_of(scene)
    entries = {"title": scene.title, "subtitle": "Balancing of a rotor", **table}
    sheet = Leaf(*page.size, (page.frame(), page.title_block(entries, "en")), title="", description="", metadata={})
    return [fault.worded("en") for fault in cuts({"rotor": (sheet,)}, scene)]


@pytest.mark.parametrize("standard", ["GOST", "ISO"])
def test_what_is_cut_all_the_same_is_told_at_its_line_with_the_letters_that_fit(standard: str) -> None:
    (note,) = told(title=" ".join([LONG] * 8), standard=standard)  # ISO 7200 counts on 25 letters, and on 25 more
    assert note.startswith("scene.toml:1:1: title = ")
    fitting = int(note.rpartition("about ")[2].split()[0])
    assert 2 * 25 < fitting < 8 * len(LONG)
    assert told(title=" ".join([LONG] * 8)[: fitting - 20], date="2026-11-21", standard=standard) == []
    assert "sheet.date = " in told(date="November-2026-" * 3, standard=standard)[0]


@pytest.mark.parametrize("standard", ["GOST", "ISO"])
def test_a_designation_is_never_cut(standard: str) -> None:
    assert told(designation="TMM.05.12.000.001 A-B.002", standard=standard) == []
    with pytest.raises(SceneError, match=r"scene.toml:9:1: sheet.designation = .* shorten it to \d+ letters"):
        told(designation="-".join([LONG.replace(" ", "-")] * 4), standard=standard)

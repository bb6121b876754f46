"""A whole force sheet drawn by hand: no letter touches a line, every force is measured back, each bears its letter."""

import pytest

from drawings.checks.letters import unlettered
from drawings.measure.measure import check, measure
from drawings.page.page import Page
from drawings.paper.strokes import Group, Leaf
from drawings.pens.svg import svg
from tests.drawings import force_specimen
from tests.drawings.collisions import collisions
from tests.parts import first

PAGES = [Page("A1"), Page("A1", "portrait", language="ru"), Page("A3", language="ru"), Page("A4", standard="ISO")]
every_page = pytest.mark.parametrize(
    "page", first(PAGES), ids=lambda page: f"{page.name}-{page.orientation}-{page.standard}"
)


@pytest.mark.rest
@every_page
def test_no_letter_of_a_force_sheet_touches_anything(page: Page) -> None:
    assert [touched for leaf in force_specimen.leaves(page) for touched in collisions(leaf)] == []


@pytest.mark.rest
@every_page
def test_every_force_is_measured_back_and_bears_its_letter(page: Page) -> None:
    names: set[str] = set()
    for leaf in force_specimen.leaves(page):
        found = measure(svg(leaf))
        assert check(found) == [] and list(unlettered(leaf)) == []
        names |= {f"{vector.plan} {vector.name}" for vector in found.vectors}
    assert {"polygon-1 R_01", "polygon-2-3 R_03", "scheme-4-5 h_1", "hodograph R_34"} <= names


def test_a_force_without_its_letter_is_told() -> None:
    leaf = force_specimen.leaves(Page("A1"))[0]
    letters = next(
        k for k, group in enumerate(leaf.groups) if "R12" in _plain(group) and not group.name and not group.data
    )
    bare = Leaf(leaf.width, leaf.height, (*leaf.groups[:letters], *leaf.groups[letters + 1 :]))
    assert "the letter R_12 on polygon-2-3" in list(map(str, unlettered(bare)))


def _plain(group: Group) -> set[str]:
    return {getattr(stroke, "plain", "") for stroke in group.strokes}

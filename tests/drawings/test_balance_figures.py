"""What the sheet of a balanced mechanism shows, read back: places by the book, sizes to scale, no arrow of nothing."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest

from drawings.balance.costs import change
from drawings.balance.sheet import leaves
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, measure
from drawings.page.scale import drafting_of
from drawings.paper.strokes import Arc, Group, Leaf, Stroke
from drawings.paper.walk import groups, texts, walk
from drawings.pens.svg import svg
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.banks import ENGINE, FOUR_BAR, counterweight

HEAD = 'sheets = ["balancing"]\n'
FULL = '[balance]\naim = "full"\n'
SECTOR = counterweight("on = 1", 'shape = "sector"')
FOOT = '[sheet]\nformat = "{}"\nlanguage = "{}"\nposition = 2\n'


def study(linkage: str, balance: str, size: str = "A2", language: str = "en") -> Study:
    return Study(parse_scene(HEAD + linkage + balance + FOOT.format(size, language)))


def measured(leaf: Leaf) -> Measured:
    return measure(svg(lettered(leaf)))


def marks(sheets: Sequence[Leaf], plan: str) -> dict[str, complex]:
    """Give all that is measured on a figure by its names, in true units."""
    every = [one for sheet in map(measured, sheets) for one in (*sheet.points, *sheet.vectors)]
    return {one.name: one.value for one in every if one.plan == plan}


def figure(sheets: Sequence[Leaf], name: str) -> Group:
    return next(group for leaf in sheets for group in groups(leaf.groups) if group.name == name)


def lines(sheets: Sequence[Leaf], name: str) -> list[Stroke]:
    return list(walk((figure(sheets, name),)))


def cells(sheets: Sequence[Leaf], table: str) -> list[str]:
    found = (group for leaf in sheets for group in groups(leaf.groups) if group.name.startswith(f"{table}-"))
    return [text.plain for group in found for text in texts((group,))]


@pytest.fixture(scope="module")
def four_bar() -> tuple[Leaf, ...]:
    """The book's variant b: counterweights on the crank and on the rocker."""
    return leaves(study(FOUR_BAR, FULL + counterweight("on = 3", "mass = 8") + counterweight("on = 1", "mass = 5")))


def test_counterweights_stand_on_their_links_where_the_book_has_them(four_bar) -> None:
    own = marks(four_bar, "scheme-after")
    off = {"m_cw3": abs(own["m_cw3"] - own["C"]), "m_cw1": abs(own["m_cw1"])}
    assert off == pytest.approx({"m_cw3": 0.18, "m_cw1": 0.06}, abs=1e-6)
    along = (own["m_cw3"] - own["C"]) / (own["B"] - own["C"])
    assert along == pytest.approx(-0.6, abs=1e-5)
    assert own["m_cw1"] / own["A"] == pytest.approx(-0.6, abs=1e-5)


def test_main_points_lead_to_the_mass_centre_and_after_to_a_point_of_the_frame(four_bar) -> None:
    for state, sizes in (("before", (0.08909090909, 0.2472727273, 0.05454545455)), ("after", None)):
        own = marks(four_bar, f"scheme-{state}")
        chain = [own[f"h_{link}"] for link in (1, 2, 3)]
        assert sum(chain) == pytest.approx(own["S"], abs=1e-6)
        bars = own["A"], own["B"] - own["A"], own["C"] - own["B"]
        shares = [vector / bar for vector, bar in zip(chain, bars, strict=True)]
        if sizes:
            assert [abs(one) for one in chain] == pytest.approx(sizes, abs=1e-6)
            assert all(share.imag == pytest.approx(0, abs=1e-5) for share in shares)
        else:  # both contours are alike
            assert own["S"] == pytest.approx(0.2158333333, abs=1e-6)
            assert shares == pytest.approx([0.2158333333 / 0.35] * 3, abs=1e-5)


def test_static_moments_are_laid_end_to_end_to_their_sum(four_bar) -> None:
    own = marks(four_bar, "static-moments")
    parts = [own[f"m_{link}r_S{link}"] for link in (1, 2, 3)]
    assert sum(parts) == pytest.approx(own["mr_S"], abs=1e-5)
    assert own["mr_S"] / 11 == pytest.approx(marks(four_bar, "scheme-before")["S"], abs=1e-5)


@pytest.mark.rest
def test_a_disc_and_a_sector_are_drawn_to_scale_and_told() -> None:
    own = leaves(study(FOUR_BAR, FULL + counterweight("on = 3", "mass = 8") + SECTOR, "A3"))
    (mu,) = {
        float(group.data["scale"]) for group in groups((figure(own, "scheme-after"),)) if group.data.get("name") == "S"
    }
    disc = math.sqrt(8 / (7850 * 0.03 * math.pi))
    # m r = 2/3 rho b sin(60 deg) R^3 = -0.3 kg*m of which the link has 0.08: (8.8) of variant b
    sector = math.cbrt(0.3 / (2 / 3 * 7850 * 0.03 * math.sin(math.pi / 3)))
    arcs = [one for one in lines(own, "scheme-after") if isinstance(one, Arc)]
    assert any(one.radius * mu == pytest.approx(disc, rel=1e-9) and one.sweep == 2 * math.pi for one in arcs)
    tips = [one for one in arcs if one.radius * mu == pytest.approx(sector, rel=1e-9)]
    assert [one.sweep for one in tips] == pytest.approx([2 * math.pi / 3])
    told = cells(own, "counterweights")
    assert {"sect. 120°", "disc", "103.99", "180", "C", "O"} <= set(told)


def test_a_mechanism_that_is_balanced_already_has_no_second_scheme_and_no_arrow() -> None:
    still = FOUR_BAR.replace("0.04, 0", "0, 0").replace("mass = 4", "mass = 0").replace("mass = 5", "mass = 0")
    own = leaves(study(still, FULL + counterweight("on = 3", "mass = 8") + counterweight("on = 1", "mass = 5"), "A3"))
    assert {name for leaf in own for name in leaf.metadata["figures"]} == {"scheme-before", "static-moments"}
    kinds = [one.data.get("kind") for leaf in own for one in groups(leaf.groups)]
    assert "vector" not in kinds
    assert cells(own, "counterweights").count("0") == 4
    assert "∠, °" in cells(own, "counterweights")


@pytest.mark.parametrize(
    ("before", "after", "told"), [(50.0, 75.0, "+50"), (50.0, 0.0, "−100"), (0.0, 1.0, "—"), (1.0, 1.0, "0")]
)
def test_a_change_is_told_in_per_cent(before: float, after: float, told: str) -> None:
    assert change(before, after, drafting_of(parse_scene(HEAD + ENGINE + "[balance]\n"))) == told

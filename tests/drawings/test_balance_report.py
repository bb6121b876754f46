"""What is said of a balance: the textbook's equations with its numbers put in, what is left, what it costs."""

from __future__ import annotations

import re
from functools import cache

import pytest

from drawings.balance.notes import BalanceNotes
from drawings.balance.report import chapters, headline
from drawings.balance.sheet import leaves
from drawings.lettering.words import decimal
from drawings.page.scale import drafting_of
from drawings.report.report import report
from plans.balance.study import BalanceStudy
from plans.model.balance.linkage import FULL, PARTIAL, SHARE, Place
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.balance_scenes import scene
from tests.drawings.pages import texts
from tests.drawings.planting import ROOT
from tests.parts import first
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, asked, study

WORDS = re.compile(r"\b(the|of|to|is|on|in|by|and|with|at|link|kg)\b")
# Worked values of methods M7.4-M7.7, by what is balanced and by what: each is told to the digits of a sheet.
BOOK = {
    "four-bar, a": (
        FOUR_BAR,
        asked(FULL, Place(1, mass=9.0), Place(2, mass=6.0)),
        (
            "Vectors of main points (8.7):  h_{1} = (m_{1}·l_{OS1} + (m_{2} + m_{3})·l_{OA})/m = ",
            "(2·0.04 + 9·0.1)/11 = 0.089091 m",
            "h_{2} = (m_{2}·l_{AS2} + m_{3}·l_{AB})/m = (4·0.18 + 5·0.4)/11 = 0.24727 m",
            "h_{3} = m_{3}·l_{BS3}/m = 5·0.12/11 = 0.054545 m",
            "must be −1.3 kg·m",
            "a_{1} = −1.38/9 = −0.15333 m",
            "must be −1.2 kg·m",
            "a_{2} = −1.92/6 = −0.32 m",
            "main-point vectors in proportion to the links (8.8):  h_{1}/l_{OA} = h_{2}/l_{AB} = h_{3}/l_{BC} = ",
            "κ = 0.076923",
            "S rests in (0.026923; 0) m",
            "Counterweights of 15 kg are added to links of 11 kg",
        ),
    ),
    "four-bar, b": (
        FOUR_BAR,
        asked(FULL, Place(1, radius=0.06), Place(3, mass=8.0)),
        (
            "must be −0.22 kg·m",
            "m_{cw1} = 0.3/0.06 = 5 kg",
            "a_{3} = −1.44/8 = −0.18 m",
            "S rests in (0.21583; 0) m",
        ),
    ),
    "six-link": (
        SIX_LINK,
        None,
        (
            "(2·0.04 + 17·0.1)/19 = 0.093684 m",
            "(m_{2}·l_{AS2} + (m_{3} + m_{4} + m_{5})·l_{AB})/m = (4·0.18 + 13·0.4)/19 = 0.31158 m",
            "h_{3} = (m_{3}·l_{BS3} + (m_{4} + m_{5})·l_{BD})/m = (5·0.12 + 8·0.2)/19 = 0.11579 m",
            "= 0.12632 m",
            "h_{5} = m_{5}·l_{ES5}/m = 6·0.02/19 = 0.0063158 m",
        ),
    ),
    "engine, in part": (
        ENGINE,
        asked(PARTIAL, Place(1, mass=2.0)),
        (
            "must be −0.25 kg·m",
            "a_{1} = −0.37/2 = −0.185 m",
            "main-point vectors in proportion to the links (8.9):  h_{1}/l_{OA} = h_{2}/l_{AB}",
            "κ = 0.55882",
            "9.5 kg",
        ),
    ),
    "engine, in full": (
        ENGINE,
        asked(FULL, Place(1, mass=28.0), Place(2, mass=16.0)),
        ("a_{2} = −3.8/16 = −0.2375 m", "= −0.10429 m", "h_{1} = h_{2} = h_{3} = 0", "S rests in (0; 0) m"),
    ),
    "engine, a half": (
        ENGINE,
        asked(SHARE, Place(1, mass=2.0), share=0.5),
        ("must be −0.725 kg·m", "Of 9.5 kg at B the crank balances the share k = 0.5"),
    ),
    "slotted link": (
        SHAPER,
        asked(FULL, Place(1, mass=6.0), Place(3, mass=160.0), Place(4, mass=30.0)),
        ("= −0.063333 m", "= −0.14333 m", "−40.7/160 = −0.25437 m", "S rests in (0; −0.33298) m"),
    ),
}


def notes(own: BalanceStudy, language: str = "en") -> BalanceNotes:
    vectors = own.points().vectors, None if own.after is None else own.points(after=True).vectors
    drafting = drafting_of(own.linkage.scene)._replace(language=language)
    return BalanceNotes(own.linkage.mechanism, own.tree, own.machine, own.balance, vectors, drafting)


@cache
def study_of(name: str) -> BalanceStudy:
    text, task, _ = BOOK[name]
    return study(text, task)


def told(name: str, language: str = "en") -> str:
    """Give all notes on a machine of the book, in plain spaces."""
    return "\n".join(notes(study_of(name), language).all).replace("\N{NO-BREAK SPACE}", " ")


@pytest.mark.parametrize("name", BOOK)
def test_the_equations_have_the_numbers_of_the_book(name: str) -> None:
    said = told(name)
    for part in BOOK[name][-1]:
        assert part in said


@pytest.mark.parametrize("name", first(BOOK))
def test_it_is_said_in_russian_with_the_same_numbers(name: str) -> None:
    said = told(name, "ru")
    assert not WORDS.search(said)
    assert WORDS.search(told("four-bar, b"))
    assert numbers(said) == [decimal(one, "ru") for one in numbers(told(name))]


def numbers(text: str) -> list[str]:
    """Give the numbers with decimals of a text, those of the book's equations left out."""
    return re.findall(r"\d+[.,]\d+", re.sub(r"\(8\.\d\)", "", text))


def test_hinges_of_the_frame_give_a_constant_vector() -> None:
    """Links 3, 4 and 5 of the slotted link begin in C: 35/40.5 of the way from O to it."""
    assert "h_{0} = (0; −0.30247) m in every position" in told("slotted link")


def test_a_link_on_a_slide_has_a_variable_vector() -> None:
    """A yoke of 4 kg beside a stone of 0.3 kg: 4/4.3 of the way along the guide."""
    text = (ROOT / "drawings" / "gallery" / "scotch-yoke.toml").read_text("utf-8")
    own = Study(parse_scene(re.sub("(?m)^sheets = .*$", 'sheets = ["balancing"]', text) + "\n[balance]\n"))
    said = "\n".join(notes(own["balance"]).all)
    assert "Link 3 hangs on a slide: its vector u_{3} along the guide is variable, 0.93023 of the way" in said


def test_what_needs_nothing_is_said_to_need_nothing() -> None:
    """Catalogue J1: no counterweight, no place in a random direction."""
    own = Study(parse_scene(scene("still")))
    said = "\n".join(notes(own["balance"]).all)
    assert "Balanced in this way already: no counterweight is needed" in said
    assert "added" not in said and "a_{" not in said


def test_least_forces_of_a_slow_machine_are_told_as_of_a_fast_one() -> None:
    """A crank a million times as slow has forces of 1e-10 N, and the same best shares."""
    own = Study(parse_scene(scene("engine", "A1").replace("speed = 20", "speed = 2e-5")))
    (slow,) = notes(own["balance"]).choice()
    assert re.fullmatch(r"The largest Φ is least, 0\.0{9}17162 N, with k = 0\.58994;  .*, 0\.0{9}18176 N, with.*", slow)


@pytest.fixture(scope="module")
def engine() -> Study:
    return Study(parse_scene(scene("engine", "A1")))


def test_the_report_tells_the_balance_and_all_that_it_changes(engine: Study) -> None:
    written = report(engine, {"balancing": leaves(engine)})
    for head in ("## Balancing", "## Counterweights", "## What balancing changes", "## Share of", "## Mass centre and"):
        assert head in written
    rows = [line for line in written.splitlines() if line.startswith("| ")]
    assert any(row.startswith("| m_cw1 | 1 | O | ") for row in rows)
    assert any(row.startswith("| R_01, N | 473 | ") for row in rows)
    assert "do not need" not in written  # its masses are read


def test_the_table_of_shares_has_both_best_ones(engine: Study) -> None:
    found = engine.comparison("balance").analysis.shares
    values = "\n".join(chapters(engine, {}).values)
    for one in (found.least_force, found.least_reaction):
        assert f"| {one.share:.6g} | {one.force:.6g} | {one.reaction:.6g} |" in values


def test_the_screen_says_what_to_put_on_and_what_it_costs(engine: Study) -> None:
    said = headline(engine)
    assert re.search(r"m_cw1 = [\d.]+/0\.06 = [\d.]+ kg; Counterweights of [\d.]+ kg are added to links of 12 kg", said)
    assert "; largest R_01: 473 → " in said


def test_the_best_shares_are_told_beside_what_there_was_without_counterweights(engine: Study) -> None:
    found, said = engine.comparison("balance").analysis, "\n".join(notes(engine["balance"]).all)
    assert re.search(r"The largest Φ is least, [\d.]+ N, with k = ", said)
    assert said.endswith(f"without counterweights it is {found.before.reactions['0-1']:.5g} N")


@pytest.mark.rest
def test_reactions_have_the_letter_that_the_scene_gives_them() -> None:
    own = Study(parse_scene(scene("engine", "A1") + 'reactions = "P"\n'))
    written = [text.plain for leaf in leaves(own) for group in leaf.groups for text in texts(group)]
    assert "P01, N" in written and "R01, N" not in written
    assert "largest P_01: 473 → " in headline(own)

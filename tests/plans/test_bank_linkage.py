"""A bank whose mechanism is a linkage, and couples that are compensated."""

from __future__ import annotations

from fractions import Fraction

import pytest

from plans.analytic.balance import bank as bank_linkage
from plans.analytic.balance.bank import bank_balance
from plans.analytic.balance.mass_centre import bodies
from plans.analytic.kinematics import Analysis
from plans.balance.study import BalanceStudy
from plans.bank.quantities import compare_bank
from plans.bank.study import BankStudy, Linkage, NoTurn
from plans.model.balance.bank import Asked, BankTask, Member
from plans.model.balance.linkage import PARTIAL, Site
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, asked, study
from tests.plans.drawn_banks import BOOK, drawn, summed, task
from tests.rows import over

MEMBERS = (
    Member("1", Fraction(0), Fraction("-0.1"), Fraction(0)),
    Member("2", Fraction("100.5"), Fraction("0.2"), Fraction(-40)),
)
ASKED = (Asked(2, 1.0, 0.1, 0.3),)


def bank(its: BalanceStudy, task: BankTask, after: bool = True) -> BankStudy:
    """Give the bank of a balance's linkage."""
    return BankStudy(task, Linkage(its.linkage, its.points(after), task.speed))


def mechanism(its: BalanceStudy, task: BankTask, after: bool = True) -> bank_linkage.ExactLinkage:
    """Give the linkage for the analysis."""
    linkage, added = its.linkage, its.counterweights if after else ()
    solid, orders = bodies(its.machine, added), (*task.orders, *(one.order for one in task.asked))
    return bank_linkage.ExactLinkage(Analysis(linkage.mechanism), solid, task.speed, linkage.turn.phi, orders)


def test_textbook() -> None:
    """Figures 8.11 and 8.13: the engine that is balanced partly shakes along its guide, methods M7.6 and M7.8."""
    its = study(ENGINE, asked(PARTIAL, Site(1, mass=2)))
    task = BOOK._replace(unit=None)
    for found in (bank(its, task).balance, bank_balance(task, mechanism(its, task))):
        assert [f"{found.force[k].real:.9g}" for k in (0, 90, 180)] == ["475", "-98.1155781", "-285"]
        assert [f"{found.left[k].real:.9g}" for k in (0, 90, 180)] == ["95", "-98.1155781", "95"]
        (one,) = found.compensators
        told = (one.with_crank, one.against, one.residual, one.couple)
        assert [f"{size:.10g}" for size in told] == ["0.475", "0.475", "22.8", "0.114"]


@over("text", (FOUR_BAR, SIX_LINK, SHAPER))
def test_roads_agree(text: str) -> None:
    its, task = study(text), BankTask(None, MEMBERS, -30.0, (1, 2, 3, 5), ASKED)
    comparison = compare_bank(bank(its, task, False), mechanism(its, task, False))
    assert comparison.agrees
    assert all(one.size > 0 for one in comparison.construction.forces.values())


def test_a_scene_with_its_balance() -> None:
    """The bank is of the engine with its counterweight on, by analysis with the counterweight that analysis finds."""
    text = ENGINE.format(positions=12).replace('"forces"', '"kinematics"')
    balance = '[balance]\naim = "partial"\n[[balance.counterweights]]\non = 1\nmass = 2\n'
    task = "[bank]\n[[bank.members]]\ncrank = 0\n[[bank.compensators]]\norder = 1\n"
    comparison = Study(parse_scene(text + balance + task), ["harmonics", "compensators"]).comparison("bank")
    assert comparison.agrees
    assert comparison.analysis.compensators[0].with_crank == pytest.approx(0.475, rel=1e-12)
    bare = Study(parse_scene(text + task), ["harmonics", "accelerations"]).comparison("bank")
    assert bare.agrees and bare.analysis.compensators[0].with_crank > 0.8


def members(*rows: tuple[int, int]) -> tuple[Member, ...]:
    """Give mechanisms in one plane by crank and guide, degrees."""
    return tuple(
        Member(str(k), Fraction(crank), Fraction(0), Fraction(axis)) for k, (crank, axis) in enumerate(rows, 1)
    )


@pytest.mark.parametrize("road", [drawn, summed])
def test_a_mass_that_turns_as_the_crank_does_has_no_offset(road) -> None:
    """A V of 90 degrees: the first harmonic goes round with the crank, and a counterweight on the crank takes it."""
    (one,) = road(task(members((25, 45), (25, -45)))._replace(asked=(Asked(1, 2.0, 0.06, 0.5),))).compensators
    assert one.on_crank and one.with_crank > 0 == one.against
    assert (one.residual, one.couple or 0.0, one.couple_angle) == (0.0, 0.0, None)


def test_a_crank_that_cannot_turn_fully_has_no_harmonics() -> None:
    text = FOUR_BAR.format(positions=12).replace('"forces"', '"kinematics"')
    for was, now in (("AB = 0.40", "AB = 0.20"), ("C = [0.35, 0]", "C = [0.42, 0]"), ("[0.39, 0.30]", "[0.25, 0.2]")):
        text = text.replace(was, now)
    scene = parse_scene(text + "[bank]\n[[bank.members]]\ncrank = 0\n")
    with pytest.raises(NoTurn, match=r"no harmonics of a turn: the crank does not turn fully") as told:
        _ = Study(scene)["bank"]
    assert "гармоник" in told.value.args[0].worded("ru")

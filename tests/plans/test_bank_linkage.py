"""A bank of the scene's linkage: the textbook's engine that is balanced partly, other linkages by both roads."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from plans.analytic.balance import bank as bank_linkage
from plans.analytic.balance.bank import bank_balance
from plans.analytic.balance.mass_centre import bodies
from plans.analytic.kinematics import Analysis
from plans.balance.study import BalanceStudy
from plans.bank.quantities import compare_bank
from plans.bank.study import BankStudy, Linkage
from plans.model.balance.bank import Asked, BankTask, Member
from plans.model.balance.linkage import FULL, PARTIAL, Place
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, asked, study
from tests.plans.drawn_banks import BOOK, drawn, summed
from tests.rows import over

MEMBERS = (
    Member("1", Fraction(0), Fraction("-0.1"), Fraction(0)),
    Member("2", Fraction("100.5"), Fraction("0.2"), Fraction(-40)),
)
ASKED = (Asked(2, 1.0, 0.1, 0.3),)


def bank(its: BalanceStudy, task: BankTask, after: bool = True) -> BankStudy:
    """Give the bank of a balance's linkage."""
    return BankStudy(task, Linkage(its.linkage, its.points(after), task.speed))


def mechanism(its: BalanceStudy, task: BankTask, after: bool = True) -> bank_linkage.Linkage:
    """Give the linkage for the analysis."""
    linkage, added = its.linkage, its.counterweights if after else ()
    solid, orders = bodies(its.machine, added), (*task.orders, *(one.order for one in task.asked))
    return bank_linkage.Linkage(Analysis(linkage.mechanism), solid, task.speed, linkage.turn.phi, orders)


def test_textbook() -> None:
    """Figures 8.11 and 8.13: the engine that is balanced partly shakes along its guide, methods M7.6 and M7.8."""
    its = study(ENGINE, asked(PARTIAL, Place(1, mass=2)))
    task = BOOK._replace(unit=None)
    for found in (bank(its, task).balance, bank_balance(task, mechanism(its, task))):
        assert [f"{found.force[k].real:.9g}" for k in (0, 90, 180)] == ["475", "-98.1155781", "-285"]
        assert [f"{found.left[k].real:.9g}" for k in (0, 90, 180)] == ["95", "-98.1155781", "95"]
        (one,) = found.compensators
        told = (one.with_crank, one.against, one.residual, one.couple)
        assert [f"{size:.10g}" for size in told] == ["0.475", "0.475", "22.8", "0.114"]


def test_an_engine_is_the_slider_crank_of_its_sizes() -> None:
    """A linkage of point masses at A and B and a unit by sizes are one mechanism, drawn and solved in two ways each."""
    text = ENGINE[: ENGINE.index("[masses]")] + "[masses]\n2 = {{ mass = 3, centre = [0, 0] }}\n3 = {{ mass = 9.5 }}\n"
    unit = BOOK.unit
    assert unit is not None
    of_sizes = BOOK._replace(unit=unit._replace(rotating=3.0), members=MEMBERS)
    of_linkage, its = of_sizes._replace(unit=None), study(text)
    roads = (drawn(of_sizes), summed(of_sizes), bank(its, of_linkage, False).balance)
    for found in (*roads[1:], bank_balance(of_linkage, mechanism(its, of_linkage, False))):
        for order, one in roads[0].moments.items():
            other = found.moments[order]
            slack = 2 * (one.slack + other.slack)
            assert abs(one.ahead - other.ahead) <= slack and abs(one.back - other.back) <= slack
        assert np.allclose(found.force, roads[0].force, rtol=0, atol=2 * (found.force_slack + roads[0].force_slack))


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


def test_what_is_balanced_already_has_no_force() -> None:
    """Of a four-bar that is balanced fully no order is left, and no compensator is needed."""
    its = study(FOUR_BAR, asked(FULL, Place(1, mass=9), Place(2, mass=6)))
    task = BankTask(None, MEMBERS, 10.0, (1, 2, 4, 6), ASKED)
    comparison = compare_bank(bank(its, task), mechanism(its, task))
    assert comparison.agrees
    for found in (comparison.construction, comparison.analysis):
        assert all(one.size == 0.0 for rows in (found.forces, found.moments) for one in rows.values())
        assert np.max(np.abs(found.force)) <= found.force_slack
        assert (found.compensators[0].with_crank, found.compensators[0].with_angle) == (0.0, None)

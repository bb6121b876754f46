"""A bank whose mechanism is a linkage, and couples that are compensated."""

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
from plans.bank.study import BankStudy, Linkage, NoTurn
from plans.model.balance.bank import Asked, BankTask, Member
from plans.model.balance.linkage import FULL, PARTIAL, Place
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


def members(*rows: tuple[int, int]) -> tuple[Member, ...]:
    """Give mechanisms in one plane by crank and guide, degrees."""
    return tuple(
        Member(str(k), Fraction(crank), Fraction(0), Fraction(axis)) for k, (crank, axis) in enumerate(rows, 1)
    )


COUPLED = {
    "along the guide": BOOK,
    "along a line of its own": task(members((0, 0), (100, -40)))._replace(asked=(Asked(2, 2.0, -0.06, 0.5),)),
    "round with the crank": task(members((25, 50), (25, -10)))._replace(asked=(Asked(2, 2.0, 0.06, 0.5),)),
    "round against it": task(members((0, 10), (0, 130), (0, 250)))._replace(asked=(Asked(2, 2.0, 0.06, 0.5),)),
}


@pytest.mark.parametrize("road", [drawn, summed])
def test_a_mass_that_turns_as_the_crank_does_has_no_offset(road) -> None:
    """A V of 90 degrees: the first harmonic goes round with the crank, and a counterweight on the crank takes it."""
    (one,) = road(task(members((25, 45), (25, -45)))._replace(asked=(Asked(1, 2.0, 0.06, 0.5),))).compensators
    assert one.on_crank and one.with_crank > 0 == one.against
    assert (one.residual, one.couple or 0.0, one.couple_angle) == (0.0, 0.0, None)


@pytest.mark.parametrize("road", [drawn, summed])
@pytest.mark.parametrize("case", COUPLED)
def test_the_couple_is_compensated(road, case) -> None:
    """Two masses in antiphase on shafts along the line of force make the couple of the offset, but the other way."""
    bank = COUPLED[case]
    ((one,), phi), (asked,) = (road(bank).compensators, np.linspace(0.0, 6.0, 13)), bank.asked
    angles, n = (one.with_angle, one.against_angle), asked.order
    line = 1.0 if None in angles else np.exp(0.5j * sum(angles))  # of a force that goes round the guide, the real axis
    ahead, back = (
        size * np.exp(1j * (angle or 0.0)) for size, angle in zip((one.with_crank, one.against), angles, strict=True)
    )
    force = ahead * np.exp(1j * n * phi) + back * np.exp(-1j * n * phi)
    offset = (np.conj(1j * asked.offset * line) * force).imag
    pair = one.couple * asked.shafts * (np.conj(line) * np.exp(1j * (n * phi + one.couple_angle))).imag
    assert np.abs(offset).max() > 0.9 * one.residual / (n * bank.speed) ** 2 > 0
    assert np.allclose(pair, -offset, rtol=0, atol=1e-13 * np.abs(offset).max())


def test_a_crank_that_cannot_turn_fully_has_no_harmonics() -> None:
    text = FOUR_BAR.format(positions=12).replace('"forces"', '"kinematics"')
    for was, now in (("AB = 0.40", "AB = 0.20"), ("C = [0.35, 0]", "C = [0.42, 0]"), ("[0.39, 0.30]", "[0.25, 0.2]")):
        text = text.replace(was, now)
    scene = parse_scene(text + "[bank]\n[[bank.members]]\ncrank = 0\n")
    with pytest.raises(NoTurn, match=r"no harmonics of a turn: the crank does not turn fully") as told:
        _ = Study(scene)["bank"]
    assert "гармоник" in told.value.args[0].worded("ru")

"""The bench of banks: both roads against sums in 50 digits, and too few ordinates seen as such."""

from __future__ import annotations

from fractions import Fraction

from plans.bench.unbalance import FEW, bank_roads
from plans.model.balance.bank import Member
from tests.plans.drawn_banks import task

MEMBERS = (
    Member("1", Fraction(0), Fraction("-0.1"), Fraction(-30)),
    Member("2", Fraction(100), Fraction("0.2"), Fraction("0.1")),
)


def test_roads_are_judged_by_their_ordinates() -> None:
    bank = task(MEMBERS, orders=(1, 2, 6))
    assert bank.unit is not None
    roads = bank_roads(bank, bank.unit)
    few, *_, enough, series = (judge(road.run()).largest for road in roads for judge in road.judged.values())
    assert [road.positions for road in roads][:3] == list(FEW)
    assert few > 1e-6 and max(enough, series) < 1e-14

"""The bench of banks: both roads against sums in 50 digits, and too few ordinates seen as such."""

from __future__ import annotations

from fractions import Fraction

from plans.bench.bank import FEW, errors, truth, ways
from plans.model.balance.bank import Member
from tests.plans.drawn_banks import task

MEMBERS = (
    Member("1", Fraction(0), Fraction("-0.1"), Fraction(-30)),
    Member("2", Fraction(100), Fraction("0.2"), Fraction("0.1")),
)


def test_roads_are_judged_by_their_ordinates() -> None:
    bank = task(MEMBERS, orders=(1, 2, 6))
    true = truth(bank)
    found = {(name, count): errors(run(), true, bank.members).largest for name, count, run in ways(bank)}
    few, *_, enough, series = found.values()
    assert [count for _, count in found][:3] == list(FEW)
    assert few > 1e-6 and max(enough, series) < 1e-14

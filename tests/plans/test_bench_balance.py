"""The bench of a balance: three ways to the mass centre against the truth, the best share against plans drawn anew."""

from __future__ import annotations

from plans.bench import balance
from plans.bench.roads import prepared
from plans.model.balance.linkage import SHARE, Place
from tests.plans.balanced import ENGINE, asked, study


def test_its_rows_tell_each_way_and_the_best_share() -> None:
    its = study(ENGINE, asked(SHARE, Place(1, mass=5)))
    rows, words, *_ = balance.centres(its, [prepared(its.linkage.scene, 12)], 1)
    ways = (balance.MAIN_POINTS, balance.LINKS, balance.SUMS)
    assert [(row.technique, row.positions) for row in rows] == [
        *((way, 12) for way in ways),
        (balance.SUPERPOSED, None),
    ]
    assert all(row.error is not None and row.error < 1e-14 for row in rows)
    assert balance.SHARE_DEFINED in words


def test_it_sees_a_wrong_way() -> None:
    its = study(ENGINE)
    on = balance.ground(prepared(its.linkage.scene, 12), its.points())
    right = next(road.run() for road in balance.roads(on) if balance.LINKS in road.judged)
    wrong = on.judge(right._replace(force=right.force * (1 + 1e-9)))
    assert 0.9e-9 < wrong.kinds[balance.SHAKING] < 1.1e-9

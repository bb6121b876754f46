"""Wrong signs in what both roads read alike, each of which must be seen by the hand values that are named beside it.

The table is tests/cases/reading_faults.toml; a shared file in which no sign is planted is not guarded.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.plans.seeded import Fault, everyday, faults, verdicts

FAULTS = faults(Path(__file__).parents[1] / "cases" / "reading_faults.toml")
# What both roads have in common and carries a sign; plans/model/machine.py holds values alone.
SHARED = (
    *("linkage/reading/linkage", "linkage/reading/guides", "linkage/reading/shapes", "forces/reading/inventory"),
    *("linkage/reading/line", "linkage/reading/driving", "forces/reading/form", "forces/loading", "forces/stroke"),
)
HARMLESS = Fault(
    "another word", "plans/linkage/reading/linkage.py", '"advice.joint" if mech', '"advice.held_twice" if mech', ()
)


@pytest.mark.parametrize("fault", everyday(FAULTS))
def test_a_wrong_sign_is_seen_by_the_hand_values_named_beside_it(fault):
    assert verdicts(fault, fault.nodes) == dict.fromkeys(fault.nodes, "red")


def test_every_fault_still_finds_the_text_that_it_replaces():
    for fault in FAULTS:
        assert fault.text


@pytest.mark.rest
def test_a_harmless_change_is_seen_by_none_of_them():
    nodes = sorted({node for fault in FAULTS for node in fault.nodes})
    assert verdicts(HARMLESS, nodes) == dict.fromkeys(nodes, "passed")


def test_every_file_that_both_roads_share_has_wrong_signs_planted():
    assert {fault.file for fault in FAULTS} == {f"plans/{name}.py" for name in SHARED}

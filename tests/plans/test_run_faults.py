"""Wrong formulas of motors and of the run of a machine, each seen by the tests that are named beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.plans.seeded import everyday, faults, verdicts

FAULTS = faults(Path(__file__).parents[1] / "cases" / "run_faults.toml")


@pytest.mark.parametrize("fault", everyday(FAULTS))
def test_a_fault_is_seen_by_the_tests_named_beside_it(fault):
    told = verdicts(fault, fault.nodes)
    named = {node.partition("[")[0] for node, verdict in told.items() if verdict == "red"}
    assert named == set(fault.nodes), told


def test_every_fault_still_finds_the_text_that_it_replaces():
    for fault in FAULTS:
        assert fault.text

"""Wrong formulas of force analysis, each of which must be seen by the tests that are named beside it.

The table is tests/cases/force_faults.toml; `python -m tests.plans.kill_matrix` prints which relation sees which fault.
"""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.plans.seeded import FOLDER, ROOT, Fault, everyday, faults, verdicts

FAULTS = faults(Path(__file__).parents[1] / "cases" / "force_faults.toml")
HARMLESS = Fault("fewer examples", f"{FOLDER}/loaded.py", "push = examples(3, 30)", "push = examples(3, 2)", ())


@pytest.mark.parametrize("fault", everyday(FAULTS))
def test_a_fault_is_seen_by_the_tests_named_beside_it(fault):
    assert verdicts(fault, fault.nodes) == dict.fromkeys(fault.nodes, "red")


def test_every_fault_still_finds_the_text_that_it_replaces():
    for fault in FAULTS:
        assert fault.text


@pytest.mark.rest
def test_a_harmless_change_is_seen_by_none_of_them():
    nodes = sorted({node for fault in FAULTS for node in fault.nodes})
    assert verdicts(HARMLESS, nodes) == dict.fromkeys(nodes, "passed")


def test_every_relation_and_every_balance_sees_a_fault():
    named = {test.partition("[")[0] for fault in FAULTS for test in fault.seen_by}
    for file in ("test_force_relations.py", "test_force_balances.py"):
        for node in ast.parse((ROOT / FOLDER / file).read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                assert f"{file}::{node.name}" in named, node.name

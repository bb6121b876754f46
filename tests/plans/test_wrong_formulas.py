"""Wrong formulas of all techniques but the forces, seen by the tests named beside them.

Each table stands in tests/cases.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.plans.seeded import everyday, faults, verdicts

CASES = Path(__file__).parents[1] / "cases"
MACHINES = "machine_faults", "dynamics_analysis_faults", "run_faults"
CAMS = "cam_task_faults", "cam_law_faults", "cam_size_faults", "cam_profile_faults"
BALANCES = "balance_construction_faults", "balance_formula_faults", "bank_formula_faults"
DRAWN = "stroke_formula_faults", "diagram_formula_faults", "hand_formula_faults"
NAMES = ("rotor_faults", "assembly_faults", *DRAWN, *BALANCES, *MACHINES, "cyclogram_faults", *CAMS)
TABLES = {name: faults(CASES / f"{name}.toml") for name in NAMES}


@pytest.mark.parametrize("fault", everyday([fault for table in TABLES.values() for fault in table]))
def test_a_fault_is_seen_by_the_tests_named_beside_it(fault):
    told = verdicts(fault, fault.nodes)
    named = {node.partition("[")[0] for node, verdict in told.items() if verdict == "red"}
    assert named == set(fault.nodes), told


@pytest.mark.parametrize("name", NAMES)
def test_every_fault_still_finds_the_text_that_it_replaces(name):
    for fault in TABLES[name]:
        assert fault.text

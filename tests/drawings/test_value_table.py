"""The table of values: what is nothing has no share of anything."""

from __future__ import annotations

from pathlib import Path

from drawings.layout.value_table import row
from plans.checks.compare import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import read_scene

DEAD_CENTRE = Path(__file__).parent.parent / "catalogue" / "commands" / "f04_zero_vector.toml"


def test_a_zero_vector_has_no_per_cent() -> None:
    """At its dead centre the slider stands: v_B is 0 there, and a difference of roundings is no share of it."""
    comparison = compare(LinkageStudy(read_scene(DEAD_CENTRE)))
    found = {finding.name: finding for finding in comparison.of("velocities")}
    assert row(found["v_B"], "v", (0,), "en").cells == ("0.00000", "0.00000", "—")
    assert row(found["v_B"], "v", (1,), "en").cells == ("0.60000", "0.60000", "<10^{−9}")

"""Arms of forces: the line of action is drawn from the force through the foot of the perpendicular."""

from __future__ import annotations

import pytest

from drawings.paper.hand import hand_of
from drawings.paper.strokes import Line
from drawings.symbols.dimension import Arm


@pytest.mark.parametrize("off", [30.0, 0.3, 0.0, -0.3, -30.0])
def test_the_line_of_action_goes_through_the_foot_wherever_the_force_acts(off: float) -> None:
    foot = 20 + 5j
    action = Arm("h", 5j, foot + off * 1j, 1j).draw(hand_of("A1"))[0]
    assert isinstance(action, Line)
    ends = sorted((action.start.imag, action.end.imag))
    assert ends[0] <= foot.imag <= ends[1]
    assert abs(action.end - foot) == pytest.approx(4.0)

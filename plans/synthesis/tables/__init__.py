"""The form of a task of synthesis: what a mechanism must do (задание на синтез)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.synthesis.tables.extremes import DoubleCrankTable, RockerTable, SliderTable
from plans.synthesis.tables.positions import DwellTable, FunctionTable, RodTable
from plans.synthesis.tables.slots import LeverTable, SineTable, SlotTable, TangentTable
from plans.synthesis.tables.swings import RockerSliderTable

EXAMPLE = '[synthesis.slider_crank] with stroke = "120 mm", time_ratio = 1.1, offset = "30 mm"'


class SynthesisTable(Table):
    """A task of synthesis: what mechanism is wanted, and what it must do."""

    crank_rocker: RockerTable | None = key(
        table(RockerTable), None, meaning="A crank-rocker (кривошипно-коромысловый механизм)."
    )
    double_crank: DoubleCrankTable | None = key(
        table(DoubleCrankTable), None, meaning="A double crank (двухкривошипный механизм)."
    )
    slider_crank: SliderTable | None = key(
        table(SliderTable), None, meaning="A slider-crank (кривошипно-ползунный механизм)."
    )
    slotted_lever: LeverTable | None = key(
        table(LeverTable), None, meaning="An oscillating slotted link (качающаяся кулиса)."
    )
    whitworth: SlotTable | None = key(table(SlotTable), None, meaning="A rotating slotted link (вращающаяся кулиса).")
    sine: SineTable | None = key(table(SineTable), None, meaning="A sine mechanism (синусный механизм).")
    tangent: TangentTable | None = key(table(TangentTable), None, meaning="A tangent mechanism (тангенсный механизм).")
    rocker_slider: RockerSliderTable | None = key(
        table(RockerSliderTable), None, meaning="A rocker that drives a slider (коромыслово-ползунный механизм)."
    )
    rod_positions: RodTable | None = key(
        table(RodTable), None, meaning="A four-bar that guides its rod through positions (положения шатуна)."
    )
    function_points: FunctionTable | None = key(
        table(FunctionTable), None, meaning="A four-bar that meets a function at points (воспроизведение функции)."
    )
    dwell: DwellTable | None = key(
        table(DwellTable), None, meaning="A rocker that rests, from a coupler's curve (механизм с выстоем)."
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that one mechanism is asked for."""
        if len(value.keys() & set(FAMILIES)) != 1:
            yield wrong("one_mechanism", known=", ".join(FAMILIES), found=", ".join(value) or "—")

    @classmethod
    def rules(cls) -> Form:
        """Say that one mechanism is asked for."""
        return {"oneOf": [{"required": [name]} for name in FAMILIES]}


FAMILIES = SynthesisTable.keys


class SynthesisForm(TechniqueForm):
    """What a scene says of a task of synthesis."""

    synthesis: SynthesisTable = key(
        table(SynthesisTable),
        meaning="A task of synthesis (кинематический синтез): what a mechanism must do; its lengths are found.",
        missing=Missing("table", EXAMPLE, {}),
    )

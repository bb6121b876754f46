"""The scales of the sheets of a set: those that the scene states, and those that figures have in common (масштабы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.paper.hand import hand_of
from drawings.symbols.figure import PLAN_LETTERS
from plans.model.order import ORDERS
from plans.scene.sheet import SheetTable

Sheets = Sequence[tuple[Mapping[str, str], Measured]]  # how names of figures begin, and their keys of [sheet.scale]

# Keys that govern an axis of graphs, with the quantities of the marks along it: the others measure ordinates.
AXES: Mapping[str, tuple[str, ...]] = {"angle": (), "way": ("S", "ψ")}


def faults(sheets: Sheets, sheet: SheetTable) -> Iterator[Wrong]:
    """Give the figures of measured sheets whose scales are not those that are stated, or not common ones."""
    yield from _not_stated(sheets, dict(sheet.scale.stated))
    yield from _not_common(sheets, sheet)


def _not_stated(sheets: Sheets, stated: Mapping[str, float]) -> Iterator[Wrong]:
    """Give the figures whose marks have another scale than the scene states for them."""
    for keys, measured in sheets:
        for mark in (*measured.vectors, *measured.points, *measured.profiles):
            figure = f"{mark.plan.replace(' ', '-')}-"
            key = next((key for begin, key in keys.items() if figure.startswith(begin)), "")
            if mark.quantity in AXES.get(key, (mark.quantity,)) and mark.scale != stated.get(key, mark.scale):
                yield on("scale_stated", mark.plan)


def _not_common(sheets: Sheets, sheet: SheetTable) -> Iterator[Wrong]:
    """Give the orders of whose plans one has another scale than the others, though it could be read at theirs."""
    letter = hand_of(sheet.format, sheet.standard).letter
    for order in ORDERS[1:] if sheet.scales == "common" else ():
        plans: dict[int | None, list[MeasuredVector]] = {}
        for vector in (one for _, measured in sheets for one in measured.vectors if one.plan == order.plan):
            plans.setdefault(vector.position, []).append(vector)
        common = max((one[0].scale for one in plans.values()), default=0.0)
        if any(one[0].scale != common and _readable(one, common, letter) for one in plans.values()):
            yield on("scale_common", order.plan)


def _readable(plan: Sequence[MeasuredVector], scale: float, letter: float) -> bool:
    """Tell whether a plan that was measured could be lettered at another scale."""
    ends = [end for vector in plan for end in (vector.start, vector.end)]
    names = {name for vector in plan for name in vector.name.split(" ")}
    wide, high = (max(row) - min(row) for row in ([end.real for end in ends], [end.imag for end in ends]))
    return max(wide, high) * plan[0].scale / scale >= letter * max(PLAN_LETTERS, len(names))

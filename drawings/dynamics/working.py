"""How steep the tangents to the loop are drawn: tg ψ_max = ω²_max·μ_J/(2·μ_T) with numbers (углы касательных)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.dynamics.plate import Plate
from drawings.dynamics.plate_frame import PlateFrame
from drawings.kinds.working import TANGENTS, Working, told
from drawings.layout.picture import Spot


def working(shown: Plate) -> Working:
    """Write beside a plate with the loop how steep the tangents to it are."""
    return Working(TANGENTS, shown.name, lambda spot: list(_lines(shown, spot)), shown.drafting)


def _lines(shown: Plate, spot: Spot | None) -> Iterator[tuple[str, ...]]:
    if not shown.loop or shown.account.flywheel is None:
        return
    drafting, (across, up) = shown.drafting, _scales(shown, spot)
    k = drafting.notation == "K"
    over, under = ("K_{T}", "K_{J}") if k else ("μ_{J}", "μ_{T}")
    factors = [told(factor, drafting) for factor in ((1 / up, 1 / across) if k else (across, up))]
    for end, slope in zip(("max", "min"), reversed(shown.account.flywheel.slopes), strict=True):
        yield (
            f"tg ψ_{{{end}}} = ω_{{{end}}}^2·{over}/(2·{under})",
            f"{told(2 * slope, drafting)}·{factors[0]}/(2·{factors[1]})",
            told(slope * across / up, drafting),
        )


def _scales(shown: Plate, spot: Spot | None) -> tuple[float, float]:
    """Give the scales of inertia and of energy; NaN before it is known where the plate stands."""
    if spot is None:
        return math.nan, math.nan
    frame = PlateFrame(shown, spot)
    return frame.inertia_scale.mu, frame.energy_scale.mu

"""Why a plan has a scale of its own beside the common one of its set (собственный масштаб плана)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.layout.picture import Picture, Spot
from drawings.lettering.words import runs
from drawings.page.drafting import Drafting
from plans.model.order import ORDERS


def remarks(plans: Sequence[Picture], spots: Mapping[str, Spot], drafting: Drafting) -> Iterator[str]:
    """Say of each order which plans are enlarged, and how large they would be at the common scale, mm."""
    for order in ORDERS[1:]:
        own = {int(one.name.rsplit("-", 1)[1]): one for one in plans if one.name.startswith(order.plan)}
        shown = {k: one for k, one in sorted(own.items()) if max(one.wide, one.high) and one.name in spots}
        scales = {k: spots[one.name].scale for k, one in shown.items()}
        common = max(scales.values(), key=lambda scale: scale.mu, default=None)
        enlarged = {k: one.extent(common) for k, one in shown.items() if common and scales[k] != common}
        if common and enlarged:
            yield drafting.word(
                f"own scale {order.plan}", positions=runs(enlarged), scale=drafting.scale(common),
                sizes=" … ".join(dict.fromkeys(f"{end(enlarged.values()):.0f}" for end in (min, max))),
            )  # fmt: skip

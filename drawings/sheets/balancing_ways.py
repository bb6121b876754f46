"""The ways to stand the figures and tables of balancing in columns, and what they are weighed by (компоновка)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.figures.balance import balance_table
from drawings.figures.balance.scheme import BEFORE, SCHEME
from drawings.layout.picture import SMALLER, Picture
from drawings.sheets.leaves import Draft, compositions
from plans.scene.scene import Scene

SCHEMES = "schemes"  # the schemes are drawn at one scale
TOLD, RESULTS = "told", "results"  # columns: of static moments and what stands under them, of the tables alone


class Way(NamedTuple):
    """A way to show it: the keys of the columns of the schemes and of hodographs and graphs, "" apart, and of tables.

    The tables are of the counterweights and of the largest values; "" stands at the foot.
    """

    schemes: str
    tables: tuple[str, str]
    graphs: str = ""
    finest: float = 0.0  # scale mu than which the schemes are drawn no larger

    def column(self, table: str) -> str:
        """Give the key of the column in which a table stands, by its name; "" at the foot."""
        return self.tables[(balance_table.WEIGHTS, balance_table.COSTS).index(table)]


WAYS = tuple(
    Way(schemes, tables, graphs)
    for schemes in (SCHEMES, "")
    for tables in ((TOLD, TOLD), (RESULTS, RESULTS), (TOLD, ""), ("", ""))
    for graphs in ("", TOLD)
)


class Weight(NamedTuple):
    """What a draft is weighed by, the less the better, in this order."""

    small: int  # figures that are too small
    sheets: int
    scale: float  # mu of the schemes
    less: float  # sum of the inverse sizes of all figures, in their least ones


def weigh(scene: Scene, draft: Draft) -> Weight:
    """Weigh a draft as it would stand."""
    composed = compositions(scene, draft)
    spots = {name: spot for one in composed for name, spot in one.spots.items()}
    rooms = [one.panel.item for one in draft.shows if isinstance(one.panel.item, Picture)]
    sizes = [one.extent(spots[one.name].scale) / one.least for one in rooms]
    small = sum(size < SMALLER for size in sizes)
    less = sum(1 / size for size in sizes if size)
    return Weight(small, len(composed), spots[SCHEME + BEFORE].scale.mu, less)

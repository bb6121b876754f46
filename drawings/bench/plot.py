"""The plot of a bench, the only place where matplotlib is imported: error over the time of a position (график).

Black and white: every technique has its own marker and line. A marker grows with the number of positions.
"""

from __future__ import annotations

import io
import itertools
import math
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

from drawings.bench.hands import BY_HAND, FORCES_BY_HAND
from drawings.bench.sheet import MEASURED, PRINTED
from geometry.meet import EPS
from plans.bench import roads
from plans.bench.error import SLIPS
from plans.bench.peers import MECHANISM, PYLINKAGE
from plans.bench.trial import Bench, Row
from plans.bench.truth import NotInstalled

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIZE = (9.6, 5.0)  # inches: two thirds of an A4 page across; the legend and the foot stand below
TITLE, FOOT, UNDER, LINE = 0.46, 1.6, 0.36, 0.17  # inches above the axes, below, from them to the legend, of its line
COLUMNS, LEGEND = 3, 3  # of the legend, and its lines that the foot has room for
GREY = "#707070"
LOWEST, HIGHEST = 1e-17, 1.0  # from under a rounding of float64, where the truth stands, to no likeness at all
SMALLEST, GROWTH = 3.5, 1.7  # points, of the markers
PAPER = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}  # behind letters that stand on a line
ROOM = 1.6  # share of the axis kept free on either side, for the names of the lines
ERROR = (
    "Error: the largest difference from the 50-digit replay of r, v, a of points and angle, omega, epsilon of links, "
    "each relative to the largest of its plan."
)
OF_FORCES = "Of forces: of reactions and moments; F: by hand. "
OF_OTHERS = "Of other techniques: as the words beside the bench's table define it. "


class Series(NamedTuple):
    """How a technique is drawn: marker, whether it is filled, line."""

    marker: str
    filled: bool
    line: str


Spot = tuple[float, float, int]  # time of one position, error, number of positions
NAMED = (
    *roads.CONSTRUCTION, *map(roads.newton, roads.TOLERANCES), roads.ROUNDING, MEASURED, PRINTED, PYLINKAGE, MECHANISM,
    roads.FORCES_CONSTRUCTED, roads.FORCES_ANALYSED, roads.LEVER, roads.POWER, roads.ENERGY,
)  # fmt: skip
MARKERS = "osO^vTDBPXSV<>d"  # a capital for a filled one that is hollow elsewhere
SHAPES = {"O": "o", "T": "^", "B": "D", "S": "s", "V": "v"}
RULES = (":", "--", "-", ":", "--", "-", "-.", "-.", "-", "-", "-", "-", ":", "--", "-.")
LOOKS = {
    name: Series(SHAPES.get(marker, marker), marker in (*SHAPES, "X"), rule)
    for name, marker, rule in zip(NAMED, MARKERS, RULES, strict=True)
}
# Looks of the techniques that have none of their own, in the order of their rows.
SPARE = [Series(marker, True, "-") for marker in "Pp*<>dh"] + [Series(marker, False, ":") for marker in "Xp*h+x"]
STYLE: Any = {  # matplotlib's own settings, named as it names them
    "svg.hashsalt": "plandraft",  # the same numbers, the same bytes
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "font.size": 8.0,
    "axes.unicode_minus": True,
    "lines.linewidth": 0.9,
}


def ready() -> None:
    """Say before anything is measured that the plot could not be drawn."""
    if find_spec("matplotlib") is None:
        why = "-o draws a plot by matplotlib, which is not installed. Fix: python -m pip install '.[bench]'"
        raise NotInstalled(why)


def svg(bench: Bench) -> bytes:
    """Draw the plot."""
    import matplotlib as mpl  # noqa: PLC0415  (only a plot pays for it)
    from matplotlib.backends.backend_svg import FigureCanvasSVG  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    counts = sorted({row.positions for row in bench.rows if row.positions})
    looks = {name: look for name, look in looks_of(bench.rows).items() if _spots(bench.rows, name)}
    with mpl.rc_context(STYLE):
        foot = FOOT + LINE * max(math.ceil(len(looks) / COLUMNS) - LEGEND, 0)
        whole = SIZE[1] + foot
        figure = Figure(figsize=(SIZE[0], whole))
        FigureCanvasSVG(figure)
        timed, untimed = figure.subplots(1, 2, sharey=True, width_ratios=(7, 1))
        _timed(timed, bench, counts, looks)
        _untimed(untimed, bench.rows)
        title = bench.title.replace("$", r"\$")  # matplotlib would set formulas between them
        figure.suptitle(f"{title}: error against run time", x=0.08, y=1 - 0.13 / whole, ha="left", fontsize=11)
        figure.legend(
            *timed.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.07, (foot - UNDER) / whole),
            ncols=COLUMNS, frameon=False, handlelength=4.5,
        )  # fmt: skip
        figure.text(0.08, 0.13 / whole, _foot(bench, counts), fontsize=7, va="bottom")
        figure.subplots_adjust(left=0.08, right=0.985, top=1 - TITLE / whole, bottom=foot / whole, wspace=0.03)
        out = io.BytesIO()
        figure.savefig(out, format="svg", metadata={"Date": None, "Title": bench.title})
    return out.getvalue()


def _timed(axes: Axes, bench: Bench, counts: Sequence[int], looks: Mapping[str, Series]) -> None:
    """Draw the techniques that have a time, one line each through its numbers of positions."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(LOWEST, HIGHEST)
    for name, look in looks.items():
        _series(axes, name, look, _spots(bench.rows, name), counts)
    _truth(axes, [row.each for row in bench.rows if row.technique == roads.REPLAY and row.each])
    _level(axes, bench.accepted, "accepted", 4)
    _level(axes, EPS, "eps of float64", -9)
    low, high = axes.get_xlim()
    axes.set_xlim(low / ROOM, high * ROOM)
    axes.set_xlabel("time of one position, s (a run's median over its positions)")
    axes.set_ylabel("largest error, share of the plan's largest")
    axes.grid(True, which="major", color="#dcdcdc", linewidth=0.5)
    axes.set_axisbelow(True)


def looks_of(rows: Sequence[Row]) -> dict[str, Series]:
    """Give how every technique is drawn: those of linkages alike on every plot, others as they come."""
    known = {*LOOKS, roads.REPLAY}  # the truth has no place: an arrow points to it
    others = dict.fromkeys(row.technique for row in rows if row.technique not in known and row.each)
    return LOOKS | dict(zip(others, itertools.cycle(SPARE), strict=False))


def _series(axes: Axes, name: str, look: Series, spots: Sequence[Spot], counts: Sequence[int]) -> None:
    """Draw a technique's line, its markers growing along it, and one of each for the legend."""
    face = "black" if look.filled else "white"
    axes.plot([time for time, *_ in spots], [error for _, error, _ in spots], look.line, color="black", linewidth=0.8)
    for time, error, positions in spots:
        size = SMALLEST + GROWTH * counts.index(positions)
        axes.plot(time, error, look.marker, markersize=size, markerfacecolor=face, markeredgecolor="black")
    axes.plot([], [], look.line, marker=look.marker, color="black", markerfacecolor=face, label=name)


def _truth(axes: Axes, times: Sequence[float]) -> None:
    """Point down to the truth: its error is none, so it has no place on a logarithmic axis."""
    for at in sorted(times)[len(times) // 2 :][:1]:
        axes.annotate(
            "replay in 50 digits:\nthe truth, error 0", (at, LOWEST), (at, LOWEST * 12), ha="center", va="bottom",
            fontsize=7, arrowprops={"arrowstyle": "-|>", "color": "black", "shrinkB": 0.0}, bbox=PAPER,
        )  # fmt: skip


def _level(axes: Axes, error: float, text: str, above: float) -> None:
    """Rule an error across, its name at the left, so many points above the line."""
    axes.axhline(error, color=GREY, linewidth=0.8, linestyle=(0, (6, 2)))
    axes.annotate(
        text, (0.0, error), (4, above), xycoords=("axes fraction", "data"), textcoords="offset points", fontsize=7,
        color=GREY, bbox=PAPER,
    )  # fmt: skip


def _untimed(axes: Axes, rows: Sequence[Row]) -> None:
    """Draw the hands beside: the median of the chance drawings, and up to where 95 of 100 are."""
    names = {BY_HAND.format(slip): f"{slip:g}" for slip in SLIPS}
    names |= {FORCES_BY_HAND.format(slip): f"{slip:g}\nF" for slip in SLIPS}
    hands = [(names[r.technique], r.error, r.often) for r in rows if r.technique in names and r.error and r.often]
    for place, (_, middle, most) in enumerate(hands):
        axes.plot([place, place], [middle, most], color="black", linewidth=0.9)
        axes.plot(place, most, "_", markersize=9, color="black")
        axes.plot(place, middle, "*", markersize=9, color="black")
    axes.set_xticks(range(len(hands)), [name for name, _, _ in hands])
    axes.set_xlim(-0.7, max(len(hands), 2) - 0.3)
    axes.set_xlabel("by hand, mm")
    axes.tick_params(axis="y", which="both", length=0)
    axes.grid(True, axis="y", which="major", color="#dcdcdc", linewidth=0.5)
    axes.set_axisbelow(True)


def _spots(rows: Sequence[Row], name: str) -> list[Spot]:
    """Find a technique's spots: where it has both a time and a finite error."""
    found = ((row.each, row.error, row.positions) for row in rows if row.technique == name)
    return [(time, max(e, LOWEST), k) for time, e, k in found if time and k and e is not None and math.isfinite(e)]


def _foot(bench: Bench, counts: Sequence[int]) -> str:
    told = ", ".join(f"{count:,}".replace(",", " ") for count in counts)
    techniques = {row.technique for row in bench.rows if row.each}
    forces = OF_FORCES if roads.FORCES_CONSTRUCTED in techniques else ""
    if not techniques <= {*LOOKS, roads.REPLAY}:
        forces += OF_OTHERS
    return (
        f"{ERROR}\nMarkers from small to large: {told} positions. By hand: the median of chance drawings, and the bar "
        f"that 95 of 100 keep under.\n{forces}Machine: {bench.machine.written()}"
    )

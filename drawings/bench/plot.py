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

from drawings.bench.sheet import BY_HAND, SLIPS
from geometry.errors import DraftError
from geometry.meet import EPS
from plans.bench.trial import Bench, Timed

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
ERROR = "Error: the worst of all quantities, relative to the largest of its plan, as the words of the bench define it."


class Series(NamedTuple):
    """How a technique is drawn: marker, whether it is filled, line."""

    marker: str
    filled: bool
    line: str


Spot = tuple[float, float, int]  # time of one position, error, number of positions
# Looks of the techniques in the order of their rows: a marker, filled or hollow, and the line through it.
MARKERS, RULES = "osD^v<>dPXp*h", (":", "--", "-", "-.")
LOOKS = tuple(
    Series(marker, filled, RULES[(number + shift) % len(RULES)])
    for shift, filled in enumerate((True, False))
    for number, marker in enumerate(MARKERS)
)
STYLE: Any = {  # matplotlib's own settings, named as it names them
    "svg.hashsalt": "plandraft",  # the same numbers, the same bytes
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "font.size": 8.0,
    "axes.unicode_minus": True,
    "lines.linewidth": 0.9,
}


class NotInstalled(DraftError):  # noqa: N818  (the message's own word)
    """The library that the plot needs is not there."""

    exit_code = 7


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

    looks = looks_of(bench.rows)
    with mpl.rc_context(STYLE):
        foot = FOOT + LINE * max(math.ceil(len(looks) / COLUMNS) - LEGEND, 0)
        whole = SIZE[1] + foot
        figure = Figure(figsize=(SIZE[0], whole))
        FigureCanvasSVG(figure)
        timed, untimed = figure.subplots(1, 2, sharey=True, width_ratios=(7, 1))
        _timed(timed, bench, looks)
        _untimed(untimed, bench.rows)
        title = bench.title.replace("$", r"\$")  # matplotlib would set formulas between them
        figure.suptitle(f"{title}: error against run time", x=0.08, y=1 - 0.13 / whole, ha="left", fontsize=11)
        figure.legend(
            *timed.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.07, (foot - UNDER) / whole),
            ncols=COLUMNS, frameon=False, handlelength=4.5,
        )  # fmt: skip
        figure.text(0.08, 0.13 / whole, _foot(bench), fontsize=7, va="bottom")
        figure.subplots_adjust(left=0.08, right=0.985, top=1 - TITLE / whole, bottom=foot / whole, wspace=0.03)
        out = io.BytesIO()
        figure.savefig(out, format="svg", metadata={"Date": None, "Title": bench.title})
    return out.getvalue()


def _timed(axes: Axes, bench: Bench, looks: Mapping[str, Series]) -> None:
    """Draw the techniques that have a time, one line each through its numbers of positions."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(LOWEST, HIGHEST)
    for name, look in looks.items():
        _series(axes, name, look, _spots(bench.rows, name))
    _level(axes, bench.accepted, "accepted", 4)
    _level(axes, EPS, "eps of float64", -9)
    low, high = axes.get_xlim()
    axes.set_xlim(low / ROOM, high * ROOM)
    axes.set_xlabel("time of one position, s (a run's median over its positions, or of the run)")
    axes.set_ylabel("worst error, share of the plan's largest")
    axes.grid(True, which="major", color="#dcdcdc", linewidth=0.5)
    axes.set_axisbelow(True)


def looks_of(rows: Sequence[Timed]) -> dict[str, Series]:
    """Give how every technique that can be shown is drawn."""
    shown = [name for name in dict.fromkeys(row.technique for row in rows) if _spots(rows, name)]
    return dict(zip(shown, itertools.cycle(LOOKS), strict=False))


def _series(axes: Axes, name: str, look: Series, spots: Sequence[Spot]) -> None:
    face = "black" if look.filled else "white"
    axes.plot([time for time, *_ in spots], [error for _, error, _ in spots], look.line, color="black", linewidth=0.8)
    for time, error, positions in spots:
        size = SMALLEST + GROWTH * math.log10(positions)
        axes.plot(time, error, look.marker, markersize=size, markerfacecolor=face, markeredgecolor="black")
    axes.plot([], [], look.line, marker=look.marker, color="black", markerfacecolor=face, label=name)


def _level(axes: Axes, error: float, text: str, above: float) -> None:
    axes.axhline(error, color=GREY, linewidth=0.8, linestyle=(0, (6, 2)))
    axes.annotate(
        text, (0.0, error), (4, above), xycoords=("axes fraction", "data"), textcoords="offset points", fontsize=7,
        color=GREY, bbox=PAPER,
    )  # fmt: skip


def _untimed(axes: Axes, rows: Sequence[Timed]) -> None:
    """Draw the hands beside: from the median of all quantities to the worst."""
    pairs = ((row, slip) for row in rows for slip in SLIPS if row.technique.endswith(BY_HAND.format("", slip)))
    hands = [(f"{slip:g}\n{row.technique[:3]}", row.errors) for row, slip in pairs if row.errors]
    for place, (_, errors) in enumerate(hands):
        axes.plot([place, place], [errors.typical, errors.worst], color="black", linewidth=0.9)
        axes.plot(place, errors.worst, "_", markersize=9, color="black")
        axes.plot(place, errors.typical, "*", markersize=9, color="black")
    axes.set_xticks(range(len(hands)), [name for name, _ in hands])
    axes.set_xlim(-0.7, max(len(hands), 2) - 0.3)
    axes.set_xlabel("by hand, mm")
    axes.tick_params(axis="y", which="both", length=0)
    axes.grid(True, axis="y", which="major", color="#dcdcdc", linewidth=0.5)
    axes.set_axisbelow(True)


def _spots(rows: Sequence[Timed], name: str) -> list[Spot]:
    """Find a technique's spots: where it has both a time and a finite error; what has no positions counts as one."""
    found = ((row.each, row.errors.worst, row.positions or 1) for row in rows if row.technique == name and row.errors)
    return [(time, max(error, LOWEST), count) for time, error, count in found if time and math.isfinite(error)]


def _foot(bench: Bench) -> str:
    return (
        f"{ERROR}\nMarkers grow with the number of positions. By hand: the median of all quantities, and the bar "
        f"to the worst.\nMachine: {bench.machine.written()}"
    )

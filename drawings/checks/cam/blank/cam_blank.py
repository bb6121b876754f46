"""The figure of a cam to be made: datum, radii, tabled points, sense of rotation, words (чертёж кулачка: линии)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from drawings.checks.cam.blank.tabled_cam import PLAN, TabledCam
from drawings.checks.cam.cam_page import headed, pole_of
from drawings.checks.cam.shape import profile_styles
from drawings.checks.cam.shape.rack import Rack
from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes, figure
from drawings.checks.graphs.linework import FAR, Linework, Way
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.letters import NEAREST
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from plans.model.motion import Complexes

FLAWS = ("undercut", "hollow", "crossing", "concave", "sharp")  # of a shape, which may be named beside it


def blank(leaf: Leaf, exact: TabledCam, drafting: Drafting) -> Iterator[Wrong]:
    """Hold all that stands about the curve of a cam to be made."""
    strokes = figure(leaf, PLAN)
    pole = None if strokes is None else pole_of(strokes)
    if strokes is None or pole is None:
        yield on("missing_on", PLAN, name="O")
        return
    zero, mu = pole
    yield from headed(strokes, PLAN, drafting.word("working profile"), mu, drafting)
    work, spots = Linework(PLAN, strokes, drafting.hand.symbol), zero + exact.told / mu
    yield from work.heads()
    yield from work.dots("r", [zero, *spots.tolist()])
    for name, spot in zip(exact.names, spots.tolist(), strict=True):
        if not any(abs(one.centre - spot) <= FLUSH for one in strokes.circles):
            yield on("edge", PLAN, name=f"{name:g}")
    yield from profile_styles.faults(strokes, PLAN, exact.found, drafting.hand)
    if exact.cam.translates:
        yield from _pushed(strokes, exact, zero)
        rack = Rack(exact.found, zero, mu, drafting.hand.symbol)
        yield from rack.faults(strokes, PLAN)
        known = [*rack.ways(), *_ordinates(exact, zero, spots), *_arrow(strokes)]
        yield from work.ways(known, {id(one) for one in work.lines if rack.hatching(one)})
    else:
        yield from work.ways([*_datum(exact, zero, spots), *_rays(exact, zero, spots)])
        yield from _turned(strokes, exact, zero, drafting)
    yield from _words(work, exact, mu, drafting)
    yield from _letters(strokes, exact, spots, drafting)


def _datum(exact: TabledCam, zero: complex, spots: Complexes) -> Iterator[Way]:
    """Give the zero ray, beyond the profile, and the axis across it."""
    ray = complex(exact.told[0]) / abs(complex(exact.told[0]))
    yield Way("θ", zero, complex(spots[0]), FAR)
    yield Way("O", zero - 1j * ray, zero + 1j * ray, 20.0)


def _rays(exact: TabledCam, zero: complex, spots: Complexes) -> Iterator[Way]:
    yield from (Way(f"r {name:g}", zero, complex(spots[k])) for k, name in exact.rays())


def _ordinates(exact: TabledCam, zero: complex, spots: Complexes) -> Iterator[Way]:
    """Give the ordinates of a cam that translates, from the level of O."""
    ends = ((name, complex(spots[k])) for k, name in exact.rays())
    yield from (Way(f"x {name:g}", complex(end.real, zero.imag), end) for name, end in ends)


def _arrow(strokes: FigureStrokes) -> Iterator[Way]:
    """Give the line of the arrow along which a cam translates, which is held by itself."""
    own = (one for one in strokes.pointings if strokes.far("v", [(one.start + one.tip) / 2]) <= NEAREST)
    yield from (Way("v", one.start, one.tip, due=False) for one in own)


def _turned(strokes: FigureStrokes, exact: TabledCam, zero: complex, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the arrow of rotation with its letter, and the letter of the zero ray at its end."""
    own = [one for one in strokes.turnings if abs(one.centre - zero) <= FLUSH]
    if [one.sense for one in own] != [exact.cam.sense] or not strokes.lettered("ω", [one.middle for one in own]):
        yield on("sense", PLAN, name="ω")
    ray = complex(exact.told[0])
    tops = [end for one in strokes.through(zero, ray) for end in (one.start, one.end)]
    tops = [end for end in tops if abs(cmath.phase((end - zero) / ray)) < 1.0]
    if not strokes.lettered(drafting.word("zero ray"), tops):
        yield on("letter", PLAN, name=drafting.word("zero ray"))


def _pushed(strokes: FigureStrokes, exact: TabledCam, zero: complex) -> Iterator[Wrong]:
    """Hold the arrow of a cam that translates, and the level of O."""
    ways = [one for one in strokes.pointings if strokes.far("v", [(one.start + one.tip) / 2]) <= NEAREST]
    if not any((one.tip - one.start).real * exact.cam.sense < 0 for one in ways):
        yield on("sense", PLAN, name="v")
    if not strokes.through(zero, 1.0, FLUSH):
        yield on("line_named", PLAN, name="O")


def _told(exact: TabledCam, name: float, drafting: Drafting) -> str:
    """Write the turn, or the travel, of a drawn radius."""
    number = drafting.number(name, 5)
    return f"x {number}" if exact.cam.translates else f"φ {number}°"


def _words(work: Linework, exact: TabledCam, mu: float, drafting: Drafting) -> Iterator[Wrong]:
    due = [drafting.word("working profile"), scale_line(mu, "l", "m", drafting), "O"]
    due += ["v"] if exact.cam.translates else ["ω", drafting.word("zero ray")]
    due += [_told(exact, name, drafting) for _, name in exact.rays()]
    yield from work.words(due, [drafting.word(f"cam {one.kind}") for one in exact.found.flaws if one.kind in FLAWS])


def _letters(strokes: FigureStrokes, exact: TabledCam, spots: Complexes, drafting: Drafting) -> Iterator[Wrong]:
    """See that each drawn radius has its own turn beside its end."""
    for k, name in exact.rays():
        if not strokes.lettered(_told(exact, name, drafting), [complex(spots[k])]):
            yield on("letter", PLAN, name=_told(exact, name, drafting))

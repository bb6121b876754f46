"""Scenes of cams by lot: followers of all kinds, laws by name, by a table and by a shape (кулачковые механизмы)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi, sin

from tests.alarms.lot import EXACT, Lot, length, rows

LAWS = (
    *("constant acceleration", "cosine", "sine", "3-4-5", "4-5-6-7"),
    *("trapezoid", "modified trapezoid", "modified sine"),
)
FOLLOWERS = [(motion, end) for motion in ("translating", "rocking") for end in ("roller", "roller", "pointed", "flat")]
REST = '"rest"'  # of the turn
TABLE = 9  # points of a law by a table


def cam(lot: Lot) -> str:
    """Write a scene of one to three cams on a shaft, or of one that translates."""
    sheets = lot.any('cam", "profile', 'cam", "profile', "cam", "profile")
    if lot.on(0.08):
        cams = [_copying(lot)]
    else:
        speed = lot.any(1, 1, -1) * lot.size(30, 500, 60, 120, 200, 300)
        cams = [_turning(lot, speed, number) for number in range(lot.any(1, 1, 1, 1, 1, 2, 3))]
    return rows(f'title = "Cam"\nsheets = ["{sheets}"]', *cams, "[sheet]")


def feed(lot: Lot) -> str:
    """Write the cam of a feed that takes its angles from the cyclogram."""
    return rows(
        '[[cam]]\nname = "K1"\nsetting = "cyclogram"\n[cam.follower]\nmotion = "translating"\nend = "roller"',
        f"lift = {length(lot.size(0.01, 0.04, 0.02))}",
        f"[cam.limits]\nrise = {lot.size(25, 40, 30)}",
        _phase("rise", '"cyclogram"', _named(lot)),
        _phase("dwell", lot.size(20, 60, 30, 60)),
        _phase("return", lot.size(60, 100, 90), _named(lot)),
        _phase("dwell", REST),
    )


def _phase(kind: str, angle: float | str, *more: str) -> str:
    return rows("[[cam.phases]]", f'kind = "{kind}"', f"angle = {angle}", more)


def _turning(lot: Lot, speed: float, number: int) -> str:
    """Write a cam that turns."""
    motion, end = lot.any(*FOLLOWERS)
    grooved = end == "roller" and lot.on(0.4)
    lift = lot.size(8, 30, 12, 20, 25) if motion == "rocking" else lot.size(0.008, 0.04, 0.02, 0.03)
    if motion == "rocking" and end == "flat":
        lift = lot.size(6, 14, 10, 12)
    arm = lot.size(0.07, 0.18, 0.1, 0.12)
    return rows(
        "[[cam]]",
        f'speed = "{speed:g} rpm"',
        [f"setting = {lot.size(0, 330, 0, 90, 180)}"] if number else (),
        ['closure = "groove"'] if grooved else (),
        lot.some(0.2, f"divisions = {lot.any(6, 10, 12)}"),
        f'[cam.follower]\nmotion = "{motion}"\nend = "{end}"',
        [f"lift = {length(lift)}"] if motion == "translating" else [f"swing = {lift:g}", *_rocker(lot, end, arm)],
        _sizes(lot, motion, end, lift, arm, grooved),
        lot.some(0.35, *_load(lot, motion, lift)) if not grooved else (),
        *_phases(lot, motion, lift, flat=end == "flat"),
    )


def _rocker(lot: Lot, end: str, arm: float) -> Sequence[str]:
    face = f"face = {length(lot.size(0.002, 0.01, 0.008))}"
    own = lot.some(0.5, face) if end == "flat" else [f"length = {length(arm)}"]
    return (f'turns = "{lot.any("with", "against")}"', *own)


def _sizes(lot: Lot, motion: str, end: str, lift: float, arm: float, grooved: bool) -> Iterator[str]:
    """Give limits by which the sizes are found, or the sizes themselves, or neither, where the book's hold."""
    if end == "flat":
        if motion == "rocking":
            yield from ("[cam.sizes]", f"centre = {length(arm)}")
        yield from ("[cam.limits]", f"curvature = {length(lot.size(0.003, 0.01, 0.005))}")
        return
    kind = lot.any("limits", "limits", "limits", "sizes", "")
    low, high, usual = (35, 50, 45) if motion == "rocking" else (25, 40, 30)
    if kind == "sizes":
        yield "[cam.sizes]"
        if motion == "rocking":
            yield f"base = {length(arm * lot.size(0.4, 0.6, 0.5))}\ncentre = {length(arm * lot.size(1.1, 1.3))}"
        else:
            yield f"base = {length(lift * lot.size(1.6, 3, 2))}\noffset = {length(lift * lot.size(-0.1, 0.3, 0))}"
        if end == "roller":
            yield f"roller = {length((arm * 0.3 if motion == 'rocking' else lift) * lot.size(0.25, 0.45, 0.3))}"
    elif kind:
        yield from ("[cam.limits]", f"rise = {lot.size(low, high, usual):g}")
        if grooved or lot.on(0.3):
            yield f"return = {lot.size(low, high, usual):g}"


def _load(lot: Lot, motion: str, lift: float) -> Sequence[str]:
    """Give what a follower bears: its mass, what resists, and a spring."""
    preload = lot.size(20, 150, 50, 100)
    if motion == "rocking":
        stiff = f"stiffness = {lot.size(5, 60, 10, 20)}"
        return ("[cam.load]", f"inertia = {lot.size(0.0005, 0.005)}", f"preload = {preload * 0.1:.3g}", stiff)
    stiff = f"stiffness = {lot.size(500, 5000, 1000, 2000)}"
    force = lot.some(0.6, f"force = {lot.size(20, 200, 50, 100)}")
    return ("[cam.load]", f"mass = {lot.size(0.2, 2, 0.5, 1)}", *force, f"preload = {preload:g}", stiff)


def _phases(lot: Lot, motion: str, lift: float, flat: bool) -> Iterator[str]:
    """Give rise, dwell, return and dwell, now and then a rise in two steps or no upper dwell."""
    rise, back = lot.size(80, 120, 90, 120), lot.size(80, 120, 90, 100, 120)
    dwell = lot.size(10, 60, 30, 45, 60)
    stepped = lot.on(0.12) and not flat
    if stepped:
        part = f"{'swing' if motion == 'rocking' else 'lift'} = {lift * 0.4:.4g}"
        yield _phase("rise", round(rise * 0.45, 4), part, 'law = "3-4-5"') + _phase("dwell", 20)
        rise = round(rise * 0.8, 4)
    yield _phase("rise", rise, _law(lot, motion, lift, rise, flat or stepped))
    if lot.on(0.85):
        yield _phase("dwell", dwell)
    yield _phase("return", back, _named(lot)) + _phase("dwell", REST)


def _law(lot: Lot, motion: str, lift: float, angle: float, named: bool) -> str:
    """Draw the law of a rise: mostly one by its name."""
    kind = lot.chance.random()
    if kind < 0.72 or named:
        return _named(lot)
    if kind < 0.80:
        return f'law = {{ name = "constant acceleration", first = {lot.size(0.3, 0.7, 0.4, 0.6)} }}'
    if kind < 0.86:
        return 'law = "constant velocity"'
    if kind < 0.93:
        pause = lot.size(0.1, 0.35, 0.25)
        ends = f"[[0, 1], [{pause}, 1], [{pause}, 0], [{1 - pause:.3g}, 0], [{1 - pause:.3g}, -1], [1, -1]]"
        return f'law = {{ name = "shape", points = {ends} }}'
    return f'law = {{ name = "table", points = {_table(motion, lift, angle)}, through = "cubics" }}'


def _named(lot: Lot) -> str:
    return f'law = "{lot.any(*LAWS)}"'


def _table(motion: str, lift: float, angle: float) -> list[list[float]]:
    digits = 3 if motion == "rocking" else 5
    shares = [k / (TABLE - 1) for k in range(TABLE)]
    return [[round(angle * x, 4), round(lift * (x - sin(2 * pi * x) / (2 * pi)), digits)] for x in shares]


def _copying(lot: Lot) -> str:
    """Write a cam that translates there and back."""
    lift = lot.size(0.01, 0.03, 0.02)
    end = "roller" if lot.kind != EXACT else "pointed"
    phases = []
    for kind, low, high in (("dwell", 0.3, 1), ("rise", 2.5, 4), ("dwell", 0.5, 1), ("return", 2.5, 4)):
        travel = f"travel = {length(lift * lot.size(low, high))}"
        phases.append(rows("[[cam.phases]]", f'kind = "{kind}"', travel, [_named(lot)] if kind != "dwell" else ()))
    return rows(
        f"[[cam]]\nspeed = {lot.any(1, -1) * lot.size(0.05, 0.5, 0.1, 0.4)}",
        f'[cam.follower]\nmotion = "translating"\nend = "{end}"\nlift = {length(lift)}',
        f"[cam.limits]\nrise = {lot.size(35, 45, 40)}",
        phases,
    )

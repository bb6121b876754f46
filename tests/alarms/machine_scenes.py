"""Scenes of machines by lot: their motion, forces, run, balancing, cyclogram (механизмы под нагрузкой)."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from math import degrees, hypot, pi

from tests.alarms.cam_scenes import feed
from tests.alarms.linkages import Linkage, linkage
from tests.alarms.lot import Lot, length, rows

GRAVITY = 9.81
REVERSING = ("slider-crank", "crank-rocker", "shaper", "rocker and slider", "toggle press", "Whitworth", "yoke")
DRIVEN = ("slider-crank", "slider-crank", "shaper", "crank-rocker", "rocker and slider", "yoke")
BALANCED = ("slider-crank", "slider-crank", "crank-rocker", "shaper")
CUT = ("slider-crank", "shaper", "shaper", "Whitworth", "rocker and slider", "yoke")
FORWARD = {"slider-crank": (60, 400), "yoke": (60, 300)}  # rpm: of cranks
SLOW = (30, 150)
_SECTOR = ['shape = "sector"', "half_angle = 60"]


def kinematics(lot: Lot) -> str:
    """Write a scene of a linkage's motion."""
    one = linkage(lot)
    sheet = lot.any("kinematics", "kinematics", "kinematics", "positions")
    shown = lot.some(0.15, "diagrams = false") if sheet == "kinematics" else ()
    return rows(_motion(lot, one, sheet), "[sheet]", shown)


def forces(lot: Lot) -> str:
    """Write a scene of a linkage's forces, with friction, a gear or springs."""
    one = linkage(lot)
    omega = _speed(lot, one)
    sheets = lot.any("forces", "forces", 'kinematics", "forces')
    balanced = lot.any((), (), [f'balancing = "{lot.any("coupling", "force")}"'], _gear(lot, one))
    hodograph = lot.some(0.25, 'hodographs = ["0-1"]')
    sheet = ("[sheet]", *(() if one.drive else hodograph), f'reactions = "{lot.any("R", "R", "P", "F")}"')
    return rows(
        _motion(lot, one, sheets, omega),
        () if one.drive else balanced,
        _masses(lot, one),
        ("[loads]", *lot.some(0.8, f"gravity = {GRAVITY}")),
        _resistance(lot, one, omega),
        lot.some(0.15, *_spring(lot, one)),
        lot.some(0.35, *_friction(lot, one)),
        sheet,
    )


def dynamics(lot: Lot) -> str:
    """Write a scene of a machine that works over one stroke, with its flywheel and motor."""
    one = linkage(lot, DRIVEN)
    omega = _speed(lot, one)
    force = _level(lot, one, omega)
    law, mean = lot.any(_cut, _pressed)(lot, one, force)
    forces_too = lot.on(0.15)
    motor, run = _motor(lot, omega, mean)
    ratio = lot.any(1, 1, lot.size(2, 6, 4))
    sheets = 'dynamics", "forces' if forces_too else "dynamics"
    from_run = ['speed_from = "dynamics"'] if forces_too else ()
    divisions = f"divisions = {lot.any(24, 24, 36, 12, 48)}"
    return rows(
        _motion(lot, one, sheets, omega, even=True),
        from_run,
        _masses(lot, one),
        ("[loads]", *lot.some(0.8, f"gravity = {GRAVITY}")),
        law,
        ("[dynamics]", f'fluctuation = "1/{lot.size(5, 100, 10, 25, 30, 50, 80):.0f}"', divisions),
        motor,
        lot.some(0.4, *run) if motor and not forces_too else (),
        lot.some(0.6, "[[dynamics.shafts]]", 'name = "gear"', f"inertia = {lot.size(0.02, 2)}"),
        lot.some(0.5, "[dynamics.flywheel]", f"ratio = {ratio}", f"diameter = {lot.size(0.4, 1.6, 0.8, 1)}"),
        "[sheet]",
    )


def balancing(lot: Lot) -> str:
    """Write a scene of a balanced linkage."""
    one = linkage(lot, BALANCED)
    aim = lot.any("none", "full", *(("partial", "share") if one.name == "slider-crank" else ("full",)))
    full = {"slider-crank": (2, 1), "crank-rocker": (1, 3)}.get(one.name, (1, 3, 4))
    links = {"full": full, "none": ()}.get(aim, (1,))
    return rows(
        _motion(lot, one, "balancing"),
        _masses(lot, one, whole=True),
        ("[loads]", f"gravity = {GRAVITY}") if lot.on(0.7) else (),
        ("[balance]", f'aim = "{aim}"'),
        ["share = " + lot.any('"force"', '"reaction"', str(lot.size(0.2, 0.8, 0.5)))] if aim == "share" else (),
        *(_counterweight(lot, one, link) for link in links),
        "[sheet]",
    )


def cyclogram(lot: Lot) -> str:
    """Write a scene of a machine tool's cyclogram, with the cam of its feed or without."""
    one = linkage(lot, CUT)
    over = lot.any(lot.size(0.03, 0.15, 0.05, 0.1), f"[{lot.size(0.03, 0.15)}, {lot.size(0.03, 0.15)}]")
    breaks = ['"60 %"', '"75 %"'] if lot.kind == "exact" else [f"{lot.size(0.2, 0.45)}", f"{lot.size(0.5, 0.8)}"]
    told = ("[cyclogram]", f"overrun = {over}", *lot.some(0.5, f"breaks = [{', '.join(breaks)}]"))
    return rows(_motion(lot, one, "cyclogram", even=True), told, lot.some(0.4, feed(lot)), "[sheet]")


def _motion(lot: Lot, one: Linkage, sheets: str, omega: float = 0, even: bool = False) -> str:
    """Write what a scene of a linkage begins with: its sheets, its tables and its drive."""
    head = rows(f'title = "{one.name.capitalize()}"', f'sheets = ["{sheets}"]')
    return (head + one.tables() + _drive(lot, one, omega, even)).rstrip()


def _speed(lot: Lot, one: Linkage) -> float:
    """Draw the speed of a crank, rad/s, to two digits."""
    return float(f"{lot.size(*FORWARD.get(one.name, SLOW), 60, 90, 120) * pi / 30:.2g}")


def _drive(lot: Lot, one: Linkage, omega: float, even: bool) -> str:
    """Write the drive: a crank that turns, mostly evenly and from an extreme position."""
    if one.drive:
        return one.drive
    speed = (omega or _speed(lot, one)) * lot.any(1, 1, -1)
    start = round(degrees(phase(one.end)), 2)
    head = ("[drive]", "link = 1", f"speed = {speed:.6g}")
    extreme = one.name in (*REVERSING, "crusher") and lot.on(0.7)
    gathering = () if even else lot.some(0.2, f"acceleration = {lot.size(1, 30)}")
    count = lot.any(12, 12, 12, 8, 24, lot.whole(6, 18))
    return rows(head, gathering, 'start = "extreme"' if extreme else f"start = {start}", f"positions = {count}")


def _masses(lot: Lot, one: Linkage, whole: bool = False) -> Iterator[str]:
    """Write the masses of links: of a rod by its length, of a slider beside them."""
    heavy = lot.size(8, 40, 10, 20)
    yield "[masses]"
    for link, points in one.links.items():
        rod = one.rods.get(link, 0.0)
        if not rod and points == "A" and not whole:
            continue
        mass = float(f"{heavy * (rod or 2 * one.crank) * lot.size(0.8, 1.3, 1):.2g}")
        centre = lot.any('"middle"', f"[{rod * lot.size(0.3, 0.6, 0.5):.4f}, 0]")
        inertia = f", inertia = {mass * rod**2 / 12 * lot.size(0.8, 1.3, 1):.3g}, centre = {centre}" if rod else ""
        yield f"{link} = {{ mass = {mass:g}{inertia} }}"


def _level(lot: Lot, one: Linkage, omega: float) -> float:
    """Draw a resistance by what the links weigh and what takes them to turn, N."""
    mass = 20 * one.crank * 3
    return float(f"{mass * hypot(GRAVITY, one.crank * omega**2) * lot.size(2, 15, 5, 10):.2g}")


def _cut(lot: Lot, one: Linkage, force: float) -> tuple[Sequence[str], float]:
    """Give a resistance over the working stroke, and its mean moment, N*m."""
    over = lot.size(0.02, 0.12, 0.05, 0.1)
    lines = ('against = "motion"', 'during = "working stroke"')
    if one.slides_on_the_frame:
        cut = _force(one, *lines, f"value = {force:g}", f"overrun = {over}")
        return cut, force * one.stroke * (1 - 2 * over) / (2 * pi)
    moment = float(f"{force * one.crank:.2g}")
    turned = ("[[loads.moments]]", f"on = {one.tool[0]}", *lines, f"value = {moment:g}")
    return turned, moment * one.stroke / (2 * pi)


def _pressed(lot: Lot, one: Linkage, force: float) -> tuple[Sequence[str], float]:
    """Give a resistance that rises towards the end of the working stroke, and its mean moment, N*m."""
    if not one.slides_on_the_frame:
        return _cut(lot, one, force)
    begin = lot.size(0.5, 0.85, 0.6, 0.75, 0.8)
    law = f"diagram = {{ travel = [0, {begin:.3g}, {begin + 0.05:.3g}, 1], force = [0, 0, {force:g}, {3 * force:g}] }}"
    work = one.stroke * force * (0.025 + (0.95 - begin) * 2)
    return _force(one, 'against = "motion"', law), work / (2 * pi)


def _force(one: Linkage, *lines: str) -> Sequence[str]:
    return ("[[loads.forces]]", f"on = {one.tool[0]}", f'point = "{one.tool[1]}"', *lines)


def _resistance(lot: Lot, one: Linkage, omega: float) -> Sequence[str]:
    force = _level(lot, one, omega)
    if one.drive:  # no working stroke of a turn
        return _force(one, f"value = {force:g}", f"direction = {lot.any(-90, 0, 180, lot.size(-180, 180))}")
    if one.name in REVERSING or one.name == "crusher":
        law = lot.any(_cut, _pressed)
        return (*law(lot, one, force)[0], *lot.some(0.2, *_cylinder(lot, one)))
    return ("[[loads.moments]]", f"on = {one.tool[0]}", f"value = {force * one.crank:.3g}", 'against = "motion"')


def _cylinder(lot: Lot, one: Linkage) -> Sequence[str]:
    """Give a pressure on the tool, as on a piston."""
    if not one.slides_on_the_frame:
        return ()
    way = next(guide[1] for link, guide in one.slides if link == one.tool[0] and not isinstance(guide, str))
    pressure, bore = lot.size(1e5, 8e5, 2e5, 5e5), length(one.crank * lot.size(0.3, 1, 0.5))
    return _force(one, f"direction = {degrees(phase(way)):.4g}", f"pressure = {pressure:g}", f"bore = {bore}")


def _gear(lot: Lot, one: Linkage) -> Sequence[str]:
    at = f"at = {lot.size(0, 330, 0, 90, 180, 210, 270)}"
    pressure = f"pressure_angle = {lot.size(15, 25, 20, 0):g}"
    return ("[drive.gear]", f"radius = {length(one.crank * lot.size(1.1, 2.5, 1.5, 2))}", at, pressure)


def _friction(lot: Lot, one: Linkage) -> Sequence[str]:
    radius = length(one.crank * lot.size(0.08, 0.25, 0.1, 0.2))
    long = lot.some(0.3, f"length = {length(one.crank * lot.size(1, 2.5, 2))}")
    return ("[friction]", f"coefficient = {lot.size(0.05, 0.15, 0.1)}", f"radius = {radius}", *long)


def _spring(lot: Lot, one: Linkage) -> Sequence[str]:
    link, point = one.tool
    fixed = next(iter(one.frame))
    if point in one.frame:
        return ()
    ends = f'between = [{{ on = {link}, point = "{point}" }}, "{fixed}"]'
    return ("[[loads.springs]]", ends, f"stiffness = {lot.size(200, 3000)}", f"free = {one.crank * lot.size(1, 4):.3f}")


def _motor(lot: Lot, omega: float, mean: float) -> tuple[Sequence[str], Sequence[str]]:
    """Give a motor that bears the mean moment at the speed of the machine, and its run; or none."""
    ratio, kind = lot.any(1.0, lot.size(4, 12, 6, 8, 10)), lot.any("", "moment", "line", "Kloss")
    nominal, slip = mean / ratio, lot.size(0.02, 0.06, 0.05)
    synchronous, greatest = f"synchronous = {omega * ratio / (1 - slip):.4g}", lot.size(2, 3, 2.5)
    critical = slip * (greatest + (greatest**2 - 1) ** 0.5)
    laws = {
        "": (),
        "moment": (f"moment = {nominal:.3g}",),
        "line": (f"starting = {nominal / slip:.4g}", synchronous),
        "Kloss": (f"breakdown = {nominal * greatest:.4g}", f"slip = {critical:.3g}", synchronous),
    }
    motor = ("[dynamics.motor]", f"rotor = {lot.size(0.01, 0.3)}", f"ratio = {ratio:g}", *laws[kind])
    run = ("[dynamics.run]", f"turns = {lot.any(2, 3, 5)}", *lot.some(0.5, f"brake = {mean * lot.size(0.8, 2):.3g}"))
    return motor if kind or lot.on(0.3) else (), run if kind in ("line", "Kloss") else ()


def _counterweight(lot: Lot, one: Linkage, link: int) -> Sequence[str]:
    """Give a link that may carry a counterweight, by its mass or its radius, about as heavy as what it balances."""
    heavy = 20 * sum(one.rods.values()) * lot.size(1, 4, 2)
    known = [f"mass = {heavy:.3g}"]
    if link == 1 and lot.on(0.4):
        known = lot.any([f"radius = {one.crank * lot.size(0.6, 1.4, 1):.4f}"], _SECTOR)
    thick = f"thickness = {length(lot.size(0.02, 0.08, 0.03, 0.05))}"
    return ("[[balance.counterweights]]", f"on = {link}", *known, thick)

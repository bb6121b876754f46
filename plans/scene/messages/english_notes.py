"""The notes of plandraft on a scene in English: what is odd though allowed, each by its kind."""

from __future__ import annotations

from collections.abc import Mapping

# Each kind of note: what is odd though allowed, and the advice.
NOTES: Mapping[str, tuple[str, str]] = {
    "byte_order_mark": ("the file begins with a byte order mark (BOM)", "it was left aside"),
    "metres": (
        "no length without a unit is under {least} m, and a bare number is in metres",
        'if millimetres are meant, write "{example} mm"',
    ),
    "enormous": (
        "{name} is {ratio} times as long as any other length, and a bare number is in metres",
        'if millimetres are meant, write "{example} mm"',
    ),
    "inertia_unit": (
        "{inertia} kg*m2 is far more than m*L2 = {most} kg*m2 of link {link}",
        "check the unit: kg*mm2 and kg*cm2 are written with the number, in quotes",
    ),
    "large_radius": (
        "a bare number is in metres, and this radius is large beside the longest link, {longest} m",
        "if millimetres are meant, write them with the number, in quotes: {example} mm",
    ),
    "radian": (
        "{example} degrees are hardly an angle, but {example} radians are {degrees} degrees",
        "if they are meant, write {degrees}",
    ),
    "spread": ("{name} is {ratio} times {other}", "check the units of both"),
    "degrees": ("{turns} turns of the crank", "if degrees are meant, write the bare number"),
    "radians": (
        "all angles are under {most}, and a bare number is in degrees",
        'if radians are meant, write "{example} rad"',
    ),
    "fixed_sketch": (
        "{name} is fixed, and its place in [mechanism.frame] holds, not this one",
        "leave it out of the sketch, or correct one of the two",
    ),
    "unused": (
        "no sheet that is asked for uses this",
        "write sheets = [{wanted}] at the top of the file, or leave this out",
    ),
    "at_rest": (
        "the crank stands still: velocities, inertia forces and loads against the motion are nothing",
        'give its speed, as "60 rpm", unless this is meant',
    ),
    "rough": (
        "a coefficient of friction above 1 is more than rubber on a dry road has",
        "check the decimal point: oiled steel has about 0.1",
    ),
    "twins": ("{name} and {other} look alike, but one has a Cyrillic letter", "rename one of them"),
    "spare_point": ("no link and no slide uses the fixed point {name}", "leave it out, or give it to a link"),
    "far_centre": (
        "the mass centre is {far} m from the nearest point of link {link}",
        "check its place and unit: the link's own frame has its first point as origin and its second on +x",
    ),
    "large_inertia": (
        "{inertia} kg*m2 is more than m*L2 = {most} kg*m2 of link {link}",
        "if it is the inertia about a hinge, give that about the mass centre: less by m*r2",
    ),
    "heavy": ("{ratio} times the gravity of the Earth", 'if millimetres are meant, write "{example} mm/s2"'),
    "upward": ("gravity as a number is downward, and this one acts upward", "leave out its sign, or write [gx, gy]"),
    "weightless": (
        "links have masses but no weights, because no gravity is given",
        "write gravity = 9.81 in [loads], or 0 where it is meant so",
    ),
    "open_diagram": (
        "the diagram does not close: at {travel} of the stroke force and back differ by {jump} N",
        "give both one value there, unless the jump is meant",
    ),
}

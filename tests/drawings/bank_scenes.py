"""Scenes of banks for their sheets: engines in line, in a V and against each other, a bank of the scene's linkage."""

from __future__ import annotations

from collections.abc import Sequence

from tests.plans.banks import FOUR_BAR

UNIT = '[bank.unit]\ncrank = "40 mm"\nrod = "140 mm"\nreciprocating = "0.5 kg"\n'
TURNING = f'{UNIT}rotating = "0.6 kg"\n'
ENGINE = '[bank.unit]\ncrank = "100 mm"\nrod = "400 mm"\nreciprocating = "9.5 kg"\n'  # of methods M7.8


def bank(
    rows: Sequence[tuple[int, int, int]], more: str = "", unit: str = UNIT, head: str = 'speed = "3000 rpm"\n'
) -> str:
    """Write a bank: its members by crank and guide in degrees and place in millimetres between them."""
    members = "".join(f'[[bank.members]]\ncrank = {c}\nplace = "{z} mm"\naxis = {a}\n' for c, z, a in rows)
    return f'sheets = ["bank"]\n[bank]\n{head}{unit}{members}{more}'


def compensator(order: int, *lines: str) -> str:
    """Write the compensators of an order."""
    return "\n".join(["[[bank.compensators]]", f"order = {order}", *lines, ""])


SCENES = {
    "four": bank(
        [(0, -150, 0), (180, -50, 0), (180, 50, 0), (0, 150, 0)],
        compensator(2, 'mass = "50 g"', 'offset = "60 mm"', 'shafts = "250 mm"'),
    ),
    "three": bank([(0, -100, 0), (120, 0, 0), (240, 100, 0)]),
    "vee": bank(
        [(0, -100, 45), (0, -100, -45), (90, 100, 45), (90, 100, -45)],
        compensator(2, 'mass = "1 kg"') + compensator(1, 'mass = "1 kg"', 'offset = "-30 mm"', 'shafts = "200 mm"'),
        TURNING,
        'speed = "-3000 rpm"\norders = [1, 2]\n',
    ),
    "twin": bank(
        [(0, 0, 30), (0, 0, -30)],
        compensator(2, 'mass = "0.1 kg"', 'offset = "50 mm"', 'shafts = "200 mm"'),
        TURNING,
        "speed = 314\norders = [1, 2]\naxis = 80\n",
    ),
    "boxer": bank([(0, -30, 0), (180, 30, 180)], head="speed = 100\norders = [1, 2, 3]\naxis = 0\n"),
    "one": bank(
        [(0, 0, 0)],
        compensator(1, 'mass = "5 kg"', 'offset = "60 mm"', 'shafts = "500 mm"') + compensator(2),
        ENGINE,
        "speed = 20\norders = [1, 2]\n",
    ),
    "six": bank(
        [(0, -250, 0), (120, -150, 0), (240, -50, 0), (240, 50, 0), (120, 150, 0), (0, 250, 0)],
        compensator(1) + compensator(6),
    ),
    "eight": bank([(c, 120 * k, a) for k, c in enumerate((0, 90, 270, 180)) for a in (45, -45)], head="speed = 300\n"),
    "turning": bank(
        [(0, 0, 0)], compensator(1, "mass = 1"), f"{ENGINE}rotating = 1\n".replace("9.5", "0"), "speed = 9\n"
    ),
    "unlike": bank([(0, -50, 0), (0, 50, 0)], compensator(1, 'mass = "2 kg"', 'offset = "60 mm"'), TURNING),
    "cancelled": bank([(0, -50, 0), (180, 50, 0)], compensator(2, "mass = 1"), TURNING),
    "radial": bank([(0, 0, 40 * k) for k in range(9)], unit=TURNING),
    "twelve": bank([(30 * k, 20 * k, 0) for k in range(12)], unit=TURNING),
    "linkage": (
        f'sheets = ["bank"]\n{FOUR_BAR}[bank]\norders = [1, 2, 3]\n[[bank.members]]\ncrank = 0\nplace = "-100 mm"\n'
        '[[bank.members]]\ncrank = 180\nplace = "100 mm"\n' + compensator(2, "mass = 2")
    ),
}


def scene(name: str, size: str = "A1", language: str = "en", standard: str = "GOST") -> str:
    """Write a scene on some paper in a language."""
    paper = f'[sheet]\nformat = "{size}"\nlanguage = "{language}"\nstandard = "{standard}"\n'
    return SCENES[name] + paper

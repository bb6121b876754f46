"""Random crank-rockers after Grashof that start at an extreme position (кривошипно-коромысловые механизмы)."""

from __future__ import annotations

import cmath
from math import sqrt
from random import Random

CRANK = 0.1  # m; the other lengths are drawn beside it
LEAST, MOST = 110, 600  # mm: of rod, rocker and frame
ROUGH = 0.1  # of the crank: how far the sketch is off

SCENE = """title = "Crank-rocker"
[mechanism.frame]
O = [0, 0]
C = [{d}, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "CB"
[mechanism.lengths]
OA = {a}
AB = {b}
CB = {c}
[mechanism.sketch]
B = [{sketch.real:.4f}, {sketch.imag:.4f}]
[drive]
link = 1
speed = {speed}
start = "extreme"
positions = 12
"""


def crank_rocker(chance: Random) -> str:
    """Draw a scene: the crank is the shortest link, and with the longest it is shorter than the other two together."""
    while True:
        b, c, d = (chance.randint(LEAST, MOST) / 1000 for _ in range(3))
        if CRANK + max(b, c, d) < b + c + d - max(b, c, d) - 1e-9:  # the lengths are whole millimetres
            break
    end = cmath.rect(CRANK, chance.uniform(-cmath.pi, cmath.pi))
    sketch = meeting(end, b, complex(d), c, chance.choice((1, -1))) + ROUGH * CRANK * _within(chance)
    return SCENE.format(a=CRANK, b=b, c=c, d=d, sketch=sketch, speed=chance.choice((10, -10)))


def meeting(a: complex, b: float, c: complex, r: float, side: int) -> complex:
    """Meet the circle of radius b about a and that of radius r about c, on one side of the line from a to c."""
    apart = abs(c - a)
    along = (apart + (b - r) * (b + r) / apart) / 2
    return a + (c - a) / apart * complex(along, side * sqrt(max(b**2 - along**2, 0.0)))


def _within(chance: Random) -> complex:
    return cmath.rect(chance.random(), chance.uniform(-cmath.pi, cmath.pi))

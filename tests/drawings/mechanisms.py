"""Mechanisms whose figures are looked at closely: each has a pair, a place or a path that is hard to draw."""

from __future__ import annotations

TOGGLE_PRESS = """
title = "Toggle press with a point on its lower arm"
[mechanism.frame]
O = [0, 0]
C = [0.5, 0.25]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "CB"
4 = "BD"
5 = "D"
[mechanism.lengths]
OA = 0.07
AB = 0.5
CB = 0.25
BD = 0.25
[mechanism.points]
K = { on = 4, at = [0.1, 0.06] }
[[mechanism.slides]]
link = 5
along = { through = [0.5, 0], angle = -90 }
[mechanism.sketch]
B = [0.45, 0.0]
D = [0.5, -0.25]
[drive]
link = 1
speed = -20
start = "extreme"
positions = 12
"""

CROSS_SLIDE = """
title = "Cross-slide with two blocks on one pin"
[mechanism.frame]
O = [0, 0]
C = [0, -0.3]
[mechanism.links]
1 = "OA"
2 = "A"
3 = "CB"
4 = "D"
5 = "DE"
[mechanism.lengths]
OA = 0.1
CB = 0.6
DE = 0.15
[[mechanism.slides]]
link = 2
along = "CB"
[[mechanism.slides]]
link = 4
along = "CB"
[[mechanism.slides]]
link = 5
along = { through = [0, 0.2], angle = 0 }
[mechanism.sketch]
B = [0.2, 0.27]
D = [0.15, 0.2]
E = [0.3, 0.2]
[drive]
link = 1
speed = -10
start = "extreme"
positions = 12
"""

OFFSET_STONE = """
title = "Stone beside a rocker"
[mechanism.frame]
O = [0, 0]
C = [0.4, 0]
E = [0.62, 0.15]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "CB"
4 = "D"
5 = "DE"
[mechanism.lengths]
OA = 0.1
AB = 0.38
CB = 0.36
DE = 0.3
[[mechanism.slides]]
link = 4
along = "CB"
offset = -0.04
[mechanism.sketch]
B = [0.42, 0.34]
D = [0.48, 0.25]
[drive]
link = 1
speed = 6
acceleration = 3
start = 0
positions = 12
[output]
link = 5
[sheet]
position = 2
"""

OFFSET_BLOCK = """
title = "Pin above its guide, rod rigid with its block"
[mechanism.frame]
O = [0, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "BE"
[mechanism.lengths]
OA = 0.06
AB = 0.2
BE = 0.08
[[mechanism.slides]]
link = 3
along = { through = [0, -0.06], angle = 0 }
offset = 0.06
angle = 30
[mechanism.sketch]
B = [0.2, 0.0]
E = [0.27, 0.04]
[drive]
link = 1
speed = 10
start = "extreme"
positions = 12
"""

CONVEYOR = """
title = "Conveyor in 36 positions"
[mechanism.frame]
O = [0, 0]
C = [0.3, 0]
[mechanism.links]
1 = "OA"
2 = "ABE"
3 = "CB"
4 = "EF"
5 = "F"
[mechanism.lengths]
OA = 0.1
AB = 0.25
CB = 0.25
AE = 0.5
BE = 0.25
EF = 0.45
[[mechanism.slides]]
link = 5
along = { through = [0, 0.4], angle = 0 }
[mechanism.sketch]
B = [0.25, 0.24]
E = [0.4, 0.5]
F = [0.7, 0.4]
[drive]
link = 1
speed = 3
start = "extreme"
positions = 36
"""

ECCENTRIC = """
title = "Eccentric, 1 to 100"
[mechanism.frame]
O = [0, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "B"
[mechanism.lengths]
OA = 0.005
AB = 0.5
[[mechanism.slides]]
link = 3
along = { through = [0, 0], angle = 0 }
[mechanism.sketch]
B = [0.5, 0]
[drive]
link = 1
speed = 10
acceleration = -5
start = 0
positions = 12
"""

ALL = {
    "toggle press": TOGGLE_PRESS,
    "cross-slide": CROSS_SLIDE,
    "offset stone": OFFSET_STONE,
    "offset block": OFFSET_BLOCK,
    "conveyor": CONVEYOR,
    "eccentric": ECCENTRIC,
}

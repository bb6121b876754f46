"""Mechanisms whose figures are looked at closely: each has a pair, a place or a path that is hard to draw."""

from __future__ import annotations

from tests.plans.scenes import scene

TOGGLE_PRESS = scene(
    'title = "Toggle press with a point on its lower arm"', frame="O = [0, 0]; C = [0.5, 0.25]",
    links="OA AB CB BD D", lengths="OA = 0.07; AB = 0.5; CB = 0.25; BD = 0.25",
    points="K = { on = 4, at = [0.1, 0.06] }", slides=["link = 5; along = { through = [0.5, 0], angle = -90 }"],
    sketch="B = [0.45, 0.0]; D = [0.5, -0.25]",
    drive='link = 1; speed = -20; start = "extreme"; positions = 12',
)  # fmt: skip
CROSS_SLIDE = scene(
    'title = "Cross-slide with two blocks on one pin"', frame="O = [0, 0]; C = [0, -0.3]", links="OA A CB D DE",
    lengths="OA = 0.1; CB = 0.6; DE = 0.15",
    slides=['link = 2; along = "CB"', 'link = 4; along = "CB"', "link = 5; along = { through = [0, 0.2], angle = 0 }"],
    sketch="B = [0.2, 0.27]; D = [0.15, 0.2]; E = [0.3, 0.2]",
    drive='link = 1; speed = -10; start = "extreme"; positions = 12',
)  # fmt: skip
OFFSET_STONE = scene(
    'title = "Stone beside a rocker"', frame="O = [0, 0]; C = [0.4, 0]; E = [0.62, 0.15]",
    links="OA AB CB D DE", lengths="OA = 0.1; AB = 0.38; CB = 0.36; DE = 0.3",
    slides=['link = 4; along = "CB"; offset = -0.04'], sketch="B = [0.42, 0.34]; D = [0.48, 0.25]",
    drive="link = 1; speed = 6; acceleration = 3; start = 0; positions = 12", output="link = 5",
    sheet="position = 2",
)  # fmt: skip
OFFSET_BLOCK = scene(
    'title = "Pin above its guide, rod rigid with its block"', frame="O = [0, 0]", links="OA AB BE",
    lengths="OA = 0.06; AB = 0.2; BE = 0.08",
    slides=["link = 3; along = { through = [0, -0.06], angle = 0 }; offset = 0.06; angle = 30"],
    sketch="B = [0.2, 0.0]; E = [0.27, 0.04]", drive='link = 1; speed = 10; start = "extreme"; positions = 12',
)  # fmt: skip
CONVEYOR = scene(
    'title = "Conveyor in 36 positions"', frame="O = [0, 0]; C = [0.3, 0]", links="OA ABE CB EF F",
    lengths="OA = 0.1; AB = 0.25; CB = 0.25; AE = 0.5; BE = 0.25; EF = 0.45",
    slides=["link = 5; along = { through = [0, 0.4], angle = 0 }"],
    sketch="B = [0.25, 0.24]; E = [0.4, 0.5]; F = [0.7, 0.4]",
    drive='link = 1; speed = 3; start = "extreme"; positions = 36',
)  # fmt: skip
ECCENTRIC = scene(
    'title = "Eccentric, 1 to 100"', frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.005; AB = 0.5",
    slides=["link = 3; along = { through = [0, 0], angle = 0 }"], sketch="B = [0.5, 0]",
    drive="link = 1; speed = 10; acceleration = -5; start = 0; positions = 12",
)  # fmt: skip
# The ram's mass centre lies where its stroke is dimensioned first.
HIGH_CENTRE = ECCENTRIC + "[masses]\n3 = { mass = 9, centre = [0, 0.03] }\n"
# Two rockers on rods too short for a whole turn of the crank: the far positions are gaps.
TWO_ROCKERS = scene(
    'title = "Two rockers"', frame="O = [0, 0]; C = [0.3, 0]", links="OA AB CB",
    lengths="OA = 0.2; AB = 0.15; CB = 0.15", sketch="B = [0.25, 0.14]",
    drive="link = 1; speed = 10; start = 60; positions = 12",
)  # fmt: skip
ALL = {
    "toggle press": TOGGLE_PRESS,
    "cross-slide": CROSS_SLIDE,
    "offset stone": OFFSET_STONE,
    "offset block": OFFSET_BLOCK,
    "conveyor": CONVEYOR,
    "eccentric": ECCENTRIC,
    "high centre": HIGH_CENTRE,
}

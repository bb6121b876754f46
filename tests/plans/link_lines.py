"""Mechanisms whose slots and rods have a direction of their own, and the same with a second point that shows it."""

from __future__ import annotations

from typing import NamedTuple

from tests.plans.scenes import scene

HEAD = """
sheets = ["kinematics", "forces"]
[drive]
link = 1
speed = "60 rpm"
acceleration = 2
positions = 12
START
[sheet]
format = "A2"
"""


class Written(NamedTuple):
    """A scene, a line of it by its angle, the same line by two letters, and what places and shows the second point."""

    text: str
    by_angle: str
    by_letters: str
    second: str
    sketch: str = ""
    start: int = 20

    @property
    def alone(self) -> str:
        """The scene without a second point."""
        return self._with(self.by_angle)

    @property
    def twin(self) -> str:
        """The scene with one."""
        sketch = f"{self.sketch}\n" if "[mechanism.sketch]" in self.text else f"[mechanism.sketch]\n{self.sketch}\n"
        text = self._with(self.by_letters) + f"\n[mechanism.points]\n{self.second}\n"
        if "[mechanism.sketch]\n" in text:
            return text.replace("[mechanism.sketch]\n", f"[mechanism.sketch]\n{self.sketch}\n")
        return text + sketch

    def _with(self, line: str) -> str:
        return HEAD.replace("START", f"start = {self.start}") + self.text.replace("LINE", line)


def slotted(pivot: str, crank: str, sliding: int, stone: str, link: str) -> str:
    """Write a crank, what is on its pin, and a link about C, with their masses; one of the two slides along LINE."""
    return scene(
        frame=f"O = [0, 0]; C = [{pivot}]",
        links="OA A C",
        lengths=f'OA = "{crank}"',
        slides=[f"link = {sliding}; along = LINE"],
        masses=f"2 = {stone}; 3 = {link}",
        loads="gravity = 9.81",
    )


# The yoke of the sine mechanism: B on the guide, the slot square to it.
YOKE = Written(
    scene(
        frame="O = [0, 0]",
        links="OA A B",
        lengths='OA = "60 mm"',
        slides=["link = 2; along = LINE", 'link = 3; along = { through = [0, "-80 mm"], angle = 0 }'],
        masses='2 = { mass = 0.3 }; 3 = { mass = 4, centre = [0, "80 mm"] }',
        loads="gravity = 9.81",
        forces=['on = 3; point = "B"; against = "motion"; value = 400; during = "working stroke"'],
    ),
    "{ link = 3, angle = 90 }",
    '"BC"',
    'C = { on = 3, at = [0, "160 mm"] }',
)
# A lever about C whose slot leans by 25 degrees from the lever's own +x and passes beside C, and its mass off both.
LEVER = Written(
    slotted(
        '0, "-200 mm"',
        "70 mm",
        2,
        "{ mass = 0.4, inertia = 0.001 }",
        '{ mass = 3, inertia = 0.02, centre = ["150 mm", "40 mm"] }',
    )
    + """[[loads.moments]]
on = 3
against = "motion"
value = 15
""",
    '{ link = 3, through = ["20 mm", "30 mm"], angle = 25 }',
    '"DE"',
    'D = { on = 3, at = ["20 mm", "30 mm"] }\nE = { on = 3, at = [0.2012615574073300, 0.1145236523481399] }',
    "E = [0.08, 0.02]",
)
# A piston rod on the crank's pin, with no piston named; the cylinder swings about C.
ROD = Written(
    slotted(
        '"-300 mm", "-100 mm"',
        "80 mm",
        3,
        '{ mass = 1, inertia = 0.01, centre = [0, "-90 mm"] }',
        "{ mass = 2, inertia = 0.02 }",
    ),
    "{ link = 2, angle = -90 }",
    '"AB"',
    'B = { on = 2, at = [0, "-450 mm"] }',
    "B = [-0.35, -0.12]",
)
# A coupler with a slot across it, through its point B, in which a stone runs that is hinged to a slider of the frame.
COUPLER = Written(
    scene(
        frame='O = [0, 0]; C = ["300 mm", 0]',
        links="OA AB CB D D",
        lengths='OA = "80 mm"; AB = "300 mm"; CB = "200 mm"',
        sketch="B = [0.32, 0.2]",
        slides=["link = 4; along = LINE", 'link = 5; along = { through = [0, "350 mm"], angle = 0 }'],
        masses='2 = { mass = 1, inertia = 0.01, centre = "middle" }; 5 = { mass = 2 }',
        loads="gravity = 9.81",
    ),
    '{ link = 2, through = "B", angle = 70 }',
    '"BE"',
    "E = { on = 2, at = [0.4026060429977007, 0.2819077862357725] }",
)
WRITTEN = {"yoke": YOKE, "lever": LEVER, "rod": ROD, "coupler": COUPLER}

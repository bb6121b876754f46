"""Scenes of balancing and of banks, to be varied: a four-bar, an engine, a bank by sizes."""

from __future__ import annotations

from tests.plans.scenes import scene

FOUR_BAR = scene(
    frame="O = [0, 0]; C = [0.35, 0]", links="OA AB BC", lengths="OA = 0.1; AB = 0.4; BC = 0.3",
    sketch="B = [0.39, 0.3]",
    masses="1 = { mass = 2, centre = [0.04, 0] }; 2 = { mass = 4, centre = [0.18, 0] }; "
    "3 = { mass = 5, centre = [0.12, 0] }",
    drive="link = 1; speed = 10",
)  # fmt: skip
ENGINE = scene(
    frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.1; AB = 0.4",
    slides=["link = 3; along = { through = [0, 0] }"], sketch="B = [0.5, 0]",
    masses="1 = { mass = 3, centre = [0.04, 0] }; 2 = { mass = 4, centre = [0.15, 0] }; 3 = { mass = 5 }",
    drive="link = 1; speed = 20",
)  # fmt: skip
UNIT = scene(bank_unit='crank = "40 mm"; rod = "140 mm"; rotating = "600 g"; reciprocating = "0.5 kg"')
MEMBER = "[[bank.members]]\ncrank = 0\n"


def counterweight(*lines: str) -> str:
    """Write a counterweight."""
    return "\n".join(["[[balance.counterweights]]", *lines, ""])

"""Scenes of balancing for their sheets: four-bars, engines in two ways, six-links, what is balanced already."""

from __future__ import annotations

from tests.plans.balanced import SHAPER, SIX_LINK
from tests.plans.banks import ENGINE, FOUR_BAR, counterweight

FULL = '[balance]\naim = "full"\n'
ONE = counterweight("on = 1", "mass = 5")
THREE = counterweight("on = 3", "mass = 8")


def own(text: str) -> str:
    """Take a scene of the balances by construction, for its sheet."""
    return text.format(positions=12).replace('sheets = ["forces"]\n', "")


BALANCED = FOUR_BAR.replace("0.04, 0", "0, 0").replace("mass = 4", "mass = 0").replace("mass = 5", "mass = 0")
PARALLELOGRAM = (
    FOUR_BAR.replace("C = [0.35, 0]", "C = [0.4, 0]")
    .replace("BC = 0.3", "BC = 0.1")
    .replace("B = [0.39, 0.3]", "B = [0.4, 0.1]")
    .replace("0.12, 0]", "0.05, 0]")
    .replace("speed = 10\n", "speed = 10\nstart = 30\npositions = 12\n")
)
SCENES = {
    "bar": FOUR_BAR + FULL + THREE + counterweight("on = 1", 'shape = "sector"'),
    "engine": ENGINE + '[balance]\naim = "share"\nshare = "force"\n' + counterweight("on = 1", 'radius = "60 mm"'),
    "guide": (
        ENGINE.replace("through = [0, 0]", "through = [0, 0.03]").replace("speed = 20", "speed = -20")
        + '[balance]\naim = "partial"\n'
        + counterweight("on = 1", 'at = "-150 mm"')
    ),
    "bent": FOUR_BAR.replace("0.18, 0]", "0.18, 0.05]") + FULL + counterweight("on = 2", "mass = 8") + ONE,
    "six": own(SIX_LINK) + "[balance]\n",
    "slot": own(SHAPER)
    + FULL
    + "".join(counterweight(f"on = {k}", f"mass = {m}") for k, m in ((1, 6), (3, 160), (4, 30))),
    "swing": FOUR_BAR.replace("OA = 0.1", "OA = 0.3") + FULL + THREE + ONE,
    "many": FOUR_BAR + "positions = 72\n" + FULL + THREE + ONE,
    "still": BALANCED + FULL + THREE + ONE,
    "parallel": '[mechanism]\nthrough = "parallel"\n' + PARALLELOGRAM + FULL + THREE + ONE,
}


def scene(name: str, size: str = "A2", language: str = "en", standard: str = "GOST") -> str:
    """Write a scene, on other paper, in another language."""
    sheet = f'[sheet]\nformat = "{size}"\nlanguage = "{language}"\nstandard = "{standard}"\nposition = 2\n'
    return f'sheets = ["balancing"]\n{SCENES[name]}{sheet}'

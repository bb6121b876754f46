"""Machines of the textbook to be balanced (8.2): scenes without what balancing asks, which tests hand in as a task."""

from __future__ import annotations

from plans.balance.study import BalanceStudy
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import BalanceTask, Site
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene

FOUR_BAR = scene(
    'sheets = ["forces"]', frame="O = [0, 0]; C = [0.35, 0]", links="OA AB BC",
    lengths="OA = 0.10; AB = 0.40; BC = 0.30", sketch="B = [0.39, 0.30]",
    drive="link = 1; speed = 10; start = 60; positions = {positions}",
    masses="1 = {{ mass = 2, centre = [0.04, 0] }}; 2 = {{ mass = 4, centre = [0.18, 0], inertia = 0.05 }}; "
    "3 = {{ mass = 5, centre = [0.12, 0], inertia = 0.04 }}",
)  # fmt: skip

# Rod DE from D of link 3, B-D 0.20 m; the slider's centre 0.02 m ahead of E.
SIX_LINK = scene(
    'sheets = ["forces"]', frame="O = [0, 0]; C = [0.35, 0]", links="OA AB BC DE E",
    lengths="OA = 0.10; AB = 0.40; BC = 0.30; DE = 0.35", points="D = {{ on = 3, at = [0.20, 0] }}",
    slides=["link = 5; along = {{ through = [0, 0.10], angle = 0 }}"],
    sketch="B = [0.39, 0.30]; D = [0.36, 0.10]; E = [0.71, 0.10]",
    drive="link = 1; speed = 10; start = 60; positions = {positions}",
    masses="1 = {{ mass = 2, centre = [0.04, 0] }}; 2 = {{ mass = 4, centre = [0.18, 0] }}; "
    "3 = {{ mass = 5, centre = [0.12, 0] }}; 4 = {{ mass = 2, centre = [0.15, 0] }}; "
    "5 = {{ mass = 6, centre = [0.02, 0] }}",
)  # fmt: skip

ENGINE = scene(
    'sheets = ["forces"]', frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.10; AB = 0.40",
    slides=["link = 3; along = {{ through = [0, 0], angle = 0 }}"], sketch="B = [0.44, 0]",
    drive="link = 1; speed = 20; start = 0; positions = {positions}",
    masses="1 = {{ mass = 3, centre = [0.04, 0], inertia = 0.01 }}; "
    "2 = {{ mass = 4, centre = [0.15, 0], inertia = 0.06 }}; 3 = {{ mass = 8 }}",
)  # fmt: skip

# Two such sliders at a right angle on one crank pin, the second rod with its centre off its line.
TWIN = (
    ENGINE.replace('3 = "B"\n', '3 = "B"\n4 = "AC"\n5 = "C"\n')
    .replace("AB = 0.40\n", "AB = 0.40\nAC = 0.30\n")
    .replace(
        "[mechanism.sketch]",
        "[[mechanism.slides]]\nlink = 5\nalong = {{ through = [0, 0], angle = 90 }}\n[mechanism.sketch]",
    )
    .replace("B = [0.44, 0]\n", "B = [0.44, 0]\nC = [0, 0.28]\n")
    + "4 = {{ mass = 3, centre = [0.10, 0.02], inertia = 0.05 }}\n5 = {{ mass = 6 }}\n"
)

# The slotted link of figure 8.10 with the attached slider-crank CDE; link 3 swings about C below the crank.
SHAPER = scene(
    'sheets = ["forces"]', frame="O = [0, 0]; C = [0, -0.35]", links="OA A CD DE E",
    lengths="OA = 0.12; CD = 0.70; DE = 0.20",
    slides=['link = 2; along = "CD"', "link = 5; along = {{ through = [0, 0.33], angle = 0 }}"],
    sketch="D = [0.1, 0.34]; E = [0.3, 0.33]", drive="link = 1; speed = 10; start = 0; positions = {positions}",
    masses="1 = {{ mass = 4, centre = [0.05, 0] }}; 2 = {{ mass = 1.5 }}; "
    "3 = {{ mass = 12, centre = [0.30, 0] }}; 4 = {{ mass = 3, centre = [0.10, 0] }}; 5 = {{ mass = 20 }}",
)  # fmt: skip

# The yoke's vertical guide is reached by no hinge: its vector is variable.
YOKE = scene(
    'sheets = ["forces"]', frame="O = [0, 0]", links="OA A DE", lengths="OA = 0.1; DE = 0.4",
    slides=['link = 2; along = "DE"', "link = 3; along = {{ through = [0, 0], angle = 90 }}; angle = -90"],
    sketch="D = [0, 0]; E = [0.4, 0]",
    drive="link = 1; speed = 10; acceleration = -7; start = 20; positions = {positions}",
    masses="1 = {{ mass = 2, centre = [0.03, 0.01] }}; 2 = {{ mass = 1 }}; 3 = {{ mass = 4, centre = [0.2, 0.05] }}",
)  # fmt: skip


def study(text: str, task: BalanceTask | None = None, positions: int = 12) -> BalanceStudy:
    """Give the study of a scene's balance with a task of its own."""
    linkage = LinkageStudy(parse_scene(text.format(positions=positions)))
    return BalanceStudy(linkage, Statics(linkage), task or BalanceTask())


def asked(aim: str, *places: Site, share: float | None = None, least: str = "force") -> BalanceTask:
    """Ask for a balance by counterweights on some links."""
    return BalanceTask(aim, places, share, least)

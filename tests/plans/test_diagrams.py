"""Kinematic diagrams of the output: chords against what a textbook gives, gaps, outputs that turn, what is left out."""

from __future__ import annotations

import numpy as np
import pytest

from plans.model.diagrams import Diagrams
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import Message

# A sine mechanism (Scotch yoke) of radius r: S = r (1 - cos φ) from its dead centre, so that all is known exactly.
YOKE = """
sheets = ["kinematics"]
[mechanism.frame]
O = [0, 0]
[mechanism.links]
1 = "OA"
2 = "A"
3 = "B"
[mechanism.lengths]
OA = 0.060
[[mechanism.slides]]
link = 3
along = {{ through = [0, 0], angle = 0 }}
[[mechanism.slides]]
link = 2
along = {{ through = "B", angle = 90 }}
[drive]
link = 1
speed = {speed}
{drive}
"""
ROCKER = """
sheets = ["kinematics"]
[mechanism.frame]
O = [0, 0]
C = [{apart}, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "CB"
[mechanism.lengths]
OA = 0.100
AB = {rod}
CB = {rocker}
[mechanism.sketch]
B = {sketch}
[drive]
link = 1
speed = 10
{drive}
{rest}
"""
CRANK_ROCKER = {"apart": 0.35, "rod": 0.4, "rocker": 0.3, "sketch": "[0.39, 0.30]", "drive": "positions = 12", "rest": ""}

"""Machines whose force plans are looked at closely, and their sheets."""

from __future__ import annotations

from functools import cache, cached_property
from math import radians
from pathlib import Path
from typing import NamedTuple

import numpy as np

from drawings.forces import lever_plan, polygon
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Picture, Place, Spot
from drawings.page.page import Field
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand, hand_of
from drawings.paper.strokes import Leaf
from plans.forces.cut import ForcePlan
from plans.forces.force_template import forces
from plans.forces.lever import Lever, lever
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Applied, Loading
from plans.model.machine import GEAR, Body, Machine, Transmission
from plans.scene.scene import parse_scene

GALLERY = Path(__file__).parents[2] / "drawings/gallery"
GEARED = Transmission(GEAR, 0.18, radians(210), radians(20))
RAM = {1: Body(1, 6, 0.25, 0j), 3: Body(3, 15, 0.6, 0.35 + 0j), 4: Body(4, 3, 0.01, 0.1 + 0j), 5: Body(5, 25, 0, 0j)}


class Case(NamedTuple):
    """A machine: its scene, changes of its text, its masses, its load with link and point, and how it is driven."""

    scene: str
    changes: tuple[tuple[str, str], ...]
    bodies: dict[int, Body]
    load: tuple[int, str, complex]
    drive: Transmission = Transmission()


def equal(count: int, *single: int) -> dict[int, Body]:
    """Give all links a mass of some kg, its centre off every hinge; single-point links have it at their point."""
    return {
        link: Body(link, 2.0 + link, 0.0 if link in single else 0.01 * link, 0j if link in single else 0.07 + 0.02j)
        for link in range(1, count + 1)
    }


AT_60 = (('start = "extreme"', "start = 60"), ("positions = 12", "positions = 1"))
TIP = (("[mechanism.sketch]", '[mechanism.points]\nC = { on = 3, at = [0, "160 mm"] }\n[mechanism.sketch]'),)
CASES = {
    "shaper at 60": Case("shaper", AT_60, RAM, (5, "D", 1500 + 0j), GEARED),
    "shaper": Case("shaper", (), RAM, (5, "D", 1500 + 0j)),
    "four-bar": Case("crank-rocker", (), equal(3), (3, "B", -400 + 100j)),
    "slider-crank": Case("slider-crank", (), equal(3, 3), (3, "B", -900j)),
    "scotch yoke": Case("scotch-yoke", TIP, equal(3, 2), (3, "C", -400 + 0j)),
    "tangent": Case("tangent", (), equal(3, 2), (3, "A", -400j)),
    "cylinder": Case("oscillating-cylinder", (), equal(3), (2, "B", 30 + 0j)),
    "press": Case("toggle-press", (), equal(5, 5), (5, "D", 4e6j)),
}


class Forced:
    """A case with its plans, and its forces by equilibrium."""

    def __init__(self, case: Case) -> None:
        text = (GALLERY / f"{case.scene}.toml").read_text("utf-8")
        for old, new in case.changes:
            assert old in text
            text = text.replace(old, new)
        text = text.partition("[sheet]")[0] if case.changes else text
        self.study, self.case = LinkageStudy(parse_scene(text)), case
        self.machine = Machine(case.bodies, -9.81j, (), (), (), case.drive, {})
        link, point, force = case.load
        count, at = len(self.study.turn), self.study.mechanism.links[link].points[point]
        self.loading = Loading((Applied("F_us", link, point, at, np.full(count, force)),), ())

    @cached_property
    def plan(self) -> ForcePlan:
        return forces(self.study.drafts().accelerations, self.study.groups, self.machine, self.loading)

    @cached_property
    def lever(self) -> Lever:
        found = lever(self.plan)
        assert found is not None
        return found


@cache
def forced(name: str) -> Forced:
    return Forced(CASES[name])


def spot(measure: Picture, cell: Field) -> Spot:
    """Give a picture the largest standard scale at which it fits a cell, and no more paper than it asks for."""
    scale = measure.ladder(cell.width, cell.height).rungs[0].scale
    half, centre = complex(*measure.size(scale)) / 2, cell.centre
    low, high = centre - half, centre + half
    return Spot(Field(low.real, low.imag, high.real, high.imag), scale)


def polygons(case: Forced, k: int, hand: Hand, language: str = "en", reactions: str = "R") -> list[LetteredFigure]:
    """Draw the force plans of all cuts in cells beside one another."""
    figures = []
    drafting = Drafting(hand, language, reactions=reactions)
    for number, cut in enumerate(case.plan.cuts):
        shown = polygon.polygon(case.plan, cut, k)
        measure = polygon.measure(shown, drafting)
        placed = spot(measure, Field(10 + 300 * number, 230, 300 + 300 * number, 450))
        figures.append(polygon.draw(shown, measure, placed, drafting))
    return figures


def hung(case: Forced, k: int, hand: Hand, language: str = "en") -> tuple[LetteredFigure, Place]:
    """Draw the lever below; say where it lies."""
    shown = lever_plan.hanging(case.plan, case.lever, k)
    drafting = Drafting(hand, language)
    measure = lever_plan.measure(shown, drafting)
    placed = spot(measure, Field(10, 10, 300, 225))
    return lever_plan.draw(shown, measure, placed, drafting), measure.place(*placed)


def leaf(figures: list[LetteredFigure], hand: Hand) -> Leaf:
    """Put figures on one sheet: all lines first, then the letters."""
    ink = Ink(920, 460)
    ink.draw([stroke for one in figures for stroke in one.lines])
    labels = Labels(ink, hand.drafted)
    return Leaf(920, 460, tuple(group for one in figures for group in one.letter(labels)), lettering="strokes")


@cache
def sheet(name: str, k: int, paper: str = "A1", language: str = "en") -> Leaf:
    case, hand = forced(name), hand_of(paper)
    return leaf([*polygons(case, k, hand, language), hung(case, k, hand, language)[0]], hand)

"""Machines whose force plans are looked at closely, their forces by plain equilibrium of all links, their sheets."""

from __future__ import annotations

import cmath
from functools import cache, cached_property
from math import radians
from pathlib import Path
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.figures.forces import force_polygon, lever_plan
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import Picture, Spot
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.hand import Hand, hand_of
from drawings.paper.strokes import Leaf
from plans.analytic.kinematics import solve
from plans.checks.force_bill import ExpectedForces
from plans.forces.force import ForcePlan
from plans.forces.force_template import forces
from plans.forces.lever import Lever, lever
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Applied, Balancing, Kinetostatics, Loading, Reaction, pairs
from plans.model.machine import GEAR, Body, Machine, Transmission
from plans.model.motion import Motion
from plans.scene.scene import parse_scene

GALLERY = Path(__file__).parents[2] / "drawings/gallery"
Figure: TypeAlias = force_polygon.PolygonFigure | lever_plan.LeverFigure
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

    @cached_property
    def motion(self) -> Motion:
        return solve(self.study.mechanism, self.study.turn.phi, first=self.study.assembly.phi)

    def expected(self, k: int) -> ExpectedForces:
        study = self.study
        return ExpectedForces(study.mechanism, self.machine, self.motion, self.loading, self._balanced(k), k)

    def _balanced(self, k: int) -> Kinetostatics:
        """Solve the equilibrium of all links at once, three equations each; the crank is driven by a moment."""
        study, motion = self.study, self.motion
        links = sorted(set(study.mechanism.links) - {0})
        every, count = pairs(study.mechanism, study.groups), len(study.turn)
        matrix, known = np.zeros((3 * len(links), 3 * len(links))), np.zeros(3 * len(links))
        columns: list[tuple[Reaction, complex, float]] = []
        for pair in every:
            r = complex(motion.points[pair.point].r[k])
            if isinstance(pair.joint, str):
                units, along = ((1 + 0j, 0.0), (1j, 0.0)), None
            else:
                angle = motion.links[pair.joint.owner].angle[k] if pair.joint.owner else 0.0
                along = pair.joint.on_owner.direction * cmath.rect(1.0, float(angle))
                units = ((1j * along, 0.0), (0j, 1.0))
            for force, moment in units:
                row = Reaction(
                    pair.giver,
                    pair.taker,
                    pair.point,
                    full(r, count),
                    full(force, count),
                    None,
                    along and full(along, count),
                )
                for link, sign in ((pair.taker, 1.0), (pair.giver, -1.0)):
                    if link:
                        j = 3 * links.index(link)
                        turning = (r.conjugate() * force).imag + moment
                        matrix[j : j + 3, len(columns)] = sign * force.real, sign * force.imag, sign * turning
                columns.append((row, force, moment))
        drive = study.mechanism.drive.link
        matrix[3 * links.index(drive) + 2, -1] = 1.0
        for link, force, r, moment in self._acting(k):
            j = 3 * links.index(link)
            known[j : j + 3] -= force.real, force.imag, (r.conjugate() * force).imag + moment
        found = np.linalg.solve(matrix, known)
        reactions: dict[str, Reaction] = {}
        for (row, force, _), size in zip(columns, found, strict=False):
            key = f"{row.giver}-{row.taker}"
            total = reactions[key].force if key in reactions else full(0j, count)
            reactions[key] = row._replace(force=total + size * force)
        return Kinetostatics("equilibrium", motion.phi, reactions, Balancing(full(found[-1], count)), ())

    def _acting(self, k: int):  # type: ignore[no-untyped-def]
        """Give the weights with inertia and the load: link, force N, place m, moment N*m."""
        for link, body in self.machine.bodies.items():
            name, own = next(iter(self.study.mechanism.links[link].points.items()))
            point, turning = self.motion.points[name], self.motion.links[link]
            omega, epsilon = float(turning.omega[k]), float(turning.epsilon[k])  # type: ignore[index]
            arm = (body.centre - own) * cmath.rect(1.0, float(turning.angle[k]))
            acceleration = complex(point.a[k]) + (1j * epsilon - omega**2) * arm  # type: ignore[index]
            force = body.mass * (self.machine.gravity - acceleration)
            yield link, force, complex(point.r[k]) + arm, -body.inertia * epsilon
        for load in self.loading.forces:
            yield load.link, complex(load.force[k]), complex(self.motion.points[load.point].r[k]), 0.0


def full(value: complex, count: int):  # type: ignore[no-untyped-def]
    return np.full(count, value)


@cache
def forced(name: str) -> Forced:
    return Forced(CASES[name])


def spot(measure: Picture, cell: Field) -> Spot:
    """Give a picture the largest standard scale at which it fits a cell, and no more paper than it asks for."""
    scale = measure.ladder(cell.width, cell.height).rungs[0].scale
    half, centre = complex(*measure.size(scale)) / 2, cell.centre
    low, high = centre - half, centre + half
    return Spot(Field(low.real, low.imag, high.real, high.imag), scale)


def polygons(
    case: Forced, k: int, hand: Hand, language: str = "en", reactions: str = "R"
) -> list[force_polygon.PolygonFigure]:
    """Draw the force plans of all cuts in cells beside one another."""
    figures = []
    drafting = Drafting(hand, language, reactions=reactions)
    for number, cut in enumerate(case.plan.cuts):
        shown = force_polygon.polygon(case.plan, cut, k)
        measure = force_polygon.measure(shown, f"{shown.plan}-{k}", drafting)
        placed = spot(measure, Field(10 + 300 * number, 230, 300 + 300 * number, 450))
        figures.append(force_polygon.draw(shown, measure, placed, drafting))
    return figures


def hung(case: Forced, k: int, hand: Hand, language: str = "en") -> lever_plan.LeverFigure:
    """Draw the lever below."""
    shown = lever_plan.hanging(case.plan, case.lever, k)
    drafting = Drafting(hand, language)
    measure = lever_plan.measure(shown, f"lever-{k}", drafting)
    placed = spot(measure, Field(10, 10, 300, 225))
    return lever_plan.draw(shown, measure, placed, drafting)


def leaf(figures: list[Figure], hand: Hand) -> Leaf:
    """Put figures on one sheet: all lines first, then the letters."""
    ink = Ink(920, 460)
    ink.draw([stroke for one in figures for stroke in one.lines])
    labels = Labels(ink, hand.drafted)
    return Leaf(920, 460, tuple(group for one in figures for group in one.letter(labels)), lettering="strokes")


@cache
def sheet(name: str, k: int, paper: str = "A1", language: str = "en") -> Leaf:
    case, hand = forced(name), hand_of(paper)
    return leaf([*polygons(case, k, hand, language), hung(case, k, hand, language)], hand)

"""A sheet of forces drawn by hand from the shaper at 60 degrees: every primitive of a force sheet at work.

The forces are those of the worked example (N, at crank angle 60 degrees); the graph and the hodograph are made up.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from drawings.figures.graphs import curve_graph, hodograph
from drawings.figures.graphs.curve_graph import GraphCurve
from drawings.figures.graphs.hodograph import Hodograph
from drawings.layout import value_table
from drawings.layout.composer import compose
from drawings.layout.contents import Composition, Contents, Panel
from drawings.layout.equation import DIRECTION, Passage, Term, forces, moments
from drawings.layout.figure import Figure
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, picture
from drawings.layout.place import Place
from drawings.layout.table import TableRow
from drawings.lettering.lettering import text_width
from drawings.lettering.words import letter, word
from drawings.page.drafting import Drafting
from drawings.page.page import Page
from drawings.paper.strokes import Group, Leaf, Line, Stroke, Text
from drawings.sheets.paragraphs import measure, write
from drawings.symbols import arms, force_arrow, symbols, transmission
from drawings.symbols.couples import CoupleArc
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.force_arrow import ForceArrow

SHAFT, C, A, B, D = 0j, -0.35j, 0.06 + 0.103923j, 0.091729 + 0.343964j, 0.291152 + 0.328786j
S3, S4 = (B + C) / 2, (B + D) / 2
R34T, R34N, R34 = 0.80694 + 10.60216j, -1639.3283 + 124.77011j, -1638.52137 + 135.37227j
PHI4, G4, FUS, PHI5, G5, R05 = 14.8635 + 5.22821j, -29.43j, 1500 + 0j, 123.65786 + 0j, -245.25j, 134.07951j
R12, R03, PHI3, G3 = -2537.12787 + 335.36008j, 861.38634 - 78.97888j, 37.22016 + 26.14107j, -147.15j
RZ, R01, G1 = 1290.91575 - 1083.20693j, -3828.04362 + 1477.42702j, -58.86j
VA, VB, VD = -1.03923 + 0.6j, -1.68064 + 0.22215j, -1.69755 + 0j
NOTES = [
    "R_{34} = 1644 N,  R_{12} = 2559 N,  R_{01} = 4103 N",
    "M_{bal} = 285.0 N·m by plan, 285.0 N·m by Zhukovsky's lever",
]
POLYGONS: dict[str, list[tuple[str, complex]]] = {
    "polygon-4-5": [
        ("R^t_{34}", R34T), ("Φ_4", PHI4), ("G_4", G4), ("F_{us}", FUS), ("Φ_5", PHI5), ("G_5", G5), ("R_{05}", R05),
        ("R^n_{34}", R34N),
    ],
    "polygon-2-3": [("R_{12}", R12), ("R_{43}", -R34), ("Φ_3", PHI3), ("G_3", G3), ("R_{03}", R03)],
    "polygon-1": [("R_{21}", -R12), ("G_1", G1), ("F_z", RZ), ("R_{01}", R01)],
}  # fmt: skip
SCHEMES: dict[str, list[complex]] = {
    "scheme-4-5": [B, D, B + 0.02, D + 0.1], "scheme-2-3": [A, B, C], "scheme-1": [0.18 + 0.18j, -0.18 - 0.18j],
}  # fmt: skip


class Draft:
    """The specimen on a page."""

    def __init__(self, page: Page) -> None:
        self.page, self.hand, self.language = page, page.hand, page.language
        self.drafting = Drafting(page.hand, page.language, page.standard)
        turn = np.linspace(0, 360, 181)
        at = np.arange(12) * 30.0
        shape = lambda phi: 120 + 170 * np.sin(np.radians(phi)) - 60 * np.cos(2 * np.radians(phi))  # noqa: E731
        self.curve = GraphCurve(
            letter(self.language, "M_{bal}"), "N*m", turn, shape(turn), at, shape(at), self.title("balancing-graph")
        )
        way = lambda phi: 1200 * np.exp(1j * np.radians(phi)) + 500 * np.exp(-2j * np.radians(phi)) + 300j  # noqa: E731
        self.hodograph = Hodograph("R_{34}", "F", "N", way(turn), way(at), 2)
        self.strokes: list[Stroke] = []
        self.lettered: list[ForceArrow | CoupleArc | arms.Arm] = []

    def title(self, name: str) -> str:
        kind, _, group = name.partition("-")
        key = {"scheme": "loading scheme", "polygon": "force plan", "balancing": "balancing graph"}.get(kind, kind)
        if group == "1":
            key = {"scheme": "primary scheme", "polygon": "primary force plan"}[kind]
        return word(self.language, key, group=group, letter="R_{34}")

    def picture(self, name: str, values: Sequence[complex], subject: tuple[str, str], around: float = 3.0) -> Picture:
        hand = self.hand
        above = around * hand.letter + 2 * hand.title + hand.text
        margins = Margins(around * hand.letter, around * hand.letter, above)
        width = text_width(Text(0j, self.title(name), hand.title))
        return picture(name, values, subject, margins, width, 10 * hand.letter)

    def passage(self, name: str) -> Passage:
        tau = lambda one: letter(self.language, one)  # noqa: E731
        if name == "equations-4-5":
            whole = forces([
                Term(tau("R^t_{34}")), Term("Φ_4"), Term("G_4"), Term(tau("F_{us}")), Term("Φ_5"), Term("G_5"),
                Term("R_{05}", DIRECTION), Term("R^n_{34}", DIRECTION),
            ])  # fmt: skip
            return Passage(
                name,
                (moments("D", [("−", tau("R^t_{34}·BD")), ("+", "G_4·h_1"), ("−", "Φ_4·h_2"), ("−", "M^Φ_4")]), whole),
                self.hand.letter,
            )
        whole = forces([Term("R_{12}"), Term("R_{43}"), Term("Φ_3"), Term("G_3"), Term("R_{03}", 0)])
        return Passage(name, (moments("C", [("+", "R_{12}·AC"), ("−", "R_{43}·h_3")]), whole), self.hand.letter)

    @property
    def contents(self) -> Contents:
        polygons = {
            name: self.picture(name, list(np.cumsum([0j, *(force for _, force in chain)])), ("F", "N"))
            for name, chain in POLYGONS.items()
        }
        schemes = {name: self.picture(name, values, ("l", "m"), 4.5) for name, values in SCHEMES.items()}
        columns = [
            (schemes[f"scheme-{k}"], self.passage(f"equations-{k}").block(), polygons[f"polygon-{k}"])
            for k in ("4-5", "2-3")
        ]
        columns.append((schemes["scheme-1"], polygons["polygon-1"]))
        lines = [
            TableRow(f"R_{{{k}}}, {word(self.language, 'N')}", ("1644.10", "1644.10", "<10^{−9}"))
            for k in (12, 34, "05", "03", "01")
        ]
        loose = (
            self.picture("lever", [0j, *(-1j * v for v in (VA, VB, VD))], ("v", "m/s"), 4.0),
            curve_graph.measure(self.curve, "balancing-graph", self.drafting),
            hodograph.measure(self.hodograph, "hodograph", self.drafting),
        )
        return Contents(
            (
                *(Panel(item, together=str(k)) for k, column in enumerate(columns) for item in column),
                *map(Panel, loose),
            ),
            (value_table.table(lines, (2,), self.drafting),),
            measure(NOTES, self.hand.text),
        )

    def leaves(self) -> list[Leaf]:
        contents = self.contents
        self.pictures = {one.item.name: one.item for one in contents.panels if isinstance(one.item, Picture)}
        return [self.leaf(one) for one in compose(contents, self.page)]

    def leaf(self, composed: Composition) -> Leaf:
        page, hand = self.page, self.hand
        ink = Ink(*page.size)
        ink.bar(page.field.inset(1.0))
        self.strokes, self.lettered = [page.title_block({"title": "Crank shaper"}, self.language)], []
        for table, corner, setting in composed.tables:
            self.strokes += table.draw(corner, setting, self.drafting)
        if composed.notes is not None:
            self.strokes.append(write(NOTES, composed.notes, hand.text, page.field.right))
        for name, field in composed.blocks.items():
            self.strokes.append(self.passage(name).write(field, hand))
        figures: list[Figure] = []
        for name, spot in composed.spots.items():
            place = self.pictures[name].place(*spot)
            scale = spot.scale.written(self.language)
            if name == "balancing-graph":
                figures.append(curve_graph.draw(self.curve, self.pictures[name], spot, self.drafting))
                continue
            if name == "hodograph":
                figures.append(hodograph.draw(self.hodograph, self.pictures[name], spot, self.drafting))
                continue
            self.strokes.append(heading(spot.box, self.title(name), scale, hand))
            {"scheme": self.scheme, "polygon": self.polygon, "lever": self.lever}[name.split("-")[0]](name, place)
        ink.draw([*self.strokes, *(line for one in figures for line in one.lines)])
        labels = Labels(ink, hand.drafted)
        letters = [one.letter_beside(labels, hand) for one in self.lettered]
        if "lever" in composed.spots:
            pole = self.pictures["lever"].place(*composed.spots["lever"]).on(0j)
            letters.append(labels.beside(pole, "p", hand.letter, 1.6, -math.pi / 2))
        lettered = [group for one in figures for group in one.letter(labels)]
        groups = [stroke if isinstance(stroke, Group) else Group((stroke,)) for stroke in self.strokes]
        return Leaf(*page.size, (page.frame(), page.corners(), *groups, Group(tuple(letters)), *lettered))

    def add(self, one: ForceArrow | CoupleArc | arms.Arm) -> None:
        drawn = one.draw(self.hand)
        self.strokes += drawn if isinstance(drawn, tuple) else [drawn]
        self.lettered.append(one)

    def shown(self, name: str, direction: complex, at: complex, length: float = 5.0, **how: bool) -> None:
        self.add(force_arrow.not_to_scale(letter(self.language, name), direction, at, length * self.hand.letter, **how))

    def scheme(self, name: str, place: Place) -> None:
        on, hand = place.on, self.hand
        if name == "scheme-4-5":
            self.strokes += [Line(on(B), on(D), hand.result), symbols.block(on(D), 1 + 0j, hand)]
            self.strokes += [
                *symbols.hinge(on(B), hand),
                *symbols.hinge(on(D), hand),
                *symbols.mass_centre(on(S4), hand),
            ]
            rod = (B - D) / abs(B - D)
            self.shown("R^n_{34}", rod, on(B), unknown=True)
            self.shown("R^t_{34}", 1j * -rod, on(B))
            self.shown("G_4", -1j, on(S4))
            self.shown("Φ_4", PHI4, on(S4), 4.0)
            self.shown("F_{us}", 1, on(D), ending=False, length=7.0)
            self.shown("G_5", -1j, on(D))
            self.shown("R_{05}", 1j, on(D), unknown=True)
            self.add(CoupleArc("M^Φ_4", on(S4), -1, 8.0 * hand.symbol, math.pi / 2))
            subject = Subject(name, "l", 2)
            self.add(arms.to_scale("h_1", on(D), on(S4), -1j, place.scale, subject))
            self.add(arms.to_scale("h_2", on(D), on(S4), PHI4, place.scale, subject))
        elif name == "scheme-2-3":
            self.strokes += [Line(on(C), on(B), hand.result), symbols.block(on(A), (B - C) / abs(B - C), hand)]
            self.strokes += [
                *symbols.hinge(on(A), hand),
                *symbols.hinge(on(B), hand),
                *symbols.hinge(on(C), hand),
                *symbols.mass_centre(on(S3), hand),
            ]
            self.shown("R_{12}", R12, on(A), 7.0)
            self.shown("R_{43}", -R34, on(B), 7.0)
            self.shown("G_3", -1j, on(S3))
            self.shown("Φ_3", PHI3, on(S3))
            self.shown("R_{03}", R03, on(C), unknown=True)
            self.add(CoupleArc("M^Φ_3", on(S3), -1, 9.0 * hand.symbol, math.pi))
            self.add(arms.to_scale("h_3", on(C), on(B), -R34, place.scale, Subject(name, "l", 2)))
        else:
            wheel = transmission.Gear(on(SHAFT), place.length(0.18), math.radians(210), RZ / abs(RZ))
            self.strokes += [
                *wheel.draw(hand),
                Line(on(SHAFT), on(A), hand.result),
                *symbols.fixed_hinge(on(SHAFT), hand, symbols.HINGE),
            ]
            self.strokes += [*symbols.hinge(on(A), hand), *symbols.hinge(on(SHAFT), hand)]
            self.shown("R_{21}", -R12, on(A), 7.0)
            self.shown("F_z", RZ, wheel.contact, 7.0)
            self.shown("R_{01}", R01, on(SHAFT), unknown=True)
            self.add(
                CoupleArc(
                    letter(self.language, "M_{bal}"), on(SHAFT), 1, 10.0 * hand.symbol, math.radians(100), math.pi
                )
            )

    def polygon(self, name: str, place: Place) -> None:
        value = 0j
        subject = Subject(name, "F", 2)
        for markup, force in POLYGONS[name]:
            one = letter(self.language, markup)
            self.add(force_arrow.to_scale(one, force, place.on(value), place.scale, subject))
            value += force

    def lever(self, name: str, place: Place) -> None:
        subject = Subject(name, "v", 2)
        self.strokes.append(point(subject, "p", 0j, place, symbols.pole(place.on(0j)), "pole"))
        for velocity in (VA, VB, VD):
            self.strokes.append(Line(place.on(0j), place.on(-1j * velocity), self.hand.result))
        self.shown("F_{us}", 1, place.on(-1j * VD), 6.0)
        self.shown("G_4", -1j, place.on(-0.5j * (VB + VD)), 4.0)
        self.add(arms.Arm("h_1", place.on(0j), place.on(-1j * VD), 1 + 0j))


def leaves(page: Page) -> list[Leaf]:
    return Draft(page).leaves()

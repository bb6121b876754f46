"""Mechanisms of the textbook as values, built without the scene reader; lengths m, angles rad."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from plans.model.mechanism import FRAME, Drive, Link, Mechanism, Output, Slide, Way

ALONG_X = Way(0j, 1 + 0j)
DATUM = (Decimal(0), Decimal(0))
Points = Mapping[str, complex]


def mechanism(
    title: str,
    links: Mapping[int, Points],
    slides: tuple[Slide, ...],
    drive: Drive,
    sketch: Points,
    output: Output | None,
) -> Mechanism:
    numbered = {number: Link(number, points) for number, points in links.items()}
    return Mechanism(title, DATUM, numbered, slides, drive, sketch, output)


def four_bar(
    a: float,
    b: float,
    c: float,
    d: float,
    *,
    sketch: Points,
    coupler: Points | None = None,
    omega: float = 10.0,
    epsilon: float = 5.0,
) -> Mechanism:
    """Crank OA = a, coupler AB = b, rocker CB = c, frame OC = d along x; `coupler` holds more points of the coupler."""
    links: dict[int, Points] = {
        FRAME: {"O": 0, "C": d},
        1: {"O": 0, "A": a},
        2: {"A": 0, "B": b, **(coupler or {})},
        3: {"C": 0, "B": c},
    }
    return mechanism("four-bar", links, (), Drive(1, "O", "A", omega, epsilon), sketch, Output(3, None))


def slider_crank(
    a: float, b: float, e: float = 0.0, *, rod: Points | None = None, omega: float = 10.0, epsilon: float = 5.0
) -> Mechanism:
    """Crank OA = a, rod AB = b, the slider B on the line y = e; `rod` holds more points of the rod."""
    links: dict[int, Points] = {FRAME: {"O": 0}, 1: {"O": 0, "A": a}, 2: {"A": 0, "B": b, **(rod or {})}, 3: {"B": 0}}
    guide = Slide(3, FRAME, ALONG_X, Way(complex(0, e), 1), "B", "")
    drive = Drive(1, "O", "A", omega, epsilon)
    return mechanism("slider-crank", links, (guide,), drive, {"B": complex(b, e)}, Output(3, "B"))


def slotted_link(a: float, d: float, length: float, *, omega: float = 10.0, epsilon: float = 5.0) -> Mechanism:
    """Crank OA = a, block A on the slotted link CB = length, whose pivot C lies d below O."""
    links: dict[int, Points] = {
        FRAME: {"O": 0, "C": -1j * d},
        1: {"O": 0, "A": a},
        2: {"A": 0},
        3: {"C": 0, "B": length},
    }
    slot = Slide(2, 3, ALONG_X, ALONG_X, "A", "CB")
    sketch = {"B": complex(0.01, length - d)}
    return mechanism("slotted link", links, (slot,), Drive(1, "O", "A", omega, epsilon), sketch, Output(3, None))


def scotch_yoke(a: float, *, omega: float = 10.0, epsilon: float = 5.0) -> Mechanism:
    """Crank OA = a, block A in the yoke's slot along x, the yoke's point D on the y axis."""
    links: dict[int, Points] = {FRAME: {"O": 0}, 1: {"O": 0, "A": a}, 2: {"A": 0}, 3: {"D": 0, "E": 1.0}}
    slot = Slide(2, 3, ALONG_X, ALONG_X, "A", "DE")
    guide = Slide(3, FRAME, Way(0j, 1j), Way(0j, 1j), "D", "")
    drive = Drive(1, "O", "A", omega, epsilon)
    return mechanism("scotch yoke", links, (slot, guide), drive, {"D": 0j, "E": 1 + 0j}, Output(3, "D"))


def tangent_mechanism(h: float, *, omega: float = 2.0, epsilon: float = -3.0) -> Mechanism:
    """Slotted rocker OE drives the pin A of link 3, which slides along the line x = h; block 2 runs in the slot."""
    links: dict[int, Points] = {FRAME: {"O": 0}, 1: {"O": 0, "E": 2 * h}, 2: {"A": 0}, 3: {"A": 0}}
    slot = Slide(2, 1, ALONG_X, ALONG_X, "A", "OE")
    guide = Slide(3, FRAME, Way(0j, 1j), Way(complex(h, 0), 1j), "A", "")
    drive = Drive(1, "O", "E", omega, epsilon)
    return mechanism("tangent mechanism", links, (slot, guide), drive, {"A": complex(h, 0)}, Output(3, "A"))


def shaper(*, omega: float = 10.0, epsilon: float = 5.0) -> Mechanism:
    """The six-link shaper: crank OA, block 2, slotted link CB, rod BD, slider D; mid-points S3 and S4."""
    links: dict[int, Points] = {
        FRAME: {"O": 0, "C": -0.35j},
        1: {"O": 0, "A": 0.12},
        2: {"A": 0},
        3: {"C": 0, "B": 0.70, "S3": 0.35},
        4: {"B": 0, "D": 0.20, "S4": 0.10},
        5: {"D": 0},
    }
    slot = Slide(2, 3, ALONG_X, ALONG_X, "A", "CB")
    guide = Slide(5, FRAME, ALONG_X, Way(0.3287856445j, 1), "D", "")
    drive = Drive(1, "O", "A", omega, epsilon)
    sketch = {"B": 0.1 + 0.34j, "D": 0.3 + 0.33j}
    return mechanism("crank shaper", links, (slot, guide), drive, sketch, Output(5, "D"))


def parallelogram(a: float, d: float) -> Mechanism:
    """Cranks OA and CB of length a, coupler and frame of length d: change points at 0 and 180 degrees."""
    return four_bar(a, d, a, d, sketch={"B": complex(d + a / 2, a)})


def triad(*, omega: float = 3.0, epsilon: float = 1.0) -> Mechanism:
    """A crank and a three-lead group: links B1 B2 B3 carried by the crank's end and by two rockers (class III)."""
    links: dict[int, Points] = {
        FRAME: {"O": 0, "A2": 0.5, "A3": 0.55 + 0.5j},
        1: {"O": 0, "A1": 0.05},
        2: {"A1": 0, "B1": 0.2341},
        3: {"B1": 0, "B2": 0.3423448554, "B3": complex(0.19722, 0.20471)},
        4: {"A2": 0, "B2": 0.197},
        5: {"A3": 0, "B3": 0.2693},
    }
    sketch = {"B1": 0.08 + 0.22j, "B2": 0.42 + 0.18j, "B3": 0.30 + 0.40j}
    return mechanism("triad", links, (), Drive(1, "O", "A1", omega, epsilon), sketch, Output(4, None))

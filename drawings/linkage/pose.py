"""One position of a linkage as a scheme of its own, on which constructions are drawn (схема одного положения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from drawings.kinds.outlines import Poses
from drawings.kinds.scheme import frame_number, link_numbers
from drawings.kinds.vector_plan import BESIDE, SAME
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels, free_side
from drawings.layout.picture import Margins, Picture, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import with_index
from drawings.linkage.guides import axes, grounds
from drawings.linkage.positions import CHOICES, position
from drawings.linkage.skeleton import Pairs, Skeletons, reference
from drawings.page.page import Drafting
from drawings.paper.strokes import SheetError, Stroke, Text
from drawings.paper.walk import PLACES
from drawings.symbols.figure import Subject, around
from drawings.symbols.symbols import ARROW_LENGTH, fit_dashes
from drawings.symbols.trimming import trim
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, Motion
from plans.words.words import message, placed


@dataclass(frozen=True, eq=False, repr=False)
class Pose(Skeletons):
    """A mechanism in one position alone; mass centres that no point names are not shown."""

    @property
    def masses(self) -> dict[str, tuple[int, complex]]:
        """No mass centres but those that are points."""
        return {}

    @property
    def points(self) -> list[complex]:
        """All true points of the position."""
        return [spot for name in self.numbered.points if not math.isnan((spot := self.spot(name, 0)).real)]


def pose(study: LinkageStudy, motion: Motion, k: int) -> Pose:
    """Give a position of a motion as the one that is shown."""
    points = {name: np.asarray(moved.r[k : k + 1]) for name, moved in motion.points.items()}
    turns = {number: np.exp(1j * moved.angle[k : k + 1]) for number, moved in motion.links.items()}
    poses = Poses(study.mechanism.links, points, {FRAME: np.ones(1, dtype=np.complex128)} | turns)
    return Pose(study, motion, poses, poses, None, 0)


FLAT = 1e-6  # of the square of a mechanism's size: three points of a smaller triangle are always in one line


def general(paths: Sequence[Complexes]) -> Floats:
    """Rate positions by how far no three points come near one line: by the triangle that is least of its largest."""
    areas = (np.abs(((b - a).conj() * (c - a)).imag) for a, b, c in combinations(paths, 3))
    size = max(float(np.nanmax(np.abs(path))) for path in paths)
    shares = [area / np.nanmax(area) for area in areas if np.nanmax(area) > FLAT * size**2]
    return np.asarray(np.min([np.ones(len(paths[0])), *shares], axis=0).round(PLACES))


def scheme(pairs: Pairs, subject: Subject | None, over: Iterable[Stroke] = ()) -> Iterator[Stroke]:
    """Draw the links with their pairs, stands, guides, under the pairs what stands on them; of no subject no marks."""
    bones, place, hand = pairs.bones, pairs.place, pairs.hand
    body, stands, blocks = list(pairs.bars()), list(pairs.stands()), [block for _, block in pairs.blocks]
    ink = Ink()
    ink.draw([*body, *blocks, *stands])
    yield from fit_dashes(trim(axes(bones, place, hand), pairs.masks))
    yield from (*grounds(pairs, ink), *blocks, *body, *pairs.corners(), *over, *stands)
    bare = (part for name, at in pairs.named.items() for part in pairs.symbol(name, place.on(at)))
    yield from bare if subject is None else pairs.marks(subject, reference(bones.mechanism))


def letters(pairs: Pairs, found: Iterable[tuple[complex, Sequence[str]]], labels: Labels) -> Iterator[Stroke]:
    """Letter the points with what else is found in their places, all else by itself; number the links."""
    place, bars, points = pairs.place, list(pairs.bars()), dict[complex, str]()
    beside: dict[complex, list[str]] = {}
    for name, value in pairs.named.items():
        points[place.on(value)] = name
        beside.setdefault(place.on(value), []).append(name)
    for value, names in found:
        spot = place.on(value)
        near = next((known for known in beside if abs(known - spot) < SAME), spot)
        beside.setdefault(near, []).extend(names)
    for spot, names in beside.items():
        clear = pairs.clear(points[spot]) + 1.0 if spot in points else BESIDE
        side = free_side(spot, bars, clear + ARROW_LENGTH) if spot in points else cmath.phase(spot - place.on(0j))
        yield labels.beside(spot, ", ".join(map(with_index, dict.fromkeys(names))), pairs.sheet.letter, clear, side)
    yield from link_numbers(pairs, pairs.bones.links, labels, pairs.sheet)
    yield from frame_number(pairs, labels, pairs.sheet)


def measured(
    name: str, points: Sequence[complex], title: str, sizes: tuple[Margins, float], drafting: Drafting
) -> Picture:
    """Measure the room of a scheme: its points, its title, paper about it and its least size in its letters."""
    (margins, letters), hand = sizes, drafting.hand
    width = text_width(Text(0j, title, hand.title))
    return picture(name, points, ("l", "m"), around(margins, hand), width, letters * hand.letter)


def shown(study: LinkageStudy, comparison: MotionComparison, table: str, asked: Sequence[int]) -> tuple[int, ...]:
    """Give the positions drawn: a table's own, or those of the plans, or one; one that has no velocities is refused."""
    chosen = tuple(asked) or study.form.sheet.plans or (position(study, comparison.construction),)
    moving = np.flatnonzero(~np.isnan(comparison.construction.links[study.output.link].omega)).tolist()
    for k in (k for k in chosen if k not in moving):
        others = ", ".join(map(str, moving[:CHOICES])) or "—"
        gap = next(gap for gap in comparison.construction.gaps if gap.position == k)
        why = {"reason": gap.reason, "where": gap.where, "advice": gap.advice}
        refused = message("refused.no_motion", table=table, position=k, positions=others, **why)
        line, column = study.scene.place((table, "positions") if asked else ("sheet", "plans"))
        raise SheetError(placed(f"{study.scene.file}:{line}:{column}", refused))
    return chosen

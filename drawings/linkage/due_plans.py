"""What must stand on the plans of velocities and accelerations, by the analysis alone: vectors and letters (планы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import numpy as np

from drawings.checks.expected import Expected
from drawings.lettering.words import with_index
from drawings.page.page import Drafting
from drawings.paper.strokes import Key, Kind, Text
from plans.linkage.parts import AnalysedVectors, findings, spans, vectors_of
from plans.linkage.plan import POLES, Plan, Sliding, Slotted, SpecialPoint, Turning, Vector
from plans.linkage.quantities import MotionComparison
from plans.linkage.special_points import AnalysedSpecial, special_rows
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ACCELERATIONS, PLANS, VELOCITIES
from plans.model.triad import Triad
from plans.quantity import Quantity

Masses = Mapping[str, tuple[int, complex]]
SHORT = 0.1  # mm: a shorter vector may be a point


@dataclass(frozen=True, eq=False, repr=False)
class VectorPlans:
    """The plans of a motion by the analysis; `masses` are unnamed centres, `keys` those that the sheets state."""

    study: LinkageStudy
    comparison: MotionComparison
    masses: Masses
    drafting: Drafting
    keys: Set[Key]

    def rows(self, plan: str, k: int, scale: float) -> Iterator[Expected]:
        """Give the vectors of a plan in a position, m/s or m/s2 by a mm, and the letters of those between points."""
        slack = 2 * max((float(finding.allowed[k]) for finding in self.comparison.of(plan)), default=0.0)
        values = self._values(plan, k)
        must = self._drawn(plan, {name for name, value in values.items() if abs(value) > SHORT * scale + slack})
        stated = {name for kind, where, name, at in self.keys if (kind, where, at) == (Kind.VECTOR, plan, k)}
        for name, value in (self._across(plan, k, stated) | values).items():
            yield Expected(Kind.VECTOR, plan, name, value, slack, k, may_lack=name not in must)
        for where, vector, letter in self._letters:
            if where == plan and (Kind.LETTER, plan, f"{vector} {letter}", k) in self.keys:
                text = Text(0j, self.drafting.letter(with_index(letter))).plain
                yield Expected(Kind.LETTER, plan, f"{vector} {letter}", text, 0.0, k, may_lack=True)

    def _values(self, plan: str, k: int) -> dict[str, complex]:
        """Give the vectors of the equations of a plan, by the names of their ends."""
        true = self._analysed(k)
        arrows = true.arrows(self.study.groups).items()
        found = {f"{start} {end}": part for (where, start, end), part in arrows if where == plan}
        order = PLANS.index(plan)
        for name, mass in self.masses.items():
            found[f"{POLES[plan]} {true.letters.small(name)}"] = true.centre(*mass, order)
        for part in self.parts:
            if part.plan == plan:
                found.setdefault(self._ends[part.name], complex(part.analysis[k]))
        return found

    def _across(self, plan: str, k: int, stated: Set[str]) -> dict[str, complex]:
        """Give the vectors to images and places under pins, and between any two of them, of those that are stated."""
        links = self._images(plan, k)
        images = {POLES[plan]: 0j, **dict(chain(*(some.items() for some in (*links, *self._under(plan, links)))))}
        ends = ((name, *name.split(" ", 1)) for name in stated if " " in name)
        found = {name: images[end] - images[start] for name, start, end in ends if start in images and end in images}
        return found | (self._along(links, plan, k) if plan == ACCELERATIONS.plan else {})

    def _along(self, images: Sequence[Mapping[str, complex]], plan: str, k: int) -> dict[str, complex]:
        """Give the Coriolis part of what slides over a link that turns, and the part along the guide after it."""
        written, found = self.study.drafts().velocities.written, dict[str, complex]()
        both = self._images(VELOCITIES.plan, k), images
        speeds, known = (dict(chain(*(link_images.items() for link_images in image))) for image in both)
        for pair, (pin, host) in written.pins.items():
            if host == FRAME:
                continue
            name, under = written.coriolis(pin, host, pair), written.under(pin, host)
            (other,) = (link for link in pair if link != host)
            mine = pin in self.study.mechanism.links[other].points
            image = self._image(pin, plan) if mine else written.under(pin, other)
            for start, end in ((under, image), (image, under)):
                part = 2j * self._analysed(k).omega(host) * (speeds.get(end, 0j) - speeds.get(start, 0j))
                found |= {f"{start} {name}": part, f"{name} {end}": known.get(end, 0j) - known.get(start, 0j) - part}
        return found

    def _images(self, plan: str, k: int) -> list[dict[str, complex]]:
        """Give for each link the images of its points, of its places under pins, and of the one that stands for it."""
        true, order = self._analysed(k), PLANS.index(plan)
        written, found = true.letters, list[dict[str, complex]]()
        for number, link in self.study.mechanism.links.items():
            spots = {self._image(name, plan): place for name, place in link.points.items()}
            spots |= {written.small(name): place for name, (of, place) in self.masses.items() if of == number}
            if number != FRAME:
                name, first = next(iter(link.points.items()))
                turned = np.exp(-1j * self.comparison.analysis.links[number].angle[k])
                spots |= {written.under(p, number): first + (true.r(p) - true.r(name)) * turned for p in self._pins}
                for special in self._specials(number):
                    spots[written.small(special.name)] = first + (special.place[k] - true.r(name)) * turned
                spots[written.of_link("n", number)] = self.study.drafts().positions.images[number].at
            still = number == FRAME
            found.append({image: 0j if still else true.centre(number, at, order) for image, at in spots.items()})
        return found

    def _specials(self, basis: int) -> Iterator[AnalysedSpecial]:
        """Give the special point of a triad's basis link."""
        for group in self.study.groups:
            if isinstance(group, Triad) and group.basis == basis and (special := self.special(group)):
                yield special

    def special(self, triad: Triad) -> AnalysedSpecial | None:
        """Give the special point of a triad, where its plans of velocities are drawn."""
        written = self.study.drafts().positions.written
        known = triad.basis in written.specials
        return AnalysedSpecial(self.study.mechanism, self.comparison.analysis, written, triad) if known else None

    @property
    def _pins(self) -> set[str]:
        return {slide.point for slide in self.study.mechanism.slides} | self.study.mechanism.hinges.keys()

    def _under(self, plan: str, images: Sequence[Mapping[str, complex]]) -> Iterator[dict[str, complex]]:
        """Give the images of all that lies at a pin: its own, and of each link the place under it."""
        made = self._made(plan)
        known = dict(chain(*(link_images.items() for link_images in images)))
        for pin in self._pins:
            unders = (name for link in made.images for name in (_below(made, pin, link), made.written.under(pin, link)))
            names = dict.fromkeys((made.written.small(pin), *unders))
            yield {name: known[name] for name in names if name in known}

    def _analysed(self, k: int) -> AnalysedVectors:
        written = self.study.drafts().velocities.written
        return AnalysedVectors(self.study.mechanism, self.comparison.analysis, k, written)

    @cached_property
    def parts(self) -> tuple[Quantity, ...]:
        """The relative, normal, tangential, Coriolis vectors by both roads, and those of mass centres."""
        return findings(self.study, self.comparison, self.masses)

    @cached_property
    def _ends(self) -> dict[str, str]:
        """Where the plans show each part: the names of its ends."""
        found = spans(self.study, self.study.drafts(), self.comparison.analysis, self.masses)
        return {name: f"{span.start.name} {span.end.name}" for name, span in found.items()}

    def _drawn(self, plan: str, long: Set[str]) -> set[str]:
        """Give of the vectors long enough those that no plan is without; points of one image have one letter there."""
        drafts, pole = self.study.drafts(), POLES[plan]
        points = {drafts.velocities.point(name).name for name in self._moving}
        points |= {self._ends[f"v_{name}"].split(" ")[1] for name in self.masses}
        found = {name for name in long if name.split(" ")[0] == pole and name.split(" ")[1] in points}
        while more := {name for name in long - found if name.split(" ")[0] in {other.split(" ")[1] for other in found}}:
            found |= more
        return found

    @property
    def _moving(self) -> Iterator[str]:
        fixed = self.study.mechanism.links[FRAME].points
        return (name for name in self.comparison.analysis.points if name not in fixed)

    @cached_property
    def _letters(self) -> tuple[tuple[str, str, str], ...]:
        """Plan, ends and letter of each vector that is no whole velocity or acceleration of a point: v_BA, a^n_BA."""
        return tuple(
            (plan, f"{start} {end}", letter)
            for vector in vectors_of(self.study.mechanism, self.study.groups)
            for plan in (VELOCITIES.plan, ACCELERATIONS.plan)
            for start, end, letter in self._lettered(vector, plan)
            if start != POLES[VELOCITIES.plan]
        )

    def _lettered(self, vector: Vector, name: str) -> Iterator[tuple[str, str, str]]:
        """Letter the vectors of an equation, each by the point that it ends at and the one that it begins at."""
        plan = self._made(name)
        written = plan.written
        match vector:
            case SpecialPoint():
                for row in special_rows(self.study.mechanism, self.comparison.analysis, written, vector):
                    yield from [(row.start, row.end, row.letter)] if row.order.plan == name else []
            case Turning(_, start, tip):
                about = "" if self._still(start) else start
                ends = plan.point(start).name, written.normal(tip, about), plan.point(tip).name
                yield from _turned(name, ends, tip + about)
            case Slotted(link, pivot, pin):
                under, about = written.under(pin, link), "" if self._still(pivot) else pivot
                ends = plan.point(pivot).name, written.normal(under.upper()), under
                yield from _turned(name, ends, _capital(under) + about)
            case Sliding(pair, host, pin, held):
                under = written.under(pin, host)
                below = under if held else _below(plan, pin, host)
                start, end, first, last = below, plan.point(pin).name, pin, _capital(under)
                if held:
                    start, end, first, last = end, start, last, first
                index = first + last
                if name == VELOCITIES.plan:
                    yield start, end, f"v_{index}"
                else:
                    middle = written.coriolis(pin, host, pair)
                    yield start, middle, f"a^k_{index}"
                    yield from ((begin, end, f"a^r_{index}") for begin in (middle, start))

    def _made(self, plan: str) -> Plan:
        """Give a plan as it was constructed: which images share a letter."""
        return self.study.drafts().plan(PLANS.index(plan))

    def _image(self, point: str, plan: str) -> str:
        written = self.study.drafts().velocities.written
        return POLES[plan] if self._still(point) else written.small(point)

    def _still(self, point: str) -> bool:
        return point in self.study.mechanism.links[FRAME].points


def _turned(plan: str, ends: tuple[str, str, str], index: str) -> Iterator[tuple[str, str, str]]:
    """Letter what an end has by turning about a start: a velocity, or a normal and a tangential part."""
    start, normal, end = ends
    if plan == VELOCITIES.plan:
        yield start, end, f"v_{index}"
    else:
        yield from ((start, normal, f"a^n_{index}"), (normal, end, f"a^t_{index}"))


def _below(plan: Plan, pin: str, link: int) -> str:
    """Name the image of a link's place under a pin: of a link that does not turn all places have one."""
    image = plan.images[link]
    return plan.written.under(pin, link) if image.arm is not None else image.origin.name


def _capital(under: str) -> str:
    return under.upper().replace("_", "")

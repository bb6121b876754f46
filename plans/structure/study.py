"""The study of a structure: the mechanism in one position as links and pairs, and its groups (структура)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from itertools import chain, count, repeat
from typing import NamedTuple

import numpy as np

from geometry.errors import DraftError
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.linkage import described
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.structure import (
    CONTACT,
    ROMAN,
    SLIDING,
    TURNING,
    CurvatureCentre,
    GroupDivision,
    Joint,
    NoMechanism,
    Structure,
)
from plans.scene.faults import Fault
from plans.scene.scene import Scene
from plans.structure.constraints import Freedom, Replacement, freedom, in_plane, matrix, replacements, without
from plans.structure.groups import divisions, lowest
from plans.structure.reading import CONTACTS, KINDS, ContactTable, StructureForm
from plans.study import Study
from plans.words.words import Message, message, placed

STRUCTURE = "structure"
SOME = 24  # positions among which the one that is shown is chosen: others are no farther from dead centres to speak of


class SchemePose(NamedTuple):
    """A mechanism in one position: the places m of its points, the place of each slide's block and its direction."""

    points: Mapping[str, complex]
    slides: Mapping[Slide, tuple[complex, complex]]


class StructureStudy:
    """The structure of a scene's mechanism."""

    def __init__(self, study: Study) -> None:
        self.scene, self._study = study.scene, study
        self.form = study.scene.of(StructureForm).structure
        self.made: set[str] = set()

    def construct(self, plans: Collection[str]) -> None:
        """Analyse the structure, if it is asked for."""
        if STRUCTURE in plans:
            _ = self.divisions, self.replacements

    @cached_property
    def mechanism(self) -> Mechanism:
        """The mechanism of the scene, whatever its mobility is."""
        return described(self.scene)

    @cached_property
    def pose(self) -> SchemePose:
        """The position in which it is shown: one that is asked for, else of all the one farthest from a dead centre."""
        poses = [*self._poses()]
        if not poses:
            return sketched(self.scene, self.mechanism)
        return max(poses, key=self._openness) if len(poses) > 1 else poses[0]

    def _poses(self) -> Iterator[SchemePose]:
        """Give the positions of the linkage, if it can be constructed; the one that is asked for alone."""
        sheet = self.scene.of(LinkageForm).sheet
        asked = sheet.position if sheet.position is not None else next(iter(sheet.plans), None)
        try:
            motion = self._study.of(LinkageStudy).motion(0)
        except DraftError:
            return
        every = max(len(motion.phi) // SOME, 1)
        for k in range(0, len(motion.phi), every) if asked is None else (asked,):
            places = {name: complex(point.r[k]) for name, point in motion.points.items()}
            places = dict(self.mechanism.links[FRAME].points) | places
            if not any(cmath.isnan(spot) for spot in places.values()):
                turns = {link: cmath.rect(1.0, float(turning.angle[k])) for link, turning in motion.links.items()}
                yield posed(self.mechanism, places, {FRAME: 1 + 0j} | turns)

    def _openness(self, pose: SchemePose) -> float:
        """Measure how independent the constraints are: little near dead centres; to two digits, for no last bit."""
        sizes = np.linalg.svd(matrix(self._structure(pose), in_plane), compute_uv=False)
        return float(f"{sizes[-1] / sizes[0]:.2g}")

    @cached_property
    def structure(self) -> Structure:
        """The links and joints as the scene gives them."""
        kinds = {key: KINDS[kind] for key, kind in self.form.pairs.items()}
        return self._structure(self.pose).altered(kinds)

    def _structure(self, pose: SchemePose) -> Structure:
        free = (name for name in chain("KMNPQTUVWXYZ", map("K{}".format, count(1))) if name not in pose.points)
        contacts = map(contact, free, self.form.contacts, repeat(pose))
        links = tuple(sorted(set(self.mechanism.links) - {FRAME}))
        return Structure(links, (*joints(self.mechanism, pose), *contacts))

    @cached_property
    def freedom(self) -> Freedom:
        """What its constraints leave and hold; a mechanism that does not move is refused."""
        found = freedom(self.structure)
        if found.main < 1:
            parts = {"planar": self.structure.planar, "n": len(self.structure.links), "p": self.structure.lower}
            raise NoMechanism(self._at(message("structure.no_mechanism", **parts, q=self.structure.higher)))
        return found

    def _at(self, why: Message) -> Message:
        line, column = self.scene.place(("mechanism", "links"))
        return placed(f"{self.scene.file}:{line}:{column}: mechanism.links", why)

    @cached_property
    def plain(self) -> Structure:
        """The structure that is divided: contacts replaced, passive links and links of local mobility left out."""
        found = self._structure(self.pose)
        if self.freedom.passive:
            found = without(found, self.freedom.passive[-1])
        found = found.lowered()
        for link in self.freedom.local:
            found = without(found, link)
        return found

    @cached_property
    def divisions(self) -> tuple[GroupDivision, ...]:
        """Its divisions into groups, for each choice of the primary link."""
        self.made.add(STRUCTURE)
        if not self.structure.primaries:
            raise NoMechanism(self._at(message("structure.no_primary")))
        plain, mobility = self.plain, self.freedom.main
        try:
            return divisions(plain, mobility, self.structure.primaries)
        except NoMechanism as error:
            raise NoMechanism(self._at(error.args[0]), error.links) from None

    def division_of(self, link: int) -> GroupDivision:
        """Give the division from a primary link; of a mechanism that it does not drive alone, the first."""
        return next((found for found in self.divisions if link in found.primaries), self.divisions[0])

    @property
    def chosen(self) -> GroupDivision:
        """The division from the primary link that the scene prefers, or from its drive."""
        return self.division_of(self.form.primary or self.mechanism.drive.link)

    @property
    def lowest(self) -> GroupDivision:
        """The division of the lowest class, the chosen one where its class is that."""
        return lowest((self.chosen, *self.divisions))

    @cached_property
    def replacements(self) -> tuple[Replacement, ...]:
        """All ways of fewest changes that leave no redundant constraint across the plane, the chosen one first."""
        return replacements(self.structure)

    @cached_property
    def freed(self) -> Structure:
        """The mechanism free of redundant constraints across its plane."""
        return self.structure.altered(dict(self.replacements[0].kinds)) if self.replacements else self.structure


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Tell that the primary link which a scene prefers gives no lower class than its drive does."""
    if scene.of(StructureForm).structure.primary is None:
        return
    try:
        study = StructureStudy(Study(scene))
        chosen, drive = study.chosen, study.division_of(study.mechanism.drive.link)
    except DraftError:
        return  # what is wrong is told where it is asked for
    if chosen.primaries != drive.primaries and chosen.rank >= drive.rank:
        ranks = {"found": ROMAN[chosen.rank], "drive": ROMAN[drive.rank]}
        yield scene.fault(("structure", "primary"), "class_not_lower", link=study.form.primary, **ranks)


def joints(mechanism: Mechanism, pose: SchemePose) -> Iterator[Joint]:
    """Give the hinges and the slides of a mechanism."""
    for name, links in mechanism.hinges.items():
        yield Joint(name, links, TURNING, TURNING, pose.points[name])
    for slide in mechanism.slides:
        first, last = sorted((slide.slider, slide.owner))
        yield Joint(f"{slide.point} {first}-{last}", (first, last), SLIDING, SLIDING, *pose.slides[slide])


def contact(name: str, form: ContactTable, pose: SchemePose) -> Joint:
    """Give a contact: its normal goes through the centres of curvature, or is square to a flat side."""
    places = [pose.points[name] for name in form.between]
    if form.along:
        start, end = (pose.points[name] for name in form.along)
        run = (end - start) / abs(end - start)
        at = start + ((places[0] - start) * run.conjugate()).real * run
        normal = 1j * run
    else:
        run = places[1] - places[0]
        normal = run / abs(run)
        at = places[1] - normal * (abs(run) / 2 if form.radius is None else float(form.radius))
    centres = tuple(map(CurvatureCentre, form.between, form.links, places))
    links = tuple(sorted(form.links))
    return Joint(f"{name} {links[0]}-{links[1]}", links, CONTACT, CONTACTS[form.kind], at, normal, centres)


def posed(mechanism: Mechanism, points: Mapping[str, complex], turns: Mapping[int, complex]) -> SchemePose:
    """Give a position by the places of its points and the directions of its links."""
    found = {}
    for slide in mechanism.slides:
        first, origin = next(iter(mechanism.links[slide.owner].points.items()))
        turn = turns[slide.owner] if slide.owner != FRAME else 1 + 0j
        base = origin if slide.owner == FRAME else points[first]
        through = base + turn * (slide.on_owner.through - origin)
        along = turn * slide.on_owner.direction
        found[slide] = through + ((points[slide.point] - through) * along.conjugate()).real * along, along
    return SchemePose(points, found)


def sketched(scene: Scene, mechanism: Mechanism) -> SchemePose:
    """Give the position that the sketch shows: of a mechanism that is not constructed, its scheme needs no scale."""
    points = dict(mechanism.links[FRAME].points) | dict(mechanism.sketch)
    drive, first = mechanism.drive, scene.of(LinkageForm).drive.first
    if drive.end not in points and first is not None and not drive.pushed:
        crank = mechanism.links[drive.link].points
        size = abs(crank[drive.end] - crank[drive.pivot])
        points[drive.end] = points[drive.pivot] + cmath.rect(size, math.radians(first))
    for link in mechanism.links.values():
        start, end, *_ = (*(name for name in link.points if name in points), "", "")
        if end and (far := link.points[end] - link.points[start]):  # the others follow by its shape
            turn = cmath.rect(1.0, cmath.phase((points[end] - points[start]) / far))
            points = {k: points[start] + turn * (at - link.points[start]) for k, at in link.points.items()} | points
    wanted = {name for link in mechanism.links.values() for name in link.points}
    if lacking := sorted(wanted - points.keys()):
        line, column = scene.place(("mechanism", "sketch") if mechanism.sketch else ("mechanism",))
        where = f"{scene.file}:{line}:{column}: mechanism.sketch"
        raise NoMechanism(placed(where, message("structure.sketch", points=", ".join(lacking))))
    return posed(mechanism, points, dict(_turns(mechanism, points)))


def _turns(mechanism: Mechanism, points: Mapping[str, complex]) -> Iterator[tuple[int, complex]]:
    """Give the directions of links by two of their points."""
    for number, link in mechanism.links.items():
        first, *rest = link.points
        far = next((name for name in rest if link.points[name] != link.points[first]), None)
        run = 1 + 0j if far is None else (points[far] - points[first]) / (link.points[far] - link.points[first])
        yield number, run / abs(run)

"""The mass centre over positions: main-point vectors laid end to end, and the polygon of static moments (8.5)-(8.7)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.balance.sums import Sums, SumTerm
from plans.balance.weights import Stem, Tree
from plans.linkage.plan import Plan
from plans.model.machine import Body
from plans.words.words import because

MAIN = "main_points"  # the board of the vectors h, m
EMPTY = Body(0, 0.0, 0.0, 0j)


class Share(NamedTuple):
    """A stem on the frame or at a slide, and the share of the whole mass that follows it."""

    stem: Stem
    share: float


class MainPoints:
    """The vectors h of all links, each in its own frame, with the masses that they are made of."""

    def __init__(self, tree: Tree, bodies: Mapping[int, Body]) -> None:
        self.tree, self.bodies, self.sums = tree, bodies, Sums()
        self.board = Board(MAIN)
        self._behind: dict[int, SumTerm] = {}
        self.masses = {
            stem.link: self.sums.mass(f"m_{stem.link}", self.body(stem.link).mass, because("own_mass", link=stem.link))
            for stem in tree.stems
        }
        self.moments = {stem.link: self._moment(stem) for stem in reversed(tree.stems)}
        self.marks = {stem.link: self._vector(stem.link) for stem in tree.stems}

    def body(self, link: int) -> Body:
        """Give a link's mass; one that the scene gives none has none."""
        return self.bodies.get(link, EMPTY)

    @cached_property
    def mass(self) -> float:
        """The mass kg of all moving links."""
        return float(self.behind_all.value.real)

    @cached_property
    def behind_all(self) -> SumTerm:
        """The mass of all moving links, laid off end to end."""
        return self.sums.total("m", self.masses.values(), self.sums.no_mass, because("all_links"))

    def behind(self, link: int) -> SumTerm:
        """Give the mass of a link with all that follow it, summed once."""
        if link not in self._behind:
            links = list(self.tree.behind(link))
            name, terms = "m_" + "+".join(map(str, links)), [self.masses[follower] for follower in links]
            self._behind[link] = self.sums.total(name, terms, self.sums.no_mass, because("follow"))
        return self._behind[link]

    def _moment(self, stem: Stem) -> SumTerm:
        """Sum the static moments about a link's beginning."""
        name, why = f"mh_{stem.link}", because("main_moment", link=stem.link, point=stem.begin)
        return self.sums.total(name, self._terms(stem), self.sums.no_moment, why)

    def _terms(self, stem: Stem) -> Iterator[SumTerm]:
        link, sums = stem.link, self.sums
        borne, centre = self.masses[link], f"S{link}"
        arm = sums.arm(f"{stem.begin}{centre}", stem.origin, self.body(link).centre, link)
        yield sums.moment(f"m_{link}·{arm.name}", borne, arm, because("own_moment", link=link))
        for other in self.tree.followers[link]:
            mass = self.behind(other.link)
            arm = sums.arm(f"{stem.begin}{other.begin}", stem.origin, other.at, link)
            why = because("follower_moment", link=other.link, point=other.begin)
            yield sums.moment(f"{mass.mark.name}·{arm.name}", mass, arm, why)

    def _vector(self, link: int) -> Mark:
        return self.board.turn(f"h_{link}", self.moments[link].mark, 1 / self.mass, because("over_mass"))

    def line(self, link: int, span: complex) -> Mark:
        """Lay down a vector of a link in its own frame, to which its vector h is fixed."""
        return self.sums.arm(f"l_{link}", 0j, span, link)

    @property
    def vectors(self) -> dict[int, complex]:
        """The vector h of each link in its own frame, m; of one whose moments are rounding none."""
        return {link: 0j if self.moments[link].vanishes else complex(mark.point) for link, mark in self.marks.items()}

    @property
    def constant(self) -> complex:
        """What hinges and guides of the frame give the mass centre, m from the datum: the same in all positions."""
        return sum((share.share * share.stem.at for share in self._shares(self.tree.rooted)), 0j)

    def _shares(self, stems: tuple[Stem, ...]) -> Iterator[Share]:
        return (Share(stem, float(self.behind(stem.link).value.real) / self.mass) for stem in stems)


CENTRE, POLYGON, CENTRE_ACCELERATION, SHAKING = "centre", "moment_polygon", "centre_acceleration", "shaking"
UNITS = {CENTRE: "m", POLYGON: "kg*m", CENTRE_ACCELERATION: "m/s2", SHAKING: "N"}
LETTERS = {CENTRE: "S", CENTRE_ACCELERATION: "s"}


class ChainSide(NamedTuple):
    """A vector of a chain: the link that it belongs to (0: to the frame), and the corners between which it lies."""

    link: int
    vector: Mark
    start: Mark
    end: Mark


class VectorChain(NamedTuple):
    """Vectors laid end to end from a pole (цепь векторов)."""

    board: Board
    pole: Mark
    sides: tuple[ChainSide, ...]

    @property
    def end(self) -> Mark:
        """The end of the last vector."""
        return self.sides[-1].end if self.sides else self.pole


@dataclass(frozen=True)
class Drawing:
    """The mass centre drawn over some positions.

    `main` are the main-point vectors to S, `polygon` the static moments of the links, closed, `accelerations` the same
    main-point vectors turned to those of the acceleration plan, `shaking` the inertia forces of the links, closed.
    """

    main: VectorChain
    polygon: VectorChain
    place: Mark  # S by the polygon of static moments: its end over the mass
    accelerations: VectorChain
    force: Mark  # the main vector of the inertia forces, -m*a_S
    shaking: VectorChain
    moment: Mark  # the main moment of the inertia forces about the datum

    @property
    def centre(self) -> Mark:
        """The mass centre by main points, m from the datum."""
        return self.main.end


def centre_drawing(points: MainPoints, accelerations: Plan) -> Drawing:
    """Draw the mass centre over the positions of an acceleration plan, and the inertia forces there."""
    main, turned = by_main_points(points, accelerations)
    board = Board(POLYGON)
    pole = board.given("0", 0j, because("static_start"))
    vectors = [
        (link, board.turn(f"m_{link}r_S{link}", mark, points.body(link).mass, because("moment_of_link", link=link)))
        for link, mark in _centres(points, accelerations.positions)
    ]
    polygon, shaking = _chain(board, pole, vectors, "mr_S"), _forces(points, accelerations)
    place = polygon.board.turn("r_S", polygon.end, 1 / points.mass, because("over_mass"))
    force = shaking.board.turn("Φ", turned.end, -points.mass, because("main_vector"))
    return Drawing(main, polygon, place, turned, force, shaking, _moment(points, accelerations, shaking))


def by_main_points(points: MainPoints, accelerations: Plan) -> tuple[VectorChain, VectorChain]:
    """Lay the main-point vectors off to the mass centre, and to its acceleration."""
    positions = accelerations.positions
    main = _main(points, positions, Board(CENTRE), positions.pole, "S")
    return main, _main(points, accelerations, Board(CENTRE_ACCELERATION), accelerations.pole, "a_S")


def _main(points: MainPoints, plan: Plan, board: Board, start: Mark, name: str) -> VectorChain:
    """Lay the main-point vectors off end to end, each turned and stretched from an arm of its link on the plan."""
    pole = board.transfer("O" if plan is plan.positions else start.name, start, because("chain_start"))
    return _chain(board, pole, list(_vectors(points, plan, board)), name)


def _vectors(points: MainPoints, plan: Plan, board: Board) -> Iterator[tuple[int, Mark]]:
    """Give the vectors that the place of the mass centre, or its acceleration, is the sum of."""
    if plan is plan.positions and points.constant:
        yield 0, board.given("h_0", points.constant, because("constant_vector"))
    for link, h in points.vectors.items():
        image = plan.images[link]
        if image.arm is not None and h:
            line, why = points.line(link, image.span), because("main_vector_of", link=link)
            yield link, board.similar(f"h_{link}", image.arm, line, points.marks[link], why=why)
    # The stems that begin at slides, with their shares: their vectors along guides are variable.
    for share in points._shares(points.tree.variable):
        # A share of the vector along a guide: on the plan of positions it is variable, and so are its images.
        stem, name = share.stem, f"u_{share.stem.link}"
        start = plan.place(stem.parent, stem.at, f"{name}′")
        end = plan.place(stem.link, stem.origin, f"{name}″")
        along = board.join(f"{name}:1", start, end, because("along_guide"))
        yield share.stem.link, board.turn(name, along, share.share, because("variable_vector", link=stem.link))


def _chain(board: Board, pole: Mark, vectors: list[tuple[int, Mark]], name: str) -> VectorChain:
    sides: list[ChainSide] = []
    for number, (link, vector) in enumerate(vectors, 1):
        start = sides[-1].end if sides else pole
        letters = name if number == len(vectors) else f"{name}:{number}"
        sides.append(ChainSide(link, vector, start, board.lay_off(letters, start, vector, because("end_to_end"))))
    return VectorChain(board, pole, tuple(sides))


def _centres(points: MainPoints, plan: Plan) -> Iterator[tuple[int, Mark]]:
    for stem in points.tree.stems:
        body = points.body(stem.link)
        if body.mass:
            yield stem.link, plan.place(stem.link, body.centre, plan.letter(f"S{stem.link}"))


def _forces(points: MainPoints, accelerations: Plan) -> VectorChain:
    """Lay the inertia forces of the links off end to end: their closing is the main vector once more."""
    board = Board(SHAKING)
    pole = board.given("0", 0j, because("forces_start"))
    centres, why = _centres(points, accelerations), because("inertia_force")
    vectors = [(link, board.turn(f"Φ_{link}", mark, -points.body(link).mass, why)) for link, mark in centres]
    return _chain(board, pole, vectors, "ΣΦ")


def _moment(points: MainPoints, accelerations: Plan, shaking: VectorChain) -> Mark:
    """Sum the moments of the inertia forces about the datum, and the inertia moments of the links."""
    board, positions = shaking.board, accelerations.positions
    places = dict(_centres(points, positions))
    rows, why = ((side.link, side.vector) for side in shaking.sides), because("about_shaft")
    moments = [board.moment(f"M(Φ_{link})", positions.pole, places[link], force, why) for link, force in rows]
    for link, reading in sorted(accelerations.readings.items()):
        inertia = points.body(link).inertia
        if inertia:
            moments.append(board.couple(f"M^Φ_{link}", *reading, -inertia, because("inertia_moment")))
    against = board.close("-M_Φ", *moments, why=because("sums_moments"))
    return board.turn("M_Φ", against, -1.0, because("main_moment_sum"))

"""Every stroke and letter of a scheme of balancing ticked off: links, pairs, guides, counterweights (опись схемы)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance import figure_parts as parts
from drawings.checks.balance import scheme_strokes as strokes
from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance.balance_schemes import Scheme
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.linkage import bars, drive_arrows, guides, pair_symbols, position_marks
from drawings.checks.linkage.laid import Ground, LaidMechanism
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.laid_poses import Segments
from drawings.checks.wrong import Wrong, on
from drawings.figures.balance.balance_scheme import PATH, RIM
from drawings.figures.balance.scheme import SCHEME
from drawings.figures.linkage.position_letters import LINKS
from drawings.figures.linkage.position_plan import TIES
from drawings.lettering.balance_letters import CENTRE, counterweight, lowered
from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, Polyline, Text
from drawings.paper.walk import flat, groups
from drawings.symbols.symbols import BLOCK, CROSS, DOUBLE, GUSSET, HATCH, HATCH_STEP, HINGE, LEG, MASS, POINT, STAND
from plans.model.balance.linkage import DISC
from plans.model.mechanism import FRAME, Link, Slide
from plans.words.words import Message

LEGS_AND_BASE = 3  # lines of a stand beside its hatching
RADII = (HINGE, *DOUBLE, POINT, MASS)  # of symbols at points
SHARES = np.linspace(0.0, 1.0, 17)  # of a line, where it is looked for


def schemes(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Hold all that the schemes of a sheet show."""
    for state in expected.states:
        scheme = Scheme(leaf, expected, state)
        if SCHEME + state in leaf.metadata["figures"] and scheme.part is not None:
            yield from _Lines(scheme, scheme.part).faults()


@dataclass(frozen=True, eq=False)
class _Lines:
    """The strokes of a scheme, with the links where the analysis has them."""

    scheme: Scheme
    part: Group

    @property
    def expected(self) -> Expected:
        return self.scheme.expected

    @property
    def symbol(self) -> float:
        return self.expected.drafting.hand.symbol

    @cached_property
    def own(self) -> tuple[Group, ...]:
        """The groups of what stands on the links: vectors, counterweights, the mass centre, paths."""
        names = {CENTRE, *(f"m_cw{one.link}" for one in self.expected.weights(self.scheme.state))}
        return tuple(one for one in groups((self.part,)) if strokes.stands_on(one, names, self.scheme.plan))

    @cached_property
    def rest(self) -> Group:
        """All else: the links with their pairs, their letters."""
        return Group(tuple(strokes.without(self.part.strokes, set(map(id, self.own)))), self.part.name)

    @cached_property
    def plan(self) -> LaidPlan:
        """The rest as a plan of positions shows the links of the shown position."""
        expected, scheme = self.expected, self.scheme
        motion, ground = expected.comparison.motion, Ground(scheme.origin, scheme.mu)
        laid = LaidMechanism(expected.own.linkage, motion.analysis, expected.shown, ground)
        lines = Group(tuple(one for one in flat((self.rest,)) if isinstance(one, Line)), TIES)
        numbers = Group(tuple(one for one in groups((self.rest,)) if strokes.is_number(one)), LINKS)
        names = pair_symbols.PAIRS, bars.SHOWN, drive_arrows.ARROWS, guides.GROUNDS
        links = Group(tuple(strokes.without(self.rest.strokes, set(map(id, numbers.strokes)))))
        whole = (Group((links,), name) for name in names)
        leaf = Leaf(scheme.leaf.width, scheme.leaf.height, (*whole, lines, numbers))
        return LaidPlan(leaf, laid, motion.road, scheme.slack / scheme.mu)

    def faults(self) -> Iterator[Wrong]:
        yield from (self._here(one) for one in self._symbols())
        ink = parts.inventory(self.scheme.plan, self.part, parts.NEAR + self.scheme.slack / self.scheme.mu)
        self._headed(ink)
        self._aside(ink)
        self._vectors(ink)
        self._weights(ink)
        self._arrows(ink)
        self._points(ink)
        self._numbers(ink)
        self._bodies(ink)
        yield from ink.faults()

    def _here(self, one: Message) -> Wrong:
        """Say of the scheme what was said of a plan of positions."""
        return on(one.key.removeprefix("wrong."), self.scheme.plan, **{k: v for k, v in one.parts if k != "plan"})

    def _symbols(self) -> Iterator[Message]:
        """Hold the symbols of pairs, the ties, the numbers of moving links, the arrows of the crank."""
        yield from pair_symbols.symbols(self.plan)
        yield from drive_arrows.faults(self.plan)
        hidden = {name for name, link, at in position_marks.centres(self.plan.laid) if not self._is_off(link, at)}
        hidden.add(str(FRAME))  # it bears no number here
        for one in position_marks.faults(self.plan.leaf, self.plan.laid):
            if dict(one.parts)["name"] not in hidden or one.key == "wrong.symbol":
                yield one

    def _is_off(self, link: int, at: complex) -> bool:
        """Tell whether a mass centre is so far off its link that a line between them can be seen."""
        return self.plan.laid.apart(link, at) > (MASS + abs(complex(*BLOCK)) / 2 + DOUBLE[0]) * self.symbol

    def _headed(self, ink: Inventory) -> None:
        by = self.expected.drafting
        title = f"{by.word(f'scheme {self.scheme.state}')}, {by.word('position', position=self.expected.shown)}"
        parts.headed(ink, title, [scale_line(self.scheme.mu, "l", "m", by)])

    def _aside(self, ink: Inventory) -> None:
        """Leave paths and outlines of counterweights aside, which are held by themselves; a swinging S has dots."""
        names = (f"{self.scheme.plan}-{PATH}", f"{self.scheme.plan}-{RIM}")
        aside = {id(one) for group in self.own if group.name.startswith(names) for one in group.strokes}
        if self.expected.whole:
            ink.every(Polyline, lambda one: id(one) in aside)
        for kind in (Line, Arc):
            ink.every(kind, partial(strokes.is_one, own=aside))
        for state in dict.fromkeys(("before", self.scheme.state)) if not self.expected.whole else ():
            one = self.expected.states[state]
            if one.path > self.expected.none.way:
                known = one.around.r[np.isfinite(one.around.r)].tolist()
                parts.dots(ink, ((f"{CENTRE} {state}", self.scheme.on(spot)) for spot in known))

    def _vectors(self, ink: Inventory) -> None:
        starts = {one.name: one.start for one in self.expected.chain(self.scheme.state)}
        for name, one in marks.vectors(self.expected.measured, self.scheme.plan).items():
            parts.arrow(ink, one, lowered(name))
            parts.carried(ink, one, self.scheme.on(starts.get(name, 0j)), one.end - one.start)

    def _weights(self, ink: Inventory) -> None:
        """Tick off the middles of counterweights with their crosses, what holds discs, and the mass centre."""
        for one in self.expected.weights(self.scheme.state):
            at, begin = (self.scheme.on(self.expected.at(one.link, spot)) for spot in (one.centre, one.origin))
            letter, name = counterweight(one.link, self.expected.drafting.language), f"m_cw{one.link}"
            parts.spot(ink, at, letter, name, POINT * self.symbol)
            arm = CROSS * self.symbol * complex(0.5**0.5, 0.5**0.5)
            for half in (arm, arm.conjugate()):
                ink.line(at - half, at + half, on("symbol", ink.plan, name=name))
            if one.place.shape == DISC:
                self._along(ink, Segments(np.array([begin]), np.array([at])), on("rim", ink.plan, name=name))
        at = self.scheme.on(self.expected.centre(self.scheme.state))
        parts.spot(ink, at, CENTRE, CENTRE, MASS * self.symbol)
        for _ in range(pair_symbols.QUARTERS):
            ink.take(Fill, lambda one: ink.at(one.points[0], at), on("symbol", ink.plan, name=CENTRE))

    def _points(self, ink: Inventory) -> None:
        """Tick off the symbols of points with their letters, and fillings of rigid corners beside them."""
        sizes, corner = [self.symbol * one for one in RADII], self.symbol * LEG * (DOUBLE[0] + GUSSET) + ink.near
        centres = {name for name, _, _ in position_marks.centres(self.plan.laid)}
        cornered = {name for link in self._cornered for name in link.points}
        for name, place in self.expected.points.items():
            at = self.scheme.on(place)
            ink.every(Circle, partial(strokes.is_symbol, at=at, sizes=sizes, near=ink.near))
            for _ in range(pair_symbols.QUARTERS if name in centres else 0):
                ink.take(Fill, partial(strokes.starts, at=at, near=ink.near), on("symbol", ink.plan, name=name))
            ink.letter(read(name), [at], on("letter", ink.plan, name=name))
        for name in cornered & self.expected.points.keys():
            ink.every(Fill, partial(strokes.is_filling, at=self.scheme.on(self.expected.points[name]), far=corner))

    @property
    def _cornered(self) -> list[Link]:
        """The links of more than one bar, whose corners are rigid."""
        mechanism = self.plan.laid.mechanism
        slotted = {slide.owner for slide in mechanism.slides} | {slide.slider for slide in mechanism.slides}
        return [one for n, one in mechanism.links.items() if n != FRAME and (n in slotted or len(one.points) > 2)]

    def _bodies(self, ink: Inventory) -> None:
        """Tick off bars, slots, blocks, stands, axes and grounds of guides."""
        mechanism, slots = self.plan.laid.mechanism, bars.slots_of(self.plan)
        for row in bars.rows_of(self.plan.poses, [self.expected.shown]):
            self._along(ink, row.pieces, on("link_missing", ink.plan, link=row.link, position=self.expected.shown))
        ink.every(Line, lambda one: bool(slots.holds(strokes.segment(one), self.plan.near).any()))
        self._stands(ink)
        for slide in (one for one in mechanism.slides if one.owner == FRAME):
            self._guide(ink, slide)
        ink.every(Polyline, lambda one: one.closed)
        for _, link, spot in position_marks.centres(self.plan.laid):
            ink.every(Line, partial(self._ties, at=spot, link=link))

    def _guide(self, ink: Inventory, slide: Slide) -> None:
        """Tick off the axis of a guide, and the ground beside its block."""
        axis, block = guides.axis_of(self.plan, slide), complex(self.plan.poses.block(slide)[self.expected.shown])
        self._along(ink, axis, on("guide", ink.plan, name=slide.point), guides.lengthened(self.plan, slide))
        if not guides.grounded(self.plan, slide, self.plan.lines(guides.GROUNDS)):
            ink.wrong.append(on("ground", ink.plan, name=slide.point))
        ink.every(Line, partial(strokes.within, at=block, far=(guides.HALF + STAND[2]) * self.symbol))

    def _stands(self, ink: Inventory) -> None:
        """Tick off the stands of the frame's hinges: of each two legs, the base and its hatching."""
        mechanism = self.plan.laid.mechanism
        height, half, more = (size * self.symbol for size in STAND)
        hinges = [spot for name, spot in mechanism.links[FRAME].points.items() if name in mechanism.hinges]
        lean, step = HATCH * self.symbol * math.sqrt(0.5), HATCH_STEP * self.symbol
        due = LEGS_AND_BASE + max(math.floor((2 * (half + more) - lean) / step), 1) + 1
        far, found = abs(complex(height + lean, half + more)) + ink.near, list[Line]()
        for spot in hinges:
            found += ink.every(Line, partial(strokes.within, at=self.scheme.on(spot), far=far))
        leaders = {id(one.strokes[0]) for one in groups((self.part,)) if strokes.is_led(one)}
        # Ties and grounds of guides may lie in the reach of a stand too.
        if sum(1 for one in found if id(one) not in leaders) < due * len(hinges):
            ink.wrong.append(on("stand", ink.plan, name=mechanism.drive.pivot))

    def _ties(self, one: Line, at: complex, link: int) -> bool:
        """Tell whether a line goes from a link to the symbol of its mass centre."""
        off = min(abs(one.start - at), abs(one.end - at))
        foot = min(self.plan.laid.apart(link, end) for end in (one.start, one.end))
        return off <= MASS * self.symbol + self.plan.near and foot <= DOUBLE[0] * self.symbol + self.plan.near

    def _along(self, ink: Inventory, due: Segments, wrong: Wrong, room: Segments | None = None) -> None:
        """Tick off the lines along pieces, or within some room; where a piece is clear of symbols it must be seen."""
        drawn, spots = self.plan.lines(bars.SHOWN), due.at(SHARES).ravel()
        if (self.plan.clear(spots) & (drawn.nearest(spots) > self.plan.near)).any():
            ink.wrong.append(wrong)
        whole = due if room is None else room
        ink.every(Line, lambda one: bool(whole.holds(strokes.segment(one), self.plan.near).any()))

    def _arrows(self, ink: Inventory) -> None:
        """Tick off the arrows of the crank's rates, each with its head at its end and its letter beside it."""
        pivot = complex(self.plan.poses.point(self.plan.laid.mechanism.drive.pivot)[self.expected.shown])
        for letter, sense in drive_arrows.due_of(self.plan):
            wrong, plain = on("sense", ink.plan, name=read(letter)), read(letter)
            own = [text for text in ink.left(Text) if text.plain == plain]
            arc = ink.take(
                Arc, partial(strokes.is_turning, at=pivot, beside=partial(strokes.beside, ink=ink, texts=own)), wrong
            )
            if arc is not None:
                ink.take(Fill, partial(strokes.goes_on, arc=arc, sense=sense), wrong)
                ink.letter(plain, [arc.at(0.5)], wrong)

    def _numbers(self, ink: Inventory) -> None:
        """Tick off the numbers of links within their circles, one for each, with their leaders."""
        links = {str(link) for link in self.plan.laid.mechanism.links}
        for group in (one for one in groups((self.rest,)) if strokes.is_number(one)):
            ring, text, *leader = group.strokes
            assert isinstance(text, Text)
            kinds = [type(one) for one in leader]
            if text.plain not in links or kinds not in ([], [Line, Circle]) or not strokes.rings(ring, text):
                continue
            links.remove(text.plain)
            own = set(map(id, group.strokes))
            for kind in (Circle, Text, Line):
                ink.every(kind, partial(strokes.is_one, own=own))

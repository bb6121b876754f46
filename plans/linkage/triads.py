"""Triads: a basis link on three leads, its branch of assemblies, and its plans by special points (M3.10, figure 6.13).

The special point S is where the lines of two leads meet, taken as a point of the basis link: what the two leads allow
of its velocity they allow of their own points on that line, so that it is met as the pin of a dyad is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from geometry.board import Mark, Reading, held_leads
from geometry.branch import AssemblyBranch, Settling, Side, follow
from geometry.meet import EPS, UNBORNE
from geometry.three_leads import GUIDE, ROD, SLOT, BodyPose, HeldBody, Known, Lead
from plans.linkage import leads
from plans.linkage.leads import GroupKind
from plans.linkage.plan import Image, Plan, Sliding, SpecialLetters, SpecialPoint, Turning, Vector, special_name
from plans.linkage.primary import PRIMARIES, pushed
from plans.model.mechanism import FRAME
from plans.model.motion import Floats
from plans.model.triad import Triad, TriadLead
from plans.words.words import Message, because, message

NODES = 180  # places of the drive on either side of home at which a branch is followed: a degree of a crank
NOWHERE = BodyPose(complex(np.nan, np.nan), complex(np.nan, np.nan))  # of a triad that cannot be assembled at all
SKETCHED = EPS**0.5  # of the body's size: lengths are met, for they move a jammed body by the root of what they miss
SEAM = 1.0 - 1e-9  # of half a turn: ways of a slide are counted no farther


class Triads(GroupKind[Triad]):
    """The triad (трёхповодковая группа)."""

    assemblies = 6
    branched = True

    def sides(self, plan: Plan, triad: Triad) -> list[Side]:
        """Give all assemblies, where they are."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return [*_body(plan, triad).assemblies(_known(plan, triad))]

    def followed(self, look: Callable[[Floats], Plan], triad: Triad, side: Side, home: float) -> Side:
        """Follow an assembly over all that the drive can do, as far as the leads can be met."""
        assert isinstance(side, BodyPose)  # it is an assembly of the sketch
        plan = look(np.array([home]))
        drive, within = plan.mechanism.drive, home - 2 * np.pi * np.round(home / (2 * np.pi))
        ends = (-SEAM * np.pi - within, SEAM * np.pi - within) if drive.pushed else (-np.pi, np.pi)
        ways, body = (drive.unit * ends[0], drive.unit * ends[1]), _body(plan, triad)
        keys, poses, out = follow(body, side, lambda keys: _known(look(home + keys / drive.unit), triad), ways, NODES)
        along = pushed(plan.mechanism).way(FRAME).direction if drive.pushed else 0j
        free = complex(np.ravel(plan.board[PRIMARIES[drive.kind].free].point)[0])
        return AssemblyBranch(free, along, keys, poses, out)

    def jammed(self, plan: Plan, triad: Triad) -> Message | None:
        """Say it with the measure: the sine of the angle between S12B3 and the third lead's line (заклинивание)."""
        links, sketch = plan.mechanism.links, plan.mechanism.sketch
        body, known = _body(plan, triad), _known(plan, triad)
        shown = [(local, sketch[name]) for name, local in links[triad.basis].points.items() if name in sketch]
        if len(shown) < 2 or not np.isfinite(sum(known.places) + sum(known.ways)).all():
            return None
        (local, seen), (first, second, third) = np.array(shown).T, triad.leads
        turn = np.vdot(local - local.mean(), seen - seen.mean())
        turn, begin = turn / abs(turn), known.at(0)
        reach = seen.mean() + turn * (body.leads[0].at - local.mean()) - begin.places[0]
        pose, missed = body.nearest(begin, BodyPose(complex(reach), complex(turn)))
        held = body.held(begin, pose)
        sine = abs(held.determinant / held.arm(2))
        if missed > SKETCHED * body.size or sine**2 > UNBORNE:
            return None
        special = special_name((first, second), plan.written.points)
        names = {"special": special, "pin": third.pin, "link": third.link}
        return message("sketch.jammed", group=triad.label, sine=f"{round(sine, 6):g}", **names)

    def positions(self, plan: Plan, triad: Triad, side: Side) -> None:
        """Settle the basis link on its leads by false positions, along its branch (метод ложных положений, M3.10)."""
        if not isinstance(side, BodyPose | AssemblyBranch):
            side = NOWHERE
        board, body, first = plan.board, _body(plan, triad), triad.leads[0]
        links, basis = plan.mechanism.links, triad.basis
        named = (name for name, place in links[basis].points.items() if place == body.leads[0].at)
        name = next(named, f"N{basis}")
        why = because("settled", link=basis, first=first.link, second=triad.leads[1].link, third=triad.leads[2].link)
        free = board[PRIMARIES[plan.mechanism.drive.kind].free]
        settled = board.settle(name, Settling(body, side), _begins(plan, triad), free, why)
        if name in links[basis].points:
            plan.name(name, settled)
        axis = board.direct(plan.written.of_link("u", basis), settled, because("settled_way", link=basis))
        plan.images[basis] = Image(settled, axis, body.leads[0].at, 1 + 0j)
        for lead in triad.leads:
            if lead.kind == ROD:
                leads.keep_rod(plan, lead.link, (lead.hinge, lead.pin), (plan.point(lead.hinge), plan.point(lead.pin)))
            else:
                host = lead.host if lead.kind == GUIDE else basis
                place = links[lead.link].points[lead.pin]
                leads.ride_on(plan, lead.link, host, lead.slide, (plan.point(lead.pin), place))

    def velocities(self, plan: Plan, triad: Triad) -> None:
        """Meet s on the lines of two leads, then the third lead's line with the turning about s (M3.10)."""
        for lead, start in _drawn(plan, triad, {}).items():
            if lead.kind == ROD:
                leads.keep_turning(plan, lead.link, start, start, plan.point(lead.pin))

    def accelerations(self, plan: Plan, triad: Triad) -> None:
        """Do so with the normal parts of the basis link: towards s of two leads, then from it (M3.10)."""
        special = Special.of(plan.positions, triad)
        normals = {lead: _normal(plan, triad, (lead.pin, special.name)) for lead in special.pair}
        normals[special.out] = _normal(plan, triad, (special.name, special.out.pin))
        for lead, start in _drawn(plan, triad, normals).items():
            if lead.kind == ROD:
                leads.keep_turning(plan, lead.link, plan.point(lead.hinge), start, plan.point(lead.pin))

    def meeting(self, plan: Plan, triad: Triad) -> Mark:
        """Give the point of the basis link that settles it: where that has no place, the group has none."""
        return plan.images[triad.basis].origin

    def vectors(self, triad: Triad) -> Iterator[Vector]:
        """Tell the vectors of its plans: of its special point, of rods about their outer hinges, of what slides."""
        yield SpecialPoint(triad)
        for lead in triad.leads:
            if lead.kind == ROD:
                yield Turning(lead.link, lead.hinge, lead.pin)
            elif lead.kind != GUIDE:
                yield Sliding(leads.key(lead.slide), triad.basis, lead.pin, held=True)
            elif lead.host != FRAME:
                yield Sliding(leads.key(lead.slide), lead.host, lead.pin)

    def pressure(self, plan: Plan, triad: Triad) -> Floats:
        """Read off its pressure angle, (N,) rad: the third lead's force to the velocity about the special point."""
        settled = self.meeting(plan, triad)
        assert settled.meeting is not None  # it was settled
        out = list(held_leads(settled))[_out(plan, triad)]
        turned = np.asarray(out.along) / np.asarray(settled.meeting.sides[0])
        return np.asarray(np.arctan2(turned.real, np.abs(turned.imag)))


class Special(NamedTuple):
    """The special point of a triad on the plan of positions: of which two leads, and which it leaves out."""

    name: str
    mark: Mark
    pair: tuple[TriadLead, TriadLead]
    out: TriadLead

    @classmethod
    def of(cls, base: Plan, triad: Triad) -> Special:
        """Meet the lines of two leads, once: of those that cross most sharply where they cross least (особая точка)."""
        out = _out(base, triad)
        first, second = (lead for lead in triad.leads if lead is not triad.leads[out])
        name = special_name((first, second), base.written.points)
        base.written.specials[triad.basis] = SpecialLetters(name, out)
        if name not in base.board:
            one, other = (line_of_force(base, lead) for lead in (first, second))
            base.board.meet(name, one, other, why=because("special", first=first.link, second=second.link))
        return cls(name, base.board[name], (first, second), triad.leads[out])


def spans(triad: Triad, settled: Mark, position: int) -> dict[str, dict[str, float]]:
    """Tell of each rod that the others keep from its length how long it is, and how long it must be there, m."""
    settling, begins = settled.step.settling, [mark.point for mark in settled.step.inputs]
    assert settling is not None  # it was settled
    known, pose = settling.known(begins[:-1]).at(position), settling.start.over(np.asarray(begins[-1]))[0]
    found = {}
    for k, lead in enumerate(lead for lead in triad.leads if lead.kind == ROD):
        span = settling.body.spanned(known, pose[position], k)
        if np.isfinite(span):
            found[f"{lead.hinge}{lead.pin}"] = {"size": settling.body.leads[k].size, "span": span}
    return found


def _out(base: Plan, triad: Triad) -> int:
    settling = base.images[triad.basis].origin.step.settling
    assert settling is not None  # it was settled
    return settling.out


def line_of_force(base: Plan, lead: TriadLead) -> Mark:
    """Draw the line of the only force that a lead without load can transmit."""
    why = because("force_line", link=lead.link)
    if lead.kind == ROD:
        return base.board.parallel(f"line {lead.hinge}{lead.pin}", base.point(lead.hinge), base.arm(lead.link), why)
    way = leads.known_direction(base, lead.slide)
    return base.board.square(f"⊥{way.name} {lead.pin}", base.point(lead.pin), way, why)


def _drawn(plan: Plan, triad: Triad, normals: Mapping[TriadLead, Mark]) -> dict[TriadLead, Mark]:
    """Draw the image of the basis link; give each lead's start, on which the line of its own point stands.

    `normals` are the basis link's own parts: of each lead of the pair from its point to S, of the third from S to its.
    """
    base, special = plan.positions, Special.of(plan.positions, triad)
    starts = {lead: _start(plan, triad, lead) for lead in triad.leads}
    reached = {lead: _shifted(plan, starts[lead], normals.get(lead)) for lead in special.pair}
    one, other = (_along(plan, lead, start) for lead, start in reached.items())
    s = plan.board.meet(plan.written.small(special.name), one, other, why=because("special_image", point=special.name))
    tip = base.point(special.out.pin)
    reach = plan.carry(_joined(base, special.mark, tip))
    turned_from = _shifted(plan, s, normals.get(special.out))
    around = plan.board.square(f"⊥{reach.name}", turned_from, reach, because("square_turning", line=reach.name))
    name = plan.letter(tip.name) if special.out.kind != SLOT else plan.written.under(tip.name, triad.basis)
    along = _along(plan, special.out, starts[special.out])
    end = plan.board.meet(name, along, around, why=because("both_directions", point=name))
    if special.out.kind != SLOT:
        plan.name(tip.name, end)
    _keep_basis(plan, triad, (s, end, reach), tip)
    tangential = _joined(plan, turned_from, end)
    plan.readings[triad.basis] = Reading(reach, tangential)
    for lead in triad.leads:
        if lead.kind != ROD:
            _keep_slide(plan, triad, lead, starts[lead], end if lead is special.out else None)
    return starts


def _start(plan: Plan, triad: Triad, lead: TriadLead) -> Mark:
    """Give the point of a plan from which a lead lets its point of the basis link move along one line."""
    if lead.kind == ROD:
        a = plan.point(lead.hinge)
        return a if len(plan.below) < 2 else leads.normal(plan, lead.link, a, (lead.hinge, lead.pin))
    if lead.kind == GUIDE:
        over = plan.positions.point(lead.pin)
        if len(plan.below) < 2:
            return leads.sliding_start(plan, lead.host, over)
        return leads.coriolis_start(plan, lead.slide, lead.host, over)
    a, pair = plan.point(lead.pin), leads.key(lead.slide)
    if len(plan.below) < 2:
        return a
    way, turned = leads.known_direction(plan, lead.slide), plan.velocities.units[pair]
    name = plan.written.coriolis(lead.pin, triad.basis, pair)
    return leads.coriolis(plan, lead.slide, a, way, turned, name)


def _along(plan: Plan, lead: TriadLead, start: Mark) -> Mark:
    """Draw the line along which a lead lets its point of the basis link move, and S with it."""
    if lead.kind == ROD:
        return leads.about(plan, lead.link, start)
    way = plan.carry(leads.known_direction(plan, lead.slide))
    return plan.board.parallel(f"∥{way.name}", start, way, because("along_guide"))


def _normal(plan: Plan, triad: Triad, ends: tuple[str, str]) -> Mark:
    """Find the normal part of the second of two points of the basis link about the first."""
    base, speeds = plan.positions, plan.velocities
    arm = plan.carry(_joined(base, *(_of_basis(base, triad, end) for end in ends)))
    turning = plan.carry(_joined(speeds, *(_of_basis(speeds, triad, end) for end in ends)))
    name = plan.written.normal(ends[1], ends[0])
    return plan.board.similar(f"a^{name}", turning, arm, turning, why=because("normal", line=arm.name))


def _of_basis(plan: Plan, triad: Triad, name: str) -> Mark:
    """Give the image of a point of the basis link that lies on a lead's line: S, a hinge, or what is under a stone."""
    special = Special.of(plan.positions, triad)
    if name == special.name:
        return special.mark if not plan.below else plan.board[plan.written.small(name)]
    lead = next(lead for lead in triad.leads if lead.pin == name)
    if lead.kind == SLOT and plan.below:
        return plan.slips[leads.key(lead.slide)].step.inputs[1]
    return plan.point(name)


def _shifted(plan: Plan, start: Mark, part: Mark | None) -> Mark:
    return start if part is None else plan.board.lay_off(part.name[2:], start, part, because("to_centre"))


def _joined(plan: Plan, start: Mark, end: Mark) -> Mark:
    """Join two marks, once."""
    name = f"{start.name}{end.name}"
    if name in plan.board and plan.board[name].step.inputs == (start, end):
        return plan.board[name]
    return plan.board.join(name, start, end)


def _keep_basis(plan: Plan, triad: Triad, found: tuple[Mark, Mark, Mark], tip: Mark) -> None:
    """Keep the image of the basis link, by that of the join from S to the third lead's point."""
    (s, end, reach), base = found, plan.positions
    image, board = base.images[triad.basis], plan.board
    assert image.arm is not None  # every link has a direction on the plan of positions
    whole, origin, why = _joined(plan, s, end), end, because("similar_figure", link=triad.basis)
    axis = board.similar(f"{image.arm.name}'", whole, reach, plan.carry(image.arm), why=why)
    if tip is not image.origin:
        name = plan.letter(image.origin.name)
        back = plan.carry(_joined(base, tip, image.origin))
        part = board.similar(f"{end.name}{name}", whole, reach, back, why=why)
        origin = board.lay_off(name, end, part, because("similar", point=name, link=triad.basis))
        if image.origin.name in base.letters:
            plan.name(image.origin.name, origin)
    plan.images[triad.basis] = Image(origin, axis, image.at, image.span)


def _keep_slide(plan: Plan, triad: Triad, lead: TriadLead, start: Mark, end: Mark | None) -> None:
    """Keep what slides on a lead's line: its slip or relative acceleration from the start, and the lead's image."""
    slide, base = lead.slide, plan.positions
    host = lead.host if lead.kind == GUIDE else triad.basis
    if end is None and lead.kind == SLOT:
        end = plan.transport(host, base.point(lead.pin), plan.written.under(lead.pin, host))
    end = end or plan.point(lead.pin)
    plan.slips[leads.key(slide)] = plan.board.join(f"{start.name}{end.name}", start, end, because("slip"))
    plan.written.slides(leads.key(slide), lead.pin, host)
    leads.ride_on(plan, lead.link, host, slide, (plan.point(lead.pin), base.images[lead.link].at))


def _begins(plan: Plan, triad: Triad) -> list[Mark]:
    """Give where the leads begin: hinges, points of guides; then the directions of the guides."""
    places = [
        plan.place(lead.host, lead.slide.way(lead.host).through, f"K{lead.slide.slider}")
        if lead.kind == GUIDE
        else plan.point(lead.hinge)
        for lead in triad.leads
    ]
    ways = [leads.direction(plan, lead.slide, lead.host) for lead in triad.leads if lead.kind == GUIDE]
    return [*places, *ways]


def _known(plan: Plan, triad: Triad) -> Known:
    settling = Settling(_body(plan, triad), BodyPose(0j, 1 + 0j))
    return settling.known([mark.point for mark in _begins(plan, triad)])


def _body(plan: Plan, triad: Triad) -> HeldBody:
    first, second, third = (_lead(plan, triad, lead) for lead in triad.leads)
    return HeldBody((first, second, third))


def _lead(plan: Plan, triad: Triad, lead: TriadLead) -> Lead:
    links = plan.mechanism.links
    own, basis = links[lead.link].points, links[triad.basis].points
    if lead.kind == ROD:
        return Lead(ROD, basis[lead.pin], abs(own[lead.pin] - own[lead.hinge]))
    left = leads.offset(plan, lead.slide, lead.link, lead.pin)
    if lead.kind == GUIDE:
        return Lead(GUIDE, basis[lead.pin], left)
    way = lead.slide.way(triad.basis)
    return Lead(SLOT, way.through, left, way.direction)

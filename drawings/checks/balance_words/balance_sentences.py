"""What must be told of a mechanism's balance, sentence by sentence, by the analysis alone (ожидаемые пояснения)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance_words.bounds import of_largest
from drawings.checks.balance_words.main_points import EQUALS, MainPoints, straight
from drawings.checks.balance_words.sentences import number
from drawings.checks.precise import KNOWN
from drawings.lettering.balance_letters import FORCE
from drawings.lettering.indices import with_index
from plans.balance.study import COSTS
from plans.balance.weights import line_of
from plans.forces.cut import indices
from plans.forces.primary import BALANCING
from plans.model.balance.linkage import DISC, SHARE, Choice, Counterweight, State
from plans.model.balance.linkage import FORCE as LEAST_FORCE
from plans.model.kinetostatics import NOTHING, Reaction
from plans.model.mechanism import FRAME

CHANGED = "\N{NO-BREAK SPACE}→\N{NO-BREAK SPACE}"
ALIKE = 6  # digits to which ratios must differ for one pair to be the one whose reaction grows most


@dataclass(frozen=True)
class BalanceSentences:
    """The sentences on a balanced mechanism, with so many digits."""

    expected: Expected
    digits: int

    def all(self) -> Iterator[str]:
        """Give all of the notes of a sheet."""
        yield from self.points.told()
        yield from self.counterweights()
        yield from self.price()
        yield from self.choice()

    @cached_property
    def points(self) -> MainPoints:
        """What is told of main points."""
        return MainPoints(self.expected, self.digits)

    def _word(self, key: str, **parts: object) -> str:
        return self.expected.drafting.word(key, **parts)

    def _number(self, value: float, size: float = 0.0) -> str:
        return self.points.number(value, size)

    def counterweights(self) -> Iterator[str]:
        """Tell what is put on, what it makes of the main points, and what is left at sliders."""
        yield from self.put_on()
        if self.expected.after is not None:
            yield self._word("with counterweights", told=self.points.after())
            yield from self._rests(self.expected.after)
        yield from self._left()

    def put_on(self) -> Iterator[str]:
        """Tell what is put on each link."""
        if self.expected.balance.still:
            yield self._word("balanced already")
        else:
            yield from map(self._counterweight, self.expected.balance.counterweights)

    def _counterweight(self, one: Counterweight) -> str:
        letter = f"m_{{{self._word('counterweight index')}{one.link}}}"
        if not one.needed:
            return self._word("nothing to put on", letters=letter, link=one.link)
        along, body = line_of(self.expected.mechanism, one.link, one.begin), self.points.bodies.get(one.link)
        own = 0j if body is None else body.mass * (body.centre - one.origin) / along
        return f"{self._moment(one, own, one.moment / along, letter)};  {self._size(one, one.moment / along, letter)}"

    def _moment(self, one: Counterweight, own: complex, added: complex, letter: str) -> str:
        """Tell what static moment a link has, what it must be, and by what it becomes so."""
        size, unit = abs(own) + abs(added), self._word("kg*m")
        was, due, more = (self.points.vector(value, size) for value in (own, own + added, added))
        needed = self._word("needed moment", link=one.link, point=one.begin, own=was, due=due, unit=unit)
        steps = [f"{letter}·a_{{{one.link}}}"]
        if was != "0" and straight(own) and straight(added):
            sign = "+" if own.real < 0 else "−"
            steps.append(f"{due} {sign} {self._number(abs(own), size)}")
        return f"{needed};  {EQUALS.join([*steps, f'{more} {unit}'])}"

    def _size(self, one: Counterweight, added: complex, letter: str) -> str:
        """Tell the place by the mass, or the mass by the place; of a sector both with its outer radius."""
        mass, metres, kilograms = self._number(one.mass), self._word("m"), self._word("kg")
        if one.place.mass is not None:
            moment = self.points.vector(added, abs(added))
            return f"a_{{{one.link}}} = {moment}/{mass} = {self.points.vector(added / one.mass, one.distance)} {metres}"
        distance = self._number(abs(added) / one.mass)
        if one.place.shape == DISC:
            return f"{letter} = {self._number(abs(added))}/{distance} = {mass} {kilograms}"
        outer = f"R_{{{one.link}}} = {self._number(one.outer)} {metres}"
        return f"{letter} = {mass} {kilograms},  a_{{{one.link}}} = {distance} {metres},  {outer}"

    def _rests(self, after: State) -> Iterator[str]:
        """Tell where the mass centre rests, if it does."""
        known = after.around.r[np.isfinite(after.around.r)]
        if len(known) > 1 and after.path <= NOTHING * self.points.reach:
            slack = self.expected.slack("r_S'")
            x, y = (number(part, slack, self.digits) for part in (float(known[0].real), float(known[0].imag)))
            yield self._word("rests", x=x, y=y)

    def _left(self) -> Iterator[str]:
        """Tell what mass is left at each slider, and what share of it the crank balances."""
        task = self.expected.balance.task
        for point, mass in sorted(self.expected.balance.left.items()):
            told = self.points.vector(mass, self.points.mass)
            shared = task.aim == SHARE and self._hangs(point)
            share = self._share() if shared else ""
            if told != "0":
                key, parts = ("share of mass", {"share": share}) if shared else ("left at slider", {})
                yield self._word(key, mass=told, point=point, **parts)

    def _share(self) -> str:
        """Put in the share of the mass that is balanced: the given one, or the best."""
        task, shares = self.expected.balance.task, self.expected.balance.shares
        if task.share is not None or shares is None:
            return number(task.share or 0.0, 0.0, self.digits)
        return self._best(shares.least_force if task.least == LEAST_FORCE else shares.least_reaction)

    def _best(self, choice: Choice) -> str:
        """Put in a best share."""
        return number(choice.share, self.share_slack(choice), self.digits)

    def share_slack(self, choice: Choice) -> float:
        """Give how far a share may be off: a best one is no sharper than the curve, which may be flat."""
        shares = self.expected.balance.shares
        assert shares is not None
        best = {shares.least_force: FORCE, shares.least_reaction: f"R_{indices(FRAME, self._crank)}"}
        return self.expected.slack(f"k {best[choice]}", COSTS) + KNOWN if choice in best else 0.0

    def _hangs(self, point: str) -> bool:
        """Tell whether a rod goes from a slider's hinge to the crank."""
        hinges = self.expected.mechanism.hinges
        rods = {link for link in hinges.get(point, ()) if link != FRAME}
        crank = [set(links) for pin, links in hinges.items() if pin != point and self._crank in links]
        return any(rods & links for links in crank)

    @property
    def _crank(self) -> int:
        return self.expected.mechanism.drive.link

    def price(self) -> Iterator[str]:
        """Tell the mass put on, the reactions of the shaft and of the pair where they grow most, the moment."""
        before, after = self.expected.balance.before, self.expected.after
        if after is None:
            return
        newtons, moments = self._word("N"), self._word("N*m")
        told = [f"{self.letter(key)}: {self._change(key, after)} {newtons}" for key in self._costly(after)]
        balancing = self.expected.drafting.letter(with_index(BALANCING))
        told.append(f"{balancing}: {self._turned(before, after)} {moments}")
        masses = {"added": self._number(self.expected.balance.added), "mass": self._number(self.points.mass)}
        yield self._word("price", **masses, told=",  ".join(told))

    def letter(self, key: str) -> str:
        """Letter a reaction as the scene asks."""
        one, drafting = self.pairs[key], self.expected.drafting
        return drafting.letter(with_index(f"{drafting.reactions}_{indices(one.giver, one.taker)}"))

    def _costly(self, after: State) -> list[str]:
        """Name the crank's shaft, and the pair whose largest reaction grows by the largest ratio."""
        was, now = self.expected.balance.before.reactions, after.reactions
        least = NOTHING * self.expected.balance.before.forces.largest
        grown = {key: round(now[key] / was[key], ALIKE) for key in self.pairs if was[key] > least}
        most = [key for key, ratio in grown.items() if ratio > 1 and ratio == max(grown.values())]
        return list(dict.fromkeys([*self.shaft, *most[:1]]))

    @property
    def pairs(self) -> Mapping[str, Reaction]:
        """The pairs in the order of the plans of forces, with their reactions by analysis."""
        rows = self.expected.balance.before.forces.reactions
        return {key: rows[key] for key in self.expected.own.balance.before.forces.reactions}

    @property
    def shaft(self) -> list[str]:
        """Name the pair of the crank's shaft."""
        return [key for key, one in self.pairs.items() if {one.giver, one.taker} == {FRAME, self._crank}][:1]

    def _change(self, key: str, after: State) -> str:
        before, one = self.expected.balance.before, self.pairs[key]
        pair = before.reactions[key], after.reactions[key]
        return self._both(f"R_{indices(one.giver, one.taker)}", pair, self._nothing(after)[0])

    def _turned(self, before: State, after: State) -> str:
        return self._both(BALANCING, (before.balancing, after.balancing), self._nothing(after)[1])

    def _nothing(self, after: State) -> tuple[float, float]:
        """Give the force N and the moment N*m that are but rounding before or after."""
        both = [one.forces.nothing for one in (self.expected.balance.before, after)]
        return max(one[0] for one in both), max(one[1] for one in both)

    def _both(self, name: str, pair: tuple[float, float], least: float) -> str:
        """Put in what is largest before and after of a quantity by its name."""
        named = zip((name, f"{name}'"), pair, strict=True)
        slacks = [(one, of_largest(self.expected, key, one)) for key, one in named]
        return CHANGED.join("0" if one <= least else number(one, slack, self.digits) for one, slack in slacks)

    def choice(self) -> Iterator[str]:
        """Tell the two best shares, and what there is without counterweights."""
        shares, before = self.expected.balance.shares, self.expected.balance.before
        if shares is None:
            return
        force, reaction = shares.least_force, shares.least_reaction
        sizes = {"force": force.force, "reaction": reaction.reaction, "bare": before.reactions[self.shaft[0]]}
        told = {name: self._number(one, before.forces.largest) for name, one in sizes.items()}
        told |= {"share": self._best(force), "other": self._best(reaction)}
        yield self._word("best shares", main=FORCE, letters=self.letter(self.shaft[0]), **told)

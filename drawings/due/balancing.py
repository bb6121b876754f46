"""What must stand on the sheets of a balanced mechanism: schemes, polygon, hodographs, graphs, tables (лист 5)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain

import numpy as np

from drawings.checks.expected import KNOWN, NOTHING, Expected, course
from drawings.due.balanced import AFTER, BEFORE, Balanced
from drawings.layout.table import cell_name
from drawings.lettering.balance_letters import CENTRE, FORCE, MOMENT, RESULT, counterweight
from drawings.lettering.indices import with_index
from drawings.paper.statement import Kind
from drawings.paper.strokes import Leaf
from drawings.report.balance.balance_report import drafting_for
from plans.balance.weights import line_of
from plans.forces.cut import indices
from plans.forces.primary import BALANCING
from plans.model.balance.linkage import DISC, Choice, Counterweight, State
from plans.study import Study

SCHEME, MOMENTS, SHAKING, ROCKING, SHARES = "scheme-", "static-moments", "shaking", "rocking", "shares"
WEIGHTS, COSTS = "counterweights", "costs"
PRIMES = {BEFORE: "", AFTER: "'"}  # behind the names of what is compared
MILLIMETRES, TURN, DIGITS = 1000.0, 360.0, 5
CHANGE = 0.05000001  # per cent: changes are told to a tenth


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's balanced mechanism (row of the table of sheets)."""
    own = study["balance"]
    for leaf in leaves[:1]:
        balanced = Balanced(own, study.comparison("balance"), drafting_for(own), leaf.metadata["position"])
        sheet = _Sheet(balanced)
        yield from chain(sheet.schemes(), sheet.polygon(), sheet.shaking(), sheet.rocking())
        yield from chain(sheet.shares(), sheet.weights(), sheet.costs())


@dataclass(frozen=True)
class _Sheet:
    """What the analysis gives to a sheet of balancing; what is too short to be seen may lack."""

    own: Balanced

    def schemes(self) -> Iterator[Expected]:
        """Give the points, the counterweights, the mass centre and the main-point vectors of each scheme."""
        own, k = self.own, self.own.shown
        for state in own.states:
            plan, slack = SCHEME + state, own.slack(f"r_S{PRIMES[state]}", position=k) + KNOWN * own.reach
            places = {name: spot for name, spot in own.points.items() if name != own.mechanism.drive.pivot}
            places |= {f"m_cw{one.link}": own.at(one.link, one.centre) for one in own.weights(state)}
            places[CENTRE] = own.centre(state)
            for name, place in places.items():
                yield Expected(Kind.POINT, plan, name, place, slack, k)
            yield from (Expected(Kind.VECTOR, plan, one.name, one.value, slack, k, True) for one in own.chain(state))

    def polygon(self) -> Iterator[Expected]:
        """Give the static moments and their sum, but for what is nothing beside all of them."""
        own, sides = self.own, list(self.own.moments())
        size, mass = sum(abs(one.value) for one in sides), own.balance.before.centre.mass
        slack = own.slack("Σmr/m", position=own.shown) * mass + KNOWN * size
        for name, value in (*((one.name, one.value) for one in sides), (RESULT, sum(one.value for one in sides))):
            if abs(value) > KNOWN * size:
                yield Expected(Kind.VECTOR, MOMENTS, name, value, slack, own.shown)

    def shaking(self) -> Iterator[Expected]:
        """Give the main vectors: their ends at all positions, and themselves in the one shown."""
        own = self.own
        largest = max(one.shaking for one in own.states.values())
        slack = max(own.slack(f"{FORCE}{prime}") for prime in PRIMES.values()) + KNOWN * largest
        for state, one in own.states.items():
            if one.shaking > own.none.force:
                known = ((k, complex(value)) for k, value in enumerate(one.centre.force) if cmath.isfinite(value))
                for k, value in known:
                    lacks = k not in own.told or _spread(one) < largest
                    yield Expected(Kind.POINT, SHAKING, f"{state} {k}", value, slack, k, lacks)
                value = complex(one.centre.force[own.shown])
                if cmath.isfinite(value):
                    name = f"{FORCE}{PRIMES[state]}"
                    yield Expected(Kind.VECTOR, SHAKING, name, value, slack, own.shown, abs(value) < 0.1 * largest)

    def rocking(self) -> Iterator[Expected]:
        """Give the ordinates of the main moment at the positions, those of the state that is told last."""
        own = self.own
        largest = max(one.rocking for one in own.states.values())
        slack = max(own.slack(f"M_Φ{prime}") for prime in PRIMES.values()) + KNOWN * largest
        values = list(own.states.values())[-1].centre.moment
        for k, value in enumerate(np.where(np.abs(values) <= own.none.moment, 0.0, values).tolist()):
            yield Expected(Kind.VECTOR, ROCKING, str(k), 1j * value, slack, k, may_lack=True)
        names = ("last, before", "last") if len(own.states) > 1 else ("last",)
        for name, one in zip(names, own.states.values(), strict=True):
            around = one.around
            if own.whole and not np.isnan(around.moment).any():
                moments = np.where(np.abs(around.moment) <= own.none.moment, 0.0, around.moment)
                points = course(np.degrees(own.own.linkage.sense * (around.phi - around.phi[0])), moments)
                loose = max(own.slack(f"M_Φ{prime}", COSTS) for prime in PRIMES.values()) + KNOWN * largest
                yield Expected(Kind.CURVE, ROCKING, name, points, loose, ends=(0.0, TURN), may_lack=True)

    def shares(self) -> Iterator[Expected]:
        """Give the least values of the choice, and both curves of it."""
        found = self.own.balance.shares
        if found is None:
            return
        best = {"force": found.least_force, "reaction": found.least_reaction}
        for kind, one in best.items():
            value = _value(one, kind)
            yield Expected(Kind.VECTOR, SHARES, kind, 1j * value, KNOWN * value, may_lack=True)
            row = sorted((each.share, _value(each, kind)) for each in (*found.curve, *best.values()))
            x, y = np.array([share for share, _ in row]), np.array([value for _, value in row])
            points = course(x, y)
            yield Expected(Kind.CURVE, SHARES, kind, points, KNOWN * float(y.max()), ends=(float(x[0]), float(x[-1])))
            for name, size in ((f"least {kind}", value), (f"share {kind}", one.share)):
                yield Expected(Kind.PHRASE, SHARES, name, size, KNOWN * abs(size), digits=4)

    def weights(self) -> Iterator[Expected]:
        """Give the cells of the table of counterweights."""
        for one in self.own.balance.counterweights:
            row = counterweight(one.link, self.own.drafting.language)
            cells = self._weight(one) if one.needed else ["0", "0", *(NOTHING for _ in range(6))]
            for column, cell in enumerate(cells):
                value, slack = cell if isinstance(cell, tuple) else (cell, 0.0)
                period = TURN if column == 4 else 0.0
                own = cell_name(row, column)
                yield Expected(Kind.NUMBER, WEIGHTS, own, value, slack, digits=DIGITS, period=period)

    def _weight(self, one: Counterweight) -> Sequence[tuple[float, float] | str]:
        own, word = self.own, self.own.drafting.word
        slacks = [own.slack(f"{letter}{one.link}", WEIGHTS) for letter in ("U_", "m_cw", "r_cw")]
        turned = one.moment / line_of(own.mechanism, one.link, one.begin)
        loose = math.degrees(slacks[0] / abs(one.moment) + KNOWN)
        sector = own.drafting.number(math.degrees(2 * one.place.half_angle))
        outer = MILLIMETRES * one.outer
        return [
            (abs(one.moment), slacks[0]), (one.mass, slacks[1]), with_index(one.begin),
            (MILLIMETRES * one.distance, MILLIMETRES * slacks[2]), (math.degrees(cmath.phase(turned)), loose),
            word("disc") if one.place.shape == DISC else word("sector", angle=sector),
            (outer, outer * slacks[1] / one.mass), (MILLIMETRES * one.place.thickness, 0.0),
        ]  # fmt: skip

    def costs(self) -> Iterator[Expected]:
        """Give the cells of the table of what is largest before and after, with its change in per cent."""
        own = self.own
        was = dict(self._largest(own.balance.before))
        now = {} if own.after is None else dict(self._largest(own.after))
        for row, value in was.items():
            yield Expected(Kind.NUMBER, COSTS, cell_name(row, 0), value, KNOWN * abs(value), digits=DIGITS)
            if row in now:
                changed = KNOWN * abs(now[row])
                yield Expected(Kind.NUMBER, COSTS, cell_name(row, 1), now[row], changed, digits=DIGITS)
                change = 100 * (now[row] / value - 1) if value else NOTHING
                yield Expected(Kind.NUMBER, COSTS, cell_name(row, 2), change, CHANGE, digits=3)

    def _largest(self, state: State) -> Iterator[tuple[str, float]]:
        """Give what is largest of a state by the names of the rows; what is nothing is 0."""
        own, word, none = self.own, self.own.drafting.word, self.own.none
        yield word("path of S", unit=word("mm")), MILLIMETRES * _rounded(state.path, none.way)
        yield f"{FORCE}, {word('N')}", _rounded(state.shaking, none.force)
        shaft = own.mechanism.drive.pivot
        yield word("moment about", letter=MOMENT, point=shaft, unit=word("N*m")), _rounded(state.rocking, none.moment)
        for key, one in state.forces.reactions.items():
            letter = own.drafting.letter(with_index(f"{own.drafting.reactions}_{indices(one.giver, one.taker)}"))
            yield f"{letter}, {word('N')}", _rounded(state.reactions[key], none.force)
        balancing = own.drafting.letter(with_index(BALANCING))
        yield f"{balancing}, {word('N*m')}", _rounded(state.balancing, none.moment)
        yield word("moving mass", unit=word("kg")), state.centre.mass


def _value(one: Choice, kind: str) -> float:
    return one.force if kind == "force" else one.reaction


def _rounded(value: float, none: float) -> float:
    return 0.0 if abs(value) <= none else value


def _spread(state: State) -> float:
    """Give how far the hodograph of a state reaches, N: the larger side of the box about it."""
    known = state.around.force[np.isfinite(state.around.force)]
    return max((float(np.ptp(row)) for row in (known.real, known.imag) if row.size), default=0.0)

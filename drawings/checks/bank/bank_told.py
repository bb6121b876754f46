"""The self-check of the notes on a bank: each number that they give a letter, what vanishes (проверка пояснений)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from drawings.checks.balance_words.bank_sentences import BankSentences
from drawings.checks.balance_words.sentences import Sentence, notes, on_sheet, wrong_notes
from drawings.checks.bank.bank_expected import DOUBTFUL, LEFT, PAPER, WHOLE, WHOLE_MOMENT, Expected
from drawings.checks.bank.bank_tables import compared
from drawings.checks.linkage import accord
from drawings.checks.reading import NOTES
from drawings.checks.rotor.rotor_tables import Cell
from drawings.checks.wrong import Wrong, within
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts
from plans.bank.letters import FORCE, MOMENT, couple_letters, letters
from plans.model.balance.bank import Compensator, Harmonic

DIGITS = 5  # of the numbers
MINUTE = 60  # seconds
_NUMBER = r"[−\d.,]*\d"
_TURNED = rf"(?:\s\S+\s∠\s({_NUMBER})°)?"
_SAID = re.compile(r"(?<!φ)\s=\s[−\d]")  # a number that a letter is given


class Told(NamedTuple):
    """What a note must say: a letter, its size, and its direction if it has one."""

    name: str
    size: Cell
    angle: Cell | None = None
    sure: bool = True  # that it is there: what is hardly more than rounding may be left out

    def holds(self, value: str, angle: str | None) -> bool:
        """Tell whether a note says it."""
        turned = angle is None if self.angle is None else angle is not None and self.angle.holds(angle)
        return self.size.holds(value) and turned


def faults(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes of the first sheet back: each letter in its turn, none left out; what vanishes, in words."""
    if not (leaf.metadata["notes"] or notes(leaf)):
        return
    told = _spaced(" ".join(text.plain for group in leaf.groups if group.name == NOTES for text in texts((group,))))
    rest, place = "", 0
    for one in _due(expected):
        found = re.compile(rf"(?<!\S){re.escape(one.name)}\s=\s(?:[^\s=]+\s=\s)?({_NUMBER}){_TURNED}").search(
            told, place
        )
        if found is None:
            yield from [within("missing_from", NOTES, name=one.name)] if one.sure else []
            continue
        rest, place = rest + told[place : found.start()], found.end()
        if not one.holds(*found.groups()):
            yield within("in", NOTES, text=found[0])
    rest += told[place:]
    yield from (
        within("stranger_in", NOTES, text=rest[max(one.start() - 4, 0) : one.end()]) for one in _SAID.finditer(rest)
    )
    yield from _rows(told, expected, drafting)
    yield from _senses(told, expected, drafting)
    yield from _phrases(told, expected, drafting)
    yield from _sentences(leaf, expected, drafting)


def _sentences(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """See that the notes say each sentence in its turn, and nothing beside; of both roads other checks ask."""
    both = accord.due([one for one in expected.comparison.findings if compared(one)], drafting.language, True)
    due = *BankSentences(expected, drafting, DIGITS, on_sheet).all(), *(Sentence(on_sheet(one), False) for one in both)
    yield from wrong_notes(leaf, due)


def _spaced(text: str) -> str:
    return " ".join(text.split())


def _due(expected: Expected) -> Iterator[Told]:
    """Give all numbers that the notes must say."""
    task = expected.task
    yield Told("n", Cell(task.speed * MINUTE / math.tau))
    yield Told("ω", Cell(task.speed))
    if task.unit is not None:
        yield Told("λ", Cell(task.unit.crank / task.unit.rod))
    for order, force in expected.analysis.forces.items():
        yield from _sums(expected, FORCE, force)
        yield from _sums(expected, MOMENT, expected.analysis.moments[order])
    for name, letter in ((WHOLE, "Fmax"), (LEFT, "F'max"), (WHOLE_MOMENT, "Mmax")):
        if expected.faint(name) and expected.acts(name, seen=True):
            size = Cell(expected.most(name), expected.allowed[name])
            yield Told(letter, size, sure=expected.acts(name, seen=False))
    for one in expected.analysis.compensators:
        yield from _masses(expected, one)


def _sums(expected: Expected, kind: str, one: Harmonic) -> Iterator[Told]:
    alone = expected.alone(one.order)
    for signed, value in ((one.order, one.ahead), (-one.order, one.back)):
        slack = expected.allowed[letters(kind, signed)]
        if abs(value) > one.slack and not (alone and signed < 0):
            angle = Cell(math.degrees(cmath.phase(value)), math.degrees(slack / abs(value)), True)
            yield Told(_plain(letters(kind, signed)), Cell(abs(value), slack), angle)
    sizes = [abs(value) for value in (one.ahead, one.back) if abs(value) > one.slack]
    if sizes and kind == FORCE:
        yield Told("Fmax", Cell(math.fsum(sizes), 2 * expected.allowed[letters(kind, one.order)]))


def _masses(expected: Expected, one: Compensator) -> Iterator[Told]:
    """Give the static moments of the masses, and the couple that their offset leaves."""
    order, slack = one.asked.order, expected.slack_of(one)
    bodies = [body for body in expected.bodies(one) if not body.coupled]
    for body in bodies:
        yield Told(_plain(letters("mr", body.turns)), Cell(body.moment, slack))
    doubtful = _alike(one, expected)
    more = one.with_crank - one.against
    if order == 1 and one.with_angle is not None and (doubtful or (_unlike(one) and more > 0)):
        angle = Cell(math.degrees(one.with_angle), math.degrees(2 * slack / one.with_crank), True)
        yield Told("mrO", Cell(more, 2 * slack), angle, sure=not doubtful)
    if expected.carried(one):
        return
    square = (order * expected.task.speed) ** 2
    couple = sum(body.moment for body in bodies) * square * abs(one.asked.offset)
    if couple:
        wide = len(bodies) * slack * square * abs(one.asked.offset)
        yield Told("M", Cell(couple, wide))
        if one.asked.shafts is not None:
            arm = square * one.asked.shafts
            yield Told(_plain(couple_letters(order)), Cell(couple / arm, wide / arm))


def _unlike(one: Compensator) -> bool:
    """Tell whether the masses on two shafts of their own are of unlike size."""
    more, less = max(one.with_crank, one.against), min(one.with_crank, one.against)
    alone = one.asked.order == 1 and one.against_angle is None
    return not alone and more - less > PAPER * more


def _alike(one: Compensator, expected: Expected) -> bool:
    """Tell whether rounding may be all that the masses differ by: they may be told apart or not."""
    return abs(one.with_crank - one.against) <= DOUBTFUL * expected.slack_of(one)


def _plain(name: str) -> str:
    return Text(0j, lowered(name)).plain


def _phrases(told: str, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """See that the notes say which orders vanish, that no moment is left where none can be, and what needs nothing."""
    analysis = expected.analysis
    single, forces, moments = (_vanish(one) for one in (analysis.single, analysis.forces, analysis.moments))
    apart = any(one.place for one in expected.members)
    rows: list[tuple[str, Callable[[int], bool]]] = [
        ("no order", lambda order: order in single),
        ("no order force", lambda order: order in forces and order not in single),
        ("no order moment", lambda order: apart and order in moments and order not in single),
        ("slight orders", expected.slight),
    ]
    for key, holds in rows:
        orders = ", ".join(str(order) for order in analysis.single if holds(order))
        begun, due = (drafting.word(key, orders=each) for each in ("\0", orders or "0"))
        if (begun.partition("\0")[0] in told) != bool(orders) or (orders and due not in told):
            yield within("in", NOTES, text=due)
    if (drafting.word("one plane of a bank") in told) == apart:
        yield within("in", NOTES, text=drafting.word("one plane of a bank"))
    for one in analysis.compensators:
        order = one.asked.order
        idle = drafting.word("no compensator", order=order)
        if (idle in told) == any(expected.bodies(one)):
            yield within("in", NOTES, text=idle)
        pair = {key: lowered(letters(FORCE, signed)) for key, signed in (("ahead", order), ("back", -order))}
        unlike = Text(0j, drafting.word("unequal vectors", **pair)).plain
        if (unlike in told) != _unlike(one) and not _alike(one, expected):
            yield within("in", NOTES, text=unlike)
    if (drafting.word("on crank") in told) != any(map(expected.carried, analysis.compensators)):
        yield within("in", NOTES, text=drafting.word("on crank"))


def _senses(told: str, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """See that the notes say of which orders what turns against the crank is not shown."""
    single = expected.analysis.single
    lasting = [order for order in single if order not in _vanish(single)]
    alone = ", ".join(str(order) for order in lasting if expected.alone(order))
    some = bool(alone) and not all(map(expected.alone, lasting))
    due = {"some mirror images": some, "mirror image": bool(alone) and not some, "both senses": not alone}
    (said,) = (drafting.word(key, **({"orders": alone} if some else {})) for key, holds in due.items() if holds)
    if not re.search(rf"{re.escape(Text(0j, said).plain)}(?!;)", told):
        yield within("missing_from", NOTES, name=Text(0j, said).plain)


def _rows(told: str, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """See that the notes say how every mechanism stands, number by number."""
    members = expected.members
    rows = {
        "crank angles": ("angles", [one.crank for one in members], True),
        "guide angles": ("angles", [one.axis for one in members], any(one.axis for one in members)),
        "bank places": ("places", [1000 * one.place for one in members], any(one.place for one in members)),
    }
    for key, (part, values, due) in rows.items():
        before, _, after = drafting.word(key, **{part: "\0"}).partition("\0")
        found = re.search(rf"{re.escape(before)}((?:{_NUMBER}(?:; )?)+){re.escape(after)}", told)
        said = found[1].split("; ") if found else []
        right = len(said) == len(values) and all(
            Cell(float(value)).holds(text) for text, value in zip(said, values, strict=True)
        )
        if bool(found) != due or (due and not right):
            yield within("in", NOTES, text=found[0] if found else before)


def _vanish(found: object) -> frozenset[int]:
    assert isinstance(found, dict)
    return frozenset(order for order, one in found.items() if max(abs(one.ahead), abs(one.back)) <= one.slack)

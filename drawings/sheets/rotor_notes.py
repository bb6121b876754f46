"""What a rotor's sheet says in words: sums, counterweights, quality, reactions of the bearings (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.figures.rotor.letters import index, lowered
from drawings.page.drafting import Drafting
from plans.model.balance_quality import grade_of, letters, permissible
from plans.model.rotor import Balance, Correction, Resultant, Rotor
from plans.rotor.bearings import BEARINGS
from plans.rotor.letters import unbalance_letters

GRAM_MILLIMETRES = 1e6  # of a kg*m
PLACES = 5  # digits of results
ANGLE = "\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}"  # between the size of a vector and its direction


def notes(rotor: Rotor, balance: Balance, drafting: Drafting) -> tuple[str, ...]:
    """Say what was unbalanced, what balances it, how well, and what the bearings bear."""
    return (
        *_sums(rotor, balance, drafting),
        *(_counterweight(one, drafting) for one in balance.corrections),
        *_quality(rotor, balance, drafting),
        *_reactions(rotor, balance, drafting),
    )


def _sums(rotor: Rotor, balance: Balance, drafting: Drafting) -> Iterator[str]:
    sums = {
        "unbalance": _vector(balance.unbalance, "kg*m", drafting),
        "couple": _vector(balance.couple, "kg*m2", drafting),
    }
    if rotor.dynamic:
        yield drafting.word("arms from", plane=rotor.planes[-1].name)
    yield drafting.word("sums before", **sums)
    if not rotor.dynamic and not balance.couple.vanishes:
        yield drafting.word("static only", couple=drafting.number(balance.couple.size, PLACES))


def _vector(one: Resultant, unit: str, drafting: Drafting) -> str:
    """Write a vector by its size and direction; one that vanishes is 0."""
    size = f"{drafting.number(one.size, PLACES)} {drafting.word(unit)}"
    return size if one.angle is None else f"{size}{ANGLE}{drafting.number(one.angle, PLACES)}°"


def _counterweight(one: Correction, drafting: Drafting) -> str:
    name, plane = lowered(unbalance_letters(one.plane.name), drafting), index(one.plane.name, drafting)
    if one.moment.angle is None:
        return drafting.word("no counterweight", letters=name)
    parts = []
    if one.mass is not None:
        parts.append(drafting.word("counterweight mass", index=plane, mass=drafting.number(one.mass, PLACES)))
    if one.radius is not None:
        parts.append(
            drafting.word("counterweight radius", index=plane, radius=drafting.number(1000 * one.radius, PLACES))
        )
    moment, angle = (drafting.number(value, PLACES) for value in (one.moment.size, one.moment.angle))
    told = drafting.word("counterweight", letters=name, moment=moment, angle=angle, parts=",  ".join(parts))
    return told.removesuffix(";  ")


def _quality(rotor: Rotor, balance: Balance, drafting: Drafting) -> Iterator[str]:
    before = rotor.quality(*balance.sizes)
    if before is None or rotor.mass is None or rotor.speed is None:
        return
    yield drafting.word("quality before", quality=drafting.number(before), grade=_grade(before, drafting))
    if rotor.grade is not None:
        whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
        told = {"grade": letters(rotor.grade), "permissible": drafting.number(whole)}
        if rotor.dynamic:
            yield drafting.word("permissible", each=drafting.number(whole / len(rotor.planes)), **told)
        else:
            yield drafting.word("permissible in one", **told)


def _grade(quality: float, drafting: Drafting) -> str:
    grade = grade_of(quality)
    return drafting.word("no grade") if grade is None else letters(grade)


def _reactions(rotor: Rotor, balance: Balance, drafting: Drafting) -> Iterator[str]:
    if balance.before and rotor.speed is not None:
        before, after = (_borne(own, drafting) for own in (balance.before, balance.after))
        yield drafting.word("bearing loads", speed=drafting.number(rotor.speed), before=before)
        yield drafting.word("bearing loads after", after=after)


def _borne(reactions: Sequence[Resultant], drafting: Drafting) -> str:
    told = (f"R_{{{name}}} = {_vector(one, 'N', drafting)}" for name, one in zip(BEARINGS, reactions, strict=True))
    return ",  ".join(told)

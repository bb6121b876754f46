"""Ratios with carriers stopped in letters, and the ratio of a train by them (формула Виллиса)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.lettering.gear_letters import teeth_letters
from drawings.lettering.words import with_index
from plans.gears.study import pair_of
from plans.model.gears import FRAME, BoxGear, Train, Willis, bodies


def ratio_letters(one: Willis) -> str:
    """Letter a ratio with the carrier stopped: U_13^(H)."""
    carrier = f"^{{({one.carrier})}}" if one.carrier else ""
    return f"U{carrier}_{{{pair_of(one.first.link, one.other.link)}}}"


def quantity(one: Willis) -> str:
    """Name the quantity of a ratio with the carrier stopped."""
    return f"U_{one.first.name}{one.other.name}^{one.carrier}"


def by_teeth(one: Willis) -> Iterator[str]:
    """Write a ratio by its teeth, in letters and in numbers, without idlers: they change the sign alone."""
    driven, driving = [*one.driven], [*one.driving]
    for wheel in one.driven:
        if wheel in driving:
            driven.remove(wheel)
            driving.remove(wheel)
    sign = "−" if one.ratio < 0 else ""
    yield sign + _over([teeth_letters(w.name) for w in driven], [teeth_letters(w.name) for w in driving])
    yield sign + _over([str(abs(w.teeth)) for w in driven], [str(abs(w.teeth)) for w in driving])


def _over(top: list[str], low: list[str]) -> str:
    return f"{'·'.join(top)}/({'·'.join(low)})" if len(low) > 1 else f"{'·'.join(top)}/{low[0]}"


def lettered(name: str, gear: BoxGear) -> str:
    """Letter what a train has in a gear, its ratio or its efficiency.

    >>> lettered("U_1H", BoxGear("II", (), ()))
    'U^{II}_{1H}'
    """
    return with_index(f"{name[0]}^{{{gear.name}}}{name[1:]}" if gear.name else name)


def stopped(train: Train, gear: BoxGear) -> str:
    """Write the ratio by those with carriers stopped, where these lead from the driving link to the driven one."""
    body, (driving, _) = bodies(train.links, (*train.joined, *gear.locked)), train.drives[0]
    ways, steps = {body[driving]: ("", "")}, [*_steps(train, gear)]
    for _ in steps:
        for one, other, top, low in steps:
            for a, b, over, under in ((body[one], body[other], top, low), (body[other], body[one], low, top)):
                if a in ways and b not in ways:
                    ways[b] = ways[a][0] + over, ways[a][1] + under
    found = ways.get(body[train.output], ("", "")) if train.single else ("", "")
    top, low = (text.replace("}U", "}·U") for text in found)
    bare = top[1:-1] if top.count("(1") == 1 and top[0] + top[-1] == "()" and not low else top
    return f"{bare or 1}/[{low}]" if low.count("(1") > 1 or "·" in low else f"{bare or 1}/{low}" if low else bare


def _steps(train: Train, gear: BoxGear) -> Iterator[tuple[str, str, str, str]]:
    """Give pairs of links with the numerator and the denominator of their ratio: 1 - U_13^(H), where 3 is held."""
    held = {link for link, one in bodies(train.links, [(FRAME, *gear.held)]).items() if one == FRAME}
    for one in train.willis:
        a, b, name = one.first.link, one.other.link, ratio_letters(one)
        if not one.carrier:
            yield a, b, name, ""
        elif b in held:
            yield a, one.carrier, f"(1 − {name})", ""
            for third in train.willis:
                if third.first is one.first and third is not one and third.other.link not in held:
                    yield third.other.link, one.carrier, f"(1 − {name}/{ratio_letters(third)})", ""
        elif a in held:
            yield b, one.carrier, f"(1 − 1/{name})", ""

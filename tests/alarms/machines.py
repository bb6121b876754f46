"""Random machines: a mechanism of the trials with masses, loads, springs and friction, and a sheet of any kind."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any, NamedTuple

from plans.model.mechanism import FRAME
from tests.trials.chains import chain
from tests.trials.changes import change
from tests.trials.crank_rockers import crank_rocker

STARTS = ("angle", "turn", "list")  # of chains: few of them have an extreme position
DYADS = 3  # of a chain at the most: how long a scene is drawn grows with them
POINT = re.compile(r"[A-Z]\d*")
# What differs between sheets, and what each may be.
PAPER = {
    "language": ("en", "ru"),
    "standard": ("GOST", "ISO"),
    "format": ("A1", "A2", "A3", "A4"),
    "lettering": ("strokes", "strokes", "text"),
    "scales": ("common", "each"),
    "notation": ("mu", "mu", "mu", "K"),
}
SHEETS = re.compile(r"^sheets = .*$", re.MULTILINE)
HEAD = re.compile(r"^\[sheet\].*$", re.MULTILINE)
POSITIONS = ((), (0,), (1,), (2, 5), (1, 4, 7))  # that are shown; of few positions the first


class Reading(NamedTuple):
    """A scene's mechanism as it is written: points by link, that of the crank, and the data."""

    points: Mapping[int, tuple[str, ...]]
    drive: int
    data: Mapping[str, Any]

    @property
    def moving(self) -> list[int]:
        """The links that move."""
        return sorted(link for link in self.points if link != FRAME)


def machine(seed: int, number: int) -> str:
    """Write a scene: the same for ever by its seed and number."""
    chance = Random(f"alarm {seed} {number}")
    text = _mechanism(chance)
    own = _read(text)
    if "masses" not in own.data and "loads" not in own.data:
        text += "\n" + "\n".join(_loads(chance, own)) + "\n"
        sheets = chance.choice(('["kinematics", "forces"]', '["kinematics", "forces"]', '["kinematics"]', '["forces"]'))
        text = f"sheets = {sheets}\n{SHEETS.sub('', text)}"
    return papered(text, {**{key: chance.choice(values) for key, values in PAPER.items()}, **_shown(chance, own)})


def papered(text: str, paper: Mapping[str, str | list[int]]) -> str:
    """Put a scene on a sheet of another kind."""
    lines = [f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value}" for key, value in paper.items()]
    begin = HEAD.search(text)
    if begin is None:
        return "\n".join([text, "[sheet]", *lines, ""])
    own = re.compile(rf"^({'|'.join(paper)}) = .*$", re.MULTILINE)
    rest = own.sub("", text[begin.end() :]) if paper else text[begin.end() :]
    return "\n".join([text[: begin.end()], *lines]) + rest


def _mechanism(chance: Random) -> str:
    text = chance.choice((_chain, _chain, _chain, crank_rocker, change))(chance)
    title = re.search(r'title = "Chain (.*)"', text)
    return _mechanism(chance) if title and len(title[1].split()) > DYADS else text


def _chain(chance: Random) -> str:
    return chain(chance, STARTS)


def _read(text: str) -> Reading:
    data = tomllib.loads(text)
    links = data["mechanism"]["links"]
    own = {
        int(link): tuple(names) if isinstance(names, list) else tuple(POINT.findall(names))
        for link, names in links.items()
    }
    extra = data["mechanism"].get("points", {})
    more = {link: tuple(name for name, one in extra.items() if one.get("on") == link) for link in own}
    points = {link: tuple(dict.fromkeys((*own[link], *more[link]))) for link in own}
    return Reading({FRAME: tuple(data["mechanism"]["frame"]), **points}, data["drive"]["link"], data)


def _shown(chance: Random, own: Reading) -> dict[str, str | list[int]]:
    """Choose the positions whose plans and forces are drawn."""
    positions = own.data["drive"].get("positions", 1)
    count = positions if isinstance(positions, int) else len(positions)
    sure = POSITIONS[:2] if own.data["title"].startswith("Chain") else POSITIONS  # others may be out of reach
    chosen = {key: [k for k in chance.choice(sure) if k < count] for key in ("plans", "forces")}
    return {key: found for key, found in chosen.items() if found}


def _loads(chance: Random, own: Reading) -> Iterator[str]:
    """Write masses, loads, a spring and friction."""
    loaded = [link for link in own.moving if chance.random() < 0.75]
    if loaded:
        yield "[masses]"
        yield from (_mass(chance, own, link) for link in loaded)
    yield "[loads]"
    if chance.random() < 0.7:
        yield f"gravity = {chance.choice(('9.81', '0', '[0, -9.81]', '[3, -9]'))}"
    for _ in range(chance.randint(1, 2)):
        yield from _force(chance, own)
    if chance.random() < 0.4:
        yield from ("[[loads.moments]]", f"on = {chance.choice(own.moving)}", *_moment(chance))
    if chance.random() < 0.3:
        yield from _spring(chance, own)
    if chance.random() < 0.3:
        yield from ("[friction]", f"coefficient = {chance.uniform(0.02, 0.2):.2f}")
        yield f"radius = {chance.choice(('0.005', '0.01', '0.02'))}"


def _mass(chance: Random, own: Reading, link: int) -> str:
    centre = ["", f", centre = [{chance.uniform(-0.3, 0.3):.3f}, {chance.uniform(-0.1, 0.1):.3f}]"]
    if len(own.points[link]) > 1:
        centre += [', centre = "middle"', f', centre = "{chance.choice(own.points[link])}"']
    inertia = chance.choice(("", f", inertia = {chance.uniform(0.01, 1):.3f}"))
    return f"{link} = {{ mass = {chance.uniform(0.1, 20):.2f}{inertia}{chance.choice(centre)} }}"


def _force(chance: Random, own: Reading) -> Iterator[str]:
    link = chance.choice(own.moving)
    value = f"value = {chance.uniform(1, 500):.4g}"
    ways = [
        [f"direction = {chance.uniform(-180, 180):.1f}", value],
        [f"direction = {chance.choice((0, 90, 180, -90))}", value],
        ['against = "motion"', value],
        [f"value = [{chance.uniform(-300, 300):.4g}, {chance.uniform(-300, 300):.4g}]"],
    ]
    if len(own.points[link]) > 1:
        ways.append([f'direction = "{"".join(own.points[link][:2])}"', value])
    yield from (
        "[[loads.forces]]",
        f"on = {link}",
        f'point = "{chance.choice(own.points[link])}"',
        *chance.choice(ways),
    )


def _moment(chance: Random) -> list[str]:
    if chance.random() < 0.5:
        return [f"value = {chance.uniform(-100, 100):.4g}"]
    return [f"value = {chance.uniform(1, 100):.4g}", 'against = "motion"']


def _spring(chance: Random, own: Reading) -> Iterator[str]:
    free = [(link, name) for link in own.moving for name in own.points[link] if name not in own.points[FRAME]]
    link, point = chance.choice(free)
    other = chance.choice(own.points[FRAME])
    yield from ("[[loads.springs]]", f'between = [{{ on = {link}, point = "{point}" }}, "{other}"]')
    yield from (f"stiffness = {chance.uniform(50, 2000):.4g}", f"free = {chance.uniform(0.05, 1):.3f}")

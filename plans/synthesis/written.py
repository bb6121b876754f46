"""The mechanism of a task written as a scene, to be studied like any other (исходные данные найденного механизма)."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from plans.model.synthesis import CrankRocker, SliderCrank
from plans.words.words import message

SPEED = "60 rpm"  # of the crank, which a task does not ask for


def written(made: CrankRocker | SliderCrank, title: str, source: str, language: str) -> str:
    """Write a scene with all digits of the lengths; the crank's speed is left to be changed.

    >>> print(written(SliderCrank(0.06, 0.2, 0.02), "Pump", "task.toml", "en").splitlines()[1])
    title = "Pump"
    """
    said = message("synthesis.written", source=source).worded(language)
    heads = (f"# {said}", *((f"title = {_text(title)}",) if title else ()))
    return "\n".join((*heads, *_mechanism(made), *_drive(language), ""))


def _mechanism(made: CrankRocker | SliderCrank) -> Iterator[str]:
    lengths = {"OA": made.crank}
    if isinstance(made, CrankRocker):
        frame = {"O": (made.pivot.real, made.pivot.imag), "C": (0.0, 0.0)}
        yield from (*_table("frame", {name: _pair(*at) for name, at in frame.items()}), *_links("AB", "CB"))
        lengths |= {"AB": made.coupler, "CB": made.rocker}
    else:
        yield from (*_table("frame", {"O": _pair(0.0, 0.0)}), *_links("AB", "B"))
        yield from ("", "[[mechanism.slides]]", "link = 3")
        yield f"along = {{ through = {_pair(0.0, made.offset)}, angle = 0 }}"
        lengths |= {"AB": made.rod}
    yield from _table("lengths", {name: f"{length!r}" for name, length in lengths.items()})
    yield from _table("sketch", {"B": _pair(*_stretched(made))})


def _stretched(made: CrankRocker | SliderCrank) -> tuple[float, float]:
    """Give about where B is with crank and coupler in one line."""
    if isinstance(made, SliderCrank):
        return made.crank + made.rod, made.offset
    # Seen from C, O is at the left and B1 at the right: the triangle of O, B1 and C by its sides.
    far, frame = made.crank + made.coupler, made.frame
    cosine = (made.rocker**2 + frame**2 - far**2) / (2 * made.rocker * frame)
    way = made.pivot / frame * complex(cosine, -((1 - cosine**2) ** 0.5))
    return made.rocker * way.real, made.rocker * way.imag


def _links(rod: str, last: str) -> Iterator[str]:
    return _table("links", {"1": '"OA"', "2": f'"{rod}"', "3": f'"{last}"'})


def _drive(language: str) -> Iterator[str]:
    yield from ("", "[drive]", "link = 1", f'speed = "{SPEED}"', 'start = "extreme"', "positions = 12")
    yield from ("", "[sheet]", f'language = "{language}"')


def _table(name: str, rows: Mapping[str, str]) -> Iterator[str]:
    yield from ("", f"[mechanism.{name}]", *(f"{key} = {value}" for key, value in rows.items()))


def _pair(x: float, y: float) -> str:
    return f"[{x!r}, {y!r}]"


def _text(text: str) -> str:
    """Write a text as TOML does."""
    return json.dumps(text, ensure_ascii=False)

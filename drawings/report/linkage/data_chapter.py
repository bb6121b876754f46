"""The data of a linkage and its structure, as a note begins with them (исходные данные, структурный анализ)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from functools import partial

import numpy as np

from drawings.lettering.words import number, span
from drawings.page.drafting import drafting_of
from drawings.report.formula import Formula, display, inline
from drawings.report.markdown import chapter, header, row
from plans.linkage.primaries import ram as cylinder
from plans.linkage.study import LinkageStudy
from plans.model.group import Pair
from plans.model.kinetostatics import pairs
from plans.model.mechanism import FRAME, Ram, Slide
from plans.model.structure import formula, mechanism_class
from plans.words.words import Message, message, word

MM = 1000.0  # mm in a metre


def data(study: LinkageStudy) -> Iterator[str]:
    """Tell what the scene gives: links, lengths, fixed points, slides, points by their places, the drive."""
    say, letters = partial(word, study.language), Formula(drafting_of(study.scene))
    yield chapter(study.language, "data")
    yield from header([say("table.link"), say("table.points")])
    for link in study.mechanism.links.values():
        names = ", ".join(f"${letters.line(name)}$" for name in link.points)
        yield row([str(link.number) if link.number != FRAME else say("report.frame"), names])
    yield ""
    yield from _lengths(study, letters)
    yield from _places(study, letters)
    yield from (_slide(study, slide, letters) for slide in study.mechanism.slides)
    drive = study.mechanism.drive
    told = {name: span(drive.unit * np.ravel(rate), study.language) for name, rate in study.rates._asdict().items()}
    yield say("report.drive_way" if drive.pushed else "report.drive", link=drive.link, count=len(study.turn), **told)
    if drive.ram is not None:
        yield _cylinder(study, drive.ram)


def _cylinder(study: LinkageStudy, ram: Ram) -> str:
    """Tell the law of the cylinder that turns the crank."""
    ends = (number(MM * way, study.language) for way in (ram.begin, ram.end))
    v, a = (span(rate, study.language) for rate in cylinder.law(study.mechanism, study.turn.phi))
    parts = {"line": f"{ram.foot}{ram.point}", "stroke": " … ".join(ends), "v": v, "a": a}
    return word(study.language, "report.cylinder", **parts)


def structure(study: LinkageStudy) -> Iterator[str]:
    """Tell links and pairs, mobility by Chebyshev's formula, groups with their class, the formula of structure."""
    mechanism, say = study.mechanism, partial(word, study.language)
    yield chapter(study.language, "structure")
    yield from header([say(f"table.{head}") for head in ("pair", "pair_kind", "point")])
    yield from (_pair(pair, study) for pair in pairs(mechanism, study.groups))
    yield "\n" + say("report.counted_pairs", n=mechanism.moving_links, p=mechanism.lower_pairs) + "\n"
    numbers = rf"3 \cdot {mechanism.moving_links} - 2 \cdot {mechanism.lower_pairs}"
    yield from display(f"W = 3n - 2p_{{5}} - p_{{4}} = {numbers} - 0 = {mechanism.mobility}")
    for group, side in zip(study.groups, study.sweep.sides, strict=True):
        yield say("report.group", group=group.label, joints=group.kind, order=group.order, side=f"{side:+.0f}")
    whole = formula(mechanism, study.groups).replace("->", "→")
    yield say("report.formula", formula=whole, klass=mechanism_class(study.groups))


def _lengths(study: LinkageStudy, letters: Formula) -> Iterator[str]:
    given = study.form.mechanism.lengths
    told = (
        inline(letters.letter(f"l_{{{name}}}"), letters.quantity(MM * float(length), "mm"))
        for name, length in given.items()
    )
    if given:
        yield word(study.language, "report.lengths", lengths=", ".join(told))


def _places(study: LinkageStudy, letters: Formula) -> Iterator[str]:
    """Tell the fixed points, and the points that links have by their places."""
    given = study.form.mechanism
    fixed = (_place(name, place, letters) for name, place in given.frame.items())
    yield word(study.language, "report.fixed_points", points=", ".join(fixed))
    for name, point in given.points.items():
        yield word(study.language, "report.own_point", link=point.on, place=_place(name, point.at, letters))


def _place(name: str, place: tuple[object, object], letters: Formula) -> str:
    return f"${letters.line(name)} {_spot([float(str(part)) for part in place], letters)}$"


def _spot(place: Iterable[float], letters: Formula) -> str:
    x, y = (letters.number(MM * part) for part in place)
    return rf"({x}; {y})\text{{ {letters.drafting.word('mm')}}}"


def _slide(study: LinkageStudy, slide: Slide, letters: Formula) -> str:
    """Say on what a link slides: on a line of two points, or on a line through a place at an angle."""
    if slide.label:
        line = message("report.line_of", owner=slide.owner, line=f"${letters.line(slide.label)}$")
    else:
        line = _line_at_angle(study, slide, letters)
    return word(study.language, "report.slide", link=slide.slider, line=line, point=f"${letters.line(slide.point)}$")


def _line_at_angle(study: LinkageStudy, slide: Slide, letters: Formula) -> Message:
    way, datum, language = slide.on_owner, study.mechanism.datum, study.language
    angle = number(math.degrees(cmath.phase(way.direction)), language)
    if slide.owner != FRAME:
        points = study.mechanism.links[slide.owner].points
        named = next((name for name, spot in points.items() if spot == way.through), None)
        place = letters.line(named) if named else _spot(_parts(way.through), letters)
        return message("report.line_of_link", owner=slide.owner, place=f"${place}$", angle=angle)
    through = way.through + complex(float(datum[0]), float(datum[1]))
    x, y = (number(MM * part, language) for part in _parts(through))
    return message("report.line_through", x=x, y=y, angle=angle)


def _parts(place: complex) -> tuple[float, float]:
    return place.real, place.imag


def _pair(pair: Pair, study: LinkageStudy) -> str:
    kind = "turning_pair" if isinstance(pair.joint, str) else "sliding_pair"
    return row([pair.key, word(study.language, f"report.{kind}"), pair.point])

"""plandraft explain: the drafting steps behind a mark, in order, each with its reason."""

from __future__ import annotations

import argparse
import difflib
import html
import re
from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np

from drawings.commands.on_sheet import OnSheet, equations, standing
from drawings.commands.stderr import noted
from drawings.files.atomic_files import print_json
from drawings.lettering.words import letter, number
from drawings.sheets.kind import sheet_kind
from geometry.board import Arc, Line, Mark, Reading, at, behind
from plans.explanation import Explanation, NoMark, UnknownMark, in_position
from plans.model.motion import FORCES, ORDERS, POSITIONS
from plans.quantity import Quantity
from plans.scene.faults import TWINS
from plans.scene.scene import read_scene
from plans.study import Study
from plans.techniques import techniques
from plans.words.words import ALONE, ENGLISH, Message, languages, message, said, term, word, words, written

DOZEN = 12  # steps that are told at first sight
DIGITS, FULL = 5, 10  # of a number on the screen, and of one in JSON
TOLD = 3  # lines in which a letter stands
UNIT = 1e-12  # by which a direction may be off the length 1
LONG = re.compile(r"-?\d+\.\d{5,}(e[-+]\d+)?")
SIGNS: Final = str.maketrans({"{": "", "}": "", "−": "-", "′": "'"})  # of lettering, and of the names of marks


def run(options: argparse.Namespace) -> int:
    """Print the steps behind a mark at one position; give the exit code."""
    study = Study.of_all(read_scene(options.scene), whole=options.all)
    noted(study)
    explanation = explained(study, options.position, str(options.mark))
    if options.json:
        print_json([_plain(mark, explanation) for mark in explanation.steps])
        return 0
    language, steps = study.scene.sheet.language, explanation.steps
    heading = message("explain.steps", title=explanation.title, count=len(steps)) if steps else explanation.title
    print(heading.worded(language))
    for line in equations(study, steps[-1], options.position) if steps else ():
        print(f"     {letter(language, line)}")
    shown, sheet = frozenset(steps if options.all else nearest(steps)), OnSheet(study, options.position)
    for place, mark in enumerate(steps, 1):
        if mark in shown:
            print(f"{place:>3}. {sentence(mark, explanation, language, sheet)}")
    left_out = (message("explain.earlier", count=len(steps) - len(shown)),) if len(shown) < len(steps) else ()
    for note in (*left_out, *_size_on(sheet, explanation), *explanation.notes):
        parts = {name: _short(letter(language, part)) if isinstance(part, str) else part for name, part in note.parts}
        print(f"     {message(note.key, **parts).worded(language)}")
    return 0


def nearest(steps: Sequence[Mark]) -> list[Mark]:
    """Give the steps that a mark rests on most closely, a dozen with itself; the others tell how these are found."""
    far = {steps[-1]: 0} if steps else {}
    for mark in reversed(steps):
        for source in mark.step.inputs:
            far[source] = min(far.get(source, len(steps)), far.setdefault(mark, 0) + 1)
    order = {mark: -place for place, mark in enumerate(steps)}
    return sorted(steps, key=lambda mark: (far.get(mark, 0), order[mark]))[:DOZEN]


def explained(study: Study, position: int, name: str) -> Explanation:
    """Find a letter in the plans of the techniques of a scene, those that rest on others first, or in their tables."""
    none: list[NoMark] = []
    for letters in (*own_names(name), *_of_sheets(study, position, name)):
        answers = [*_answers(study, position, letters)]
        if isinstance(answers[-1], Explanation):
            asked = message(answers[-1].title.key, **{**dict(answers[-1].title.parts), "mark": name})
            return answers[-1]._replace(title=asked)
        none = none or [answer for answer in reversed(answers) if isinstance(answer, NoMark)]
    found = next((answer for letters in own_names(name) if (answer := _quantity(study, letters))), None)
    if found is not None:
        return _explained(found, name, position)
    of, _, bare = name.rpartition(":")
    if told := standing(study, own_names(bare), of):
        return Explanation(message("explain.name", mark=name), (), {}, tuple(_as_it_stands(study, name, told)))
    raise UnknownMark(_no_mark(name, none))


def _as_it_stands(study: Study, name: str, told: Sequence[str]) -> Iterator[Message]:
    """Tell of a letter that rests on no step what such a letter means, and what sheets and report say of it."""
    names = own_names(name.rpartition(":")[2])
    own = (f"{technique} {letters}" for technique in study.techniques for letters in names)
    keys = [*own, *names, *(letters.rstrip("0123456789") for letters in names), f"{names[0].partition('_')[0]}_"]
    yield from [message(f"letter.{key}") for key in keys if f"letter.{key}" in words(ENGLISH)][:1]
    yield from (message("explain.stands", text=text) for text in told[:TOLD])


def _answers(study: Study, position: int, name: str) -> Iterator[Explanation | NoMark]:
    for technique in reversed(study.techniques):
        answer = techniques()[technique].marks(study, position, name)
        yield answer
        if isinstance(answer, Explanation):
            return


def _of_sheets(study: Study, position: int, name: str) -> Iterator[str]:
    """Give what a letter is on the record that a sheet alone gives, such as the number of an arm."""
    for kind in (sheet_kind(sheet) for row in study.rows for sheet in row.sheets):
        yield from (found for letters in own_names(name) if (found := kind.letters(study, position, letters)))


def own_names(name: str) -> list[str]:
    """Give a letter as it is asked for, then as records and tables may name what a sheet of any language letters so.

    >>> own_names("M_ур"), own_names("F_−II"), own_names("ω3"), own_names("omega_H")
    (['M_ур', 'M_bal'], ['F_−II', 'F_-II'], ['ω3', 'ω_3'], ['omega_H', 'ω_H'])
    """
    indexed = re.sub(r"(?<=[^\W\d_])(?=\d)", "_", name)  # ω3
    head, line, rest = name.partition("_")
    greek = html.unescape(f"&{head};") if line else ""
    spelt = f"{greek}_{rest}" if len(greek) == 1 else name
    found = dict.fromkeys((name, name.translate(SIGNS), name.translate(TWINS), indexed, spelt))
    for lettered, key in _indices():
        index = re.compile(rf"(?<=[_^]){re.escape(lettered)}(?![^\W\d_])")
        found |= dict.fromkeys(index.sub(key, letters) for letters in [*found])
    return [*found]


def _indices() -> Iterator[tuple[str, str]]:
    """Give the indices that a language has letters of its own for, with what records call them."""
    for language in languages():
        letters = {key.removeprefix("index."): str(text) for key, text in words(language).items() if "index." in key}
        letters[ALONE] = word(language, "sheet.counterweight index")
        yield from ((text, key) for key, text in letters.items() if text != key)


def _quantity(study: Study, name: str) -> Quantity | None:
    """Find a quantity that the tables tell, whether or not it was drawn: R_0 of the first cam, K2:R_0 of K2."""
    of, _, letter_only = name.rpartition(":")
    cams = study.comparison("cam").analysis.cams if of and "cam" in study.techniques else ()
    wanted = {name, f"Σ{name}", f"{letter_only} {of}"}
    if [cam.cam.name for cam in cams] == [of]:
        wanted.add(letter_only)
    every = (quantity for row in reversed(study.techniques) for quantity in study.quantities(row))
    listed = [(quantity.name.translate(SIGNS), quantity) for quantity in every]
    exact = (quantity for letters, quantity in listed if letters in wanted)
    return next(exact, next((quantity for letters, quantity in listed if letters.partition(" ")[0] == name), None))


def _explained(quantity: Quantity, name: str, position: int) -> Explanation:
    """Tell a quantity in a position by both roads, after the steps behind what shows it."""
    count = len(quantity.construction)
    if not 0 <= position < count and count > 1:
        raise UnknownMark(message("mark.position", position=position, last=count - 1))
    position = position if count > 1 else 0
    values = (row[position] for row in (quantity.construction, quantity.analysis))
    ours, theirs = (f"{abs(value) if np.iscomplexobj(value) else float(value.real):.10g}" for value in values)
    value = message("explain.roads", mark=name, ours=ours, theirs=theirs, unit=quantity.unit)
    title = message("explain.at", mark=name, position=position) if count > 1 else message("explain.name", mark=name)
    steps = in_position(behind(*quantity.marks), position, count)
    units = {order.plan: order.point.unit for order in ORDERS}
    units |= {} if isinstance(quantity.shown, Reading) else {quantity.plan: quantity.unit}  # that has a unit of its own
    return Explanation(title, steps, units, (value,), POSITIONS.plan)


def _no_mark(name: str, none: Sequence[NoMark]) -> Message:
    near = difflib.get_close_matches(name, [known for answer in none for known in answer.names], 1)
    examples = ", ".join(example for answer in none for example in answer.examples)
    also = (message("mark.also", examples=examples),) if examples else ()
    parts: dict[str, object] = {"mark": name, "listed": (*(answer.listed for answer in none if answer.listed), *also)}
    return message("mark.unknown", **parts) if not near else message("mark.meant", near=near[0], **parts)


def sentence(mark: Mark, of: Explanation, language: str, sheet: OnSheet | None = None) -> str:
    """Say one step: what is drawn, from which marks, where it is, also on the sheet, how sharply it meets, and why."""
    sources = ", ".join(_named(source, of, language) for source in mark.step.inputs)
    text = f"{_named(mark, of, language)}: {term(language, 'op', mark.step.op)}" + (f" ({sources})" if sources else "")
    text += f" = {_value(mark, of, DIGITS).worded(language)}"
    scale = _scale(mark, of, sheet)
    if scale is not None:
        text = word(language, "explain.on_sheet", step=text, place=_reduced(mark, scale))
    if mark.sharpness is not None:
        angle = f"{np.degrees(np.arcsin(min(at(mark.sharpness, 0).real, 1.0))):.2f}"
        text = word(language, "explain.crossing", step=text, angle=angle)
    return f"{text}. {letter(language, said(mark.step.why, language))}" if mark.step.why else text


def _scale(mark: Mark, of: Explanation, sheet: OnSheet | None) -> float | None:
    """Give the scale at which a sheet shows a mark; a direction, of length 1, is not laid off, and a moment neither."""
    direction = not isinstance(mark.value, tuple) and abs(abs(at(mark.point, 0)) - 1) < UNIT
    if sheet is None or direction or mark.is_moment:
        return None
    board = _drawn_on(mark)
    return sheet.scale(board, mark.name, of.units.get(board, ""))


def _reduced(mark: Mark, scale: float) -> Message | str:
    """Tell in mm where a place is, through where a line goes, which radius an arc has."""
    match mark.value:
        case Arc():
            return _written(at(mark.value.radius, 0).real / scale)
        case Line():
            return _pair(at(mark.value.through, 0) / scale, DIGITS)
    return _pair(at(mark.point, 0) / scale, DIGITS)


def _size_on(sheet: OnSheet, of: Explanation) -> Iterator[Message]:
    """Say how long the vector is that was asked for, or that a rate is read off, and how long it is on the sheet."""
    last = of.steps[-1] if of.steps else None
    if last is None or last.subject == of.home or isinstance(last.value, tuple):
        return
    if (scale := _scale(last, of, sheet)) is not None:
        size, read_off = abs(at(last.point, 0)), last.step.op == "join" and last.subject != FORCES
        texts = {"size": _written(size), "mm": _written(size / scale), "unit": of.units[_drawn_on(last)]}
        asked = str(dict(of.title.parts)["mark"])
        product = last.name.startswith(f"{asked}D_")  # a mass is told by its static moment m_1D_1, kg*m
        yield message("explain.size", mark=last.name if read_off or product else asked, **texts)


def _short(part: str) -> str:
    return _written(float(part)) if LONG.fullmatch(part) else part


def _named(mark: Mark, of: Explanation, language: str) -> str:
    name = letter(language, written(term(language, "mark_name", mark.name), language))
    if " " in mark.name and name == mark.name:
        name = " ".join(term(language, "mark_part", part) for part in mark.name.split(" "))
    return name if mark.subject == of.home else f"{name} [{_plan(mark.subject, language)}]"


def _plan(subject: str, language: str) -> str:
    """Word the plan of a mark: lines-II is the plan "lines" of what is called II."""
    plan, _, which = subject.partition("-")
    said = term(language, "plan", subject)
    return said if said != subject or not which else f"{term(language, 'plan', plan)}, {which}"


def _value(mark: Mark, of: Explanation, digits: int) -> Message:
    unit = of.units.get(mark.name, of.units.get(_drawn_on(mark), ""))
    if isinstance(mark.value, Line):
        through, direction = at(mark.value.through, 0), at(mark.value.direction, 0)
        angle = f"{np.degrees(np.angle(direction)) % 180:.2f}"
        return message("explain.line", through=_pair(through, digits), angle=angle)
    if mark.is_moment:
        return _moment(mark, digits)
    if isinstance(mark.value, Arc):
        radius = _written(at(mark.value.radius, 0).real, digits)
        return message("explain.arc", centre=_pair(at(mark.value.centre, 0), digits), radius=radius, unit=unit)
    place = _pair(0j if mark in of.zeros else at(mark.value, 0), digits)
    return message("explain.point", value=place, unit=unit) if unit and not _directs(mark, of) else place


def _directs(mark: Mark, of: Explanation) -> bool:
    """Tell whether a vector of length 1 only gives lines their direction, and so has no unit."""
    uses = {step.step.op for step in of.steps if mark in step.step.inputs}
    return abs(abs(at(mark.point, 0)) - 1) < UNIT and bool(uses) and uses <= {"parallel", "square", "transfer"}


def _moment(mark: Mark, digits: int) -> Message:
    """Tell a moment, and of a force's the arm: the moment over the force."""
    moment = at(mark.point, 0).real + 0.0
    force = abs(at(mark.step.inputs[2].point, 0)) if mark.step.op == "moment" else 0.0
    if digits == DIGITS and abs(moment) <= UNIT * force:  # of no arm but rounding
        moment = 0.0
    if not force:
        return message("explain.moment", moment=_written(moment, digits))
    arm = _written(abs(moment) / force, digits)
    return message("explain.armed", moment=_written(moment, digits), force=_written(force, digits), arm=arm)


def _drawn_on(mark: Mark) -> str:
    """Give the plan on which a mark was drawn: what is carried over keeps its unit."""
    while mark.step.op == "transfer":
        (mark,) = mark.step.inputs
    return mark.subject


def _written(value: float, digits: int = DIGITS) -> str:
    return f"{value:.10g}" if digits == FULL else number(value, digits=digits).replace("−", "-")


def _pair(value: complex, digits: int) -> Message:
    least = UNIT * max(abs(value), 1.0) if digits == DIGITS else 0.0  # what is less is rounding
    x, y = (_written(0.0 if abs(part) <= least else part + 0.0, digits) for part in (value.real, value.imag))
    return message("explain.pair", x=x, y=y)


def _plain(mark: Mark, of: Explanation) -> dict[str, object]:
    return {
        "plan": mark.subject,
        "name": mark.name,
        "op": mark.step.op,
        "from": [source.name for source in mark.step.inputs],
        "value": str(_value(mark, of, FULL)),
        "why": str(mark.step.why),
    }

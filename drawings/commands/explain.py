"""plandraft explain: the drafting steps behind a mark, in order, each with its reason."""

from __future__ import annotations

import argparse
import difflib
from collections.abc import Mapping, Sequence

import numpy as np

from drawings.commands.talk import noted
from drawings.files.json_text import print_json
from geometry.board import Arc, Line, Mark, at
from geometry.precision import condition
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.scene.scene import read_scene
from plans.study import Study
from plans.techniques import TECHNIQUES, named


def run(options: argparse.Namespace) -> int:
    """Print the steps behind a mark at one position; give the exit code."""
    study = Study.of_all(read_scene(options.scene), whole=options.all)
    noted(study)
    explanation = explained(study, options.position, options.mark)
    if options.json:
        print_json([_plain(mark, explanation.units) for mark in explanation.steps])
        return 0
    print(f"{explanation.title}, {len(explanation.steps)} steps")
    for number, mark in enumerate(explanation.steps, 1):
        print(f"{number:>3}. {sentence(mark, explanation.units)}")
    for note in explanation.notes:
        print(f"     {note}")
    return 0


def explained(study: Study, position: int, name: str) -> Explanation:
    """Find a mark in the plans of the techniques of a scene, those that rest on others first."""
    none: list[NoMark] = []
    for technique in reversed(study.techniques):
        answer = named(TECHNIQUES[technique].marks)(study, position, name)
        if isinstance(answer, Explanation):
            return answer
        none.insert(0, answer)
    raise UnknownMark(_no_mark(name, none))


def _no_mark(name: str, none: Sequence[NoMark]) -> str:
    """Say which marks there are, and which of them may have been meant."""
    near = difflib.get_close_matches(name, [known for one in none for known in one.names], 1)
    hint = f"did you mean {near[0]}? " if near else ""
    listed = "; ".join(one.listed for one in none if one.listed)
    examples = ", ".join(example for one in none for example in one.examples)
    return f"no mark is named {name}: {hint}{listed}; also {examples}"


def sentence(mark: Mark, units: Mapping[str, str]) -> str:
    """Say one step: what is drawn, from which marks, where it is, how sharply it meets, and why."""
    sources = ", ".join(_named(source) for source in mark.step.inputs)
    text = f"{_named(mark)}: {mark.step.op}" + (f" ({sources})" if sources else "") + f" = {_value(mark, units)}"
    if mark.sharpness is not None:
        text += f", crossing at {np.degrees(np.arcsin(min(at(mark.sharpness, 0).real, 1.0))):.2f}°"
        text += f" (kappa {float(condition(mark).flat[0]):.3g})"
    return f"{text}. {mark.step.why}" if mark.step.why else text


def _named(mark: Mark) -> str:
    return f"{mark.name} [{mark.subject}]" if mark.subject != "positions" else mark.name


def _value(mark: Mark, units: Mapping[str, str]) -> str:
    unit = units.get(_drawn_on(mark), "")
    if isinstance(mark.value, Line):
        return f"line through {_pair(at(mark.value.through, 0))}, direction {_pair(at(mark.value.direction, 0))}"
    if mark.is_moment:
        return f"{at(mark.point, 0).real + 0.0:.10g} N*m{_armed(mark)}"
    if isinstance(mark.value, Arc):
        return f"arc about {_pair(at(mark.value.centre, 0))}, radius {at(mark.value.radius, 0).real:.10g} {unit}"
    return f"{_pair(at(mark.value, 0))} {unit}"


def _armed(mark: Mark) -> str:
    """Tell the arm of a force's moment: the moment over the force."""
    if mark.step.op != "moment":
        return ""
    force, moment = abs(at(mark.step.inputs[2].point, 0)), abs(at(mark.point, 0))
    return f" ({force:.6g} N with an arm of {moment / force:.6g} m)" if force else ""


def _drawn_on(mark: Mark) -> str:
    """Give the plan on which a mark was drawn: what is carried over keeps its unit."""
    while mark.step.op == "transfer":
        (mark,) = mark.step.inputs
    return mark.subject


def _pair(value: complex) -> str:
    return f"({value.real + 0.0:.10g}, {value.imag + 0.0:.10g})"


def _plain(mark: Mark, units: Mapping[str, str]) -> dict[str, object]:
    return {
        "plan": mark.subject,
        "name": mark.name,
        "op": mark.step.op,
        "from": [source.name for source in mark.step.inputs],
        "value": _value(mark, units),
        "why": mark.step.why,
    }

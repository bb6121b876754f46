"""What the sheets show of a mark: its length at the scale of its figure, and the vector equation that it solves."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import chain
from typing import NamedTuple

from drawings.lettering.words import letter, with_index
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import groups
from drawings.paper.walk import texts as lettering
from drawings.report.formula import unmathed
from drawings.report.report import lines, report_of
from drawings.sheets.documents import leaves_of
from geometry.board import Mark
from geometry.errors import DraftError
from plans.study import Study


class DrawnMark(NamedTuple):
    """A vector or a point as a sheet has it: its figure, name and position, the scale in true units a mm, the unit."""

    figure: str
    name: str
    position: str
    scale: float
    unit: str


@lru_cache(maxsize=1)
def laid_out(study: Study) -> Mapping[str, Sequence[Leaf]]:
    """Give the sheets of a study's scene; none where they cannot be drawn."""
    try:
        return leaves_of(Study(study.scene))
    except DraftError:
        return {}


def standing(study: Study, names: Iterable[str], cam: str = "") -> list[str]:
    """Give what sheets, of one cam where it is named, and report say of a letter: its value, else where it stands."""
    bare = (re.sub("[{}]", "", name) for name in names)
    both = (lettered for name in bare for lettered in (name, letter(study.scene.sheet.language, name)))
    plain = {Text(0j, with_index(lettered)).plain for lettered in both}
    pattern = re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, plain))})(?![\w'′])(\s*[=≈])?")
    leaves = laid_out(study)
    shown = [leaf for leaf in chain(*leaves.values()) if not cam or leaf.metadata.get("cam") == cam]
    texts = [levelled(text) for leaf in shown for text in lettering(leaf.groups)]
    texts += [unmathed(line) for line in (lines(Study(study.scene), leaves) if leaves else ())]
    found = [(match, " ".join(text.split())) for text in texts if (match := pattern.search(NOT_READ.sub("", text)))]
    told = [text for match, text in found if match[1]] or [text for _, text in found]
    return list(dict.fromkeys(re.sub(r"\\[lr]vert", "|", text).replace("$", "").lstrip("- ") for text in told))


NOT_READ = re.compile(r"[{}_^$*`]|\\[a-z]+")  # of lettering, as it is read aloud


def levelled(text: Text) -> str:
    """Write lettering on a line, its levels by their signs: J_S3."""
    return "".join(("_" if run.level < 0 else "^" if run.level > 0 else "") + run.text for run in text.runs)


class OnSheet:
    """The figures of a scene's sheets, by which lengths of a record are told in mm."""

    def __init__(self, study: Study, position: int) -> None:
        self.drawn = [*_drawn(leaf for group in laid_out(study).values() for leaf in group)]
        self.position = str(position)

    def scale(self, board: str, name: str, unit: str) -> float | None:
        """Give the scale of the figure that shows a mark of a board: of its name, or of the cut that it is a corner of.

        Where figures of one board differ and the mark is in none by its name, it has none.
        """
        figures = [mark for mark in self.drawn if mark.figure == board or mark.figure.startswith(f"{board}-")]
        here = [mark for mark in figures if mark.position == self.position] or figures
        named = [mark for mark in here if mark.name == name]
        cut = [mark for mark in here if mark.figure == f"{board}-{name.partition(':')[0]}"]
        found = {(mark.scale, mark.unit) for mark in named or cut or here}
        return next(iter(found))[0] if len(found) == 1 and {unit} == {text for _, text in found} else None


def _drawn(leaves: Iterable[Leaf]) -> Iterator[DrawnMark]:
    for data in (group.data for leaf in leaves for group in groups(leaf.groups)):
        if "plan" in data and "scale" in data:
            name, position, unit = (data.get(key, "") for key in ("name", "position", "unit"))
            yield DrawnMark(data["plan"], name, position, float(data["scale"]), unit)


def equations(study: Study, mark: Mark, position: int) -> list[str]:
    """Write the equations that give a mark: those of its technique, or else the sum of its polygon."""
    lines = [line for name in study.techniques for line in report_of(name).equations(study, mark, position)]
    return [unmathed(line) for line in lines] or [*_polygon(mark)]


def _polygon(mark: Mark) -> Iterator[str]:
    """Write the sum of vectors laid end to end that a mark ends or closes."""
    while mark.step.op == "turn" and mark.step.inputs[0].step.op in ("join", "turn"):
        mark = mark.step.inputs[0]
    end, terms = mark.step.inputs[0] if mark.step.op == "join" else mark, list[str]()
    while end.step.op == "lay_off":
        end, side = end.step.inputs
        terms.insert(0, side.name)
    if mark.step.op == "close":
        terms = [side.name for side in mark.step.inputs]
    if len(terms) > 1:
        closed = mark.step.op in ("close", "join")
        text = f"{' + '.join([*terms, mark.name])} = 0" if closed else f"{mark.name} = {' + '.join(terms)}"
        yield text.replace("+ -", "− ")

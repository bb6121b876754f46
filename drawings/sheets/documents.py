"""Documents of a set (документы комплекта): sheets of one designation are numbered and counted through (ГОСТ 2.104)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from drawings import VERSION
from drawings.lettering.lettering import UnknownLetter, demand
from drawings.page.blocks.form1 import short_date
from drawings.page.frame import NUMBERS
from drawings.page.page import BLOCK, EXTRA, Page, page_of
from drawings.paper.hand import SIZES
from drawings.paper.strokes import Group, Leaf, Run, SheetError, Stroke, Text
from drawings.paper.walk import groups, texts
from drawings.reading.seal import digest
from drawings.sheets.kind import sheet_kind
from plans.scene.faults import Fault, Path, SceneError
from plans.scene.scene import Scene
from plans.study import Study
from plans.words.words import Message, message, placed

CELLS = ("designation", "drawn", "checked", "approved", "date", "group", "organisation")


def of_title(scene: Scene) -> None:
    """See that the title block can be lettered."""
    cells = ((("sheet", cell), getattr(scene.sheet, cell)) for cell in CELLS)
    table = scene.sheet.designations
    documents = ((("sheet", "designations", kind), getattr(table, kind)) for kind in table.keys)
    letter(scene, [(("title",), scene.title), *cells, *documents])


def of_scales(scene: Scene) -> None:
    """See that the sheets draw figures of each scale that the scene states."""
    known = {key for kind in scene.sheets for key in sheet_kind(kind).scales.values()}
    for name, _ in scene.sheet.scale.stated:
        if name not in known:
            raise unknown(scene, name)


def unknown(scene: Scene, name: str) -> SheetError:
    """Refuse a scale that no figure of a scene's sheets has, with those that some has."""
    keys = dict.fromkeys(key for kind in scene.sheets for key in sheet_kind(kind).scales.values() if key != name)
    return SheetError(of_scale(scene, name, message("refused.scale_unknown", name=name, names=tuple(keys))))


def of_scale(scene: Scene, name: str, said: Message) -> Message:
    """Say something of a key of [sheet.scale] at its place."""
    line, column = scene.place(("sheet", "scale", name))
    return placed(f"{scene.file}:{line}:{column}", said)


def letter(scene: Scene, words: Iterator[tuple[Path, str]] | list[tuple[Path, str]]) -> None:
    """See that the alphabet has all letters of what the scene's author wrote, each with its key."""
    for path, text in words:
        try:
            demand([Text(0j, (Run(text),))])
        except UnknownLetter as unknown:
            line, column = scene.place(path)
            where = f"{scene.file}:{line}:{column}: {'.'.join(map(str, path))}"
            raise SheetError(placed(where, unknown.args[0])) from None


Leaves = Mapping[str, Sequence[Leaf]]


def bind(leaves: Leaves, scene: Scene) -> Leaves:
    """Number the sheets of a scene, in the order of its kinds, through each document that they make up."""
    designations = {kind: scene.sheet.designated(kind) for kind in leaves}
    counts = Counter(designations[kind] for kind, group in leaves.items() for _ in group)
    found: dict[str, tuple[Leaf, ...]] = {}
    for kind, group in leaves.items():
        name = designations[kind]
        first = 1 + sum(len(other) for before, other in found.items() if designations[before] == name)
        found[kind] = tuple(
            _numbered(leaf, _page(leaf, scene, kind), first + k, counts[name]) for k, leaf in enumerate(group)
        )
    return found


def _page(leaf: Leaf, scene: Scene, kind: str) -> Page:
    """Give the page of a leaf, which may be of a smaller format than the scene's."""
    size = {round(leaf.width, 3), round(leaf.height, 3)}
    name = next(name for name, sides in SIZES.items() if set(sides) == size)
    return page_of(scene.changed(sheet=scene.sheet.changed(format=name)), kind)


def cuts(leaves: Leaves, scene: Scene) -> Iterator[Fault]:
    """Tell once what the author wrote that a title block has no room for; a designation that is cut is refused."""
    known: set[Path] = set()
    for kind, group in leaves.items():
        named, others = _designation(scene, kind), [(("title",), scene.title), *_names(scene)]
        for leaf in group[:1]:  # the others have the same
            shown = min(_shown(named[1], place) for place in (*_lettering(leaf, BLOCK), *_lettering(leaf, EXTRA)))
            if shown < len(named[1]):
                raise SceneError([scene.fault(named[0], "designation", count=shown)])
            for path, text in others:
                shown = min(_shown(text, place) for place in _lettering(leaf, BLOCK))
                if shown < len(text) and path not in known:
                    known.add(path)
                    yield scene.fault(path, "cut", count=shown)


def _designation(scene: Scene, kind: str) -> tuple[Path, str]:
    path: Path = ("sheet", "designations", kind)
    return path if scene.has(path) else ("sheet", "designation"), scene.sheet.designated(kind)


def _names(scene: Scene) -> Iterator[tuple[Path, str]]:
    """Give what else the author wrote for the title block, by its key, but a date that its form may write shorter."""
    yield from ((("sheet", cell), text) for cell in CELLS[1:] if short_date(text := getattr(scene.sheet, cell)) == text)


def _lettering(leaf: Leaf, name: str) -> Iterator[str]:
    """Read the lettering of a group of a sheet in one line, without spaces."""
    for group in groups(leaf.groups):
        if group.name == name:
            yield "".join(text.plain for text in texts(group.strokes)).replace(" ", "")


def _shown(text: str, place: str) -> int:
    """Count the letters of a text that are there, from its beginning."""
    return next((k for k in range(len(text), 0, -1) if text[:k].replace(" ", "") in place), 0)


def _numbered(leaf: Leaf, page: Page, sheet: int, sheets: int) -> Leaf:
    """Write the number of a sheet and how many its document has into its title block, and into its data."""
    numbers = page.numbers(sheet, sheets)
    groups = tuple(_filled(group, numbers) if group.name == BLOCK else group for group in leaf.groups)
    document = {"designation": page.designation, "sheet": sheet, "sheets": sheets}
    return leaf._replace(groups=groups, metadata={**leaf.metadata, "document": document})


def _filled(block: Group, numbers: Group) -> Group:
    strokes: list[Stroke] = [
        numbers if isinstance(stroke, Group) and stroke.name == NUMBERS else stroke for stroke in block.strokes
    ]
    return block._replace(strokes=tuple(strokes))


def leaves_of(study: Study) -> Mapping[str, Sequence[Leaf]]:
    """Lay out the sheets of a study, by kind; the data of each say of which scene it is, and of which version."""
    scene = study.scene
    leaves = bind({kind: sheet_kind(kind).leaves(study) for kind in scene.sheets}, scene)
    return {kind: tuple(_signed(leaf, scene) for leaf in group) for kind, group in leaves.items()}


def _signed(leaf: Leaf, scene: Scene) -> Leaf:
    return leaf._replace(metadata={**leaf.metadata, "scene": digest(scene.content), "plandraft": VERSION})

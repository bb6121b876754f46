"""The scene (исходные данные): one TOML file as a frozen value; every fault names file, line, key and advice."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import partial
from pathlib import Path as FilePath
from typing import Any, NamedTuple, Protocol, TypeVar

from geometry.errors import LimitError
from plans.scene import fields as f
from plans.scene.faults import Fault, Path, SceneError
from plans.scene.forms import SHEETS, first_sheet, techniques_of, with_sheets_named
from plans.scene.readers import Refusal, Refused, many
from plans.scene.sheet import SheetTable
from plans.scene.source import Source, parse_source, read_source
from plans.scene.tables import REQUIRED, Kinds, Table, key, read_parts, table
from plans.techniques import TECHNIQUES, name_of, techniques
from plans.words.words import ENGLISH, placed, term


class TechniqueForm(Table):
    """What a scene says of one technique: its own tables, and its keys of tables that it shares."""

    def fit(self, scene: Scene) -> None:
        """See that the scene stays within the limits of the technique."""

    def borrowed(self) -> Iterable[str]:
        """Give the names that its tables use of the tables of others."""
        return ()

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive, which a drive over a stroke has not."""
        return False


F = TypeVar("F", bound=TechniqueForm)


class Scene(Table):
    """What the user asked for: the sheets wanted, and what each technique that they need is told."""

    title: str = key(f.TEXT, "", meaning="Title of the sheet and the report; default: a word for what is drawn.")
    sheets: tuple[str, ...] = key(
        many(f.words(*SHEETS, kind="sheet_name"), f.NOT_EMPTY, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="The sheets that are wanted; default: the first that the tables of the file allow.",
    )
    sheet: SheetTable = key(
        table(SheetTable), SheetTable(), meaning="What stands on the sheet: language, format, positions, title block."
    )
    techniques: tuple[str, ...]  # that it has a part in
    _source: Source
    _forms: Mapping[type[Table], TechniqueForm]

    @property
    def file(self) -> str:
        """The name of the file."""
        return self._source.file

    @property
    def content(self) -> bytes:
        """The bytes of the file."""
        return self._source.content

    @property
    def read_as(self) -> Iterable[Fault]:
        """What of the file was left aside, or read as what it looks like."""
        return self._source.notes()

    @property
    def forms(self) -> Iterable[TechniqueForm]:
        """What it says of each technique that it has a part in."""
        return self._forms.values()

    @property
    def meaning(self) -> Meaning:
        """What it means, examined once."""
        found: Meaning = vars(self).setdefault("_meaning", Meaning(self))
        return found

    def of(self, kind: type[F]) -> F:
        """Give what it says of a technique; of one that needs no table of its own also where it says nothing."""
        found = self._forms.get(kind)
        if isinstance(found, kind):
            return found
        missing = [name for name, known in kind.keys.items() if known.default is REQUIRED]
        if missing:
            from plans.scene.refusal import lacking  # noqa: PLC0415  (only a refused scene pays for it)

            raise SceneError([lacking((), missing, self._source, (kind,))])
        return kind()

    def part(self, technique: str) -> TechniqueForm | None:
        """Give what it says of a technique by its name, nothing where it has no part in it; imports nothing."""
        return next((form for form in self.forms if name_of(form) == technique), None)

    def changed(self, *forms: TechniqueForm, **values: Any) -> Scene:
        """Give the scene with other values, which are not checked again."""
        found = copy(self)
        vars(found).update(values, _forms=dict(self._forms) | {type(form): form for form in forms})
        vars(found).pop("_meaning", None)
        return found

    def place(self, path: Path) -> tuple[int, int]:
        """Give line and column of a key."""
        return self._source.place(path)

    def has(self, path: Path) -> bool:
        """Tell whether the file has a key, given as the keys that lead to it."""
        found: Any = self._source.tables
        for name in path:
            if not isinstance(found, dict) or name not in found:
                return False
            found = found[name]
        return True

    def heading(self, language: str = ENGLISH) -> str:
        """Give its title; of one without, the word of a language for its first technique."""
        return self.title or term(language, "untitled", self.techniques[0])

    def fault(self, path: Path, kind: str, /, **details: object) -> Fault:
        """Make a fault at a key of this scene."""
        return self._source.fault(path, kind, **details)


class Survey(Protocol):
    """What the examination of a technique's part of a scene found."""

    @property
    def faults(self) -> Sequence[Fault]: ...  # noqa: D102


class Sound(NamedTuple):
    """That a part is without faults once its form is."""

    faults: tuple[Fault, ...] = ()


V = TypeVar("V")


class Meaning:
    """The meaning of a scene: the survey of each technique, made on first demand; of `doubts` nothing more is said."""

    def __init__(self, scene: Scene, doubts: frozenset[Path] = frozenset()) -> None:
        self.scene, self.doubts = scene, doubts
        self._surveys: dict[str, Survey] = {}

    def __getitem__(self, technique: str) -> Survey:
        if technique not in self._surveys:
            self._surveys[technique] = techniques()[technique].survey(self)
        return self._surveys[technique]

    def of(self, kind: type[V]) -> V:
        """Give the survey of a technique's part by its kind."""
        found = self[name_of(kind)]
        assert isinstance(found, kind)  # it is made in the folder of the technique
        return found

    @property
    def faults(self) -> list[Fault]:
        """The faults in the meaning of all parts."""
        return [fault for technique in self.scene.techniques for fault in self[technique].faults]


def kinds_of(names: Iterable[str] = TECHNIQUES) -> Kinds:
    """Give the tables at the top of a file: the scene's own keys, and the forms of some techniques, or of all."""
    known = techniques()
    return Scene, *(known[name].form() for name in names)


def read_scene(path: FilePath) -> Scene:
    """Read a scene file; all its faults together are one SceneError."""
    return _scene(read_source(path))


def parse_scene(text: str, file: str = "scene.toml") -> Scene:
    """Read a scene from its text; `file` is the name that faults give."""
    return _scene(parse_source(text, file))


def _scene(source: Source) -> Scene:
    source = replace(source, tables=with_sheets_named(source.tables))
    try:
        scene = _read(source, source.tables)
        for form in reversed([*scene.forms]):
            form.fit(scene)
        return scene
    except Refused as error:
        raise _refused(error, source) from None
    except LimitError as error:
        raise LimitError(placed(source.file, error.args[0])) from None


def _refused(error: Refused, source: Source) -> SceneError:
    """Word all that a file's form refuses, and what is wrong in the meaning of the rest."""
    from plans.scene.refusal import REFUSALS_LIMIT, doubts_of, refusals, spare  # noqa: PLC0415  (only it pays)

    faults = refusals(error, source, kinds_of())
    unlisted = max(0, len(error.refusals) - REFUSALS_LIMIT)
    rest = None if unlisted else spare(source, partial(_read, source), kinds_of())
    meaning = Meaning(rest, doubts_of(faults)).faults if rest else []
    settled = {path for fault in meaning for path in fault.settles}
    return SceneError([*(fault for fault in faults if fault.path not in settled), *meaning], unlisted)


def _read(source: Source, data: Mapping[str, Any]) -> Scene:
    """Read the keys of a file as the scene's own and those of the techniques that it has a part in."""
    asked = techniques_of(data)
    tables = ", ".join(f"[{name}]" for technique in techniques().values() for name in technique.tables)
    empty = [] if asked else [Refusal((), "no_table", {"tables": tables}, data)]
    scene, *forms = read_parts(kinds_of(asked), data, *empty).values()
    assert isinstance(scene, Scene)
    vars(scene).update(_source=source, techniques=asked, _forms={type(form): form for form in forms})
    vars(scene).update({} if scene.sheets else {"sheets": first_sheet(data)})
    for name in asked:
        scene = techniques()[name].completed(scene)
    return scene

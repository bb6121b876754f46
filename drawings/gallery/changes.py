"""What a change of the program makes of the gallery: alike or not, told by statement, listed with its reason."""

from __future__ import annotations

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from decimal import Decimal
from itertools import islice, zip_longest
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as ET

from drawings.files import atomic_files
from drawings.files.sheet_set import SUFFIX, digest_of
from drawings.reading.sheet import see
from drawings.sheet_diff.collate import collate
from drawings.sheet_diff.edit import Edit

WITHIN = 0.002  # mm: far under what is seen, and over the last digit of a stroke
ROUNDED = 1e-9  # of the largest: a value that a mark states has 12 digits
LAST = 2  # places of the last digit, of a number of a report
LONG = 6  # digits of a whole number that may be rounded in its last one; a shorter one counts, or numbers a position
NUMBER = re.compile(r"-?(?:\d+(?:[.,]\d+)?|\.\d+)(?:e[+-]\d+)?")
GEOMETRY = frozenset({"d", "cx", "cy", "r", "stroke-dasharray", "data-deviation"})
WORDS = frozenset({"data-text", "data-name", "id", "class"})
# Of a report, what measures rounding itself.
ROUNDINGS = re.compile(r"^## (?:Comparison|Сравнение).*?(?=^## )|^- .*DOP853.*?$", re.MULTILINE | re.DOTALL)


def differences(fresh: Path, kept: Path) -> Iterator[str]:
    """Tell what differs: of a sheet its elements in their order, of a report or a table its words and numbers."""
    if not kept.exists():
        yield f"{kept.name}: came"
        return
    compare = _of_sheets if kept.suffix == ".svg" else _of_words
    yield from (f"{kept.name}: {change}" for change in compare(fresh.read_text("utf-8"), kept.read_text("utf-8")))


def _of_sheets(fresh: str, kept: str) -> Iterator[str]:
    elements = (ET.fromstring(text.encode()).iter() for text in (fresh, kept))
    for place, (new, old) in enumerate(zip_longest(*elements)):
        if new is None or old is None or new.tag != old.tag or new.keys() != old.keys():
            yield f"element {place} is another one"
            return
        if new.get("id") != "seal" and (new.text, new.tail) != (old.text, old.tail):
            yield f"words of element {place}: {old.text!r} -> {new.text!r}"
        for key, value in old.items():
            if not _agree(key, new.attrib[key], value):
                yield f"{key} of element {place}: {value} -> {new.attrib[key]}"


def _agree(key: str, new: str, old: str) -> bool:
    if new == old:
        return True
    if key in WORDS or NUMBER.sub("#", new) != NUMBER.sub("#", old):
        return False
    ours, theirs = ([float(number.replace(",", ".")) for number in NUMBER.findall(text)] for text in (new, old))
    within = WITHIN if key in GEOMETRY else ROUNDED * max(map(abs, theirs))
    return all(abs(a - b) <= within for a, b in zip(ours, theirs, strict=True))


def _of_words(fresh: str, kept: str) -> Iterator[str]:
    ours, theirs = (ROUNDINGS.sub("", text).splitlines() for text in (fresh, kept))
    for new, old in zip_longest(ours, theirs, fillvalue=""):
        if new != old and not (NUMBER.sub("#", new) == NUMBER.sub("#", old) and _near(new, old)):
            yield f"{old} -> {new}"


def _near(new: str, old: str) -> bool:
    pairs = zip(NUMBER.findall(new), NUMBER.findall(old), strict=True)
    return all(new == old if new.isdigit() and len(new) < LONG else _off(new, old) <= LAST for new, old in pairs)


def _off(new: str, old: str) -> Decimal:
    """Tell how many places of the last digit two numbers are apart."""
    a, b = (Decimal(number.replace(",", ".")) for number in (new, old))
    return abs(a - b).scaleb(-min(int(a.as_tuple().exponent), int(b.as_tuple().exponent)))


LIST = "renewals.json"
ALPHABET = "alphabet.svg"


class Renewal(NamedTuple):
    """What a set came out as, and why."""

    digest: str
    because: str


def listed(folder: Path) -> dict[str, Renewal]:
    """Read the list of a gallery; a gallery without one has listed nothing."""
    path = folder / LIST
    plain = json.loads(path.read_text("utf-8")) if path.exists() else {}
    return {name: Renewal(*row) for name, row in plain.items()}


def there(folder: Path) -> dict[str, str]:
    """Give the checksums of the manifests of all sets, which have those of all files, and of the alphabet."""
    paths = sorted((*folder.glob(f"*{SUFFIX}"), *folder.glob(ALPHABET)))
    return {path.name: str(digest_of(path)) for path in paths}


def unlisted(folder: Path) -> list[str]:
    """Name the sets that are not as the list has them, and those that are listed and gone."""
    known, found = listed(folder), there(folder)
    same = {name for name in known if found.get(name) == known[name].digest}
    return sorted({*known, *found} - same)


def enter(folder: Path, because: str) -> None:
    """List what is not listed, with its reason, one set a line."""
    known: Mapping[str, Renewal] = listed(folder)
    rows = {
        name: known[name] if name in known and known[name].digest == digest else Renewal(digest, because)
        for name, digest in there(folder).items()
    }
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(row, ensure_ascii=False)}" for name, row in rows.items())
    atomic_files.write(folder / LIST, f"{{\n{lines}\n}}\n".encode())


STATED = frozenset(
    (
        "letter",
        "cell",
        "heading",
        "equation",
        "note",
        "title_cell",
        "vector",
        "point",
        "pole",
        "profile",
        "arrow",
        "couple",
    )
)
CARRIED = frozenset(("cell", "heading", "equation", "note", "title_cell"))  # that move with all around them
CHANGES = {"missing": "went", "added": "came", "text": "{must} -> {is_}"}
LINES = 20  # that are told of a report


def changes(fresh: Path, kept: Path) -> list[str]:
    """Tell what a drawn file says otherwise than the kept one; nothing of what processors round otherwise."""
    others = list(islice(differences(fresh, kept), LINES))
    if not others or kept.suffix != ".svg" or not kept.exists():
        return others
    ours, theirs = (see(path.read_bytes()).written for path in (kept, fresh))
    found = collate(ours, theirs)
    lines = (*map(str, found.whole), *statements(found.edits))
    return [f"{kept.name}: {statement}" for statement in lines] or [f"{others[0]}; nothing that is seen"]


def statements(edits: Iterable[Edit]) -> Iterator[str]:
    """Tell each statement that changed in a line, and what else moved, came or went in a line a figure."""
    strokes: dict[str, list[Edit]] = defaultdict(list)
    for edit in edits:
        if edit.what in STATED and not (edit.moved is not None and edit.what in CARRIED):
            yield f"{edit.what} {edit.name} on {edit.figure or 'the sheet'}: {_change(edit)}"
        else:
            strokes[edit.figure].append(edit)
    for figure, stroke in strokes.items():
        yield f"strokes of {figure or 'the sheet'}: {_counts(stroke)}"


def _change(edit: Edit) -> str:
    """Name what came of a statement."""
    if edit.moved is not None:
        return f"{edit.how} by {edit.moved:.3g} mm"
    return CHANGES[edit.how].format(**dict(edit.told.parts)) if edit.how in CHANGES else str(edit.told)


def _counts(edits: Iterable[Edit]) -> str:
    """Count strokes by what came of them, with how far the farthest moved."""
    found: dict[str, list[Edit]] = defaultdict(list)
    for edit in edits:
        found["went" if edit.how == "missing" else "came" if edit.how == "added" else edit.how].append(edit)
    return ", ".join(f"{sum(edit.strokes for edit in some)} {how}{_farthest(some)}" for how, some in found.items())


def _farthest(edits: Iterable[Edit]) -> str:
    moved = [edit.moved for edit in edits if edit.moved is not None]
    return f" by up to {max(moved):.3g} mm" if moved else ""

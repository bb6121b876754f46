"""Fuzzing of `check` and `measure`: `python -m tests.fuzz_sheets --seconds 600`.

Written sheets are changed at random in their bytes, elements and attributes. Whatever they are then, both commands must
end as the README says: a verdict or one message, and no exception of any other kind. `--seed 7` begins elsewhere.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import sys
import time
import traceback
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from xml.etree import ElementTree

from drawings.commands import cli
from drawings.commands.check import lines, plain
from drawings.files.json_text import json_text
from drawings.original.originals import Originals
from drawings.original.sheet_check import check
from tests.forgeries.file_edits import body_of, sealed_anew

GALLERY = Path(__file__).parents[1] / "drawings" / "gallery"
SCENES = ("fan", "crank-rocker", "shaper-feed", "engine-share", "valve-cam", "slider-crank")
MEASURED = {0, 3, 5, 7, 8}
SVG = "http://www.w3.org/2000/svg"

NASTY = (
    "",
    " ",
    "NaN",
    "inf",
    "-inf",
    "1e999",
    "-1e308",
    "1e-320",
    "0",
    "-0",
    "9" * 99,
    "9" * 101,
    "0x10",
    "1,5",
    "1;5",
    "%",
    "100%",
    "none",
    "url(#x)",
    "url(http://x/)",
    "translate(1e300)",
    "matrix(0 0 0 0 0 0)",
    "rotate(",
    "scale(0)",
    "#fff",
    "#ffff",
    "rgba(0,0,0,0)",
    "M",
    "M0 0",
    "M0 0L",
    "M0 0A0 0 0 0 0 1 1",
    "M1 1A1e9 1e-9 0 2 1 1e9 0z",
    "mzzz",
    "M0 0Q1 1",
    "M0 0H1V2S1 1 2 2T1 1",
    "vector",
    "point",
    "pole",
    "corner",
    "profile",
    "force",
    "couple",
    "٣",
    "𝟙",
    "\ufffd",
    "a" * 5000,
    "1 2 3",
    "{}",
    "[]",
    '{"sheet": 7}',
    '{"rows": 5, "plandraft": [], "scene": {}}',
    "null",
    "-1",
    "2.5",
    "\u202e",
    "é",
)
NAMES = (
    "d",
    "x1",
    "y1",
    "x2",
    "y2",
    "cx",
    "cy",
    "r",
    "rx",
    "x",
    "y",
    "width",
    "height",
    "points",
    "transform",
    "style",
    "fill",
    "stroke",
    "stroke-width",
    "stroke-dasharray",
    "stroke-linecap",
    "opacity",
    "display",
    "visibility",
    "clip-path",
    "mask",
    "filter",
    "id",
    "class",
    "viewBox",
    "preserveAspectRatio",
    "data-kind",
    "data-plan",
    "data-name",
    "data-value",
    "data-scale",
    "data-unit",
    "data-position",
    "data-text",
    "font-size",
    "text-anchor",
    "textLength",
)
TAGS = (
    "g",
    "path",
    "line",
    "circle",
    "ellipse",
    "rect",
    "polyline",
    "polygon",
    "text",
    "tspan",
    "use",
    "image",
    "svg",
    "defs",
    "clipPath",
    "style",
    "script",
    "metadata",
    "title",
    "desc",
    "animate",
    "switch",
    "symbol",
    "foreignObject",
)


def of_bytes(source: bytes, chance: Random) -> bytes:
    """Change, take out, repeat or put in bytes."""
    data = bytearray(source)
    for _ in range(chance.randint(1, 6)):
        place, length = chance.randrange(len(data) + 1), chance.choice((1, 1, 2, 8, 64, 1000))
        match chance.randrange(5):
            case 0:
                data[place : place + length] = chance.randbytes(length)
            case 1:
                del data[place : place + length]
            case 2:
                data[place:place] = data[place : place + length]
            case 3:
                data[place:place] = chance.choice(NASTY).encode("utf-8", "replace")
            case _:
                data[place:place] = chance.choice(
                    (b"<", b">", b"&", b'"', b"</g>", b"<g>", b"]]>", b"<!--", b"\0", b"&#0;")
                )
    return bytes(data)


def of_digits(source: bytes, chance: Random) -> bytes:
    """Change digits alone: the sheet stays one."""
    data = bytearray(source)
    digits = [place for place, byte in enumerate(data) if byte in b"0123456789"]
    for place in chance.choices(digits, k=chance.randint(1, 8)) if digits else ():
        data[place] = chance.choice(b"0123456789-.e")
    return bytes(data)


def of_elements(source: bytes, chance: Random) -> bytes:
    """Take out, repeat, move, rename or put in elements, and change their attributes; the seal is made anew."""
    ElementTree.register_namespace("", SVG)
    root = ElementTree.fromstring(source)
    for _ in range(chance.randint(1, 5)):
        parents = [one for one in root.iter() if len(one)]
        parent = chance.choice(parents)
        place = chance.randrange(len(parent))
        child = parent[place]
        match chance.randrange(6):
            case 0:
                parent.remove(child)
            case 1:
                parent.insert(chance.randrange(len(parent) + 1), child)
            case 2:
                parent.remove(child)
                chance.choice(parents).append(child)
            case 3:
                child.tag = f"{{{SVG}}}{chance.choice(TAGS)}"
            case 4:
                name = chance.choice([*child.attrib, *NAMES])
                child.set(name, chance.choice(NASTY))
            case _:
                wrap = ElementTree.Element(
                    f"{{{SVG}}}{chance.choice(TAGS)}", {chance.choice(NAMES): chance.choice(NASTY)}
                )
                wrap.append(child)
                parent[place] = wrap
        if not len(root):
            break
    body = body_of(ElementTree.tostring(root, encoding="utf-8", xml_declaration=True).replace(b"</svg>", b""))
    with contextlib.suppress(ElementTree.ParseError):
        return sealed_anew(body)
    return body


CHANGES: tuple[Callable[[bytes, Random], bytes], ...] = (of_bytes, of_digits, of_elements, of_elements)


class UndeclaredError(Exception):
    """An exception that is not declared, with the sheet that raised it."""


def trials(scenes: Sequence[str], seed: int) -> list[tuple[Originals, str, bytes]]:
    """Give the sheets that are changed, with their scenes."""
    found = [Originals(GALLERY / f"{name}.toml") for name in scenes]
    return [(own, sheet.name, own.drawn(sheet)) for own in found for sheet in own.sheets]


def tried(own: Originals, name: str, source: bytes, folder: Path) -> str:
    """Check and measure one sheet; give how both ended."""
    path = folder / name
    checked = check(path, source, own)
    for language in ("en", "ru"):
        json_text(plain(path, language, checked))
        list(lines(path, language, checked))
    path.write_bytes(source)
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as said:
        code = cli.main(["measure", str(path)])
    if code not in MEASURED:
        raise UndeclaredError(f"measure ended with {code}: {said.getvalue()}")
    return f"check {checked.exit_code}, measure {code}"


def main(arguments: Sequence[str] | None = None) -> int:
    """Fuzz for a time, or so many sheets; give 1 if any undeclared exception came."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz_sheets", description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--sheets", type=int, default=sys.maxsize, help="at most so many")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--scene", action="append", help="of the gallery")
    wanted = parser.parse_args(arguments)
    ends, bugs = Counter[str](), 0
    own = trials(wanted.scene or SCENES, wanted.seed)
    until = time.monotonic() + wanted.seconds
    with TemporaryDirectory() as folder:
        for number in range(wanted.sheets):
            if time.monotonic() > until:
                break
            chance = Random(f"{wanted.seed} {number}")
            originals, name, source = chance.choice(own)
            forged = chance.choice(CHANGES)(source, chance)
            try:
                ends[tried(originals, name, forged, Path(folder))] += 1
            except Exception:
                bugs += 1
                print(f"seed {wanted.seed}, sheet {number} ({name}):\n{traceback.format_exc()}", flush=True)
    for end, count in sorted(ends.items()):
        print(f"{end:<24} {count:>7}")
    print(f"sheets: {ends.total() + bugs}, undeclared exceptions: {bugs}")
    return 1 if bugs else 0


if __name__ == "__main__":
    sys.exit(main())

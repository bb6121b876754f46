"""Chance edits of a written sheet: in its bytes, digits, elements and attributes, and of all that is drawn at once."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable
from random import Random
from xml.etree import ElementTree

from tests.forgeries.file_edits import body_of, sealed_anew

SVG = "http://www.w3.org/2000/svg"

NASTY = (
    "", " ", "NaN", "inf", "-inf", "1e999", "-1e308", "1e-320", "0", "-0", "9" * 99, "9" * 101, "0x10", "1,5", "1;5",
    "%", "100%", "none", "url(#x)", "url(http://x/)", "translate(1e300)", "matrix(0 0 0 0 0 0)", "rotate(", "scale(0)",
    "#fff", "#ffff", "rgba(0,0,0,0)", "M", "M0 0", "M0 0L", "M0 0A0 0 0 0 0 1 1", "M1 1A1e9 1e-9 0 2 1 1e9 0z", "mzzz",
    "M0 0Q1 1", "M0 0H1V2S1 1 2 2T1 1", "vector", "point", "pole", "corner", "profile", "force", "couple", "٣", "𝟙",
    "\ufffd", "a" * 5000, "1 2 3", "{}", "[]", '{"sheet": 7}', '{"rows": 5, "plandraft": [], "scene": {}}', "null",
    "-1", "2.5", "\u202e", "é",
)  # fmt: skip
NAMES = (
    "d", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "x", "y", "width", "height", "points", "transform", "style",
    "fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "opacity", "display", "visibility",
    "clip-path", "mask", "filter", "id", "class", "viewBox", "preserveAspectRatio", "data-kind", "data-plan",
    "data-name", "data-value", "data-scale", "data-unit", "data-position", "data-text", "font-size", "text-anchor",
    "textLength",
)  # fmt: skip
TAGS = (
    "g", "path", "line", "circle", "ellipse", "rect", "polyline", "polygon", "text", "tspan", "use", "image", "svg",
    "defs", "clipPath", "style", "script", "metadata", "title", "desc", "animate", "switch", "symbol", "foreignObject",
)  # fmt: skip


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


def of_layers(source: bytes, chance: Random) -> bytes:
    """Put all that is drawn into groups that move, turn, scale or stretch it, by little or beyond all paper."""
    start, end = source.find(b"<g "), source.rfind(b"</svg>")
    if min(start, end) < 0:
        return source
    depth = chance.choice((1, 2, 5, 300))
    layers = [f'<g transform="{chance.choice(LAYERS)(chance)}">' for _ in range(depth)]
    inside = "".join(layers).encode() + source[start:end] + b"</g>" * depth
    return source[:start] + inside + source[end:]


def of_length(source: bytes, chance: Random) -> bytes:
    """End a sheet early, as a broken download does, or close what is open then."""
    short = source[: chance.randrange(len(source) + 1)]
    return short if chance.random() < 0.5 else short[: short.rfind(b">") + 1] + b"</g></svg>"


def without_data(source: bytes, chance: Random) -> bytes:
    """Take out all data, or some, as an editor does that knows none; then change what is left."""
    kept = chance.choice((0.0, 0.0, 0.9))
    data = re.compile(rb' data-(?!text)[a-z]+="[^"]*"')
    bare = data.sub(lambda one: one[0] if chance.random() < kept else b"", source)
    return chance.choice((of_digits, of_elements, of_layers))(bare, chance)


LAYERS: tuple[Callable[[Random], str], ...] = (
    lambda chance: f"translate({chance.uniform(-500, 500):g} {chance.uniform(-500, 500):g})",
    lambda chance: f"rotate({chance.uniform(0, 360):g})",
    lambda chance: f"scale({chance.uniform(0.5, 2):g})",
    lambda chance: f"scale({10 ** chance.uniform(-300, 300):g})",
    lambda chance: f"translate({10 ** chance.uniform(0, 300):g} 0)",
    lambda chance: f"scale({chance.choice((-1, 1, 0, 1.001))} 1)",
    lambda chance: f"skewX({chance.uniform(-89, 90):g})",
    lambda chance: "translate(1e300) translate(-1e300)",
)
CHANGES: tuple[Callable[[bytes, Random], bytes], ...] = (of_bytes, of_digits, of_elements, of_elements)
# Of sheets that are handed in.
HANDED_IN = (*CHANGES, of_layers, of_length, without_data, without_data)

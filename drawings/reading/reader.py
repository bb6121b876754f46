"""The reader: takes the marks out of a stranger's SVG while it streams past, and builds no tree of it."""

from __future__ import annotations

import json
import time
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from drawings.paper import limits
from drawings.paper.limits import OverLimit, SheetRefused
from drawings.reading.marks import KINDS, LINES, LONGEST, Nest, SheetMark, Witness, called, drawn, marked
from drawings.reading.pathdata import pair
from drawings.reading.transform import Viewport, about, transform, viewport
from drawings.reading.visibility import ANIMATIONS, Look, Said, presented, said, teller, telling
from plans.words.words import Message, message

_BEGINNINGS = {
    b"%PDF": "pdf", b"PK\x03\x04": "zip", b"\x89PNG": "png", b"\xff\xd8": "jpeg", b"AC10": "dwg", b"%!PS": "postscript",
    b"\xd0\xcf\x11\xe0": "office", b"{\\rtf": "rtf", b"0SECTION": "dxf", b"999": "dxf",
}  # fmt: skip
_LOOKED_AT = 40  # bytes


def foreign(source: bytes) -> str | None:
    """Tell what a file is that is no sheet.

    >>> foreign(b"  0\\r\\nSECTION\\r\\n"), foreign(b"<svg/>")
    ('dxf', None)
    """
    begins = b"".join(source[:_LOOKED_AT].split())  # a DXF indents its numbers as it likes
    return next((what for beginning, what in _BEGINNINGS.items() if begins.startswith(beginning)), None)


_SVG = "http://www.w3.org/2000/svg"
_CHUNK = 64 * 1024
KNOWN = 4096  # elements that are remembered as alike: a sheet of ours has some dozens, one of an editor any number
_TELLING = ("style", "metadata")  # elements whose text may be heard
_GZIP = b"\x1f\x8b"
_SAID = 40  # letters of a name that are told


@dataclass(eq=False, repr=False)
class ReadSheet:
    """What was read."""

    viewport: Viewport
    marks: list[SheetMark] = field(default_factory=list)
    notes: list[Message] = field(default_factory=list)
    metadata: dict[str, Any] = field(default_factory=dict)


def read(source: bytes, witness: Witness | None = None) -> ReadSheet:
    """Read a sheet (svg or svgz); what cannot be read within the limits is refused with the reason."""
    return _Reader(witness).read(_unpacked(source))


def _unpacked(source: bytes) -> bytes:
    if what := foreign(source):
        raise SheetRefused("foreign", what=what)
    if source.startswith(_GZIP):
        try:
            source = zlib.decompressobj(wbits=31).decompress(source[: limits.SHEET_BYTES], limits.SHEET_BYTES + 1)
        except zlib.error as error:
            raise SheetRefused("packed") from error
    if len(source) > limits.SHEET_BYTES:
        raise OverLimit("bytes", limit=limits.SHEET_BYTES)
    if not source.strip():
        raise SheetRefused("empty")
    return source


class _Reader:
    def __init__(self, witness: Witness | None = None) -> None:
        self.witness = witness
        self.sheet: ReadSheet | None = None
        self.frames: list[Nest] = []
        self.ids: set[str] = set()
        self.elements = self.entities = self.ampersands = self.path_length = 0
        self.known: dict[object, Nest] = {}  # by what an element stands in, its name, its look
        self.hearing, self.heard = "", list[str]()  # what tag is heard, and its text
        self.heard_depth = self.heard_length = 0
        self.left_aside: set[str] = set()

    def read(self, source: bytes) -> ReadSheet:
        self.ampersands = source.count(b"&")
        parser = self._parser()
        deadline = time.process_time() + limits.READING_SECONDS  # of its own work: a busy machine refuses no sheet
        try:
            for place in range(0, len(source), _CHUNK):
                parser.Parse(source[place : place + _CHUNK], False)
                if time.process_time() > deadline:
                    raise OverLimit("seconds", limit=f"{limits.READING_SECONDS:g}")
            parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise SheetRefused("xml", why=error.code, line=error.lineno, column=error.offset + 1) from error
        except (ValueError, LookupError) as error:
            if self.elements:
                raise
            raise SheetRefused("encoding") from error
        if self.sheet is None:
            raise SheetRefused("no_svg")
        return self.sheet

    def _parser(self) -> expat.XMLParserType:
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._hear
        parser.EntityDeclHandler = self._declare
        parser.ExternalEntityRefHandler = self._refuse_entity
        parser.SkippedEntityHandler = self._refuse_entity
        parser.ProcessingInstructionHandler = self._instruct
        return parser

    def _declare(self, name: str, parameter: int, value: str | None, *_: object) -> None:
        """Editors name their namespaces by entities; anything richer is an attack or a mistake."""
        self.entities += 1
        honest = value is not None and not parameter and len(value) <= limits.ENTITY_LENGTH
        if value is None or not honest or any(sign in value for sign in "&%<"):
            raise SheetRefused("entity", name=name[:_SAID])
        if self.entities > limits.ENTITIES or self.ampersands * limits.ENTITY_LENGTH > limits.SHEET_BYTES:
            raise OverLimit("entities")

    def _refuse_entity(self, name: str | None, *_: object) -> int:
        raise SheetRefused("far_entity", name=(name or "")[:_SAID])

    def _instruct(self, target: str, _: str) -> None:
        if target == "xml-stylesheet":
            raise SheetRefused("far_style")

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self.elements += 1
        if self.elements > limits.SHEET_ELEMENTS:
            raise OverLimit("elements", limit=limits.SHEET_ELEMENTS)
        if len(self.frames) >= limits.SHEET_DEPTH:
            raise OverLimit("depth", limit=limits.SHEET_DEPTH)
        if len(attributes) > limits.ELEMENT_ATTRIBUTES:
            raise OverLimit("attributes", limit=limits.ELEMENT_ATTRIBUTES)
        space, _, tag = name.rpartition(" ")
        if (identity := attributes.get("id")) is not None:
            if identity in self.ids:
                raise SheetRefused("id", name=identity[:LONGEST])
            self.ids.add(identity)
        if self.sheet is None:
            self._open(space, tag, attributes)
        else:
            self._enter(name, tag, attributes, self.sheet)
        if self.witness is not None:
            self.witness.enter(self.frames[-1], attributes)

    def _open(self, space: str, tag: str, attributes: Mapping[str, str]) -> None:
        if (space, tag) != (_SVG, "svg"):
            raise SheetRefused("root", tag=tag[:_SAID], space=_SVG)
        look = presented(Look(), tag, said(attributes))
        if "transform" in look.properties:
            raise SheetRefused("root_transform")
        paper = viewport(attributes) if self.witness is None else self.witness.opened(attributes)
        self.sheet = ReadSheet(paper, notes=list(paper.notes))
        self.frames.append(Nest(tag, paper.placing, look.look, None))

    def _enter(self, name: str, tag: str, attributes: dict[str, str], sheet: ReadSheet) -> None:
        if tag in _TELLING or self.hearing:
            telling_tag = tag == "style" or (tag == "metadata" and attributes.get("id") == "sheet")
            # An editor may add elements to the description, and none to a style.
            if self.hearing and (telling_tag or self.hearing == "style"):
                raise SheetRefused("inside", tag=tag[:_SAID])
            if telling_tag:
                self.hearing, self.heard, self.heard_length, self.heard_depth = tag, [], 0, len(self.frames) + 1
        names, values = teller(tuple(attributes))
        alike = (self.frames[-1], name, names, values(attributes))
        if (frame := self.known.get(alike)) is None:
            frame = self._framed(self.frames[-1], name, said(attributes), sheet)
            if len(self.known) < KNOWN:
                self.known[alike] = frame
        self.frames.append(frame)
        if frame.tag and attributes.get("data-kind") in KINDS:
            self._mark(frame, marked(attributes), attributes, sheet)

    def _framed(self, outer: Nest, name: str, telling_look: Said, sheet: ReadSheet) -> Nest:
        space, _, tag = name.rpartition(" ")
        if space != _SVG:
            gone = outer.look.gone or message("gone.inside", tag=tag[:_SAID])
            return Nest("", outer.to_paper, outer.look._replace(gone=gone), outer.refusal)
        if tag in ANIMATIONS and not outer.look.gone:
            raise SheetRefused("animation", tag=tag)
        if tag in ("script", "use") and tag not in self.left_aside:
            self.left_aside.add(tag)
            sheet.notes.append(message("aside.element", tag=tag))
        refusal = outer.refusal
        properties, look, moved = presented(outer.look, tag, telling_look)
        if tag == "svg":
            refusal = refusal or message("unreadable.nested")
        elif moved:
            refusal = refusal or message("unreadable.moved", by=moved)
        if properties.get("transform", "none") == "none":
            return Nest(tag, outer.to_paper, look, refusal, telling_look)
        moving = transform(properties["transform"])
        if "transform-origin" in properties:
            moving = about(pair(properties["transform-origin"].replace("px", "")), moving)
        if moving.singular:
            look = look._replace(gone=look.gone or message("gone.scaled"))
        return Nest(tag, outer.to_paper.after(moving), look, refusal, telling_look)

    def _mark(self, frame: Nest, data: dict[str, str], attributes: Mapping[str, str], sheet: ReadSheet) -> None:
        kind = data["kind"]
        if hidden := frame.look.hidden(filled=kind not in LINES):
            sheet.notes.append(message("aside.mark", who=called(data), why=hidden))
            return
        bent = message("unreadable.bent") if kind == "profile" and frame.to_paper.stretched else None
        if refusal := frame.refusal or bent:
            raise SheetRefused("of_mark", who=called(data), why=refusal)
        self.path_length += len(attributes.get("d", ""))
        if self.path_length > limits.PATH_COMMANDS:
            raise OverLimit("paths")
        try:
            shown = drawn(kind, frame.tag, attributes)
        except SheetRefused as refused:
            raise SheetRefused("of_mark", who=called(data), why=refused.reason) from refused
        points = tuple(frame.to_paper(place) for part in shown for place in part)
        if not all(abs(size) <= limits.REACH for point in points for size in (point.real, point.imag)):
            raise SheetRefused("far_mark", who=called(data))
        sheet.marks.append(SheetMark(kind, data, points, tuple(map(len, shown))))

    def _hear(self, text: str) -> None:
        if self.witness is not None:
            self.witness.hear(text)
        if not self.hearing or len(self.frames) != self.heard_depth:
            return
        self.heard_length += len(text)
        if self.heard_length > (limits.TEXT_LENGTH if self.hearing == "style" else limits.METADATA_LENGTH):
            raise OverLimit("description")
        self.heard.append(text)

    def _end(self, _: str) -> None:
        self.frames.pop()
        if self.witness is not None:
            self.witness.leave()
        if not self.hearing or self.sheet is None or len(self.frames) + 1 != self.heard_depth:
            return
        text, tag, self.hearing = "".join(self.heard), self.hearing, ""
        if tag == "metadata":
            self.sheet.metadata = _described(text, self.sheet.notes)
        elif name := telling(text):
            raise SheetRefused("style_sheet", name=name)


def _described(text: str, notes: list[Message]) -> dict[str, Any]:
    """Read the sheet's own description; a damaged one costs a note, not the measurement."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        found = None
    if not isinstance(found, dict):
        notes.append(message("aside.description"))
        return {}
    return found

"""The reader: takes the marks out of a stranger's SVG while it streams past, and builds no tree of it."""

from __future__ import annotations

import json
import time
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from drawings.measure.marks import LINES, SheetMark, called, drawn, marked
from drawings.measure.pathdata import pair
from drawings.measure.transform import about, transform
from drawings.measure.viewport import Viewport, viewport
from drawings.measure.visibility import ANIMATIONS, UNDRAWN, Look, properties, telling, unfollowed
from drawings.measure.witness import Frame, Witness
from drawings.paper import limits
from drawings.paper.limits import OverLimit, SheetRefused

_SVG = "http://www.w3.org/2000/svg"
_CHUNK = 64 * 1024
_GZIP = b"\x1f\x8b"
_FOREIGN = {b"%PDF": "a PDF", b"PK\x03\x04": "a ZIP or Word file", b"\x89PNG": "a PNG picture", b"\xff\xd8": "a JPEG"}


@dataclass
class ReadSheet:
    """What was read."""

    viewport: Viewport
    marks: list[SheetMark] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    metadata: dict[str, Any] = field(default_factory=dict)


def read(source: bytes, witness: Witness | None = None) -> ReadSheet:
    """Read a sheet (svg or svgz); what cannot be read within the limits is refused with the reason."""
    return _Reader(witness).read(_unpacked(source))


def _unpacked(source: bytes) -> bytes:
    for start, what in _FOREIGN.items():
        if source.startswith(start):
            raise SheetRefused(f"this is {what}, not an SVG sheet")
    if source.startswith(_GZIP):
        try:
            unpacking = zlib.decompressobj(wbits=31)
            source = unpacking.decompress(source[: limits.SHEET_BYTES], limits.SHEET_BYTES + 1)
        except zlib.error as error:
            raise SheetRefused(f"the packed sheet is damaged: {error}") from error
    if len(source) > limits.SHEET_BYTES:
        raise OverLimit(f"the sheet has over {limits.SHEET_BYTES} bytes")
    if not source.strip():
        raise SheetRefused("the sheet is empty")
    return source


class _Reader:
    def __init__(self, witness: Witness | None = None) -> None:
        self.witness = witness
        self.sheet: ReadSheet | None = None
        self.frames: list[Frame] = []
        self.ids: set[str] = set()
        self.elements = self.entities = self.ampersands = self.path_length = 0
        self.heard: list[str] | None = None
        self.heard_depth = self.heard_length = 0
        self.left_aside: set[str] = set()

    def read(self, source: bytes) -> ReadSheet:
        self.ampersands = source.count(b"&")
        parser = self._parser()
        deadline = time.monotonic() + limits.READING_SECONDS
        try:
            for place in range(0, len(source), _CHUNK):
                parser.Parse(source[place : place + _CHUNK], False)
                if time.monotonic() > deadline:
                    raise OverLimit(f"reading took over {limits.READING_SECONDS:g} s")
            parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise SheetRefused(f"this is not well-formed XML: {error}") from error
        except (ValueError, LookupError) as error:
            if self.elements:
                raise
            raise SheetRefused(f"the encoding is not read ({error}); save the sheet as UTF-8") from error
        if self.sheet is None:
            raise SheetRefused("this is not an SVG sheet")
        return self.sheet

    def _parser(self) -> expat.XMLParserType:
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.ordered_attributes = True
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
            raise SheetRefused(f"the entity {name[:40]!r} is not a short text")
        if self.entities > limits.ENTITIES or self.ampersands * limits.ENTITY_LENGTH > limits.SHEET_BYTES:
            raise OverLimit("the sheet uses too many entities")

    def _refuse_entity(self, name: str | None, *_: object) -> int:
        raise SheetRefused(f"the entity {(name or '')[:40]!r} is not in the file")

    def _instruct(self, target: str, _: str) -> None:
        if target == "xml-stylesheet":
            raise SheetRefused("a style sheet outside the file decides what is seen")

    def _start(self, name: str, listed: list[str]) -> None:
        self.elements += 1
        if self.elements > limits.SHEET_ELEMENTS:
            raise OverLimit(f"the sheet has over {limits.SHEET_ELEMENTS} elements")
        if len(self.frames) >= limits.SHEET_DEPTH:
            raise OverLimit(f"elements are nested over {limits.SHEET_DEPTH} deep")
        if len(listed) > 2 * limits.ELEMENT_ATTRIBUTES:
            raise OverLimit(f"an element has over {limits.ELEMENT_ATTRIBUTES} attributes")
        space, _, tag = name.rpartition(" ")
        attributes = dict(zip(listed[::2], listed[1::2], strict=True))
        self._name(attributes)
        if self.sheet is None:
            self._open(space, tag, attributes)
        else:
            self._enter(space, tag, attributes, self.sheet)
        if self.witness is not None:
            self.witness.enter(self.frames[-1] if space == _SVG else self.frames[-1]._replace(tag=""), attributes)

    def _name(self, attributes: Mapping[str, str]) -> None:
        if (own := attributes.get("id")) is not None:
            if own in self.ids:
                raise SheetRefused(f"id {own[:60]!r} twice")
            self.ids.add(own)

    def _open(self, space: str, tag: str, attributes: Mapping[str, str]) -> None:
        if (space, tag) != (_SVG, "svg"):
            raise SheetRefused(f"the root is <{tag[:40]}>, not <svg> of {_SVG}")
        if "transform" in properties(attributes):
            raise SheetRefused("the root has a transform")
        paper = viewport(attributes)
        self.sheet = ReadSheet(paper, notes=list(paper.notes))
        self.frames.append(Frame(tag, paper.placing, Look().below(tag, properties(attributes)), ""))

    def _enter(self, space: str, tag: str, attributes: dict[str, str], sheet: ReadSheet) -> None:
        outer = self.frames[-1]
        self._listen(tag, attributes)
        if space != _SVG:
            gone = outer.look.gone or f"inside <{tag[:40]}>"
            self.frames.append(outer._replace(tag=tag, look=outer.look._replace(gone=gone)))
            return
        if tag in ANIMATIONS and not outer.look.gone:
            raise SheetRefused(f"the sheet moves (<{tag}>); only a still drawing can be measured")
        frame = self._framed(outer, tag, attributes)
        self.frames.append(frame)
        if tag in ("script", "use") and tag not in self.left_aside:
            self.left_aside.add(tag)
            sheet.notes.append(f"<{tag}> is left aside")
        if data := marked(attributes):
            self._mark(frame, data, attributes, sheet)

    def _framed(self, outer: Frame, tag: str, attributes: Mapping[str, str]) -> Frame:
        own = properties(attributes)
        look = outer.look.below(tag, own) if own or tag in UNDRAWN else outer.look
        refusal = outer.refusal
        if tag == "svg":
            refusal = refusal or "it is in a drawing within the drawing"
        elif moved := unfollowed(own):
            refusal = refusal or f"a style moves it by {moved!r}"
        if own.get("transform", "none") == "none":
            return Frame(tag, outer.to_paper, look, refusal)
        moving = transform(own["transform"])
        if "transform-origin" in own:
            moving = about(pair(own["transform-origin"].replace("px", "")), moving)
        if moving.singular:
            look = look._replace(gone=look.gone or "scaled to nothing")
        return Frame(tag, outer.to_paper.after(moving), look, refusal)

    def _mark(self, frame: Frame, data: dict[str, str], attributes: Mapping[str, str], sheet: ReadSheet) -> None:
        kind, who = data["kind"], called(data)
        if hidden := frame.look.hidden(filled=kind not in LINES):
            sheet.notes.append(f"{who} is not counted: {hidden}")
            return
        if refusal := frame.refusal or ("it is stretched" if kind == "profile" and frame.to_paper.stretched else ""):
            raise SheetRefused(f"{who}: {refusal}")
        self.path_length += len(attributes.get("d", ""))
        if self.path_length > limits.PATH_COMMANDS:
            raise OverLimit("the marked paths are too long for marks")
        try:
            shown = drawn(kind, frame.tag, attributes)
        except SheetRefused as refused:
            raise SheetRefused(f"{who}: {refused.reason}") from refused
        points = tuple(frame.to_paper(place) for part in shown for place in part)
        if not all(abs(size) <= limits.REACH for point in points for size in (point.real, point.imag)):
            raise SheetRefused(f"{who} is off every paper")
        sheet.marks.append(SheetMark(kind, data, points, tuple(map(len, shown))))

    def _listen(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Begin to hear the text of a style or of the description; an editor may add elements to the latter."""
        telling_tag = tag == "style" or (tag == "metadata" and attributes.get("id") == "sheet")
        if self.heard is not None and (telling_tag or self.frames[-1].tag == "style"):
            raise SheetRefused(f"a <{tag[:40]}> stands inside a style or description")
        if telling_tag:
            self.heard, self.heard_length, self.heard_depth = [], 0, len(self.frames) + 1

    def _hear(self, text: str) -> None:
        if self.witness is not None:
            self.witness.hear(text)
        if self.heard is None or len(self.frames) != self.heard_depth:
            return
        self.heard_length += len(text)
        style = self.frames[-1].tag == "style"
        if self.heard_length > (limits.TEXT_LENGTH if style else limits.METADATA_LENGTH):
            raise OverLimit("the sheet's style or description is too long")
        self.heard.append(text)

    def _end(self, _: str) -> None:
        frame = self.frames.pop()
        if self.witness is not None:
            self.witness.leave()
        if self.heard is None or self.sheet is None or len(self.frames) + 1 != self.heard_depth:
            return
        text, self.heard = "".join(self.heard), None
        if frame.tag == "metadata":
            self.sheet.metadata = _described(text, self.sheet.notes)
        elif name := telling(text):
            raise SheetRefused(
                f"a style sheet decides what is seen ({name}); let the editor write it into the elements"
            )


def _described(text: str, notes: list[str]) -> dict[str, Any]:
    """Read the sheet's own description; a damaged one costs a note, not the measurement."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        found = None
    if not isinstance(found, dict):
        notes.append("the sheet's description cannot be read")
        return {}
    return found

"""Edits of a written file: as an editor or a hand with a text editor makes them; the seal is made anew."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random
from xml.etree import ElementTree

from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.reading.seal import seal
from tests.forgeries.forgery import Told
from tests.forgeries.leaf_edits import letter_lost

Edit = Callable[[Leaf, Random], tuple[bytes, Told] | None]
END = re.compile(rb'<metadata id="seal">.*\Z', re.DOTALL)


def body_of(source: bytes) -> bytes:
    """Give a sheet without its seal and the end of its root."""
    return END.sub(b"", source)


def sealed_anew(body: bytes) -> bytes:
    """Seal a body as the pen does."""
    return body + seal(body, sum(1 for _ in ElementTree.fromstring(body + b"</svg>").iter()))


def _root(old: str, new: Callable[[re.Match[str]], str], told: Told) -> Edit:
    """Change the opening of the root."""

    def edit(leaf: Leaf, _: Random) -> tuple[bytes, Told]:
        text = body_of(svg(leaf)).decode("utf-8")
        found = re.search(old, text)
        assert found is not None
        return sealed_anew((text[: found.start()] + new(found) + text[found.end() :]).encode("utf-8")), told

    return edit


def _figures(leaf: Leaf) -> list[str]:
    return [group.name for group in leaf.groups if group.name and group.name not in ("frame", "corners", "title-block")]


def _group(attributes: str, *kinds: str) -> Edit:
    """Give a figure's group attributes more."""

    def edit(leaf: Leaf, chance: Random) -> tuple[bytes, Told]:
        name = chance.choice(_figures(leaf))
        text = body_of(svg(leaf)).decode("utf-8")
        mark = f'id="{name}"'
        assert text.count(mark) == 1
        return sealed_anew(text.replace(mark, f"{mark} {attributes}").encode("utf-8")), Told(kinds, None, name)

    return edit


def _last(inside: str, told: Told) -> Edit:
    """Put an element over all that is drawn."""

    def edit(leaf: Leaf, _: Random) -> tuple[bytes, Told]:
        return sealed_anew(body_of(svg(leaf)) + inside.encode("utf-8") + b"\n"), told

    return edit


def twice(leaf: Leaf, chance: Random) -> tuple[bytes, Told] | None:
    """Draw an element twice, as it stands in the file, with its data."""
    text = body_of(svg(leaf)).decode("utf-8")
    own = list(re.finditer(r'<g class="vector"[^>]*>.*?</g>', text))
    if not own:
        return None
    found = chance.choice(own)
    name = re.search(r'data-name="([^"]*)"', found[0])
    assert name is not None
    forged = text[: found.end()] + found[0] + text[found.end() :]
    return sealed_anew(forged.encode("utf-8")), Told(("copied", "refused"), None, None, None, name[1])


def torn(leaf: Leaf, chance: Random) -> tuple[bytes, Told]:
    whole = svg(leaf)
    return whole[: chance.randrange(len(whole) // 3, len(whole) - 20)], Told(("torn",))


def seal_broken(leaf: Leaf, _: Random) -> tuple[bytes, Told]:
    return svg(leaf).replace(b"</g>\n", b"</g>\n\n", 1), Told(("seal",))


def seal_lost(leaf: Leaf, _: Random) -> tuple[bytes, Told]:
    return body_of(svg(leaf)) + b"</svg>\n", Told(("seal",))


def other_version(leaf: Leaf, chance: Random) -> tuple[bytes, Told] | None:
    """Take a letter away, and say that another version laid the sheet out: it is told that lines were not held."""
    if (edited := letter_lost(leaf, chance)) is None:
        return None
    text = body_of(svg(edited[0])).decode("utf-8")
    forged = re.sub(r'"plandraft": "[^"]*"', '"plandraft": "0.0.1"', text, count=1)
    return sealed_anew(forged.encode("utf-8")), Told(("version",))


def other_scene(leaf: Leaf, _: Random) -> tuple[bytes, Told]:
    text = body_of(svg(leaf)).decode("utf-8")
    forged = re.sub(r'"scene": "[^"]*"', f'"scene": "{"0" * 64}"', text, count=1)
    return sealed_anew(forged.encode("utf-8")), Told(("scene",))


def script(leaf: Leaf, _: Random) -> tuple[bytes, Told]:
    text = body_of(svg(leaf)).decode("utf-8") + "<script>document.title = 1</script>\n"
    return sealed_anew(text.encode("utf-8")), Told(("unread",))


PATCH = '<rect x="0" y="0" width="2000" height="2000" fill="{fill}" stroke="none"/>'
FILE_EDITS: dict[str, Edit] = {
    "the paper's size": _root(
        r'width="([\d.]+)mm"', lambda m: f'width="{float(m[1]) + 4:g}mm"', Told(("whole", "refused"))
    ),
    "the viewBox": _root(
        r'viewBox="0 0 ([\d.]+) ([\d.]+)"',
        lambda m: f'viewBox="0 0 {float(m[1]) * 1.02:g} {float(m[2]) * 1.02:g}"',
        Told(("whole",)),
    ),
    "a figure clipped": _group('clip-path="url(#none)"', "hidden", "refused"),
    "a figure transparent": _group('opacity="0"', "hidden", "missing"),
    "a figure not displayed": _group('display="none"', "hidden"),
    "a figure moved by a transform": _group('transform="translate(2.5 1)"', "moved"),
    "a figure scaled by a transform": _group('transform="scale(1.01)"', "moved"),
    "a figure turned by a transform": _group('transform="rotate(0.5 100 100)"', "moved", "text"),
    "a figure mirrored": _group('transform="matrix(-1 0 0 1 300 0)"', "mirrored", "refused", "missing"),
    "a figure stretched": _group('transform="scale(1.02 1)"', "stretched", "refused", "missing"),
    "all covered by a white sheet": _last(PATCH.format(fill="#ffffff"), Told(("hidden", "strange", "patch"))),
    "a line over all": _last('<path d="M10 10L300 200" stroke="#000000" fill="none"/>', Told(("added",), at=None)),
    "a line in a link": _last('<a href="#a"><path d="M10 10L300 200" stroke="#000"/></a>', Told(("added",))),
    "a line in an element that no viewer knows": _last(
        '<layer><path d="M10 10L300 200" stroke="#000"/></layer>', Told(("added",))
    ),
    "a curve that goes on by itself": _last(
        '<path d="M10 10Q20 20 30 10T50 10" fill="none" stroke="#000"/>', Told(("unread",), says="<path>")
    ),
    "all covered by a white sheet with round corners": _last(
        PATCH.format(fill="#ffffff").replace("/>", ' rx="9"/>'), Told(("hidden", "strange", "patch"))
    ),
    "a figure moved by a style": _group('style="translate:2px"', "unread", "refused"),
    "a figure hidden by what is important": _group('style="display:none ! important;display:inline"', "hidden"),
    "a figure blended with the paper": _group('style="mix-blend-mode:screen"', "unread"),
    "a figure that another language has": _group('systemLanguage="en-x-none"', "unread"),
    "a figure whose look a viewer works out": _group('style="visibility:var(--seen,hidden)"', "hidden", "unread"),
    "an element twice": twice,
    "torn": torn,
    "the seal broken": seal_broken,
    "the seal lost": seal_lost,
    "of another version": other_version,
    "of another scene": other_scene,
    "a script": script,
}  # fmt: skip

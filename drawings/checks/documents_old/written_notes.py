"""The notes of a sheet read back word by word: each that is due stands in its order, and no other (пояснения листа)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from drawings.checks.graphs.figure_strokes import read
from drawings.checks.precise import KNOWN, tells
from drawings.checks.reading import NOTES
from drawings.checks.wrong import Wrong, within
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups, texts


def faults(leaf: Leaf, due: Iterable[str], digits: Collection[int]) -> Iterator[Wrong]:
    """Hold the notes, from the description of every sheet and from where they are written, to those due.

    Those have all digits of their numbers; what is written has some of `digits`.
    """
    words = [read(one).split() for one in due]
    yield from compared(read(leaf.description.replace("\n", " ")).split(), words, digits)
    own = [one for one in groups(leaf.groups) if one.name == NOTES]
    if own or leaf.metadata["notes"]:
        written = [word for one in own for text in texts((one,)) for word in text.plain.split()]
        yield from compared(written, words, digits)


def compared(words: Sequence[str], due: Iterable[Sequence[str]], digits: Collection[int]) -> Iterator[Wrong]:
    """Give the first note that says something else than is due; what follows it may be out of step."""
    place = 0
    for one in due:
        said = " ".join(words[place : place + len(one)])
        if not tells(said, " ".join(one), digits, KNOWN):
            yield within("note", NOTES, text=said) if said else within("missing_from", NOTES, name=" ".join(one))
            return
        place += len(one)
    if words[place:]:
        yield within("note_beside", NOTES, text=" ".join(words[place:]))

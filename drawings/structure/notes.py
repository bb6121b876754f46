"""A structure in words: mobility worked out, what holds twice, the class (пояснения к структуре)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.lettering.words import Phrase, Slot, joined, with_index
from drawings.page.page import Drafting
from drawings.structure.scheme import formula_of
from plans.model.structure import ROMAN, SPACE, Structure
from plans.structure.study import StructureStudy

LISTED = 40  # ways that a sheet lists


class StructureNotes(NamedTuple):
    """The notes on a structure."""

    study: StructureStudy
    drafting: Drafting

    @property
    def all(self) -> tuple[str, ...]:
        """Mobility in the plane and in space, redundant constraints and their removal, the class, the letters."""
        letters = ("structure letters", *(("structure letters freed",) if self.study.replacements else ()))
        return *self.mobility(), *self.redundant(), *self.ranks(), *self.removal(), *map(self._said, letters)

    def mobility(self) -> Iterator[str]:
        """Work out the mobility by Chebyshev and by Somov and Malyshev."""
        structure = self.study.structure
        plane = (2, structure.lower), (1, structure.higher)
        yield self._formula("W", 3, structure, plane, Slot("W_c", structure.planar))
        yield self._formula("W_{s}", 6, structure, _spatial(structure), Slot("W_s", structure.spatial))

    def _formula(
        self, letter: str, motions: int, structure: Structure, terms: Sequence[tuple[int, int]], found: Slot
    ) -> Phrase:
        """Write a formula of structure in letters and in numbers, without the pairs that there are none of."""
        n = len(structure.links)
        kept = [(k, taken, count) for k, (taken, count) in enumerate(terms, 1) if count]
        letters = "".join(f" − {taken if taken > 1 else ''}p_{{{k}}}" for k, taken, _ in kept)
        numbers = "".join(f" − {taken}·{count}" if taken > 1 else f" − {count}" for _, taken, count in kept)
        return joined("", (f"{letter} = {motions}n{letters} = {motions}·{n}{numbers} = ", self.drafting.slot(found)))

    def redundant(self) -> Iterator[str]:
        """Name local mobilities and passive links, and count redundant constraints."""
        freedom, structure = self.study.freedom, self.study.structure
        for key, links in (("structure local", freedom.local), ("structure spinning", freedom.spinning)):
            yield from (self._said(key, link=link) for link in links)
        if freedom.within:
            passive = ", ".join(map(str, freedom.passive)) or "—"
            yield self._said("structure passive", within=Slot("q_w", freedom.within), links=passive)
        spatial = self.drafting.number(structure.spatial)
        parts = {"w": Slot("W", freedom.mobility), "spatial": f"({spatial})" if structure.spatial < 0 else spatial}
        across = freedom.mobility - structure.planar - freedom.within
        added = {"q_{w}": freedom.within, f"{across}": across}  # what the formula of W leaves out
        letters = " + ".join(("W", *(letter for letter, size in added.items() if size)))
        if letters != "W":
            numbers = " + ".join(f"{size}" for size in (structure.planar, *added.values()) if size)
            letters = f"({letters}) − W_{{s}} = ({numbers}) − {parts['spatial']} = "
        else:
            letters = "W − W_{s} = "
        yield self._said("structure redundant", **parts, letters=letters, q=Slot("q", freedom.redundant))

    def ranks(self) -> Iterator[str]:
        """Say which primary link gives the lowest class."""
        chosen, lowest = self.study.chosen, self.study.lowest
        letters = chosen.letters
        parts = {"rank": ROMAN[chosen.rank], "letters": with_index(letters), "k": Slot(letters, chosen.rank)}
        yield self._said("structure chosen", formula=formula_of(chosen.formula), **parts)
        if lowest.rank < max(division.rank for division in self.study.divisions):
            links = ", ".join(str(link) for d in self.study.divisions if d.rank == lowest.rank for link in d.primaries)
            yield self._said("structure lowest", rank=ROMAN[lowest.rank], links=links)

    def removal(self) -> Iterator[str]:
        """Say how the redundant constraints are removed."""
        if not self.study.replacements:
            yield from [self._said("structure unsearched")] if self.study.freedom.across else []
            return
        freed = self.study.freed
        count = len(self.study.replacements)
        key = "structure ways" if count <= LISTED else "structure first ways"
        yield self._said(key, count=Slot("N", count), listed=LISTED)
        yield self._formula("W'_{s}", 6, freed, _spatial(freed), Slot("W'_s", freed.spatial))
        yield self._said("structure freed note", q=Slot("q'", self.study.freedom.within))

    def _said(self, key: str, **parts: object) -> Phrase:
        return self.drafting.phrase(key, **parts)


def _spatial(structure: Structure) -> list[tuple[int, int]]:
    """Give how many constraints the pairs of each mobility make, and how many pairs there are."""
    return [(SPACE - mobility, count) for mobility, count in enumerate(structure.counts, 1)]

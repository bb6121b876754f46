"""The self-check of the loading schemes of a sheet, each by the analysis of its links (проверка схем нагружения)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from drawings.checks.forces import scheme_drive
from drawings.checks.forces.laid_scheme import laid_scheme, links_of
from drawings.checks.forces.scheme_forces import Floor, SchemeForces
from drawings.checks.forces.scheme_lines import SchemeLines
from drawings.checks.forces.scheme_links import SchemeLinks
from drawings.checks.wrong import Wrong
from drawings.paper.strokes import Group, Leaf
from plans.checks.force_bill import ForceBill


class LoadingSchemes(NamedTuple):
    """The loading schemes of a sheet, and the bills of the groups by their links."""

    leaf: Leaf
    bills: Mapping[tuple[int, ...], ForceBill]
    floor: Floor

    def faults(self) -> Iterator[Wrong]:
        """Hold each scheme of the sheet."""
        scales = self.leaf.metadata["scales"]
        for group in self.leaf.groups:
            if group.name.startswith("scheme-") and (bill := self.bills.get(links_of(group))) is not None:
                yield from self._scheme(group, bill, scales[group.name.rpartition("-")[0]])

    def _scheme(self, group: Group, bill: ForceBill, mu: float) -> Iterator[Wrong]:
        links = SchemeLinks(group.name, bill)
        laid = laid_scheme(group, mu, links.points)
        yield from links.faults(laid)
        yield from SchemeLines(group.name, laid, bill).faults()
        yield from scheme_drive.faults(group.name, laid, bill)
        yield from SchemeForces(group.name, laid, bill, self.floor).faults()

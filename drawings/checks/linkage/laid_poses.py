"""A mechanism in many positions as it must lie on its sheet, by the analysis (положения механизма на листе)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.checks.linkage.laid import Ground
from drawings.checks.linkage.link_bars import bars, flat, hanging
from plans.analytic.balance.mass_centre import placed
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes, Floats, Motion

Flags: TypeAlias = npt.NDArray[np.bool_]

BLOCK = 64  # spots that are looked at together: those beside one another have few pieces about them


class Segments(NamedTuple):
    """Straight pieces on paper, mm: their starts and ends, (n,) each; NaN at gaps."""

    starts: Complexes
    ends: Complexes

    @classmethod
    def of(cls, pairs: Iterator[tuple[complex, complex]]) -> Segments:
        """Gather pieces."""
        found = np.array([*pairs], dtype=np.complex128).reshape(-1, 2)
        return cls(found[:, 0], found[:, 1])

    @classmethod
    def joined(cls, parts: Sequence[Segments]) -> Segments:
        """Gather the pieces of many."""
        none = np.zeros(0, dtype=np.complex128)
        return cls(
            np.concatenate([none, *(one[0] for one in parts)]), np.concatenate([none, *(one[1] for one in parts)])
        )

    def apart(self, spots: Complexes) -> Floats:
        """Give how far spots (m,) are from each piece, (m, n) mm."""
        runs, off = self.ends - self.starts, spots[:, None] - self.starts
        with np.errstate(invalid="ignore", divide="ignore"):
            shares = np.nan_to_num((off * runs.conj()).real / np.abs(runs) ** 2)
        return np.asarray(np.abs(off - np.clip(shares, 0.0, 1.0) * runs))

    def nearest(self, spots: Complexes, within: float = np.inf) -> Floats:
        """Give how far spots (m,) are from the nearest piece, mm; infinity where none is within so much."""
        found = np.full(len(spots), np.inf)
        rows = np.argsort(spots.real)
        for block in np.split(rows, range(BLOCK, len(rows), BLOCK)):
            near = self._about(spots[block], within)
            if len(near.starts):
                off = np.nan_to_num(near.apart(spots[block]), nan=np.inf).min(axis=1)
                found[block] = np.where(off <= within, off, np.inf)
        return found

    def _about(self, spots: Complexes, within: float) -> Segments:
        """Give the pieces that reach into the box around spots; those at gaps do not."""
        there = np.ones(len(self.starts), dtype=bool)
        for starts, ends, own in (
            (self.starts.real, self.ends.real, spots.real), (self.starts.imag, self.ends.imag, spots.imag),
        ):  # fmt: skip
            low, high = float(np.fmin.reduce(own, initial=np.inf)), float(np.fmax.reduce(own, initial=-np.inf))
            there &= (np.minimum(starts, ends) <= high + within) & (np.maximum(starts, ends) >= low - within)
        return Segments(self.starts[there], self.ends[there])

    def holds(self, other: Segments, near: float) -> Flags:
        """Tell of each of other pieces (m,) whether it lies along one of these."""
        if not len(self.starts):
            return np.zeros(len(other.starts), dtype=bool)
        off = np.fmax(self.apart(other.starts), self.apart(other.ends))
        return np.asarray(np.nan_to_num(off, nan=np.inf).min(axis=1, initial=np.inf) <= near)

    def known(self) -> Segments:
        """Give those that have a place and a length."""
        there = np.isfinite(self.starts) & np.isfinite(self.ends) & (self.starts != self.ends)
        return Segments(self.starts[there], self.ends[there])

    def at(self, shares: Floats) -> Complexes:
        """Give the places at some shares of each piece, (n, shares)."""
        return np.asarray(self.starts[:, None] + shares * (self.ends - self.starts)[:, None])


class LaidPoses(NamedTuple):
    """A mechanism over the positions of a motion, on paper."""

    mechanism: Mechanism
    motion: Motion
    ground: Ground

    def on(self, link: int, own: complex) -> Complexes:
        """Place a spot of a link, (N,) mm."""
        count = len(self.motion.phi)
        true = np.full(count, own) if link == FRAME else placed(self.mechanism, self.motion, link, own)
        return np.asarray(self.ground.origin + true / self.ground.scale)

    def point(self, name: str) -> Complexes:
        """Place a named point, (N,) mm."""
        link = self.mechanism.link_of(name)
        return self.on(link, self.mechanism.links[link].points[name])

    def way(self, slide: Slide) -> Complexes:
        """Direct a slide's line, (N,) unit vectors."""
        through, ahead = (slide.on_owner.through + k * slide.on_owner.direction for k in (0.0, 1.0))
        run = self.on(slide.owner, ahead) - self.on(slide.owner, through)
        return np.asarray(run * self.ground.scale)

    def block(self, slide: Slide) -> Complexes:
        """Place a slide's block, (N,) mm: the foot of its point on the line."""
        return np.asarray(self.on(slide.owner, slide.on_owner.through) + self.along(slide) * self.way(slide))

    def along(self, slide: Slide) -> Floats:
        """Give how far the block is along its line from the point that the line goes through, (N,) mm."""
        off = self.point(slide.point) - self.on(slide.owner, slide.on_owner.through)
        return np.asarray((off * self.way(slide).conj()).real)

    def bars(self, link: int) -> list[Segments]:
        """Give what a link is drawn of: its bars, slots as far as their stones, a rod to a block off its point."""
        own = [Segments(self.on(link, start), self.on(link, end)) for start, end in bars(self.mechanism, link)]
        for slide in self.mechanism.slides:
            if slide.owner == link:
                own += self._slot(slide)
            if slide.slider == link:
                own.append(Segments(self.point(slide.point), self.block(slide)))
        return own

    def _slot(self, slide: Slide) -> list[Segments]:
        """Give a slot from both ends of the bar that lies along it; without one it hangs on a point of its link."""
        link, block = slide.owner, self.block(slide)
        lying = [ends for ends in bars(self.mechanism, link) if flat(slide, ends)]
        if lying:
            return [Segments(self.on(link, end), block) for ends in lying for end in ends]
        point, foot = hanging(self.mechanism, slide)
        return [Segments(self.on(link, point), self.on(link, foot)), Segments(self.on(link, foot), block)]

"""The rings about a cam on paper: what lies how far out, from its profile to the arcs of its phases (кольца фигуры)."""

from __future__ import annotations

import cmath
from typing import NamedTuple

from drawings.figures.cam.profile_view import ProfileView
from drawings.layout.place import Place
from drawings.paper.hand import Hand

CLEAR = 2.0  # mm between a follower at its highest and its guide
GUIDE = 9.0  # mm, length of a guide
PAST = 2.0  # mm that an axis goes past its guide
NUMBER = 2.4  # sizes of a number from the ends of the axes to the arcs of the phases
PHASE = 1.2  # sizes of a letter beyond the arcs of the phases
BODY_GUIDE = 8.0  # mm under a cam that translates, for its guide


class Rings(NamedTuple):
    """Radii on paper about O, mm, each beyond the one before."""

    view: ProfileView
    place: Place
    hand: Hand

    @property
    def cam(self) -> float:
        """The farthest place of the cam and of rollers on it."""
        return self.place.length(self.view.reach)

    @property
    def ends(self) -> float:
        """The ends of the turned axes, or the turned pivots of a rocker."""
        if self.view.cam.rocks:
            return max(self.place.length(abs(self.view.sizes.pivot)), self.cam + CLEAR * self.hand.symbol)
        return self.cam + beyond(self.hand)

    @property
    def phases(self) -> float:
        """The arcs of the phases."""
        return self.ends + NUMBER * self.hand.number

    def crossing(self, turned: float, radius: float) -> complex:
        """Give where a turned axis, or the ray through a turned pivot, meets a circle about O, mm from O."""
        view = self.view
        if view.cam.rocks:
            ray = view.way(view.sizes.pivot, turned)
            return radius * ray / abs(ray)
        off = self.place.length(view.axis)
        return view.way(complex(off, cmath.sqrt(radius**2 - off**2).real), turned)


def beyond(hand: Hand) -> float:
    """Give how far the axes go past the cam, mm: to where a guide ends, and on."""
    return (2 * CLEAR + GUIDE + PAST) * hand.symbol


def around(view: ProfileView, hand: Hand) -> float:
    """Give the paper around what is drawn to scale, mm."""
    ends = CLEAR * hand.symbol if view.cam.rocks else beyond(hand)
    return ends + NUMBER * hand.number + PHASE * hand.letter

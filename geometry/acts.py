"""A row of acts on numbers, to be gone through again with another free number; no act is done twice (ряд действий)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from typing import Any, TypeAlias

import numpy as np

from geometry.meet import Vectors

Place: TypeAlias = int  # of a number among those of a row
Rule: TypeAlias = Callable[[Any, Any], Any]


class Acts:
    """Acts on one or two numbers each, which may be arrays; what does not hang on the free number is done but once.

    >>> acts = Acts()
    >>> half = acts.do(np.multiply, acts.free, acts.fix(0.5))
    >>> acts.follow(1 + 3j)[half]
    np.complex128(0.5+1.5j)
    """

    def __init__(self) -> None:
        self._numbers: list[Any] = []  # those that never change, in their places; None: worked out each time
        self._varying: set[Place] = set()
        self._row: list[tuple[Place, Rule, Place, Place]] = []
        self._done: dict[tuple[Rule, Place, Place], Place] = {}
        self._turned: dict[Place, tuple[Place, Place]] = {}  # a vector turned and stretched: from which, by which
        self.free, self._nothing = self.vary(), self.fix(None)
        self._real, self._imaginary, self._quarter = self.fix("real"), self.fix("imag"), self.fix(1j)

    def over(self) -> Acts:
        """Begin a row of further acts on the numbers of this one, which stays as it is."""
        other = copy(self)
        other._numbers, other._varying = self._numbers.copy(), self._varying.copy()
        other._done, other._turned, other._row = self._done.copy(), self._turned.copy(), []
        return other

    def follow(self, free: Vectors, given: Mapping[Place, Any] | None = None) -> list[Any]:
        """Give all numbers for another free one; `given` are the numbers that change besides."""
        return self._followed(self._numbers.copy(), {self.free: free, **(given or {})})

    def follow_on(self, numbers: list[Any], given: Mapping[Place, Any]) -> list[Any]:
        """Give all numbers over those of the row below; `given` are the numbers that change besides."""
        return self._followed(numbers + self._numbers[len(numbers) :], given)

    def _followed(self, numbers: list[Any], given: Mapping[Place, Any]) -> list[Any]:
        for place, number in given.items():
            numbers[place] = number
        for place, act, first, other in self._row:
            numbers[place] = act(numbers[first], numbers[other])
        return numbers

    def fixed(self, place: Place) -> Any:
        """Give a number that is the same with any free one; None where it changes."""
        return self._numbers[place]

    def fix(self, number: Any) -> Place:
        """Give a place to a number that never changes."""
        self._numbers.append(number)
        return len(self._numbers) - 1

    def vary(self) -> Place:
        """Give a place to a number that is given anew each time."""
        self._varying.add(self.fix(None))
        return len(self._numbers) - 1

    def do(self, act: Rule, first: Place, other: Place | None = None) -> Place:
        """Put down an act: done at once where its numbers never change, and never twice."""
        other = self._nothing if other is None else other
        key = (act, first, other)
        if key not in self._done:
            if first in self._varying or other in self._varying:
                self._done[key] = self.vary()
                self._row.append((self._done[key], *key))
            else:
                self._done[key] = self.fix(act(self._numbers[first], self._numbers[other]))
        return self._done[key]

    def turn(self, vector: Place, by: Place) -> Place:
        """Turn and stretch a vector by a number."""
        return self.turned(self.do(np.multiply, vector, by), vector, by)

    def turned(self, found: Place, vector: Place, by: Place) -> Place:
        """Note that a vector is another one, turned and stretched by a number."""
        self._turned.setdefault(found, (vector, by))
        return found

    def square(self, vector: Place) -> Place:
        """Turn a vector by a quarter."""
        return self.turn(vector, self._quarter)

    def ratio(self, image: Place, of: Place) -> Place:
        """Divide one vector by another, where it is not known by what it was turned and stretched from the other."""
        known = self.known_ratio(image, of)
        return self.do(np.divide, image, of) if known is None else known

    def known_ratio(self, image: Place, of: Place) -> Place | None:
        """Give the number by which one vector was turned and stretched from another; None where it was not."""
        if image not in self._turned:
            return None
        source, by = self._turned[image]
        if source == of:
            return by
        before = self.known_ratio(source, of)
        return None if before is None else self.do(np.multiply, before, by)

    def rate(self, image: Place, of: Place) -> Place:
        """Give the part of the ratio of two vectors by which one is square to the other."""
        source, by = self._turned.get(image, (None, self._nothing))
        if source is not None and self.known_ratio(source, of) == self._quarter:
            return self.do(getattr, by, self._real)
        return self.do(getattr, self.ratio(image, of), self._imaginary)

    def is_origin(self, place: Place) -> bool:
        """Whether a point lies at the origin at all positions."""
        return place not in self._varying and np.ndim(self._numbers[place]) == 0 and bool(self._numbers[place] == 0)

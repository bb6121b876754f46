"""The axes of a train: missing teeth by coaxiality, heights of axes, what does not lie in one plane (соосность)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from plans.model.gears import FRAME, ToothedWheel, bodies, link_of

Teeth = Mapping[str, int | None]
Mesh = tuple[str, str]


class RawTrain(NamedTuple):
    """A train as a scene tells it, some of its teeth not known yet; those of rings count negative."""

    teeth: Teeth
    rings: frozenset[str]
    modules: Mapping[str, Fraction]
    meshes: tuple[Mesh, ...]
    carriers: Mapping[str, tuple[str, ...]]
    coaxial: tuple[tuple[str, ...], ...]  # shafts that are one or that clutches join
    sides: Mapping[str, str]  # of bevel wheels

    @property
    def links(self) -> tuple[str, ...]:
        """The links in the order of their wheels, then the carriers."""
        return tuple(dict.fromkeys((*map(link_of, self.teeth), *self.carriers)))

    @property
    def planets(self) -> Mapping[str, str]:
        """The carriers of the links that turn on one."""
        return {link: carrier for carrier, links in self.carriers.items() for link in links}

    def axes(self) -> Mapping[str, str]:
        """Give a link that stands for the axis of each: a carrier is coaxial with the wheels about its planets."""
        groups, planets = [*self.coaxial], self.planets
        for mesh in self.meshes:
            for one, other in (mesh, mesh[::-1]):
                if link_of(one) in planets and link_of(other) not in planets:
                    groups.append((planets[link_of(one)], link_of(other)))
        return bodies(self.links, groups)

    def wheel(self, name: str) -> ToothedWheel:
        """Give a wheel whose teeth are known."""
        return ToothedWheel(name, self.teeth[name] or 0, self.modules[name], self.sides.get(name, ""))

    @property
    def flat(self) -> tuple[Mesh, ...]:
        """The meshes of parallel axes."""
        return tuple(mesh for mesh in self.meshes if self.sides.keys().isdisjoint(mesh))


class Apart(NamedTuple):
    """The distance m of two axes by one mesh: the sum of its teeth that are known, times their half modules."""

    mesh: Mesh
    known: Fraction
    lacking: Mapping[str, Fraction]  # wheels whose teeth lack, and by how much a tooth moves the axes apart


def apart(raw: RawTrain, mesh: Mesh) -> Apart:
    """Give how far two axes are apart by a mesh: m(z_1 + z_2)/2, of a ring m(z_3 - z_2)/2."""
    ring = not raw.rings.isdisjoint(mesh)
    lacking, known = dict[str, Fraction](), Fraction(0)
    for name in mesh:
        sign = -1 if ring and name not in raw.rings else 1
        each = sign * raw.modules[name] / 2
        if raw.teeth[name] is None:
            lacking[name] = each
        else:
            known += each * abs(raw.teeth[name] or 0)
    return Apart(mesh, known, lacking)


def between_axes(raw: RawTrain) -> Mapping[frozenset[str], list[Apart]]:
    """Give what meshes say of how far the axes of each two are apart."""
    axes, found = raw.axes(), dict[frozenset[str], list[Apart]]()
    for mesh in raw.flat:
        pair = frozenset(axes[link_of(name)] for name in mesh)
        found.setdefault(pair, []).append(apart(raw, mesh))
    return found


def completed(raw: RawTrain) -> RawTrain:
    """Find the teeth that coaxiality gives, as far as they are whole."""
    while True:
        whole = ((name, int(teeth)) for name, teeth in sought(raw) if teeth.denominator == 1 and teeth > 0)
        name, teeth = next(whole, ("", 0))
        if not name:
            return raw
        raw = raw._replace(teeth={**raw.teeth, name: -teeth if name in raw.rings else teeth})


def sought(raw: RawTrain) -> Iterator[tuple[str, Fraction]]:
    """Give teeth that two meshes between the same axes determine, whole or not."""
    for rows in between_axes(raw).values():
        for one in rows:
            for other in rows:
                name, *more = {*one.lacking, *other.lacking} or {""}
                if name and not more and one is not other:
                    factor = one.lacking.get(name, Fraction(0)) - other.lacking.get(name, Fraction(0))
                    if factor:
                        yield name, (other.known - one.known) / factor


class Unlike(NamedTuple):
    """Two meshes that put the same axes apart by different distances m."""

    mesh: Mesh
    distance: Fraction
    other: Mesh
    wanted: Fraction


def unlike(raw: RawTrain) -> Iterator[Unlike]:
    """Find the meshes between the same axes that need other distances than the first of them."""
    for first, *others in between_axes(raw).values():
        for other in others:
            if not first.lacking and not other.lacking and first.known != other.known:
                yield Unlike(other.mesh, other.known, first.mesh, first.known)


def heights(raw: RawTrain) -> tuple[Mapping[str, Fraction], Sequence[Unlike]]:
    """Give the height m of each link's axis over the main one, and meshes whose axes do not lie in one plane so.

    The main axis is that of the first carrier, of an ordinary train that of its first wheel. Planets stand above their
    carriers' axis, wheels within a ring above its axis. Any other axis comes back to one that is there where the
    distances allow it, else it goes on up.
    """
    axes, planets = raw.axes(), {raw.axes()[link] for link in raw.planets}
    start = axes[next(iter(raw.carriers), raw.links[0])]
    found, left, wrong = {start: Fraction(0), axes[FRAME]: Fraction(0)}, [*raw.flat], list[Unlike]()
    while left:
        mesh = next((one for one in left if any(axes[link_of(name)] in found for name in one)), None)
        if mesh is None:  # a part that no mesh joins to the others stands on the main axis
            found[axes[link_of(left[0][0])]] = Fraction(0)
            continue
        left.remove(mesh)
        here, there = (axes[link_of(name)] for name in mesh)
        here, there = (here, there) if here in found else (there, here)
        far = apart(raw, mesh).known
        if there not in found:  # on the other side where an axis is there
            far = -far if any(name in raw.rings and axes[link_of(name)] == there for name in mesh) else far
            back = far > 0 and found[here] - far in found.values() and planets.isdisjoint((here, there))
            found[there] = found[here] - far if back else found[here] + far
        elif abs(found[there] - found[here]) != far:
            wrong.append(Unlike(mesh, far, mesh, abs(found[there] - found[here])))
    return {link: found.get(axes[link], Fraction(0)) for link in raw.links}, wrong

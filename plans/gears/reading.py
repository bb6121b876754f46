"""The train that a scene gives, made with all its faults: names, axes, planets, mobility (по исходным данным)."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from decimal import Decimal
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from plans.gears.assignment import lack, wanted_of
from plans.gears.axes import RawTrain, completed, heights, sought, unlike
from plans.gears.crank import CrankTrain
from plans.gears.form import LEAST_TEETH, DrivingLinkTable, GearsForm, GearsTable, WheelTable, geared
from plans.gears.synthesis import TIP, Searched, clear_of, search
from plans.linkage.reading.form import LinkageForm
from plans.model.gears import ACROSS, FRAME, BoxGear, ToothedWheel, Train, assembly, link_of
from plans.model.trains import determined, mobility
from plans.scene.faults import Fault, Path, suggestion
from plans.scene.scene import Meaning, Scene
from plans.words.words import message

HALF_TURN = 180


class GearsSurvey(NamedTuple):
    """What the examination of a train found: the train where it is sound, and faults."""

    train: Train | None
    faults: list[Fault]
    searched: Searched | None = None  # where its teeth are sought by a wanted ratio


def survey_of(meaning: Meaning) -> GearsSurvey:
    """Examine a train: its names, its axes, its planets, its mobility; all faults that do not follow from others."""
    if any(path[:2] == ("gears", table) for path in meaning.doubts for table in ("wheels", "carriers", "module")):
        return GearsSurvey(None, [])  # what is not read well is there for all that
    reading = _TrainReading(meaning.scene, meaning.scene.of(GearsForm).gears, [])
    for step in (reading.names, reading.rings, reading.synthesis, reading.axes, reading.room, reading.mobilities):
        step()
        if reading.faults:
            return GearsSurvey(None, reading.faults)
    reading.crank()
    return GearsSurvey(reading.train, reading.faults, reading.searched)


def crank_train(scene: Scene) -> CrankTrain | None:
    """Give the train before the crank of a scene; nothing where there is none, or it gives that no one speed."""
    train = scene.meaning.of(GearsSurvey).train if geared(scene) else None
    found = CrankTrain(train, scene.of(GearsForm).gears.drives[0].speed) if train is not None else None
    return found if found is not None and found.fits else None


def with_speed(scene: Scene) -> Scene:
    """Give a scene with the speed of its crank, with any where the train before it has faults."""
    if not geared(scene):
        return scene
    train, linkage = crank_train(scene), scene.of(LinkageForm)
    given = train.speed if train is not None else Decimal(1)
    speed = given if linkage.drive.speed is None else linkage.drive.speed
    return scene.changed(linkage.changed(drive=linkage.drive.changed(speed=speed)))


def unknown(name: str, known: Collection[str]) -> dict[str, object]:
    """Give the parts of a fault at a name that is not among those that are known."""
    there = message("gears.there_are", names=", ".join(known)) if known else ""
    return {"name": name, "known": there, "suggestion": suggestion(name, known)}


def millimetres(length: Fraction) -> str:
    """Write a length m in millimetres for a message."""
    return f"{float(1000 * length):.6g}"


class _TrainReading:
    """A train while it is examined."""

    def __init__(self, scene: Scene, form: GearsTable, faults: list[Fault]) -> None:
        self.scene, self.form, self.faults = scene, form, faults
        self.searched: Searched | None = None
        self.wheels = {name: w if isinstance(w, WheelTable) else WheelTable(teeth=w) for name, w in form.wheels.items()}

    def report(self, path: Path, kind: str, **details: object) -> None:
        """Tell a fault at a key of the train."""
        self.faults.append(self.scene.fault(("gears", *path), kind, **details))

    def names(self) -> None:
        """See that what is named is there: wheels, links, brakes, clutches."""
        form = self.form
        links, planets = self.raw.links, self.raw.planets
        central = [link for link in links if link not in planets]
        for k, mesh in enumerate(form.meshes):
            self._know(("meshes", k), mesh, self.wheels, "no_wheel")
        for carrier, some in form.carriers.items():
            self._know(("carriers", carrier), some, [link for link in links if link not in form.carriers], "no_planet")
            for link in some:
                if carrier != (first := next(one for one, of in form.carriers.items() if link in of)):
                    self.report(("carriers", carrier), "planet_twice", name=link, first=first)
        rows: list[tuple[Path, Collection[str]]] = [(("fixed",), form.fixed)]
        rows += [(("output",), (form.output,))] if form.output not in self.slides else []
        rows += [(("joined", k), some) for k, some in enumerate(form.joined)]
        rows += [(("brakes", name), (link,)) for name, link in form.brakes.items()]
        rows += [(("clutches", name), pair) for name, pair in form.clutches.items()]
        rows += [(self._drive(k), (drive.link,)) for k, drive in enumerate(form.drives)]
        for path, named in rows:
            self._know(path, named, central, "no_central")
        meshes = ["-".join(way) for mesh in form.meshes for way in (mesh, mesh[::-1])]
        self._know(("efficiencies",), ["-".join(mesh) for mesh in form.efficiencies], meshes, "unmeshed")
        for name in form.inertia:
            self._know(("inertia", name), (name,), links, "no_link")
        for name in form.masses:
            self._know(("masses", name), (name,), [link for link in links if link in planets], "no_planet")
        for name, some in form.engaged.items():
            self._know(("engaged", name), some, (*form.brakes, *form.clutches), "no_brake")

    def _drive(self, k: int) -> Path:
        return ("drive", "link") if isinstance(self.form.drive, DrivingLinkTable) else ("drive", k, "link")

    def _know(self, path: Path, names: Collection[str], known: Collection[str], kind: str) -> None:
        for name in names:
            if name not in known:
                self.report(path, kind, **unknown(name, known))

    @cached_property
    def slides(self) -> frozenset[str]:
        """The names of the racks."""
        return frozenset(name for name, wheel in self.wheels.items() if wheel.rack)

    @property
    def racks(self) -> Mapping[str, str]:
        """The racks, each with the wheel that it meshes with."""
        meshes = [*self.form.meshes, *(mesh[::-1] for mesh in self.form.meshes)]
        return {one: other for one, other in meshes if one in self.slides}

    def _slide(self) -> None:
        """See that each rack meshes with one wheel of a fixed axis, and is loaded by a force."""
        round_it = {one for one, wheel in self.wheels.items() if not wheel.internal and not wheel.rack}
        for name in (name for name in self.wheels if name in self.slides):
            others = [one for mesh in self.form.meshes if name in mesh for one in mesh if one != name]
            free = [one for one in others if one not in round_it or link_of(one) in self.raw.planets]
            same = [one for one in self.wheels if one != name and link_of(one) == link_of(name)]
            if len(others) > 1 or free or same:
                self.report(("wheels", name), "rack_mesh", rack=name, others=", ".join(dict.fromkeys(others + same)))
        slides = self.form.output in self.slides
        for key, given in (("load", self.form.load), ("force", self.form.force)):
            if given is not None and slides == (key == "load"):
                self.report((key,), "load_of_rack" if slides else "force_of_wheel", output=self.form.output)

    def _cones(self) -> None:
        """See that bevel wheels mesh with such of axes across, and that these stand in the plane of all axes."""
        form, sides, rows = self.form, self.raw.sides, dict[str, list[tuple[str, str]]]()
        for k, mesh in enumerate(form.meshes):
            across = [name for name in mesh if sides.get(name) in ACROSS]
            if not sides.keys().isdisjoint(mesh) and (len(across) != 1 or not sides.keys() >= {*mesh}):
                self.report(("meshes", k), "bevel_mesh", first=mesh[0], second=mesh[1])
            elif across:
                (level,) = {*mesh} - {*across}
                rows.setdefault(link_of(across[0]), []).append((level, across[0]))
        planets = self.raw.planets
        coaxial = {link for group in (*self.raw.coaxial, form.fixed, form.brakes.values()) for link in group}
        for link, pairs in rows.items():
            own = {self.wheels[name].bevel for name in self.wheels if link_of(name) == link}
            away = len(own) > 1 or link in coaxial or any(link_of(one) in planets for one, _ in pairs)
            if away or (link in planets and "down" in own) or len(pairs) > (2 if link in planets else 1):
                self.report(("wheels", pairs[0][1]), "bevel_axis", name=link)
            elif len(pairs) > 1:
                (first, one), (second, other) = pairs
                beside = self.wheels[first].bevel == self.wheels[second].bevel
                alike = beside and self.raw.teeth[one] == self.raw.teeth[other]
                if alike or (one == other and self.raw.teeth[first] != self.raw.teeth[second]):
                    self.report(("wheels", one), "bevel_cone", name=link, first=first, second=second)
        for key, given in (("inertia", form.inertia), ("masses", form.masses)):
            for name in given.keys() & rows.keys() & planets.keys():
                self.report((key, name), "bevel_inertia", name=name)

    def rings(self) -> None:
        """See that no two rings mesh, that wheels that mesh have one module, that every wheel meshes."""
        self._slide()
        self._cones()
        for k, mesh in enumerate(self.form.meshes):
            if link_of(mesh[0]) == link_of(mesh[1]):
                self.report(("meshes", k), "own_mesh", first=mesh[0], second=mesh[1])
            if all(self.wheels[name].internal for name in mesh):
                self.report(("meshes", k), "two_rings", first=mesh[0], second=mesh[1])
            one, other = (self._module(name) for name in mesh)
            if one != other:
                sizes = {"module": millimetres(one), "other": millimetres(other)}
                self.report(("meshes", k), "unlike_modules", first=mesh[0], second=mesh[1], **sizes)
        meshing = {name for mesh in self.form.meshes for name in mesh}
        for name in self.wheels:
            if name not in meshing:
                self.report(("wheels", name), "idle_wheel", name=name)

    def _module(self, name: str) -> Fraction:
        own = self.wheels[name].module
        return Fraction(own if own is not None else self.form.module)

    @cached_property
    def raw(self) -> RawTrain:
        """The train with the teeth that it is given."""
        form, turning = self.form, {name: w for name, w in self.wheels.items() if name not in self.slides}
        return RawTrain(
            {name: -w.teeth if w.teeth and w.internal else w.teeth for name, w in turning.items()},
            frozenset(name for name, wheel in turning.items() if wheel.internal),
            {name: self._module(name) for name in turning},
            tuple(mesh for mesh in form.meshes if turning.keys() >= {*mesh}),
            form.carriers,
            (*form.joined, *form.clutches.values()),
            {name: wheel.bevel for name, wheel in turning.items() if wheel.bevel},
        )

    def synthesis(self) -> None:
        """Find the teeth that give the wanted ratio, if one is wanted."""
        if self.form.wanted is None:
            return
        wanted = None if self.raw.sides else wanted_of(self.form, self.raw)
        if wanted and wanted.sign * wanted.ratio < 0:
            ends = dict(zip(("held", "driving", "driven"), wanted.ends, strict=True))
            kind = "only_positive" if wanted.sign > 0 else "only_negative"
            self.report(("wanted", "ratio"), kind, **ends, would=-self.form.wanted.ratio)
            return
        self.searched = search(wanted) if wanted else None
        if self.searched is None:
            self.report(("wanted",), "wanted_scheme")
        elif not self.searched.solutions:
            kind, parts = lack(self.searched)
            self.report(("wanted",), kind, **parts)

    def axes(self) -> None:
        """Find the missing teeth, and see that the axes of all meshes are coaxial where they must be."""
        best = self.searched.solutions[0] if self.searched else None
        whole = self.raw._replace(teeth=best.teeth) if best else completed(self.raw)
        fractions = dict(sought(whole))
        for name, teeth in whole.teeth.items():
            if teeth is None and name in fractions:
                self.report(("wheels", name), "part_of_tooth", name=name, teeth=f"{float(fractions[name]):.6g}")
            elif teeth is None:
                self.report(("wheels", name), "teeth_sought", name=name)
        if self.faults:
            return
        for mesh, far, other, wanted in unlike(whole):
            self._not_coaxial(whole, mesh, far, other, wanted)
        for mesh in whole.meshes:
            ring = next((name for name in mesh if name in whole.rings), None)
            if ring and sum(whole.teeth[name] or 0 for name in mesh) >= 0:
                inner = next(name for name in mesh if name != ring)
                self.report(("wheels", ring), "small_ring", ring=ring, inner=inner, teeth=whole.teeth[inner])
        if not self.faults:
            found, wrong_axes = heights(whole)
            for mesh, far, _, wanted in wrong_axes:
                sizes = {"distance": millimetres(far), "wanted": millimetres(wanted)}
                path = "meshes", self.form.meshes.index(mesh)
                self.report(path, "not_in_plane", first=mesh[0], second=mesh[1], **sizes)
            self.train = self._train(whole, found)

    def _not_coaxial(
        self, raw: RawTrain, mesh: tuple[str, str], far: Fraction, other: tuple[str, str], wanted: Fraction
    ) -> None:
        name = mesh[1]
        rest = raw._replace(teeth={**raw.teeth, name: None})
        would = next((teeth for one, teeth in sought(rest) if one == name), Fraction(0))
        sizes = {"distance": millimetres(far), "wanted": millimetres(wanted)}
        pairs = {"first": "-".join(mesh), "second": "-".join(other), "name": name}
        kind = "not_coaxial" if would.denominator == 1 and would >= LEAST_TEETH else "not_coaxial_whole"
        self.report(("meshes", self.form.meshes.index(mesh)), kind, **pairs, **sizes, teeth=f"{float(would):.6g}")

    def _train(self, raw: RawTrain, found: Mapping[str, Fraction]) -> Train:
        form, driving = self.form, self.racks.get(self.form.output, "")  # the wheel that moves the driven rack
        load = form.load if form.force is None else Fraction(form.force) * raw.wheel(driving).radius
        engaged: Mapping[str, tuple[str, ...]] = form.engaged or {"": (*form.brakes, *form.clutches)}
        return Train(
            wheels={name: raw.wheel(name) for name in raw.teeth},
            meshes=raw.meshes,
            carriers=form.carriers,
            joined=form.joined,
            gears=tuple(self._gear(name, some) for name, some in engaged.items()),
            drives=tuple((drive.link, float(drive.speed)) for drive in form.drives),
            output=link_of(driving) if driving else form.output,
            axes=found,
            brakes=form.brakes,
            clutches=form.clutches,
            planets=self.searched.solutions[0].planets if self.searched else form.planets,
            inertia={link: float(size) for link, size in form.inertia.items()},
            load=None if load is None else float(load),
            masses={link: float(size) for link, size in form.masses.items()},
            efficiency=self._efficiency(),
            racks=self.racks,
            driven=form.output if driving else "",
        )

    def _efficiency(self) -> Mapping[tuple[str, str], Fraction]:
        """Give the efficiency of each mesh, if any is given: its own one, or that of all; of what is not told 1."""
        form, usual = self.form, Fraction(self.form.efficiency or 1)
        own = {mesh: Fraction(part) for mesh, part in form.efficiencies.items()}
        if form.efficiency is None and not own:
            return {}
        return {mesh: own.get(mesh, own.get(mesh[::-1], usual)) for mesh in form.meshes}

    def _gear(self, name: str, engaged: tuple[str, ...]) -> BoxGear:
        held = (*self.form.fixed, *(self.form.brakes[one] for one in engaged if one in self.form.brakes))
        locked = tuple(self.form.clutches[one] for one in engaged if one in self.form.clutches)
        return BoxGear(name, tuple(dict.fromkeys(held)), locked)

    def room(self) -> None:
        """See that so many planets stand beside each other and can be put in."""
        train, count = self.train, self.form.planets
        if count is None or count < 2:
            return
        for link, carrier in train.carrier_of.items():
            rows = {row.cross.name: row for row in train.crossing.get(link, ()) if row.tip * count >= HALF_TURN}
            for row in rows.values():
                sizes = {"tip": f"{row.tip:.6g}", "share": f"{HALF_TURN / count:.6g}", "most": int(HALF_TURN / row.tip)}
                self.report(("planets",), "cones_touching", name=row.cross.name, count=count, **sizes)
            for own in (wheel for wheel in train.wheels.values() if wheel.link == link and not wheel.side):
                self._neighbours(own, abs(train.heights[link] - train.heights[carrier]), count)
            for one in assembly(train, link):
                if one.share.denominator != 1:
                    parts = {"share": f"{abs(float(one.share)):.6g}", "likely": _dividing(one.share * count)}
                    kind = "blocks_not_put_in" if one.blocks else "not_put_in"
                    self.report(("planets",), kind, **one.parts(count), **parts)

    def _neighbours(self, wheel: ToothedWheel, far: Fraction, count: int) -> None:
        """See that 2 a sin(pi/k) > d_a = m(z + 2)."""
        across = 2 * far / wheel.module
        if wheel.teeth > clear_of(count, across):
            most = next(k for k in range(1, count) if wheel.teeth > clear_of(k + 1, across))
            chord, tips = 2000 * float(far) * math.sin(math.pi / count), millimetres(wheel.module * (wheel.teeth + TIP))
            sizes = {"chord": f"{chord:.6g}", "tips": tips, "most": most}
            self.report(("planets",), "touching", name=wheel.name, count=count, **sizes)

    def mobilities(self) -> None:
        """See that each gear leaves as many mobilities as there are drives, and that these determine all links."""
        train = self.train
        for gear in train.gears:
            found, wanted = mobility(train, gear), len(train.drives)
            path: Path = ("engaged", gear.name) if gear.name else ("drive",)
            parts: dict[str, Any] = {"links": len(train.links), "equations": len(train.links) - found, "found": found}
            parts |= {"where": message("gears.in_gear", gear=gear.name) if gear.name else "", "wanted": wanted}
            if found > wanted:
                self.report(path, "too_mobile", **parts, more=self._freed(gear, wanted))
            elif found < wanted:
                self.report(path, "locked_train" if not found else "too_held", **parts)
            elif not determined(train, gear):
                self.report(path, "drive_held", **parts, link=", ".join(link for link, _ in train.drives))
        if all(train.output in gear.held for gear in train.gears):
            self.report(("output",), "output_held", name=train.output)

    def crank(self) -> None:
        """See that the train fits the crank that it is before."""
        if geared(self.scene):
            self.faults += CrankTrain(self.train, self.form.drives[0].speed).faults(self.scene)
            if self.form.load is not None and self.scene.part("dynamics") is not None:
                self.report(("load",), "load_of_machine")

    def _freed(self, gear: BoxGear, wanted: int) -> str:
        """Name the links that, held too, leave the mobility that is wanted."""
        links = (link for link in self.train.links if link not in self.train.carrier_of and link not in gear.held)
        tried = ((link, gear._replace(held=(*gear.held, link))) for link in links)
        good = [link for link, one in tried if mobility(self.train, one) == wanted and determined(self.train, one)]
        return ", ".join(good) or FRAME


def _dividing(whole: Fraction) -> str:
    """Name the numbers of planets that divide a sum."""
    numbers = [k for k in range(2, 9) if (whole / k).denominator == 1]
    return ", ".join(map(str, numbers)) or "1"

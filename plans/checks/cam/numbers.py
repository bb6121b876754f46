"""The numbers of cams as plain data, for `solve`: SI units and radians (числа кулачков)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plans.cam.study import LAWS, PROFILE, SIZES, CamStudy
from plans.checks.plain_numbers import pairs, plain
from plans.model.cam import ROLLER
from plans.model.cam_motion import CONSTRUCTION, CamFound, Contour, Extreme, Flaw, Pressing, Shock, Sizes

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True)
class CamNumbers:
    """Cams by one road, and what of them is told."""

    title: str
    by: str
    cams: Sequence[CamFound]
    plans: frozenset[str]

    @property
    def flawed(self) -> bool:
        """Whether something is wrong with a cam."""
        return any(one.flaws for one in self.cams)

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        return {"scene": self.title, "by": self.by, "cams": {one.cam.name: self._cam(one) for one in self.cams}}

    def _cam(self, one: CamFound) -> dict[str, Any]:
        contour = one.contour
        data: dict[str, Any] = {"phi": plain(contour.turned)}
        if LAWS in self.plans:
            travel = contour.travel
            data |= {"S": plain(travel.s), "S'": plain(travel.slope), "S''": plain(travel.bend)}
            data["peaks"] = {name: _extreme(found) for name, found in one.peaks.items()}
            data["shocks"] = [_shock(shock) for shock in one.shocks]
        if SIZES in self.plans:
            data["sizes"] = _sizes(one.sizes, one)
            data["pressure"] = {kind: _extreme(found) for kind, found in one.pressure.items()}
        if PROFILE in self.plans:
            data |= _profile(contour)
            data["sharpest"], data["hollow"] = _extreme(one.sharpest), _extreme(one.hollow)
            if one.pressing is not None:
                data["forces"] = _forces(one.pressing, one.cam.follower.end == ROLLER)
            data["flaws"] = [_flaw(flaw) for flaw in one.flaws]
        return data


def numbers(study: Study, by: str) -> CamNumbers:
    """Give the cams of a scene by a road (row of the table of techniques)."""
    cams: CamStudy = study["cam"]
    found = cams.found if by == CONSTRUCTION else study.comparison("cam").analysis.cams
    return CamNumbers(study.scene.heading(), by, found, study.plans)


def _sizes(sizes: Sizes, one: CamFound) -> dict[str, Any]:
    if one.cam.translates:
        return {"roller": one.roller}
    data: dict[str, Any] = {"R0": sizes.base, "roller": one.roller}
    if one.cam.rocks:
        pivot = [sizes.pivot.real, sizes.pivot.imag]
        return data | {"L": sizes.centre, "psi0": sizes.initial, "O1": pivot, **_face(one)}
    return data | ({} if one.cam.flat else {"e": sizes.offset}) | _face(one)


def _face(one: CamFound) -> dict[str, Any]:
    return {"face": list(one.face)} if one.cam.flat else {}


def _profile(contour: Contour) -> dict[str, Any]:
    data: dict[str, Any] = {
        "pitch": pairs(contour.pitch),
        "profile": pairs(contour.profile),
        "alpha": plain(contour.pressure),
        "rho": plain(contour.radius),
        "sliding": plain(contour.sliding),
    }
    return data if contour.outer is None else data | {"outer": pairs(contour.outer)}


def _forces(one: Pressing, rolls: bool) -> dict[str, Any]:
    """Give what presses the follower on the cam; what a roller would wear, stuck on its pin, is not told."""
    data = {"least": _extreme(one.least), "most": _extreme(one.most), "preload": one.preload}
    return data if rolls else data | {"wear": _extreme(one.wear)}


def _shock(one: Shock) -> dict[str, Any]:
    return {"phi": one.turned, "order": one.order, "jump": one.jump}


def _extreme(one: Extreme | None) -> dict[str, float] | None:
    return None if one is None else {"value": one.value, "phi": one.turned}


def _flaw(one: Flaw) -> dict[str, Any]:
    return {"kind": one.kind, "from": one.start, "to": one.end, "worst": _extreme(one.worst)}

"""The reasons of graphical integration and differentiation, by their keys (пояснения к построению)."""

from __future__ import annotations

from typing import Final

from geometry.strips import Reasons
from plans.words.words import because

REASONS: Final = Reasons(
    axes=because("diagram_axes"),
    pole=because("diagram_pole"),
    start=because("integral_start"),
    mean=because("mean_ordinate"),
    carried=because("mean_carried"),
    ray=because("mean_ray"),
    strip=because("strip_width"),
    edge=because("strip_edge"),
    chord=because("integral_chord"),
    integral=because("integral_point"),
    point=because("curve_point"),
    part=because("curve_part"),
    tangent=because("curve_tangent"),
    slope_ray=because("slope_ray"),
    cut=because("slope_cut"),
    level=because("slope_level"),
    middle=because("slope_place"),
    derivative=because("derivative_point"),
)

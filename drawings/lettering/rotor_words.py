"""The words of a rotor's sheet, English and Russian (уравновешивание роторов)."""

from __future__ import annotations

from typing import Final

ROTOR: Final[dict[str, tuple[str, str]]] = {
    "rotor sheet title": ("Balancing of the rotor", "Уравновешивание ротора"),
    "view along": ("View along the shaft", "Вид вдоль вала"),
    "view across": ("View across the shaft", "Вид поперёк вала"),
    "polygon of moments": ("Polygon of moments", "Многоугольник моментов"),
    "polygon of static moments": ("Polygon of static moments", "Многоугольник статических моментов"),
    "closes by itself": ("closes by itself", "замыкается сам"),
    "no vectors": ("no vectors: all arms are zero", "векторов нет: все плечи равны нулю"),
    "angles alone": ("angles alone, not to scale", "только углы, не в масштабе"),
    "counterweight index": ("cw", "пр"),
    "mass number": ("Mass", "Масса"),
    "m, kg": ("m, kg", "m, кг"), "D, mm": ("D, mm", "D, мм"), "φ, °": ("φ, °", "φ, °"), "h, mm": ("h, mm", "h, мм"),
    "m·D, kg·m": ("m·D, kg·m", "m·D, кг·м"), "m·D·h, kg·m²": ("m·D·h, kg·m²", "m·D·h, кг·м²"),
    "kg*m": ("kg·m", "кг·м"),
    "arms from": ("Arms h from plane {plane}", "Плечи h - от плоскости {plane}"),
    "sums before": ("Before:  ΣmD = {unbalance};  ΣmDh = {couple}",
                    "До уравновешивания:  ΣmD = {unbalance};  ΣmDh = {couple}"),
    "counterweight": ("{letters} = {moment} kg·m at {angle}°;  {parts}",
                      "{letters} = {moment} кг·м под {angle}°;  {parts}"),
    "no counterweight": ("{letters} = 0: nothing to balance", "{letters} = 0: уравновешивать нечего"),
    "counterweight mass": ("m_{{{index}}} = {mass} kg", "m_{{{index}}} = {mass} кг"),
    "counterweight radius": ("D_{{{index}}} = {radius} mm", "D_{{{index}}} = {radius} мм"),
    "static only": ("One plane: static balance only;  a couple ΣmDh = {couple} kg·m² is left",
                    "Одна плоскость: только статическое уравновешивание;  остаётся момент ΣmDh = {couple} кг·м²"),
    "quality before": ("Quality before: e·ω = {quality} mm/s, {grade} by ISO 21940-11",
                       "Точность до уравновешивания: e·ω = {quality} мм/с, {grade} по ISO 21940-11"),
    "no grade": ("beyond G4000", "хуже G4000"),
    "permissible": ("{grade} permits U_{{per}} = {permissible} g·mm, {each} g·mm in each plane",
                    "{grade} допускает U_{{доп}} = {permissible} г·мм, {each} г·мм в каждой плоскости"),
    "permissible in one": ("{grade} permits U_{{per}} = {permissible} g·mm",
                           "{grade} допускает U_{{доп}} = {permissible} г·мм"),
    "residual": ("Residual of the rounded table: {residual} g·mm, {grade}",
                 "Остаток по округлённой таблице: {residual} г·мм, {grade}"),
    "bearing loads": ("Reactions at ω = {speed} rad/s, turning with the rotor:  {before}",
                      "Реакции при ω = {speed} рад/с, вращаются с ротором:  {before}"),
    "bearing loads after": ("after:  {after}", "после:  {after}"),
}  # fmt: skip

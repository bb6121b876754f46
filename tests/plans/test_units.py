"""Quantities: exact decimals in SI, and one clear refusal for each way of writing them wrongly."""

from __future__ import annotations

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.scene import units
from plans.scene.faults import Wrong
from plans.scene.units import UnitKind
from plans.words.words import ENGLISH, said, words
from tests.parts import examples
from tests.rows import over


@over(
    "written, kind, exact",
    [
        ("110 mm", units.LENGTH, "0.11"),
        ("11cm", units.LENGTH, "0.11"),
        ("110 мм", units.LENGTH, "0.11"),
        ("1.1e-1 m", units.LENGTH, "0.11"),
        ("+0.11 m", units.LENGTH, "0.11"),
        ("-30 deg", units.ANGLE, "-30"),
        ("30°", units.ANGLE, "30"),
        ("5 rad/s2", units.ANGULAR_ACCELERATION, "5"),
        ("5 rad/s^2", units.ANGULAR_ACCELERATION, "5"),
        ("5 rad / s²", units.ANGULAR_ACCELERATION, "5"),
        ("2 kg", units.MASS, "2"),
        ("250 g", units.MASS, "0.25"),
        ("0.6 kg·m²", units.INERTIA, "0.6"),
        ("0.6 kg m2", units.INERTIA, "0.6"),
        ("1.5 kN", units.FORCE, "1500"),
        ("-12 N*m", units.MOMENT, "-12"),
        ("40,5 mm", units.LENGTH, "0.0405"),
        ("1,250 мм", units.LENGTH, "0.001250"),
        ("0,5", units.LENGTH, "0.5"),
        ("0,1", units.NUMBER, "0.1"),
        ("3 MM", units.LENGTH, "0.003"),
        ("8 1/s", units.SPEED, "8"),
        ("8 s^-1", units.SPEED, "8"),
        ("8 рад·с⁻¹", units.SPEED, "8"),
        ("8 рад/c", units.SPEED, "8"),  # with a Latin c
        ("2 с^-2", units.ANGULAR_ACCELERATION, "2"),
        ("30 м/мин", units.VELOCITY, "0.5"),
        ("50 кгс", units.FORCE, "490.3325"),
        ("1,2 тс", units.FORCE, "11767.98"),
        ("5 даН", units.FORCE, "50"),
        ("5 КН", units.FORCE, "5000"),
        ("5 H", units.FORCE, "5"),  # a Latin letter for a Russian one
        ("2 мН·м", units.MOMENT, "0.002"),
        ("3 Нм", units.MOMENT, "3"),
        ("2 кгс·см", units.MOMENT, "0.196133"),
        ("0.3 кгс·см·с²", units.INERTIA, "0.02941995"),
        ("20 кг·см²", units.INERTIA, "0.002"),
        ("2 кгс·с²/м", units.MASS, "19.6133"),
        ("3 kN/m", units.STIFFNESS, "3000"),
        ("3 Н/см", units.STIFFNESS, "300"),
        ("2 кгс/мм", units.STIFFNESS, "19613.3"),
        ("3 at", units.PRESSURE, "294199.5"),
        ("2 атм", units.PRESSURE, "202650"),
        ("2 кгс/см2", units.PRESSURE, "196133"),
        ("760 мм рт. ст.", units.PRESSURE, "101325.0144354"),  # 13,595.1 kg/m3 * 9.80665 m/s2 * 0.76 m
        ("0.6 Мпа", units.PRESSURE, "600000"),
        ("7.85 г/см³", units.DENSITY, "7850"),
        ("96 г·мм", units.STATIC_MOMENT, "0.000096"),
        ("-1.5e-13 Н", units.FORCE, "-1.5e-13"),
        (Decimal("-1.5e-13"), units.MOMENT, "-1.5e-13"),
        (Decimal("1e-40"), units.FORCE, "0"),
        (Decimal("0.1"), units.LENGTH, "0.1"),
        (7, units.LENGTH, "7"),
        (Decimal("-0.0"), units.LENGTH, "0"),
    ],
)
def test_a_quantity_is_exact(written: object, kind: UnitKind, exact: str) -> None:
    assert units.quantity(written, kind) == Decimal(exact)


@over(
    "written, kind, fault",
    [
        ("nan m", units.LENGTH, "not_a_quantity"),
        ("inf m", units.LENGTH, "not_a_quantity"),
        ("1_000 mm", units.LENGTH, "not_a_quantity"),
        ("١٢ mm", units.LENGTH, "not_a_quantity"),
        ("１２ mm", units.LENGTH, "not_a_quantity"),
        (".5 m", units.LENGTH, "not_a_quantity"),
        ("", units.LENGTH, "not_a_quantity"),
        ("mm", units.LENGTH, "not_a_quantity"),
        ("5. m", units.LENGTH, "not_a_quantity"),
        ("0x10 m", units.LENGTH, "wrong_unit"),
        ("5", units.LENGTH, "text_number"),
        ("0.5", units.NUMBER, "not_bare"),
        ("1,250 mm", units.LENGTH, "decimal_comma"),
        ("81/s", units.SPEED, "not_a_quantity"),
        ("3 kg", units.LENGTH, "wrong_unit"),
        ("3 м", units.MASS, "wrong_unit"),
        ("3 мПа", units.PRESSURE, "wrong_unit"),
        ("3 мн", units.FORCE, "wrong_unit"),
        ("3 кгсм2", units.INERTIA, "wrong_unit"),
        ("60 deg", units.SPEED, "wrong_unit"),
        ("1e400 m", units.LENGTH, "out_of_range"),
        ("1e-400 m", units.LENGTH, "out_of_range"),
        ("1e99999999999999999999 m", units.LENGTH, "not_finite"),
        (Decimal("NaN"), units.LENGTH, "not_finite"),
        (Decimal("-Infinity"), units.LENGTH, "not_finite"),
        (True, units.LENGTH, "not_a_number"),
        ([1], units.LENGTH, "not_a_number"),
        ({}, units.LENGTH, "not_a_number"),
        ("3 m", units.NUMBER, "not_bare"),
        ("half", units.NUMBER, "not_bare"),
    ],
)
def test_a_refusal_is_of_one_kind(written: object, kind: UnitKind, fault: str) -> None:
    with pytest.raises(Wrong) as refused:
        units.quantity(written, kind)
    assert refused.value.kind == fault


@pytest.mark.parametrize("written", [0, -1, Decimal("9e-10"), Decimal("1.1e9"), "0 mm"])
def test_a_length_is_positive_and_within_reason(written: object) -> None:
    with pytest.raises(Wrong):
        units.length(written)


@given(st.text(max_size=30))
@examples(20)
def test_any_text_is_a_decimal_or_a_refusal(text: str) -> None:
    try:
        assert units.quantity(text, units.LENGTH).is_finite()
    except Wrong as refused:
        assert f"fault.{refused.kind}.expected" in words(ENGLISH)


# Each kind of quantity with a size above all of its machines, in a unit of its own.
ENORMOUS = [
    (units.FORCE, "1e10 kN"), (units.MOMENT, "1e13 kN*m"), (units.MASS, "1e10 t"), (units.INERTIA, "-1e19 kg*m2"),
    (units.STIFFNESS, "-1e13 N/mm"), (units.ACCELERATION, "1e12 cm/s2"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "written"), ENORMOUS, ids=lambda given: getattr(given, "name", given))
def test_a_quantity_of_no_machine_is_refused_in_any_unit(kind: UnitKind, written: str) -> None:
    assert units.quantity(kind.most, kind) == kind.most
    assert units.quantity(-kind.least, kind) == -kind.least
    assert units.quantity(kind.least / 2, kind) == 0
    for value in (written, kind.most * 2):
        with pytest.raises(Wrong) as caught:
            units.quantity(value, kind)
        assert caught.value.kind == "too_large"
        assert caught.value.details["most"] == f"±{kind.most}"


@over(
    "written, kind, cure",
    [
        ("50 кг", units.FORCE, 'сила в килограммах — это кгс: напишите "50 кгс", это "490.3325 Н"'),
        ("2 kg/cm2", units.PRESSURE, 'сила в килограммах — это кгс: напишите "2 кгс/см2", это "196133 Па"'),
        ("2 кгс·м²", units.INERTIA, 'кгс*м2 — единица махового момента GD²: J = GD²/(4g), напишите "0.5 кг*м2"'),
        ("0.8 mPa", units.PRESSURE, 'возможно, "0.8 MPa"?'),
        ("3 ати", units.PRESSURE, 'возможно, "3 ат"?'),
        ("3 мн", units.FORCE, 'возможно, "3 мН" или "3 МН"?'),
        ("3 kg", units.LENGTH, "запишите в одной из этих единиц или числом без единицы, в м"),
    ],
)
def test_a_wrong_unit_is_told_with_its_conversion(written: str, kind: UnitKind, cure: str) -> None:
    with pytest.raises(Wrong) as refused:
        units.quantity(written, kind)
    assert said(refused.value.details["advice"], "ru") == cure


def test_units_are_spelt_in_the_language_that_is_spoken() -> None:
    told = units.Spelt(("N*m", "kgf/cm2", "rpm", "mm/s2"))
    assert (str(told), told.worded("ru")) == ("N·m, kgf/cm², rpm, mm/s²", "Н·м, кгс/см², об/мин, мм/с²")


@pytest.mark.parametrize("written", ["1e100 rad/s", "-1e10", "1e-200 rad/s", "1e11 rpm"])
def test_a_speed_of_no_machine_is_refused(written: str) -> None:
    value = written if " " in written else Decimal(written)
    with pytest.raises(Wrong) as caught:
        units.rate(value, units.SPEED)
    assert caught.value.kind == "out_of_range"

"""The techniques (разделы курса): what each reads of a scene, what studies it, and what it can show.

A row is text alone: nothing of a technique is imported before a scene asks for it. Each text is "module:name".
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any, Final, NamedTuple


class Technique(NamedTuple):
    """What one technique reads of a scene, what studies it, and what it can show."""

    form: str  # what a scene says of it: its tables, and its keys of shared ones
    tables: tuple[str, ...]  # its keys at the top of a file
    shares: Mapping[str, tuple[str, ...]]  # its keys of tables that are the scene's or another technique's
    meaning: str  # of a scene's meaning to the survey of its part, with the faults that only the technique can see
    notes: str  # of a scene to what is odd in its part
    study: str  # of the memo `Study` to its own study, on first demand
    comparison: str  # of a study to the comparison of the two roads
    numbers: str  # of a study, a road and the wanted plans to plain data, for `solve`
    marks: str  # of a study, a position and a name to drafting steps, for `explain`
    plans: tuple[str, ...]  # what it makes, in order: the names that --only and --trace know
    sheets: Mapping[str, tuple[str, ...]]  # what a scene may ask for, each with the plans that it needs
    needs: tuple[str, ...] = ()  # techniques that it rests on
    pace: str = ""  # of the memo to the rates that it gives the drive in each position, or nothing
    borrows: tuple[str, ...] = ()  # techniques whose tables it reads, though it makes none of their plans
    quantities: str = ""  # of a study to all that its tables tell, where that is more than is compared
    asks: str = ""  # of a scene to the techniques that its values refer to, though others like it stand alone


MOTION: Final = ("extremes", "positions", "velocities", "accelerations")
DIAGRAMS: Final = ("diagrams",)
DYNAMICS: Final = ("reduction", "works", "flywheel", "speeds", "run")
BALANCE: Final = ("centre", "counterweights", "costs")
BANK: Final = ("harmonics", "compensators")
CAM: Final = ("laws", "sizes", "profile")

TECHNIQUES: Final[Mapping[str, Technique]] = {
    "linkage": Technique(
        form="plans.linkage.reading.form:LinkageForm",
        tables=("mechanism", "drive", "output"),
        shares={"sheet": ("plans", "position")},
        meaning="plans.linkage.reading.linkage:survey_of",
        notes="plans.linkage.reading.survey:notes_of",
        study="plans.linkage.study:study_of",
        comparison="plans.linkage.quantities:comparison_of",
        quantities="plans.linkage.parts:quantities_of",
        numbers="plans.linkage.quantities:numbers",
        marks="plans.linkage.marks:marks",
        plans=MOTION,
        sheets={"kinematics": (*MOTION, *DIAGRAMS), "positions": ("positions",)},
    ),
    "diagrams": Technique(
        form="plans.diagrams.study:DiagramsForm",
        tables=(),
        shares={"sheet": ("diagrams",)},
        meaning="plans.diagrams.study:DiagramsSurvey",
        notes="plans.diagrams.study:notes_of",
        study="plans.diagrams.study:study_of",
        comparison="plans.diagrams.quantities:comparison_of",
        numbers="plans.diagrams.quantities:numbers",
        marks="plans.diagrams.marks:marks",
        plans=DIAGRAMS,
        sheets={},
        needs=("linkage",),
    ),
    "forces": Technique(
        form="plans.forces.reading.form:ForceForm",
        tables=("masses", "loads", "friction"),
        shares={"drive": ("balancing", "gear"), "sheet": ("forces", "reactions", "hodographs")},
        meaning="plans.forces.reading.references:survey_of",
        notes="plans.forces.reading.references:notes_of",
        study="plans.forces.statics:study_of",
        comparison="plans.forces.quantities:comparison_of",
        numbers="plans.forces.quantities:numbers",
        marks="plans.forces.marks:marks",
        plans=("forces", "friction"),
        sheets={"forces": (*MOTION, "forces", "friction")},
        needs=("linkage",),
    ),
    "dynamics": Technique(
        form="plans.dynamics.form:DynamicsForm",
        tables=("dynamics",),
        shares={"drive": ("speed_from",)},
        meaning="plans.dynamics.reading:survey_of",
        notes="plans.dynamics.reading:notes_of",
        study="plans.dynamics.study:study_of",
        comparison="plans.dynamics.quantities:comparison_of",
        quantities="plans.dynamics.numbers:quantities_of",
        numbers="plans.dynamics.numbers:numbers",
        marks="plans.dynamics.marks:marks",
        plans=DYNAMICS,
        sheets={"dynamics": ("positions", "velocities", *DYNAMICS)},
        needs=("linkage",),
        pace="plans.dynamics.numbers:pace_of",
        borrows=("forces",),
    ),
    "balance": Technique(
        form="plans.balance.form:BalanceForm",
        tables=("balance",),
        shares={},
        meaning="plans.balance.reading:survey_of",
        notes="plans.balance.reading:notes_of",
        study="plans.balance.study:study_of",
        comparison="plans.balance.quantities:comparison_of",
        numbers="plans.balance.quantities:numbers",
        marks="plans.balance.marks:marks",
        plans=BALANCE,
        sheets={"balancing": (*MOTION, *BALANCE)},
        needs=("linkage",),
        borrows=("forces",),
    ),
    "bank": Technique(
        form="plans.bank.reading:BankForm",
        tables=("bank",),
        shares={},
        meaning="plans.bank.reading:survey_of",
        notes="plans.bank.reading:notes_of",
        study="plans.bank.study:study_of",
        comparison="plans.bank.quantities:comparison_of",
        numbers="plans.bank.quantities:numbers",
        marks="plans.bank.marks:marks",
        plans=BANK,
        sheets={"bank": BANK},
        asks="plans.bank.reading:asked_of",
    ),
    "rotor": Technique(
        form="plans.rotor.reading:RotorForm",
        tables=("rotor",),
        shares={},
        meaning="plans.rotor.reading:survey_of",
        notes="plans.rotor.reading:notes_of",
        study="plans.rotor.study:study_of",
        comparison="plans.rotor.quantities:comparison_of",
        numbers="plans.rotor.quantities:numbers",
        marks="plans.rotor.marks:marks",
        plans=("couples", "unbalances", "reactions"),
        sheets={"rotor": ("couples", "unbalances", "reactions")},
    ),
    "cyclogram": Technique(
        form="plans.cyclogram.reading:CyclogramForm",
        tables=("cyclogram",),
        shares={},
        meaning="plans.cyclogram.reading:survey_of",
        notes="plans.cyclogram.reading:notes_of",
        study="plans.cyclogram.study:study_of",
        comparison="plans.cyclogram.quantities:comparison_of",
        numbers="plans.cyclogram.quantities:numbers",
        marks="plans.cyclogram.marks:marks",
        plans=("cyclogram",),
        sheets={"cyclogram": ("extremes", "positions", "cyclogram")},
        needs=("linkage",),
        asks="plans.cyclogram.reading:asked_of",
    ),
    "cam": Technique(
        form="plans.cam.reading.form:CamForm",
        tables=("cam",),
        shares={},
        meaning="plans.cam.reading.cams:survey_of",
        notes="plans.cam.reading.notes:notes_of",
        study="plans.cam.study:study_of",
        comparison="plans.cam.quantities:comparison_of",
        quantities="plans.cam.quantities:quantities_of",
        numbers="plans.cam.numbers:numbers",
        marks="plans.cam.marks:marks",
        plans=CAM,
        sheets={"cam": CAM, "profile": ("profile",)},
        asks="plans.cam.reading.cams:asked_of",
    ),
}


def named(text: str) -> Any:
    """Import what a row of a table names.

    >>> named("plans.techniques:TECHNIQUES")["forces"].needs
    ('linkage',)
    """
    module, _, name = text.partition(":")
    return getattr(import_module(module), name)


def makers_of(sheet: str) -> tuple[str, ...]:
    """Give the techniques that make the plans which a sheet needs.

    >>> makers_of("kinematics")
    ('linkage', 'diagrams')
    """
    needed = TECHNIQUES[technique_of(sheet)].sheets[sheet]
    return tuple(name for name, technique in TECHNIQUES.items() if not set(technique.plans).isdisjoint(needed))


def sheet_of(technique: str) -> str:
    """Give the first sheet of a technique, or of one that has none of its own the first that shows what it makes.

    >>> sheet_of("forces"), sheet_of("diagrams")
    ('forces', 'kinematics')
    """
    own = TECHNIQUES[technique].sheets
    others = (sheet for row in TECHNIQUES.values() for sheet in row.sheets if technique in makers_of(sheet))
    return next(iter(own), "") or next(others)


def technique_of(sheet: str) -> str:
    """Give the technique whose sheet it is.

    >>> technique_of("forces")
    'forces'
    """
    return next(name for name, technique in TECHNIQUES.items() if sheet in technique.sheets)

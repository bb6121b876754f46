"""What a scene says of transfer functions: the positions whose turned plans are drawn (передаточные функции)."""

from __future__ import annotations

from dataclasses import replace

from plans.linkage.reading.linkage import check_numbers
from plans.linkage.reading.survey import LinkageSurvey
from plans.scene import fields as f
from plans.scene.faults import Path
from plans.scene.readers import many
from plans.scene.scene import Meaning, TechniqueForm
from plans.scene.tables import Table, key, table

POSITIONS: Path = ("transfer", "positions")


class TransferTable(Table):
    """The transfer functions of a linkage: where the turned velocity plan is drawn on the scheme."""

    positions: tuple[int, ...] = key(
        many(f.POSITION, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="Positions whose schemes bear the turned velocity plan; default: those of sheet.plans, or one.",
    )


class TransferForm(TechniqueForm):
    """What a scene says of the transfer functions of its linkage."""

    transfer: TransferTable = key(
        table(TransferTable),
        TransferTable(),
        meaning="Transfer functions u, u', S', S'' (передаточные функции), off the velocity plan turned by a quarter.",
    )


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """See that a crank turns, by whose angle all is derived, and that the positions are there."""
    survey, form = replace(meaning.of(LinkageSurvey), faults=[]), meaning.scene.of(TransferForm).transfer
    if survey.form.drive.stroke is not None:
        survey.report(("drive", "stroke"), "no_crank")
    check_numbers(survey, {(*POSITIONS, index): number for index, number in enumerate(form.positions)})
    return survey

"""What a scene says of instant centres: the positions in which they are drawn (мгновенные центры)."""

from __future__ import annotations

from dataclasses import replace

from plans.linkage.reading.linkage import check_numbers
from plans.linkage.reading.survey import LinkageSurvey
from plans.scene import fields as f
from plans.scene.readers import many
from plans.scene.scene import Meaning, TechniqueForm
from plans.scene.tables import Table, key, table


class CentresTable(Table):
    """The instant centres of a linkage: in which positions they are drawn."""

    positions: tuple[int, ...] = key(
        many(f.POSITION, f.NO_REPEATS, first=f.FEW),
        (),
        meaning="Positions whose instant centres are drawn; default: those of sheet.plans, or one.",
    )


class CentresForm(TechniqueForm):
    """What a scene says of the instant centres of its linkage."""

    centres: CentresTable = key(
        table(CentresTable),
        CentresTable(),
        meaning="Instant centres of all links (мгновенные центры), by Aronhold and Kennedy.",
    )


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """See that the positions are there."""
    survey, asked = replace(meaning.of(LinkageSurvey), faults=[]), meaning.scene.of(CentresForm).centres.positions
    check_numbers(survey, {("centres", "positions", index): number for index, number in enumerate(asked)})
    return survey

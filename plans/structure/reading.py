"""What a scene says of the structure of its mechanism: kinds of pairs, contacts, the primary link (структура)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Final

from plans.linkage.reading import fields as g
from plans.linkage.reading.survey import LinkageSurvey
from plans.model.mechanism import FRAME, Mechanism
from plans.model.structure import CYLINDRICAL, LINE, POINT, SLIDING, SPHERICAL, TURNING
from plans.scene import fields as f
from plans.scene.readers import Check, many, named
from plans.scene.scene import Meaning, TechniqueForm
from plans.scene.tables import Missing, Table, key, table

KINDS: Final = {"cylindrical": CYLINDRICAL, "spherical": SPHERICAL, "plane": "E", "tube": "B"}
CONTACTS: Final = {"line": LINE, "point": POINT}
# What a pair may be and still move in the plane as a hinge or a slide does.
FITTING: Final = {TURNING: ("cylindrical", "spherical", "tube"), SLIDING: ("cylindrical", "plane")}


class ContactTable(Table):
    """A contact (высшая пара) of two links: by their centres of curvature, of a flat side by its line."""

    links: tuple[int, ...] = key(
        many(g.ANY_LINK, f.NO_REPEATS, first=Check(f.check_pair, least=2, most=2)),
        meaning="The two links that touch.",
        missing=Missing("pair of links", "links = [1, 2]"),
    )
    between: tuple[str, ...] = key(
        g.LETTERS,
        meaning='Centres of curvature at the place of contact: a point of the first link, then of the other, "AB"; of '
        "a flat side the first link's alone.",
        missing=Missing("letters of the centres of curvature", 'between = "AB"'),
    )
    along: tuple[str, ...] | None = key(
        g.LINE, None, meaning='The flat side, by two points of the second link, "CD"; then one centre is given.'
    )
    radius: Decimal | None = key(
        f.LENGTH, None, meaning="Radius of curvature of the second link, m: of a roller; default: half of the distance."
    )
    kind: str = key(f.words(*CONTACTS), "line", meaning="What they touch in: a line, as cylinders do, or a point.")


class StructureTable(Table):
    """The structure of a mechanism beyond its hinges and slides."""

    pairs: Mapping[str, str] = key(
        named(g.PAIR, f.words(*KINDS), first=f.FEW),
        {},
        meaning='Pairs that allow more than a turn or a slide, by their links: "2-3" = "spherical".',
    )
    contacts: tuple[ContactTable, ...] = key(
        many(table(ContactTable), first=f.FEW), (), meaning="Higher pairs (высшие пары): of a cam, of teeth."
    )
    primary: int | None = key(
        g.MOVING_LINK, None, meaning="The primary link (начальное звено) to be preferred; default: that of the drive."
    )


class StructureForm(TechniqueForm):
    """What a scene says of a structure."""

    structure: StructureTable = key(
        table(StructureTable),
        StructureTable(),
        meaning="Structural analysis (структурный анализ): kinds of pairs, contacts, the primary link.",
    )

    def borrowed(self) -> Iterable[str]:
        """Give the points that its contacts name."""
        return (name for contact in self.structure.contacts for name in (*contact.between, *(contact.along or ())))


def survey_of(meaning: Meaning) -> LinkageSurvey:
    """Examine what a scene says of a structure: that its pairs and contacts are there."""
    survey = replace(meaning.of(LinkageSurvey), faults=[])
    form = meaning.scene.of(StructureForm).structure
    for number, contact in enumerate(form.contacts):
        _see_contact(survey, number, contact)
    if survey.mechanism is not None:
        _see_pairs(survey, form, dict(_joined(survey.mechanism)))
    return survey


def _see_pairs(survey: LinkageSurvey, form: StructureTable, joined: Mapping[str, str]) -> None:
    """See that the pairs that are told are there and move so in the plane, and the primary link is on the frame."""
    for name, kind in form.pairs.items():
        fitting = FITTING.get(joined.get(name, ""), ())
        if not fitting:
            survey.report(("structure", "pairs", name), "no_such_pair", known=", ".join(sorted(joined)))
        elif kind not in fitting:
            survey.report(("structure", "pairs", name), "unfit_kind", kinds=", ".join(fitting))
    framed = [name.removeprefix("0-") for name in sorted(joined) if name.startswith("0-")]
    primary = form.primary
    if primary is not None and survey.know_link(("structure", "primary"), primary) and str(primary) not in framed:
        survey.report(("structure", "primary"), "not_on_frame", links=", ".join(framed))


def _joined(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Give each pair by its links, as a scene names it, with whether it turns or slides."""
    for first, *others in mechanism.hinges.values():
        yield from ((f"{first}-{other}", TURNING) for other in others)
    for slide in mechanism.slides:
        yield f"{min(slide.slider, slide.owner)}-{max(slide.slider, slide.owner)}", SLIDING


def _see_contact(survey: LinkageSurvey, number: int, contact: ContactTable) -> None:
    """See that the centres of a contact are points of its links, two of them, or one beside a flat side."""
    path = ("structure", "contacts", number)
    if not all(link == FRAME or survey.know_link((*path, "links", k), link) for k, link in enumerate(contact.links)):
        return
    wanted = 1 if contact.along else 2
    if len(contact.between) != wanted:
        survey.report((*path, "between"), "centres", found=len(contact.between), wanted=wanted)
        return
    if contact.along and contact.radius is not None:
        survey.report((*path, "radius"), "flat_radius")
    pairs = [*zip(contact.links, contact.between, strict=False)]
    pairs += [(contact.links[1], name) for name in contact.along or ()]
    for link, name in pairs:
        _ = survey.know((*path, "between"), (name,)) and survey.on_link((*path, "between"), link, name)

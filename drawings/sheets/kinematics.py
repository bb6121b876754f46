"""Sheet 1, kinematics: plan of positions, velocity and acceleration plans, table of values (кинематика, лист 1)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from drawings.figures.linkage import position_plan, vector_plan
from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.skeleton import Skeletons, skeletons
from drawings.figures.linkage.vector_plan import Diagram, PlanFigure, diagram, figure
from drawings.layout import value_table
from drawings.layout.composition import Composed, compose
from drawings.layout.labels import Ink, Labels
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.trials import Content
from drawings.lettering.lettering import text_width
from drawings.lettering.words import word
from drawings.page.page import Field, Page, page_of
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Leaf, Text
from drawings.sheets.choice import plans, position
from drawings.sheets.notes import measured, notes, written
from plans.checks.compare import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.order import ORDERS, POSITIONS
from plans.model.structure import formula
from plans.study import Study

# Paper around the plan of positions in sizes of its letters: numbers, symbols, and above it the dimension of a stroke.
MARGINS = Margins(3.5, 3.5, 11.0)
KEPT = 1.0  # mm inside the frame that letters keep clear of


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the kinematics sheets of a scene."""
    return sheets(study["linkage"], study.comparison("linkage"))


def sheets(study: LinkageStudy, comparison: MotionComparison) -> tuple[Leaf, ...]:
    """Lay out the kinematics sheet, and as many following ones as its figures need to stay readable."""
    draft = _Draft(study, comparison)
    composed = compose(draft.content, draft.page)
    return tuple(draft.leaf(one, k + 1, len(composed)) for k, one in enumerate(composed))


def sheet(study: LinkageStudy, comparison: MotionComparison) -> Leaf:
    """Lay out the first kinematics sheet."""
    return sheets(study, comparison)[0]


@dataclass(frozen=True)
class _Draft:
    """What a set of kinematics sheets is drawn from; nothing is made that the scene's sheets do not need."""

    study: LinkageStudy
    comparison: MotionComparison

    @cached_property
    def page(self) -> Page:
        return page_of(self.study.scene)

    @property
    def language(self) -> str:
        return self.study.scene.sheet.language

    @cached_property
    def shown(self) -> int:
        return position(self.study, self.comparison)

    @cached_property
    def drawn(self) -> tuple[int, ...]:
        """The positions whose plans are drawn."""
        return plans(self.study, self.comparison, self.shown)

    @cached_property
    def bones(self) -> Skeletons:
        return skeletons(self.study, self.comparison.construction, self.shown)

    @cached_property
    def said(self) -> list[str]:
        return notes(self.study, self.comparison, self.language)

    @cached_property
    def diagrams(self) -> dict[str, Diagram]:
        """The drawn plans by name, in the order of positions, those that a gap leaves none of left out."""
        drafts = self.study.drafts()
        found = {}
        for order in ORDERS[1:]:
            plan, subject = drafts.plan(order.number), order.plan
            for k in self.drawn:
                found[f"{subject}-{k}"] = diagram(plan, k)
        return found

    @cached_property
    def content(self) -> Content:
        """All that the sheets must show, measured."""
        given = {f"{symbol}_{self.study.mechanism.drive.link}" for symbol in ("ω", "ε")}
        hand = self.page.hand
        lines = value_table.rows(self.comparison, self.drawn, given, self.language) if self.drawn else []
        rows = [[self._picture(f"{order.plan}-{k}") for k in self.drawn] for order in ORDERS[1:]]
        return Content(
            self._main(),
            tuple(rows[0]),
            tuple(rows[1]),
            value_table.table(lines, self.drawn, hand.text, self.language) if lines else None,
            measured(self.said, hand.text),
        )

    def _main(self) -> Picture:
        letter, heading = self.page.hand.letter, self.page.hand.heading
        title = text_width(Text(0j, word(self.language, POSITIONS.plan), heading))
        side, below, above = (size * letter for size in MARGINS)
        margins = Margins(side, below, above + 2.5 * heading)
        return picture(POSITIONS.plan, self.bones.points, ("l", "m"), margins, title)

    def _picture(self, name: str) -> Picture:
        subject, k = name.split("-")
        if self._missing(subject, int(k)):
            return vector_plan.nothing(name, self._why(subject, int(k)), self.page.hand)
        return vector_plan.measured(self.diagrams[name], name, self.page.hand, self.language)

    def _missing(self, subject: str, k: int) -> bool:
        return bool(self.study.lost[k]) or not np.isfinite(self.diagrams[f"{subject}-{k}"].points).all()

    def _why(self, subject: str, k: int) -> str:
        """Say in words why a plan is not drawn."""
        gap = next((g for g in self.comparison.construction.gaps if g.position == k), None)
        reason = word(self.language, gap.reason) if gap else ""
        plan = word(self.language, f"{subject} plan")
        return word(self.language, "no plan", plan=plan, position=k, reason=reason)

    def leaf(self, composed: Composed, number: int, count: int) -> Leaf:
        """Draw one sheet: the lines of all its figures first, then the letters among them."""
        page, language = self.page, self.language
        ink = Ink(*page.size)
        ink.bar(page.field.inset(KEPT))
        groups = self._still(composed, number, count)
        pairs = self._pairs(composed.main) if composed.main is not None else None
        main = self._positions(pairs, composed.main.box) if pairs is not None and composed.main is not None else []
        figures, missing = self._plans(composed)
        ink.draw([*groups, *main, *missing, *(stroke for one in figures for stroke in one.lines)])
        labels = Labels(ink, page.hand.drafted)
        if pairs is not None:
            main.append(position_plan.letters(pairs, labels))
        return Leaf(
            *page.size,
            (page.frame(), page.corners(), *groups, *main, *(one.lettered(labels) for one in figures), *missing),
            title=f"{self.study.scene.title}: {word(language, 'sheet title')}",
            description=" ".join(self.said),
            metadata=self._metadata(composed, number, count),
        )

    def _still(self, composed: Composed, number: int, count: int) -> list[Group]:
        """Draw the title block, the table and the notes."""
        page = self.page
        groups = [page.title_block(self._entries(composed.main, number, count), self.language)]
        table = composed.content.table
        if table is not None and composed.table is not None and composed.setting is not None:
            groups += table.drawn(composed.table, composed.setting, page.hand, self.language)
        if composed.notes is not None:
            groups.append(written(self.said, composed.notes, page.hand.text))
        return groups

    def _scale(self, spot: Spot) -> str:
        return spot.scale.written(self.language, self.study.scene.sheet.notation)

    def _pairs(self, spot: Spot) -> Pairs:
        main = self.content.main
        assert main is not None  # a set of sheets has one plan of positions
        return Pairs(self.bones, main.placed(*spot), self.page.hand)

    def _positions(self, pairs: Pairs, box: Field) -> list[Group]:
        lines = position_plan.figure(pairs, self.language)
        scale = pairs.place.scale.written(self.language, self.study.scene.sheet.notation)
        title = _heading(box, word(self.language, POSITIONS.plan), scale, self.page.hand)
        return [title, Group(tuple(lines), POSITIONS.plan)]

    def _plans(self, composed: Composed) -> tuple[list[PlanFigure], list[Group]]:
        """Draw the plans of this sheet; say of those that have none why."""
        figures: list[PlanFigure] = []
        missing: list[Group] = []
        for one in (*composed.content.velocities, *composed.content.accelerations):
            spot = composed.plans[one.name]
            subject, k = one.name.split("-")
            if self._missing(subject, int(k)):
                text = Text(spot.box.centre, self._why(subject, int(k)), self.page.hand.text, "middle", True)
                missing.append(Group((text,)))
            else:
                shown = self.diagrams[one.name]
                figures.append(figure(shown, one, spot, self._scale(spot), self.page.hand, self.language))
        return figures, missing

    def _entries(self, main: Spot | None, number: int, count: int) -> dict[str, str]:
        table, language = self.study.scene.sheet, self.language
        return {
            "title": self.study.scene.title,
            "subtitle": word(language, "sheet title"),
            "designation": table.designation,
            "drawn": table.drawn,
            "checked": table.checked,
            "approved": table.approved,
            "date": table.date,
            "group": table.group,
            "organisation": table.organisation,
            "scale": main.scale.ratio(language) if main is not None else "",
            "sheet": str(number),
            "sheets": str(count),
        }

    def _metadata(self, composed: Composed, number: int, count: int) -> dict[str, Any]:
        return {
            "sheet": "kinematics",
            "title": self.study.scene.title,
            "structure": formula(self.study.mechanism, self.study.groups),
            "positions": len(self.study.turn),
            "shown": self.shown if composed.main is not None else None,
            "plans": list(self.drawn[composed.positions]),
            "number": number,
            "of": count,
        }


def _heading(box: Field, title: str, scale: str, hand: Hand) -> Group:
    """Write the title and the scale of the largest figure above it."""
    at = complex(box.centre.real, box.top - hand.heading)
    under = at - 1j * (0.6 * hand.heading + hand.title)
    return Group((Text(at, title, hand.heading, "middle", True), Text(under, scale, hand.title, "middle", True)))

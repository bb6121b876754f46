"""The form of a scene as a JSON Schema (2020-12), for editors: keys, units and words are told while one writes."""

from __future__ import annotations

from plans.scene.faults import Path
from plans.scene.fields import ENTRIES_LIMIT, LINKS_LIMIT
from plans.scene.forms import LINK, PAIR, POINT, Form, entries, named
from plans.scene.keys import KEYS, RULES
from plans.scene.scene import TABLES
from plans.scene.tables import REQUIRED

DRAFT = "https://json-schema.org/draft/2020-12/schema"
# Lists of tables, and what the keys of tables of tables are and how many.
LISTS = ("slides", "forces", "moments", "springs")
NAMES = {"masses": (LINK, LINKS_LIMIT), "pairs": (PAIR, ENTRIES_LIMIT), "points": (f"^{POINT}$", ENTRIES_LIMIT)}


def schema() -> Form:
    """Give the JSON Schema of a scene."""
    return {"$schema": DRAFT, "title": "plandraft scene", **_table(())}


def _table(path: Path) -> Form:
    """Give the form of a table: its keys, which of them it must have, and no others."""
    keys = TABLES[path].form
    properties = {key: {"description": KEYS[path][key][0], **_form(path, key)} for key in keys}
    required = [key for key, known in keys.items() if known.default is REQUIRED]
    table: Form = {"type": "object", "properties": properties, "additionalProperties": False}
    return {**table, **({"required": required} if required else {}), **RULES.get(path, {})}


def _form(path: Path, key: str) -> Form:
    """Give the form of a key: its own, a table, a list of tables, or a table of tables by number or name."""
    within, many, own = (*path, key), (*path, key, "*"), KEYS[path][key][1]
    if many in TABLES:
        if key in NAMES:
            return named(_table(many), *NAMES[key])
        return entries(_table(many)) if key in LISTS else entries({"anyOf": [own, _table(many)]}, 2, 2)
    if within not in TABLES:
        return own
    return {"anyOf": [own, _table(within)]} if own else _table(within)

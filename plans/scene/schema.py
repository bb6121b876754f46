"""The form of a scene as a JSON Schema (2020-12), for editors: keys, units and words are told while one writes."""

from __future__ import annotations

from plans.scene.forms import Form, resting
from plans.scene.scene import kinds_of
from plans.scene.tables import REQUIRED, Kinds, form_of
from plans.techniques import TECHNIQUES, Technique, techniques

DRAFT = "https://json-schema.org/draft/2020-12/schema"


def schema() -> Form:
    """Give the JSON Schema of a scene: its keys, and which tables a sheet, a table or a key needs beside it."""
    form = {"$schema": DRAFT, "title": "plandraft scene", **form_of(kinds_of())}
    del form["required"]  # by the scene as a whole: a technique's tables are, where it has a part in it
    needs = {name: _required(kinds_of(resting([name]))) for name in TECHNIQUES}
    tables = {table: needs[name] for name, technique in techniques().items() for table in technique.tables}
    rules = [_on_demand(technique, needs[name]) for name, technique in techniques().items()]
    return {**form, "anyOf": [{"required": [table]} for table in tables], "dependentRequired": tables, "allOf": rules}


def _required(kinds: Kinds) -> list[str]:
    return [name for kind in kinds for name, known in kind.keys.items() if known.default is REQUIRED]


def _on_demand(technique: Technique, required: list[str]) -> Form:
    """Say which tables the sheets of a technique need, and its keys of shared tables."""
    asked = ({"sheets": {"contains": {"const": sheet}}} for sheet in technique.sheets)
    sheets = [{"properties": properties, "required": ["sheets"]} for properties in asked]
    shared = [(table, name) for table, names in technique.shares.items() for name in names]
    keys = [{"properties": {table: {"required": [name]}}, "required": [table]} for table, name in shared]
    return {"if": {"anyOf": sheets + keys}, "then": {"required": required}}

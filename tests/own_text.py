"""The program's own text: each file is parsed once for all that is asked of it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

Asked = ast.Raise | ast.Call | ast.Compare
ASKED = (ast.Raise, ast.Call, ast.Compare)  # quicker to ask for than their union


class Parsed(NamedTuple):
    """What is asked of a text of Python; the whole tree of every file would take half a gigabyte."""

    imports: tuple[tuple[str, int, bool], ...]  # module, line, and whether it waits for a function or serves the types
    asked: tuple[Asked, ...]  # what it raises, calls and compares


@cache
def parsed(text: str) -> Parsed:
    tree = ast.parse(text)
    return Parsed(tuple(imports(tree)), tuple(node for node in ast.walk(tree) if isinstance(node, ASKED)))


def imports(node: ast.AST, late: bool = False) -> Iterator[tuple[str, int, bool]]:
    """Give the imports of a file: module, line, and whether it waits for a function or only serves the types."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.expr):  # no statement stands within an expression
            continue
        if isinstance(child, ast.Import):
            yield from ((name.name, child.lineno, late) for name in child.names)
        elif isinstance(child, ast.ImportFrom):
            yield "." * child.level + (child.module or ""), child.lineno, late
            # `from plans import group` imports a module as `import plans.group` does
            yield from ((f"{child.module}.{name.name}", child.lineno, late) for name in child.names if not child.level)
        else:
            types = isinstance(child, ast.If) and ast.unparse(child.test) == "TYPE_CHECKING"
            yield from imports(child, late or types or isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef))

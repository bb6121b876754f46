"""Faults planted into loaded code (посев ошибок): functions of a file run as if its text were another one."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any, NamedTuple

from tests import homes

ROOT = Path(__file__).parents[2]
OWN = ("geometry", "plans", "drawings")


class DrawingFault(NamedTuple):
    """A fault of drawing: the text of a file, what replaces it, the scene that shows it."""

    name: str
    scene: str
    file: str
    right: str
    wrong: str

    @property
    def text(self) -> str:
        """The file with the fault; its text must be there exactly once, or the table has been left behind."""
        text = (ROOT / self.file).read_text(encoding="utf-8")
        count = text.count(self.right)
        assert count == 1, f"{self.file} has {count} times what the fault {self.name!r} replaces. Fix: renew its text"
        return text.replace(self.right, self.wrong)

    @property
    def module(self) -> ModuleType:
        """The module of the file."""
        return importlib.import_module(self.file.removesuffix(".py").replace("/", "."))


@contextmanager
def planted(fault: DrawingFault) -> Iterator[None]:
    """Let every function of a file do what it does with the fault: who holds one has the faulty one then."""
    module = fault.module
    other: dict[str, Any] = {"__name__": module.__name__, "__file__": module.__file__}
    exec(compile(fault.text, str(module.__file__), "exec", dont_inherit=True), other)
    codes = [(one, one.__code__) for one, _ in _pairs(module.__dict__, other, module.__name__)]
    numbers = {name: module.__dict__[name] for name, one in other.items() if _changed(module, name, one)}
    for one, faulty in list(_pairs(module.__dict__, other, module.__name__)):
        one.__code__ = faulty.__code__
    _set({name: (old, other[name]) for name, old in numbers.items()})
    _forget(module)
    homes.changed = fault.name if fault.file.startswith(homes.COMPOSED) else ""
    try:
        yield
    finally:
        homes.changed = ""
        for one, code in codes:
            one.__code__ = code
        _forget(module)
        _set({name: (other[name], old) for name, old in numbers.items()})


def _forget(module: ModuleType) -> None:
    """Let a module find anew what its functions have kept."""
    for one in vars(module).values():
        if hasattr(one, "cache_clear") and one.__module__ == module.__name__:
            one.cache_clear()


def _pairs(own: Any, other: Any, module: str) -> Iterator[tuple[FunctionType, FunctionType]]:
    """Give the functions of a module or a class, each with that of the same name in another one."""
    for name, new in list(other.items()):
        old = own.get(name)
        if isinstance(new, type) and isinstance(old, type) and new.__module__ == module:
            yield from _pairs(vars(old), vars(new), module)
        pair = _function(old), _function(new)
        if pair[0] is not None and pair[1] is not None and pair[1].__module__ == module:
            yield pair[0], pair[1]


def _function(one: Any) -> FunctionType | None:
    """Give the function behind a method, a property, or what is kept once found."""
    if isinstance(one, property):
        return _function(one.fget)
    if isinstance(one, cached_property):
        return _function(one.func)
    if isinstance(one, staticmethod | classmethod):
        return _function(one.__func__)
    if hasattr(one, "cache_clear"):
        return _function(one.__wrapped__)
    return one if isinstance(one, FunctionType) else None


def _changed(module: ModuleType, name: str, new: Any) -> bool:
    """Tell whether a plain value of a module is another one."""
    own = module.__dict__.get(name)
    return isinstance(new, int | float | str | tuple) and isinstance(own, type(new)) and own != new and name.isupper()


def _set(values: dict[str, tuple[Any, Any]]) -> None:
    """Put other values in the place of those of their names, in every module that holds them."""
    for module in [one for name, one in sys.modules.items() if name.partition(".")[0] in OWN]:
        for name, (old, new) in values.items():
            if module.__dict__.get(name) is old:
                setattr(module, name, new)

"""The trace of a run: what it made, imported and left out, and how long each stage took. Times never enter a file."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib.machinery import ModuleSpec, PathFinder
from typing import TYPE_CHECKING, Any

from plans.words.words import term, word

if TYPE_CHECKING:
    from plans.study import Study

# Libraries that cost a tenth of a run or more, or whose need a scene decides.
LIBRARIES = ("numpy", "svgwrite", "mpmath", "scipy", "shapely", "matplotlib")

# Plans that a trace tells: those that were made, and those that were not.
MADE = {"made": True, "not_made": False}


class TracedMark:
    """The stages of a run in their order, with what each took together; told only where it is asked for."""

    def __init__(self) -> None:
        self.before = time.process_time()
        self.begun = time.perf_counter()
        self.stages: dict[str, float] = {}
        self.imports: dict[str, float] = {}

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Time a stage; what passed before the first one was spent on imports."""
        began = time.perf_counter()
        self.stages.setdefault("imports", began - self.begun)
        try:
            yield
        finally:
            self.stages[name] = self.stages.get(name, 0.0) + time.perf_counter() - began

    def stated(self, study: Study) -> str:
        """Tell the stages, the plans made and not made, the libraries imported and left out."""
        say = partial(word, study.scene.sheet.language)
        plans = [plan for row in study.rows for plan in row.plans]
        made = {key: [plan for plan in plans if (plan in study.made) == there] for key, there in MADE.items()}
        imported = [name for name in LIBRARIES if name in sys.modules]
        groups = {
            **{key: [term(study.scene.sheet.language, "plan", plan) for plan in plans] for key, plans in made.items()},
            "imported": [self._cost(name, say) for name in imported],
            "left_out": [name for name in LIBRARIES if name not in imported],
        }
        return "\n".join(
            (
                *self._stages(study.scene.sheet.language),
                say("trace.before", ms=f"{1000 * self.before:.0f}"),
                *(say(f"trace.{key}", names=", ".join(names) or say("trace.nothing")) for key, names in groups.items()),
            )
        )

    def _stages(self, language: str) -> Iterator[str]:
        total = time.perf_counter() - self.begun
        rows = {**self.stages, "the rest": total - sum(self.stages.values()), "together": total}
        heads = [word(language, f"trace.{head}") for head in ("stage", "ms", "share")]
        yield f"{heads[0]:<20} {heads[1]:>8} {heads[2]:>7}"
        for name, took in rows.items():
            yield f"{term(language, 'stage', name):<20} {1000 * took:>8.1f} {took / total:>7.1%}"

    def _cost(self, name: str, say: Callable[..., str]) -> str:
        if name not in self.imports:
            return say("trace.earlier", name=name)
        return say("trace.cost", name=name, ms=f"{1000 * self.imports[name]:.1f}")


def begin() -> TracedMark:
    """Begin a trace that times the imports of the libraries too."""
    trace = TracedMark()
    sys.meta_path.insert(0, _Watch(trace.imports))
    return trace


class _Watch:
    """Finds the libraries as they are always found, and times their imports, with all that they import themselves."""

    def __init__(self, times: dict[str, float]) -> None:
        self.times = times

    def find_spec(self, name: str, path: Any, target: Any = None) -> ModuleSpec | None:
        """Find a library; leave all else to those who find it always."""
        spec = PathFinder.find_spec(name, path, target) if name in LIBRARIES else None
        if spec is None or spec.loader is None:
            return None
        executed = spec.loader.exec_module

        def timed(module: Any) -> None:
            began = time.perf_counter()
            try:
                executed(module)
            finally:
                self.times[name] = time.perf_counter() - began

        spec.loader.exec_module = timed  # type: ignore[method-assign]
        return spec

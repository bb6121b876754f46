"""Which figures the sheets of a machine's motion must show together, by the analysis (состав листов динамики)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.wrong import Wrong
from plans.analytic.dynamics.rim import wheel
from plans.checks.dynamics_comparison import DynamicsComparison
from plans.dynamics.study import DynamicsStudy
from plans.forces.stroke import asks
from plans.model.flywheel_rim import THICKEST
from plans.words.words import message

# The ways to show the graphs and the loop: in line, on two plates, the graphs on two more.
PLATES = (("machine",), ("diagrams", "energy-mass"), ("moments-works", "energy-speeds", "energy-mass"))
LOAD, SKETCH, BEFORE, RUN = "load_diagram", "flywheel_sketch", "before", "tachogram"
APART = 4.0  # times the range of speeds with the flywheel: what swings more has a graph of its own


class DueFigures(NamedTuple):
    """The machine and what the analysis finds of it."""

    study: DynamicsStudy
    comparison: DynamicsComparison

    def faults(self, shown: Sequence[str]) -> Iterator[Wrong]:
        """See that each figure that is due stands on the sheets, once, and no other."""
        counted, plates = Counter(shown), {name for way in PLATES for name in way}
        due = [*self._drawn_for_loads(), *(self._of_motion() if self.comparison.analysis.cycle is not None else ())]
        if self.comparison.analysis.cycle is not None:
            way = max(PLATES, key=lambda way: (sum(name in counted for name in way), -len(way)))
            due += way
        yield from (message("wrong.missing", name=name) for name in due if not counted[name])
        strangers = [name for name in counted if name in {*plates, SKETCH, BEFORE, RUN} and name not in due]
        strangers += [name for name, count in counted.items() if count > 1 and name not in strangers]
        yield from (message("wrong.stranger", name=name) for name in strangers)

    def _drawn_for_loads(self) -> Iterator[str]:
        """Name the diagram of each load that changes over a stroke."""
        yield from (f"{LOAD}-{one.name}" for one in self.study.statics.machine.loads if asks(one))

    def _of_motion(self) -> Iterator[str]:
        """Name the flywheel's sketch, the speeds without it, the run."""
        analysis, task = self.comparison.analysis, self.study.task
        rim = None if analysis.flywheel is None else wheel(analysis.flywheel.inertia, task.rim)
        if rim is not None and rim.thickness <= THICKEST * rim.diameter:
            yield SKETCH
        before, after = analysis.before, analysis.speeds
        if before is not None and (after is None or (before.inertia != after.inertia and self._wide)):
            yield BEFORE
        run = self.comparison.exact.run
        if run is not None and len(run.t) > 1:
            yield RUN

    @property
    def _wide(self) -> bool:
        """Whether the speeds without the flywheel swing too far to stand among those with it."""
        before, after = self.comparison.analysis.before, self.comparison.analysis.speeds
        assert before is not None and after is not None  # asked before
        ranges = [found.extremes[1] - found.extremes[0] for found in (before, after)]
        return ranges[0] > APART * ranges[1]

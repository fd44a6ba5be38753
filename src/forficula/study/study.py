"""Study: a design, its factors, and what to compute at every point."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from forficula.design import Design
from forficula.displayed import Displayed
from forficula.names import counted
from forficula.results import call
from forficula.study.changes import NO_CHANGES, ChangePlan
from forficula.study.factors import Factor
from forficula.study.refine.boundary_plan import BoundaryPlan
from forficula.study.search_steps import Search

if TYPE_CHECKING:
    from forficula.study.running.study_status import StudyStatus
    from forficula.study.tables.study_table import StudyTable


@dataclass(frozen=True, kw_only=True)
class Study(Displayed):
    """Many runs of one design.

    Attributes:
        name: name in outputs.
        source: source of the values.
        base: the design that is varied.
        factors: what is varied.
        points: values of every point by dotted key, as in a design file; of many points they are computed from the
            index of the point. Other keys have the value of the base.
        sampled: whether the points were sampled. Otherwise they are the grid of all factors; the last varies fastest.
        search: values to try in searches for least values; None to run the protocol unchanged.
        choices: if factors are varied one at a time, the changed value of each choice, by key; the first choice is
            empty (the base). Otherwise empty.
        grid: factors whose whole grid is repeated at every choice; the last varies fastest.
        plan: named changes that the study makes; empty if it varies factors.
        reproduces: name of the paper with which the results are compared; None for no paper.
        boundaries: how the study locates boundaries between outcomes; None if its points are fixed. Before the study
            runs, its points are those of the initial grid. The study of its table has all points.
    """

    name: str
    source: str
    base: Design
    factors: tuple[Factor, ...]
    points: Sequence[Mapping[str, object]]
    sampled: bool
    search: Search | None
    choices: tuple[Mapping[str, object], ...] = ()
    grid: tuple[Factor, ...] = ()
    plan: ChangePlan = NO_CHANGES
    reproduces: str | None = None
    boundaries: BoundaryPlan | None = None

    def run(
        self, out: str | os.PathLike[str] | None = None, *, threads: int = 0, progress: object = None
    ) -> StudyTable:
        """Run all points and return the table; see `forficula.run_study`, which has more options.

        Args:
            out: folder of the journal, in which an interrupted study continues; a temporary one if not given.
            threads: number of threads; 0 for one per core.
            progress: as in `forficula.run`.

        Raises:
            InputError: the folder contains rows of another study or cannot be written.
        """
        table: StudyTable = call("run_study")(self, out, threads=threads, progress=progress)
        return table

    def collect(self, out: str | os.PathLike[str]) -> StudyTable:
        """Return the table of a study that several machines ran in parts (shards), from the rows in a folder.

        Raises:
            InputError: rows are missing, or the folder contains rows of another study.
        """
        table: StudyTable = call("collect")(self, out)
        return table

    def estimate(
        self, out: str | os.PathLike[str] | None = None, *, shard: tuple[int, int] = (1, 1)
    ) -> tuple[int, int, float]:
        """Return the largest number of runs, the number of points to run, and the estimated duration, s.

        The estimate follows from one point for each core of this machine, which are run now.

        Args:
            out: folder of the journal, whose points are not run again.
            shard: number, from 1, and count, if only a shard of the study is estimated.
        """
        most, left, seconds = call("estimate")(self, out, shard=shard)
        return most, left, seconds

    def status(self, out: str | os.PathLike[str]) -> StudyStatus:
        """Return which shards are complete, run, or must run again, as `forficula study --status` does.

        Args:
            out: folder of the journals, which is not changed.
        """
        status: StudyStatus = call("study_status")(self, out)
        return status

    def __repr__(self) -> str:
        """Return the number of points and the varied keys, or the number of changes."""
        keys = ", ".join(factor.key for factor in (*self.factors, *self.grid))
        if self.plan:
            keys = counted(len(self.plan.changes), "change")
        return f"<Study {self.name}: {len(self.points)} points of {self.base.name} over {keys}>"

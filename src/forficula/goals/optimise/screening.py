"""What designs come to by a goal, the cheap before the dear: what fails a limit goes no further."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from forficula.analysis.margin import chained_row
from forficula.design import Design
from forficula.goals.assessor import Assessor, value_of
from forficula.goals.goal import Goal, own_limits
from forficula.goals.outcome_quantity import Source
from forficula.structure import Transition, structure_of
from forficula.study.running.journal import Row

# A structure that only just does not do what is asked misses it by no less.
_JUST = 1e-9
_SIMULATED: tuple[Source, ...] = ("run", "record", "search")


@dataclass(frozen=True, kw_only=True)
class Screened:
    """What is known of a design.

    Attributes:
        design: or why there is none.
        row: with what its sources told, as far as it was asked.
        works: margin of what its protocol asks for; nan where it was not run; 1 where no run is asked for.
        margins: of the goal's own limits, in their order; nan where they were not looked at.
        ruled_out: source of the limit that it failed before anything was run; "" where it was run, or nothing is.
    """

    design: Design | str
    row: Row
    works: float
    margins: tuple[float, ...]
    ruled_out: str

    @property
    def meets(self) -> bool:
        """Whether it works and no limit is missed."""
        return self.works > 0 and all(margin >= 0 for margin in self.margins)

    @property
    def least(self) -> float:
        """The margin that decides, of those that were looked at; -1 of none."""
        return min((margin for margin in (self.works, *self.margins) if not math.isnan(margin)), default=-1.0)


def screened(
    goal: Goal,
    assess: Assessor,
    designs: Sequence[Design | str],
    points: Sequence[Mapping[str, object]] = (),
    *,
    runs_first: bool = False,
) -> list[Screened]:
    """Ask of designs what a goal wants to know, source after source, as long as each meets what was asked before.

    Args:
        goal: what is asked.
        assess: that answers.
        designs: or why there is none.
        points: the values of each that are not the base's.
        runs_first: whether to run them before statics is asked: of designs that most likely meet it, what takes longer
            comes last, and many side by side run in less time than it.
    """
    limits, transitions = own_limits(goal), structure_of(goal.base).transitions
    rows: list[Row] = [{} for _ in designs]
    margins = [[math.nan] * len(limits) for _ in designs]
    works = [math.nan if goal.simulate else 1.0 for _ in designs]
    ruled_out = ["not built" if isinstance(design, str) else "" for design in designs]
    going = [number for number, design in enumerate(designs) if isinstance(design, Design)]
    for sources in sorted(_stages(goal), key=lambda stage: "run" not in stage) if runs_first else _stages(goal):
        told = assess(
            [designs[number] for number in going],
            sources,
            points=[points[number] for number in going] if points else (),
            search=goal.search,
        )
        for number, row in zip(going, told, strict=True):
            rows[number] = rows[number] | row
            for place, limit in enumerate(limits):
                if limit.quantity.source in sources:
                    margins[number][place] = limit.margin(value_of(rows[number], limit.quantity, designs[number]))
            if "run" in sources:
                works[number] = _works(row, transitions)
        failing = [number for number in going if _fails(works[number], margins[number])]
        for number in failing:
            if not set(sources) & set(_SIMULATED):
                ruled_out[number] = sources[0]
        going = [number for number in going if number not in failing]
    return [
        Screened(design=design, row=row, works=work, margins=tuple(margin), ruled_out=out)
        for design, row, work, margin, out in zip(designs, rows, works, margins, ruled_out, strict=True)
    ]


def _stages(goal: Goal) -> list[tuple[Source, ...]]:
    """Sources that are asked together, one stage after another."""
    asked = [source for source in goal.sources if source != "neighbours"]
    runs = tuple(source for source in asked if source in ("run", "record"))
    stages: list[tuple[Source, ...]] = [(source,) for source in asked if source not in _SIMULATED]
    stages += [runs] if runs else []
    return stages + ([("search",)] if "search" in asked else [])


def _works(row: Row, transitions: Sequence[Transition]) -> float:
    """The margin of what a run was to do; one that just does not do it fails, too."""
    margin = chained_row(row, transitions)
    return margin if margin > 0 else min(margin, -_JUST)


def _fails(works: float, margins: Sequence[float]) -> bool:
    return works <= 0 or any(margin < 0 for margin in margins)

"""Evaluation of designs for a goal, from cheap to expensive sources, until a limit is missed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from forficula.analysis.margin import combined_row_margin
from forficula.design import Design
from forficula.goals.assessor import Assessor, value_of
from forficula.goals.goal import Goal, own_limits
from forficula.goals.outcome_quantity import Source
from forficula.structure import Transition, structure_of
from forficula.study.running.journal import Row

# Smallest negative margin of a structure that does not reach the goals of its protocol.
_JUST = 1e-9
_SIMULATED: tuple[Source, ...] = ("run", "record", "search")


@dataclass(frozen=True, kw_only=True)
class Screened:
    """Result of a design.

    Attributes:
        design: the design, or why there is none.
        row: values of its sources, as far as computed.
        works: margin of the protocol; nan if it was not run; 1 if the goal needs no run.
        margins: margins of the goal's own limits, in their order; nan if not computed.
        ruled_out: source of the limit that it missed before any run; "" if it was run, or if the goal needs no run.
    """

    design: Design | str
    row: Row
    works: float
    margins: tuple[float, ...]
    ruled_out: str

    @property
    def meets(self) -> bool:
        """Whether the design works and misses no limit."""
        return self.works > 0 and all(margin >= 0 for margin in self.margins)

    @property
    def least(self) -> float:
        """Smallest margin that was computed; -1 if there is none."""
        return min((margin for margin in (self.works, *self.margins) if not math.isnan(margin)), default=-1.0)


def screened(
    goal: Goal,
    assess: Assessor,
    designs: Sequence[Design | str],
    points: Sequence[Mapping[str, object]] = (),
    *,
    runs_first: bool = False,
) -> list[Screened]:
    """Evaluate designs, one source after another, as long as each design meets the limits so far.

    Args:
        goal: the goal.
        assess: computes rows of designs.
        designs: designs, or why there is none.
        points: values of each design that differ from the base.
        runs_first: whether to run designs before statics. This is faster if most of them meet the goal, because many
            runs side by side take less time than statics.
    """
    limits, transitions = own_limits(goal), structure_of(goal.base).transitions
    rows: list[Row] = [{} for _ in designs]
    margins = [[math.nan] * len(limits) for _ in designs]
    works = [math.nan if goal.simulate else 1.0 for _ in designs]
    ruled_out = ["not built" if isinstance(design, str) else "" for design in designs]
    open_designs = [number for number, design in enumerate(designs) if isinstance(design, Design)]
    for sources in sorted(_stages(goal), key=lambda stage: "run" not in stage) if runs_first else _stages(goal):
        results = assess(
            [designs[number] for number in open_designs],
            sources,
            points=[points[number] for number in open_designs] if points else (),
            search=goal.search,
        )
        for number, row in zip(open_designs, results, strict=True):
            rows[number] = rows[number] | row
            for position, limit in enumerate(limits):
                if limit.quantity.source in sources:
                    margins[number][position] = limit.margin(value_of(rows[number], limit.quantity, designs[number]))
            if "run" in sources:
                works[number] = _works(row, transitions)
        failing = [number for number in open_designs if _fails(works[number], margins[number])]
        for number in failing:
            if not set(sources) & set(_SIMULATED):
                ruled_out[number] = sources[0]
        open_designs = [number for number in open_designs if number not in failing]
    return [
        Screened(design=design, row=row, works=work, margins=tuple(margin), ruled_out=out)
        for design, row, work, margin, out in zip(designs, rows, works, margins, ruled_out, strict=True)
    ]


def _stages(goal: Goal) -> list[tuple[Source, ...]]:
    """Return the sources that are computed together, one stage after another."""
    sources = [source for source in goal.sources if source != "neighbours"]
    runs = tuple(source for source in sources if source in ("run", "record"))
    stages: list[tuple[Source, ...]] = [(source,) for source in sources if source not in _SIMULATED]
    stages += [runs] if runs else []
    return stages + ([("search",)] if "search" in sources else [])


def _works(row: Row, transitions: Sequence[Transition]) -> float:
    """Return the margin of a run's protocol; if a goal is missed, the margin is negative, however small."""
    margin = combined_row_margin(row, transitions)
    return margin if margin > 0 else min(margin, -_JUST)


def _fails(works: float, margins: Sequence[float]) -> bool:
    return works <= 0 or any(margin < 0 for margin in margins)

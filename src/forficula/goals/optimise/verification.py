"""Whether what a search found holds: at a quarter of the timestep, and of fresh neighbours."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.assessor import Assessor
from forficula.goals.goal import Goal
from forficula.goals.optimise.candidate import Candidate, wanted_share
from forficula.goals.optimise.neighbours import Neighbours, neighbour_offsets, neighbours_of
from forficula.goals.optimise.screening import Screened, screened

FINER = 4
# Fresh neighbours, for each that the search asked.
_FRESH = 4
# What tells the draws of the fresh ones from those of the search.
_OTHER_SEED = 1_000_003


@dataclass(frozen=True, kw_only=True)
class Verification:
    """How a candidate does where the search did not look.

    Attributes:
        candidate: that was verified.
        timestep: of its run, s; None where nothing is run.
        finer: what it comes to at a quarter of that; None where nothing is run.
        fresh: what became of neighbours that the search did not ask; None without tolerances.
        holds: whether all limits are met again, that on the probability among them.
    """

    candidate: Candidate
    timestep: float | None
    finer: Screened | None
    fresh: Neighbours | None
    holds: bool

    @property
    def residual(self) -> float | None:
        """The largest share of the energy that is missing at the finer timestep."""
        return None if self.finer is None else self.finer.row.get("residual")


def verified(goal: Goal, assess: Assessor, candidates: Sequence[Candidate], before: int = 0) -> list[Verification]:
    """Verify candidates that meet a goal.

    Args:
        goal: what is asked.
        assess: that answers.
        candidates: that were built.
        before: how many others were verified before and did not hold: each time the fresh neighbours are drawn anew.
    """
    designs = [each.found.design for each in candidates if isinstance(each.found.design, Design)]
    steps = [_timestep(each) for each in candidates]
    finer: list[Screened | None] = [None] * len(candidates)
    if goal.simulate:
        finer = [*screened(goal, assess, [_finer(d, step) for d, step in zip(designs, steps, strict=True)])]
    fresh: list[Neighbours | None] = [None] * len(candidates)
    if goal.deviations:
        offsets = neighbour_offsets(goal, _FRESH * goal.neighbours, goal.seed + _OTHER_SEED + before)
        fresh = [*neighbours_of(goal, assess, designs, offsets, None)]
    wanted = wanted_share(goal)
    return [
        Verification(
            candidate=candidate,
            timestep=step,
            finer=fine,
            # the first that does well enough is taken
            fresh=None if other is None else replace(other, looks=before + 1),
            holds=(fine is None or fine.meets) and (wanted is None or other is None or wanted.margin(other.share) >= 0),
        )
        for candidate, step, fine, other in zip(candidates, steps, finer, fresh, strict=True)
    ]


def _timestep(candidate: Candidate) -> float | None:
    step = candidate.found.row.get("timestep_s")
    return None if step is None else float(step)


def _finer(design: Design, timestep: float | None) -> Design | str:
    """The design at a quarter of a timestep, s."""
    try:
        return design if timestep is None else design.with_values({"protocol.timestep": timestep / FINER})
    except InputError as error:
        return str(error)

"""Deviation in one direction at which a design begins to fail."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

from forficula.serial import Key, Written


class Answer(StrEnum):
    """Result of the run of a deviating design.

    Attributes:
        WORKS: it works.
        FAILS: it does not work.
        UNKNOWN: the run is unreliable.
        OUTSIDE: the design does not exist, because a value is out of its bounds.
    """

    WORKS = "works"
    FAILS = "fails"
    UNKNOWN = "unknown"
    OUTSIDE = "outside"


# returns answers for deviations, each given as the index of a direction and a distance
Ask = Callable[[Sequence[tuple[int, float]]], Sequence[Answer]]


@dataclass(frozen=True, kw_only=True)
class Reach:
    """Range within which a design works in one direction.

    Attributes:
        works: largest tried distance up to which all tried designs work; 0 if none does.
        beyond: smallest tried distance at which the design does not work; None if all work.
        why: answer at that distance; "works" if all work.
    """

    works: Annotated[float, Key("works_to")]
    beyond: Annotated[float | None, Written.NEVER]
    why: Annotated[Answer, Key("beyond")]

    @property
    def fails(self) -> Annotated[float | None, Key("fails_at")]:
        """Smallest tried distance at which the design fails; None if it works, or if the answer before is unknown."""
        return self.beyond if self.why is Answer.FAILS else None


def reaches(ask: Ask, directions: int, steps: Sequence[float], halvings: int) -> list[Reach]:
    """Try steps in each direction from a working design, then bisect between the last success and the first failure.

    The limit up to which designs can be built is not searched. The steps of all directions are requested at once, and
    so is every round of bisection. A failure between two steps that both work is not detected.

    Args:
        ask: returns answers for deviations.
        directions: number of directions.
        steps: distances to try, rising, above 0.
        halvings: number of bisections.
    """
    answers = ask([(direction, step) for direction in range(directions) for step in steps])
    count = len(steps)
    ends = [_first_end(steps, answers[count * direction : count * (direction + 1)]) for direction in range(directions)]
    for _ in range(halvings):
        halved = {
            direction: (reach.works + reach.beyond) / 2
            for direction, reach in enumerate(ends)
            if reach.beyond is not None and reach.why is not Answer.OUTSIDE
        }
        if not halved:
            break
        for (direction, middle), answer in zip(halved.items(), ask(list(halved.items())), strict=True):
            before = ends[direction]
            ends[direction] = (
                Reach(works=middle, beyond=before.beyond, why=before.why)
                if answer is Answer.WORKS
                else Reach(works=before.works, beyond=middle, why=answer)
            )
    return ends


def _first_end(steps: Sequence[float], answers: Sequence[Answer]) -> Reach:
    """Return the range in one direction from the steps alone."""
    works = 0.0
    for step, answer in zip(steps, answers, strict=True):
        if answer is not Answer.WORKS:
            return Reach(works=works, beyond=step, why=answer)
        works = step
    return Reach(works=works, beyond=None, why=Answer.WORKS)

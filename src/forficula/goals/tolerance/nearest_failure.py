"""How far a design may deviate in one direction before it fails."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

from forficula.serial import Key, Written


class Answer(StrEnum):
    """What a run says of a deviated design.

    Attributes:
        WORKS: it works.
        FAILS: it does not.
        UNKNOWN: the run is not to be trusted.
        OUTSIDE: there is no such design, for a value is out of its bounds.
    """

    WORKS = "works"
    FAILS = "fails"
    UNKNOWN = "unknown"
    OUTSIDE = "outside"


# answers to deviations, each given as the number of a direction and how far it goes
Ask = Callable[[Sequence[tuple[int, float]]], Sequence[Answer]]


@dataclass(frozen=True, kw_only=True)
class Reach:
    """How far a design goes in one direction.

    Attributes:
        works: up to where everything that was tried works; 0 where nothing does.
        beyond: the nearest that was tried and does not work; None where everything works.
        why: what it is there; that it works where everything does.
    """

    works: Annotated[float, Key("works_to")]
    beyond: Annotated[float | None, Written.NEVER]
    why: Annotated[Answer, Key("beyond")]

    @property
    def fails(self) -> Annotated[float | None, Key("fails_at")]:
        """The nearest that fails; None where it works, or cannot be told, before that."""
        return self.beyond if self.why is Answer.FAILS else None


def reaches(ask: Ask, directions: int, steps: Sequence[float], halvings: int) -> list[Reach]:
    """Go from where a design works in each direction in steps, then halve the stretch with the first that does not.

    Where a design cannot be built is not looked for. The steps of all directions are asked for at once, and so is every
    round of halving. What fails between two steps and works again at both is not seen.

    Args:
        ask: answers to deviations.
        directions: how many.
        steps: how far to try, rising, above 0.
        halvings: of the stretch between the last step that works and the first that does not.
    """
    answers = ask([(direction, step) for direction in range(directions) for step in steps])
    each = len(steps)
    found = [_first_end(steps, answers[each * direction : each * (direction + 1)]) for direction in range(directions)]
    for _ in range(halvings):
        halved = {
            direction: (reach.works + reach.beyond) / 2
            for direction, reach in enumerate(found)
            if reach.beyond is not None and reach.why is not Answer.OUTSIDE
        }
        if not halved:
            break
        for (direction, middle), answer in zip(halved.items(), ask(list(halved.items())), strict=True):
            before = found[direction]
            found[direction] = (
                Reach(works=middle, beyond=before.beyond, why=before.why)
                if answer is Answer.WORKS
                else Reach(works=before.works, beyond=middle, why=answer)
            )
    return found


def _first_end(steps: Sequence[float], answers: Sequence[Answer]) -> Reach:
    """How far it works in steps alone."""
    works = 0.0
    for step, answer in zip(steps, answers, strict=True):
        if answer is not Answer.WORKS:
            return Reach(works=works, beyond=step, why=answer)
        works = step
    return Reach(works=works, beyond=None, why=Answer.WORKS)

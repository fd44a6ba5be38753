"""What a run came to, as data, and the sentences that say so."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

from forficula.quantities import show_value
from forficula.structure import Transition, Wording


class Verdict(StrEnum):
    """What a run came to."""

    REACHED = "reached"  # every goal
    MOVING = "moving"  # the time limit ended a stage short of its goal while it still moved, or its torque still rose
    STUCK = "stuck"  # at rest short of a goal
    NOT_HELD = "not held"  # a goal was reached under torque, and lost when released
    DIVERGED = "diverged"  # numbers that are no longer finite, or a hinge far beyond its stop
    UNDECIDED = "undecided"  # another one at half the timestep, or from a slightly different start
    UNTRUSTED = "untrusted"  # too much energy is missing for anything to be said
    NOT_BUILT = "not built"

    @property
    def tells(self) -> bool:
        """Whether it says something of the structure, rather than of the computation."""
        return self in (Verdict.REACHED, Verdict.MOVING, Verdict.STUCK, Verdict.NOT_HELD)


SETTLED = "settled"
# why a run at the shortest timestep that was tried is not to be trusted though its energy balances
UNSETTLED = "its outcome still changes with the timestep"
# The only definition of these sentences: pages get them as data and fill in the same fields. A key is a verdict, or a
# verdict with more that is known; "done", "doing", "verb" and "stays" are of a transition's wording.
ENDING_TEXTS = {
    "settled": SETTLED,
    "reached": "{done}",
    "moving": "still {doing}",
    "moving, limit": "still moving when its time to {verb} was over",
    "moving, reading": "still moving at {reading} when its time to {verb} was over",
    "moving, too short": "at its goal for too short a time when its stage was over",
    "moving, torque rises": "at rest under a torque that still rose when its stage was over",
    "stuck": "did not {verb}",
    "stuck, under way": "stuck on the way",
    "stuck, reading": "stuck at {reading}",
    "not held": "did not stay {stays}",
    "not held, early": 'the goal of stage "{stage}" holds before it begins',
    "diverged": "diverged",
    "diverged, time": "diverged at t = {time} s",
    "undecided": "undecided",
    "undecided, why": "undecided: {why}",
    "untrusted": "not to be trusted",
    "untrusted, why": "not to be trusted: {why}",
    "not built": "cannot be built",
    "not built, why": "cannot be built: {why}",
}


@dataclass(frozen=True, kw_only=True)
class Ending:
    """What a run came to, with its numbers.

    Attributes:
        verdict: in a word.
        transition: that it speaks of, the last one that was reached or the one that was missed; None of a protocol that
            drives nothing, and where nothing ran.
        reading: of the transition's measure, furthest from its goal, at the end of its stages, rad or m; None where
            there is none, or where nothing is to be trusted.
        time: when it diverged, s, or None.
        residual: of the energy balance; None where nothing ran, or the run diverged.
        why: there is nothing to run, it is not to be trusted whatever the residual, it did not rest at its goal, or
            that held before; mostly empty.
    """

    verdict: Verdict
    transition: Transition | None = None
    reading: float | None = None
    time: float | None = None
    residual: float | None = None
    why: str = ""

    @property
    def goal(self) -> str:
        """Name of the transition that it speaks of, or "none"."""
        return "none" if self.transition is None else self.transition.name


def ending_text(ending: Ending) -> str:
    """What became of a structure, in a few words."""
    match ending.verdict:
        case Verdict.DIVERGED:
            if ending.time is None:
                return ENDING_TEXTS["diverged"]
            return ENDING_TEXTS["diverged, time"].format(time=f"{ending.time:.4g}")
        case Verdict.UNDECIDED | Verdict.UNTRUSTED if ending.why:
            return ENDING_TEXTS[f"{ending.verdict}, why"].format(why=ending.why)
        case Verdict.UNTRUSTED if ending.residual is not None:
            share = f"{100 * ending.residual:.2g} %" if ending.residual < 1 else "more than was exchanged"
            return ENDING_TEXTS["untrusted, why"].format(why=f"the energy balance misses {share}")
        case Verdict.NOT_BUILT:
            return ENDING_TEXTS["not built, why"].format(why=ending.why)
        case Verdict.STUCK if _on_the_way(ending) and ending.reading is not None:
            return ENDING_TEXTS["stuck, reading"].format(reading=_reading_text(ending.transition, ending.reading))
        case Verdict.MOVING | Verdict.NOT_HELD if ending.why:
            return ending.why
        case Verdict.MOVING if ending.transition is not None:
            verb = ending.transition.wording.verb
            if ending.transition.begun is None or ending.reading is None:
                return ENDING_TEXTS["moving, limit"].format(verb=verb)
            reading = _reading_text(ending.transition, ending.reading)
            return ENDING_TEXTS["moving, reading"].format(reading=reading, verb=verb)
        case _:
            return ending_word(ending)


def ending_word(ending: Ending) -> str:
    """What became of a structure, without its numbers: what many have in common."""
    wording = None if ending.transition is None else ending.transition.wording
    return verdict_word(ending.verdict, wording, under_way=_on_the_way(ending))


def verdict_word(verdict: Verdict, wording: Wording | None, *, under_way: bool = False) -> str:
    """The word of a verdict on a transition.

    Args:
        verdict: on it.
        wording: of the transition; None where there is none.
        under_way: whether it had begun for good.
    """
    if not verdict.tells:
        return ENDING_TEXTS[verdict]
    if wording is None:
        return ENDING_TEXTS["settled"]
    key = "stuck, under way" if verdict is Verdict.STUCK and under_way else verdict
    return ENDING_TEXTS[key].format_map(vars(wording))


def _reading_text(transition: Transition | None, reading: float) -> str:
    if transition is not None and transition.kind == "distance":
        return show_value(reading, "m")
    return f"{math.degrees(reading):.1f} deg"


def _on_the_way(ending: Ending) -> bool:
    transition, reading = ending.transition, ending.reading
    if transition is None or transition.begun is None or reading is None:
        return False
    return reading < transition.begun if transition.furthest == "largest" else reading > transition.begun

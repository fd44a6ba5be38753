"""Verdict of a run, as data, and the sentences that express it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

from forficula.quantities import show_value
from forficula.structure import Transition, Wording


class Verdict(StrEnum):
    """Verdict of a run."""

    REACHED = "reached"  # every goal was reached
    MOVING = "moving"  # a stage ended short of its goal while the structure still moved, or its torque still rose
    STUCK = "stuck"  # at rest short of a goal
    NOT_HELD = "not held"  # a goal was reached under torque, and lost when released
    DIVERGED = "diverged"  # values are not finite, or a hinge is far beyond its stop
    UNDECIDED = "undecided"  # the outcome differs at half the timestep, or from a slightly different start
    UNTRUSTED = "untrusted"  # too much energy is missing for a reliable outcome
    NOT_BUILT = "not built"

    @property
    def conclusive(self) -> bool:
        """Return whether the verdict is conclusive: about the structure and not about the computation."""
        return self in (Verdict.REACHED, Verdict.MOVING, Verdict.STUCK, Verdict.NOT_HELD)


SETTLED = "settled"
# why a run at the shortest timestep tried is unreliable although its energy balance closes
UNSETTLED = "its outcome still changes with the timestep"
# The only definition of these sentences: pages receive them as data and fill in the same fields. A key is a verdict,
# or a verdict with a detail; the fields "done", "doing", "verb" and "stays" come from a transition's wording.
ENDING_TEXTS = {
    "settled": SETTLED,
    "missed": "missed the goal of a stage",
    "missed, stage": 'missed the goal of stage "{stage}"',
    "reached": "{done}",
    "moving": "still {doing}",
    "moving, limit": "still moving when its time to {verb} was over",
    "moving, reading": "still moving at {reading} when its time to {verb} was over",
    "moving, too short": "at its goal when its stage ended, but not for long enough",
    "moving, torque rises": "at rest while its torque was still rising when its stage ended",
    "stuck": "did not {verb}",
    "stuck, under way": "stuck on the way",
    "stuck, reading": "stuck at {reading}",
    "not held": "did not stay {stays}",
    "not held, early": 'the goal of stage "{stage}" is already met before the stage begins',
    "diverged": "diverged",
    "diverged, time": "diverged at t = {time} s",
    "undecided": "undecided",
    "undecided, why": "undecided: {why}",
    "untrusted": "unreliable",
    "untrusted, why": "unreliable: {why}",
    "not built": "cannot be built",
    "not built, why": "cannot be built: {why}",
}


# outcome words of earlier versions, which stored tables of studies may contain
FORMER_WORDS = {"not to be trusted": Verdict.UNTRUSTED}


@dataclass(frozen=True, kw_only=True)
class Ending:
    """Verdict of a run with the numbers that belong to it.

    Attributes:
        verdict: of the run.
        transition: transition that decided it: the missed one, or the last one if all were reached; None for a protocol
            without drives, and if nothing ran.
        reading: reading of the transition's measure furthest from its goal at the end of its stages, rad or m; None
            without a measure, or if the run is unreliable.
        time: when the run diverged, s, or None.
        residual: of the energy balance; None if nothing ran, or if the run diverged.
        why: reason why nothing could run, the run is unreliable whatever its residual, it did not rest at its goal, or
            the goal was met before; mostly empty.
    """

    verdict: Verdict
    transition: Transition | None = None
    reading: float | None = None
    time: float | None = None
    residual: float | None = None
    why: str = ""

    @property
    def goal(self) -> str:
        """Return the name of the deciding transition, or "none"."""
        return "none" if self.transition is None else self.transition.name


def ending_text(ending: Ending) -> str:
    """Return the outcome of a run in a few words."""
    match ending.verdict:
        case Verdict.DIVERGED:
            if ending.time is None:
                return ENDING_TEXTS["diverged"]
            return ENDING_TEXTS["diverged, time"].format(time=f"{ending.time:.4g}")
        case Verdict.UNDECIDED | Verdict.UNTRUSTED if ending.why:
            return ENDING_TEXTS[f"{ending.verdict}, why"].format(why=ending.why)
        case Verdict.UNTRUSTED if ending.residual is not None:
            share = f"{100 * ending.residual:.2g} %" if ending.residual < 1 else "more than the exchanged energy"
            return ENDING_TEXTS["untrusted, why"].format(why=f"the energy balance misses {share}")
        case Verdict.NOT_BUILT:
            return ENDING_TEXTS["not built, why"].format(why=ending.why)
        case Verdict.STUCK if _stuck_on_the_way(ending) and ending.reading is not None:
            return ENDING_TEXTS["stuck, reading"].format(reading=_reading_text(ending.transition, ending.reading))
        case Verdict.MOVING | Verdict.NOT_HELD | Verdict.STUCK if ending.why:
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
    """Return the outcome of a run without its numbers, so that equal outcomes have equal words."""
    wording = None if ending.transition is None else ending.transition.wording
    return verdict_word(ending.verdict, wording, under_way=_stuck_on_the_way(ending))


def verdict_word(verdict: Verdict, wording: Wording | None, *, under_way: bool = False) -> str:
    """Return the word of a verdict on a transition.

    Args:
        verdict: on the transition.
        wording: of the transition; None without a transition.
        under_way: whether the structure had left its first state for good.
    """
    if not verdict.conclusive:
        return ENDING_TEXTS[verdict]
    if wording is None:
        return ENDING_TEXTS["settled" if verdict is Verdict.REACHED else "missed"]
    key = "stuck, under way" if verdict is Verdict.STUCK and under_way else verdict
    return ENDING_TEXTS[key].format_map(vars(wording))


def _reading_text(transition: Transition | None, reading: float) -> str:
    if transition is not None and transition.kind == "distance":
        return show_value(reading, "m")
    return f"{math.degrees(reading):.1f} deg"


def _stuck_on_the_way(ending: Ending) -> bool:
    transition, reading = ending.transition, ending.reading
    if transition is None or transition.begun is None or reading is None:
        return False
    return reading < transition.begun if transition.furthest == "largest" else reading > transition.begun

"""What a run came to, as data, and the sentences that say so."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

from forficula.design import Design
from forficula.quantities import show_value

# A hinge this far past straight, folding, has left the overbend for good.
LEFT_STRAIGHT = math.radians(5.0)


class Verdict(StrEnum):
    """What a run came to."""

    REACHED = "reached"  # every goal
    MOVING = "moving"  # the time limit ended a stage short of its goal while the wing still moved
    STUCK = "stuck"  # at rest short of a goal
    NOT_HELD = "not held"  # a goal was reached under torque, and lost when released
    DIVERGED = "diverged"  # numbers that are no longer finite, or a hinge far beyond its stop
    UNTRUSTED = "untrusted"  # too much energy is missing for anything to be said
    NOT_BUILT = "not built"

    @property
    def tells(self) -> bool:
        """Whether it says something of the wing, rather than of the computation."""
        return self in (Verdict.REACHED, Verdict.MOVING, Verdict.STUCK, Verdict.NOT_HELD)


FOLDED, OPENED = "folded", "folded and opened"
# how many times the allowed residual tells nothing of the timestep that would do
_FAR_OFF = 20
# by verdict and by the drive of the goal, where it matters
_WORDS = {
    (Verdict.REACHED, "none"): "settled",
    (Verdict.REACHED, "fold"): FOLDED,
    (Verdict.REACHED, "unfold"): OPENED,
    (Verdict.MOVING, "fold"): "still folding",
    (Verdict.MOVING, "unfold"): "still opening",
    (Verdict.STUCK, "fold"): "did not fold",
    (Verdict.STUCK, "unfold"): "did not open",
    (Verdict.NOT_HELD, "fold"): "did not stay folded",
    (Verdict.NOT_HELD, "unfold"): "did not stay open",
    (Verdict.DIVERGED, ""): "diverged",
    (Verdict.UNTRUSTED, ""): "not to be trusted",
    (Verdict.NOT_BUILT, ""): "cannot be built",
}
_MORE_TORQUE = {"fold": "Raise protocol.fold_torque, or", "unfold": "Raise protocol.unfold_torque, or"}


@dataclass(frozen=True, kw_only=True)
class Ending:
    """What a run came to, with its numbers.

    Attributes:
        verdict: in a word.
        goal: the drive of the goal that it speaks of, "fold" or "unfold", the last one that was reached or the one that
            was missed; "none" of a protocol that drives nothing.
        angle: of the distal hinge that is furthest from folded, at the end of that goal's stages, rad; None where there
            is none, or where nothing is to be trusted.
        time: when it diverged, s, or None.
        residual: of the energy balance; None where nothing ran, or the run diverged.
        why: there is no wing, it is not to be trusted whatever the residual, or it did not rest at its goal; mostly
            empty.
    """

    verdict: Verdict
    goal: str = "none"
    angle: float | None = None
    time: float | None = None
    residual: float | None = None
    why: str = ""


def ending_text(ending: Ending) -> str:
    """What became of a wing, in a few words."""
    match ending.verdict:
        case Verdict.DIVERGED:
            return "diverged" if ending.time is None else f"diverged at t = {ending.time:.4g} s"
        case Verdict.UNTRUSTED if ending.why:
            return f"not to be trusted: {ending.why}"
        case Verdict.UNTRUSTED if ending.residual is not None:
            share = f"{100 * ending.residual:.2g} %" if ending.residual < 1 else "more than was exchanged"
            return f"not to be trusted: the energy balance misses {share}"
        case Verdict.NOT_BUILT:
            return f"cannot be built: {ending.why}"
        case Verdict.STUCK if _on_the_way(ending) and ending.angle is not None:
            return f"stuck at {math.degrees(ending.angle):.1f} deg"
        case Verdict.MOVING if ending.why:
            return ending.why
        case Verdict.MOVING if ending.goal == "fold" and ending.angle is not None:
            return f"still moving at {math.degrees(ending.angle):.1f} deg when its time to fold was over"
        case Verdict.MOVING:
            return "still moving when its time to open was over"
        case _:
            return ending_word(ending)


def ending_word(ending: Ending) -> str:
    """What became of a wing, without its numbers: what many have in common."""
    if _on_the_way(ending) and ending.verdict is Verdict.STUCK:
        return "stuck on the way"
    return _WORDS.get((ending.verdict, ending.goal)) or _WORDS[ending.verdict, ""]


def ending_advice(ending: Ending, design: Design) -> str:
    """What to try, in a sentence; empty where there is nothing to mend."""
    advice = _advice(ending, design)
    # of a law the stiffness follows
    return advice if design.tendon.law is None else advice.replace("tendon.stiffness", "tendon.area")


def _on_the_way(ending: Ending) -> bool:
    return ending.goal == "fold" and ending.angle is not None and ending.angle < -LEFT_STRAIGHT


def _advice(ending: Ending, design: Design) -> str:
    match ending.verdict, ending.goal:
        case Verdict.DIVERGED, _:
            return 'Take a shorter timestep (protocol.timestep = "auto" chooses one) or a softer membrane.'
        case Verdict.UNTRUSTED, _ if ending.why:
            return "It stands on an edge, where the least change decides: move a value of it away from here."
        case Verdict.UNTRUSTED, _:
            return _shorter_step(ending, design)
        case Verdict.MOVING, goal:
            until = {"fold": "folded", "unfold": "opened"}[goal]
            stage = next(each for each in design.protocol.stages if each.drive == goal or each.until == until)
            return (
                f'It is still on its way: raise the time_limit, {stage.time_limit:.4g} s, of the stage "{stage.name}".'
            )
        case Verdict.NOT_HELD, "fold":
            return (
                "It folded under torque and opened again when released: raise tendon.stiffness, shorten"
                " tendon.rest_length, or raise hinge.damping."
            )
        case Verdict.NOT_HELD, _:
            return (
                "It opened under torque and folded again when released: hold it longer (hold of the unfolding stage),"
                " or raise hinge.overbend or tendon.stiffness so that the open state locks."
            )
        case Verdict.STUCK, "unfold":
            return (
                "Raise protocol.unfold_torque, or take softer or longer tendons (tendon.stiffness, tendon.rest_length)."
            )
        case Verdict.STUCK, _ if _on_the_way(ending):
            return "Raise protocol.fold_torque, or take stiffer or shorter tendons, which pull further into the fold."
        case Verdict.STUCK, _:
            return (
                f"{_MORE_TORQUE['fold']} lower the barrier: softer or longer tendons (tendon.stiffness,"
                " tendon.rest_length), less hinge.overbend."
            )
        case _:
            return ""


def _shorter_step(ending: Ending, design: Design) -> str:
    """The timestep that would do: what is missing falls with it at least in proportion."""
    limit, timestep = design.protocol.residual_limit, design.protocol.timestep
    allowed = f"{100 * limit:.3g} % are allowed (protocol.residual_limit)"
    if ending.residual is None or not ending.residual <= _FAR_OFF * limit or not isinstance(timestep, float):
        return f'Take a shorter timestep: {allowed}; protocol.timestep = "auto" chooses one.'
    needed = timestep * limit / ending.residual
    digit = 10.0 ** math.floor(math.log10(needed))
    needed = math.floor(needed / digit * (1 + 1e-9)) * digit
    return (
        f"Take a timestep of about {show_value(needed, 's')} instead of {show_value(timestep, 's')}: {allowed};"
        ' protocol.timestep = "auto" chooses one.'
    )

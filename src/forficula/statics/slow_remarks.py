"""Sentences on slowly growing torques: that none makes a transition, or that inertia may make it with less."""

from __future__ import annotations

import math

from forficula.design import TORQUE
from forficula.quantities import show_quantity, show_value
from forficula.statics.inertial_help import InertialHelp
from forficula.statics.partial_folds import folding_hinges
from forficula.statics.quasi_static import SlowTransition
from forficula.structure import Structure, Transition

# torques that differ less, of themselves, are the same
_SAME = 0.03


def slow_remarks(
    structure: Structure,
    transition: Transition,
    most: float,
    found: SlowTransition | None,
    span: tuple[float, float] | None,
    helped: InertialHelp | None,
) -> tuple[str, ...]:
    """What to say where no slowly growing torque makes a transition, or where inertia may make it with less.

    Args:
        structure: whose sentences.
        transition: of which.
        most: the largest torque tried, N m.
        found: of one structure; None where it does not rest in the state that the transition starts from.
        span: least and largest torque for structures shifted a little where they snap, N m; None where none makes it.
        helped: a snap after which inertia may make it with less; None without such a snap.
    """
    verb, does = transition.wording.verb, transition.wording.does
    makes = f"makes it {verb}" if " " in verb else f"{does} it"
    if found is None:
        before = _before(structure, transition)
        return (f"no slowly growing torque {makes} from {before}: it does not rest {before}",)
    if found.torque[0] == 0:
        return (f'no torque is needed to {verb}: the goal of "{transition.name}" holds where it rests before',)
    spread: tuple[str, ...] = ()
    if span is not None and span[1] > (1 + _SAME) * span[0]:
        low, high = (show_quantity(torque, TORQUE) for torque in span)
        whole, least = structure.appearance.whole, ""
        if math.isfinite(found.torque[0]):
            least = f", {show_quantity(float(found.torque[0]), TORQUE)},"
        further = f"to {high}" if math.isfinite(span[1]) else f"to more than {show_quantity(most, TORQUE)}"
        spread = (
            f"the least slow torque to {verb}{least} depends on small differences: with hinges shifted by 0.3 deg"
            f" where the {whole} begins to snap, it takes {low} {further}, so inertia and imperfections decide",
        )
    if helped is not None:
        least, snap = (show_quantity(torque, TORQUE) for torque in (float(found.torque[0]), helped.torque))
        whole, released, climb = structure.appearance.whole, helped.released, helped.barrier
        return (
            *spread,
            f"the least slow torque to {verb}, {least}, is an upper bound, because inertia may decide: at {snap} the"
            f" {whole} snaps and releases {show_value(released, 'J')}, and from there the slow path climbs"
            f" {show_value(climb, 'J')}; a run with protocol.rise computes whether less is enough",
        )
    if not math.isnan(found.torque[0]):
        return spread
    started = "" if transition is structure.transitions[0] else f" from {_before(structure, transition)}"
    folding = list(folding_hinges(structure))
    stopped = (
        f", the last hinge stops at {math.degrees(float(found.position[0, folding].max())):.4g} deg" if folding else ""
    )
    if spread:
        return spread
    # what a run can do beyond it
    inertia = f"{stopped}: it {does} by inertia or not at all, which a run tells"
    return (f"no slowly growing torque up to {show_quantity(most, TORQUE)} {makes}{started}{inertia}",)


def _before(structure: Structure, transition: Transition) -> str:
    """Name of the state from which a transition starts, after the first one."""
    return structure.transitions[structure.transitions.index(transition) - 1].state

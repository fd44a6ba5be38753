"""How much more torque a protocol has than its structures need when torques grow slowly."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.statics.tree.potential import Ensemble, ensemble_of
from forficula.statics.tree.quasi_static import (
    SlowTransition,
    least_slow_torque,
    start_state,
    state_after,
    state_beyond,
)
from forficula.structure import Transition, drive_of

# What does not move with the protocol's torque is tried with so many times it.
MORE = 10.0


def least_slow_torques(designs: Sequence[Design], names: Collection[str] | None = None) -> tuple[Array, ...]:
    """The least slowly growing torques of every transition, to 1 %, up to ten times the protocol's.

    Statics without inertia. In a simulation the least torque that makes a transition is no smooth function of the
    design: swinging helps one structure and hinders the next.

    Args:
        designs: that differ in their tendons only.
        names: of the transitions that are asked for; all if not given.

    Returns:
        By transition, each from where the one before leads, N m, nan where none makes it, the protocol does not try or
        it is not asked for, (design,).
    """
    structures = ensemble_of(designs)
    transitions = structures.structure.transitions
    start = start_state(structures).position
    wanted = [each.stage is not None and (names is None or each.name in names) for each in transitions]
    found = []
    for number, transition in enumerate(transitions):
        # where a transition starts depends on those before it
        tried = transition.stage is not None and any(wanted[number:])
        least = np.full(len(designs), np.nan)
        if tried:
            slow = _slow(structures, start, transition)
            least = slow.torque if wanted[number] else least
            start = state_after(structures, transition, slow.torque, slow.position).position
        elif any(wanted[number:]):
            start = state_beyond(structures, transition).position
        found.append(least)
    return tuple(found)


def _slow(structures: Ensemble, start: Array, transition: Transition) -> SlowTransition:
    own = abs(drive_of(structures.structure, transition.drive).strength)
    least, position = np.full(len(start), np.nan), start.copy()
    # what the protocol's torque moves is found more finely without the larger ones
    for most in (own, MORE * own) if own > 0 else ():
        left = np.flatnonzero(np.isnan(least))
        if len(left):
            slow = least_slow_torque(structures.only(left), start[left], transition, most)
            least[left], position[left] = slow.torque, slow.position
    return SlowTransition(torque=least, position=position)


def margin(torque: float, least: float) -> float | None:
    """A torque by the least one; None where there is no such, or none is needed."""
    return torque / least if least > 0 else None

"""Safety factor of a protocol's torques over the least torques that are sufficient when they grow slowly."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.statics.path_dependence import refuse_path_dependence
from forficula.statics.tree.ensemble import Ensemble, ensemble_of
from forficula.statics.tree.quasi_static import (
    SlowTransition,
    least_slow_torque,
    start_state,
    state_after,
    state_beyond,
)
from forficula.structure import Transition, drive_of

# If the protocol's torque is not sufficient, torques up to this many times as large are tried.
LARGEST_TORQUE_FACTOR = 10.0


def least_slow_torques(designs: Sequence[Design], names: Collection[str] | None = None) -> tuple[Array, ...]:
    """Compute the least slowly growing torques of every transition, to 1 %, up to ten times the protocol's torque.

    The computation is static and without inertia. In a simulation the least torque of a transition is not a smooth
    function of the design, because swinging helps one structure and hinders a similar one.

    Args:
        designs: designs that differ only in their tendons.
        names: of the requested transitions; all by default.

    Returns:
        Torques by transition, each from the state to which the one before leads, N m, (design,); nan if no torque makes
        the transition, or if the protocol does not drive it or it is not requested.

    Raises:
        InputError: a crease folds permanently.
    """
    structures = ensemble_of(designs)
    refuse_path_dependence(structures.structure, "least slow torques")
    transitions = structures.structure.transitions
    start = start_state(structures).position
    wanted = [
        transition.stage is not None and (names is None or transition.name in names) for transition in transitions
    ]
    result = []
    for number, transition in enumerate(transitions):
        # the start of a transition depends on the transitions before it
        tried = transition.stage is not None and any(wanted[number:])
        least = np.full(len(designs), np.nan)
        if tried:
            slow = _slow(structures, start, transition)
            least = slow.torque if wanted[number] else least
            start = state_after(structures, transition, slow.torque, slow.position).position
        elif any(wanted[number:]):
            start = state_beyond(structures, transition).position
        result.append(least)
    return tuple(result)


def _slow(structures: Ensemble, start: Array, transition: Transition) -> SlowTransition:
    strength = abs(drive_of(structures.structure, transition.drive).strength)
    least, position = np.full(len(start), np.nan), start.copy()
    # the protocol's own torque is tried first, because a smaller range is resolved more finely
    for most in (strength, LARGEST_TORQUE_FACTOR * strength) if strength > 0 else ():
        left = np.flatnonzero(np.isnan(least))
        if len(left):
            slow = least_slow_torque(structures.only(left), start[left], transition, most)
            least[left], position[left] = slow.torque, slow.position
    return SlowTransition(torque=least, position=position)


def margin(torque: float, least: float) -> float | None:
    """Return a torque divided by the least torque; None if no torque is sufficient, or none is needed."""
    return torque / least if least > 0 else None

"""How much more torque a protocol has than its structures need when torques grow slowly."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.statics.potential import Ensemble, ensemble_of
from forficula.statics.quasi_static import least_slow_torque, start_state, state_beyond
from forficula.structure import Transition, drive_of

Array = NDArray[np.float64]

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
    start = start_state(structures).position
    found = []
    for transition in structures.structure.transitions:
        tried = transition.stage is not None and (names is None or transition.name in names)
        found.append(_least(structures, start, transition) if tried else np.full(len(designs), np.nan))
        if transition is not structures.structure.transitions[-1]:
            start = state_beyond(structures, transition).position
    return tuple(found)


def _least(structures: Ensemble, start: Array, transition: Transition) -> Array:
    own = abs(drive_of(structures.structure, transition.drive).strength)
    least = np.full(len(start), np.nan)
    # what the protocol's torque moves is found more finely without the larger ones
    for most in (own, MORE * own) if own > 0 else ():
        left = np.flatnonzero(np.isnan(least))
        if len(left):
            least[left] = least_slow_torque(structures.only(left), start[left], transition, most).torque
    return least


def margin(torque: float, least: float) -> float | None:
    """A torque by the least one; None where there is no such, or none is needed."""
    return torque / least if least > 0 else None

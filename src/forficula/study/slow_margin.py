"""How much more torque a protocol has than its wings need when torques grow slowly."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.statics.potential import Drive, Section, section
from forficula.statics.quasi_static import flat_state, folded_state, least_slow_torque

Array = NDArray[np.float64]

# What does not move with the protocol's torque is tried with so many times it.
_MORE = 10.0


def least_slow_torques(designs: Sequence[Design]) -> tuple[Array, Array]:
    """The least slowly growing torques that fold and that open, to 1 %, up to ten times the protocol's.

    Statics without inertia. In a simulation the least torque that folds is no smooth function of the design: swinging
    helps one wing and hinders the next.

    Args:
        designs: that differ in their tendons only.

    Returns:
        Of folding from flat and of opening from folded, N m, nan where none does or the protocol does not try,
        (design,).
    """
    wings, protocol = section(designs), designs[0].protocol
    folding = _least(wings, flat_state(wings), "fold", protocol.fold_torque)
    if all(stage.drive != "unfold" for stage in protocol.stages):
        return folding, np.full(len(designs), np.nan)
    return folding, _least(wings, folded_state(wings), "unfold", protocol.unfold_torque)


def _least(wings: Section, start: Array, drive: Drive, own: float) -> Array:
    least = np.full(len(start), np.nan)
    # what the protocol's torque moves is found more finely without the larger ones
    for most in (own, _MORE * own) if own > 0 else ():
        left = np.flatnonzero(np.isnan(least))
        if len(left):
            least[left] = least_slow_torque(wings.only(left), start[left], drive, most).torque
    return least


def margin(torque: float, least: float) -> float | None:
    """A torque by the least one; None where there is no such, or none is needed."""
    return torque / least if least > 0 else None

"""Work on structures whose steps are those of Runge and Kutta, from the states and forces at both ends of each."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.dynamics.steps import Steps


def explicit_works(steps: Steps, travel: Array, damping: Array, timestep: Array) -> dict[str, Array]:
    """Works of dampers and of what stops or closes a structure in each step, (row, step), in the models' units.

    A damper of hinges takes the integral of its squared speed: by Simpson's rule, with the speed in the middle that the
    cubic has which goes through both positions with both speeds, of fourth order. Of other forces powers are known at
    both ends of a step, and the trapezoidal rule is of second order.

    Args:
        steps: of structures that `Model.explicit` is true of.
        travel: of the joints in each step, (row, step, dof).
        damping: of the joints, (row, dof).
        timestep: (row,).
    """
    before = np.concatenate([steps.velocity_before[:, None], steps.velocity[:, :-1]], axis=1)
    after, step, damping = steps.velocity, timestep[:, None, None], damping[:, None]
    middle = 1.5 * travel / step - (before + after) / 4
    assert steps.late is not None
    at_start, at_end = steps.derived, steps.late
    works = {"hinge_damping_work": -step / 6 * damping * (before**2 + 4 * middle**2 + after**2)}
    for name, field in (("elastic_damping_work", "qfrc_damper"), ("stop_work", "qfrc_constraint")):
        own = damping if field == "qfrc_damper" else 0.0
        powers = (at_start[field] + own * before) * before + (at_end[field] + own * after) * after
        works[name] = step / 2 * powers
    return {name: np.sum(work, axis=2) for name, work in works.items()}

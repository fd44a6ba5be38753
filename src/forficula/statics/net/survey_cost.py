"""Expected duration of the landscape of a structure, before it is computed."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

import numpy as np

from forficula.statics.net.energy import expand
from forficula.statics.net.factor import factored
from forficula.statics.net.net_of import is_net, net_of, start_shape
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.potential import potential
from forficula.structure import Structure

# Measured durations of eight landscapes divided by the time of one Newton step of the same net: the least
# (`miura-sheet`) and the largest (`force-clasp`). They do not grow with the size of the net.
_STEPS = (4_600, 17_000)
# the same for six landscapes with contact: `kresling-cell` and `letter-fold`, whose panels touch while loads act on its
# closed state
_STEPS_WITH_CONTACT = (14_000, 81_000)
# Measured durations of landscapes of trees on a table, divided by the time of one step and by the square of the number
# of hinges, are 483 and 1001 for `binder2025-on-table` with two heights of the table, and 235 to 753 for joints and
# strips. [chosen] a range around those of fans, the only ones that take long.
_STEPS_ON_TABLE = (400, 1500)
_TIMED = 8  # steps from which the time of one is measured


def survey_time(structure: Structure) -> tuple[float, float] | None:
    """Return the least and the largest expected duration of the landscape of a structure on this machine, s.

    The time of a step (energy, Hessian and, in nets, factorisation) is measured with this structure. The number of
    steps is that of other landscapes.

    Returns:
        None for a tree without a table, whose landscape takes a few seconds.
    """
    if is_net(structure):
        net = net_of(structure)
        shape = start_shape(structure, net)
        step = _median_time(lambda: factored(expand(net, shape).free))
        least, most = _STEPS if structure.contact is None else _STEPS_WITH_CONTACT
    elif structure.table is not None:
        tree, angles = ensemble([structure]), np.array([[hinge.start for hinge in structure.hinges]])
        step = _median_time(lambda: potential(tree, angles))
        least, most = (steps * len(structure.hinges) ** 2 for steps in _STEPS_ON_TABLE)
    else:
        return None
    return least * step, most * step


def _median_time(compute: Callable[[], object]) -> float:
    """Return the median duration of a computation that is repeated, s."""
    times = []
    for _ in range(_TIMED):
        start = perf_counter()
        compute()
        times.append(perf_counter() - start)
    return sorted(times)[_TIMED // 2]

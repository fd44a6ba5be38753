"""Expected duration of the landscape of a net, before it is computed."""

from __future__ import annotations

from time import perf_counter

from forficula.statics.net.energy import expand
from forficula.statics.net.factor import factored
from forficula.statics.net.net_of import is_net, net_of, start_shape
from forficula.structure import Structure

# Measured durations of eight landscapes divided by the time of one Newton step of the same net: the least
# (`miura-sheet`) and the largest (`force-clasp`). They do not grow with the size of the net.
_STEPS = (4_600, 17_000)
# the same for six landscapes with contact: `kresling-cell` and `letter-fold`, whose panels touch while loads act on its
# closed state
_STEPS_WITH_CONTACT = (14_000, 81_000)
_TIMED = 8  # steps from which the time of one is measured


def survey_time(structure: Structure) -> tuple[float, float] | None:
    """Return the least and the largest expected duration of the landscape of a net on this machine, s.

    The time of a Newton step (energy, Hessian and factorisation) is measured with this net. The number of steps is that
    of other landscapes.

    Returns:
        None for a tree, whose landscape takes a few seconds.
    """
    if not is_net(structure):
        return None
    net = net_of(structure)
    shape = start_shape(structure, net)
    times = []
    for _ in range(_TIMED):
        start = perf_counter()
        factored(expand(net, shape).free)
        times.append(perf_counter() - start)
    step = sorted(times)[_TIMED // 2]
    least, most = _STEPS if structure.contact is None else _STEPS_WITH_CONTACT
    return least * step, most * step

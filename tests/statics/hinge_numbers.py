"""Numbers of a hinge that tests ask for, as its landscape has them, and the closed forms that some of them have."""

import math

from forficula.statics import hinge_landscape
from forficula.statics.tree.hinge import released_energy


def top_barrier(hinge):
    return hinge_landscape(hinge, 2).barrier


def holding_torque(hinge):
    return hinge_landscape(hinge, 2).holding_torque


def peak_opening_torque(hinge):
    return hinge_landscape(hinge, 2).peak_opening


def growth_rate(hinge):
    return hinge_landscape(hinge, 2).growth_rate


def hinge_states(hinge):
    return hinge_landscape(hinge, 2).states


def closed_barrier(hinge):
    """What the tendon gives back from its top to the overbend stop, as a product that keeps its digits."""
    if not hinge.pulls or hinge.top_to_overbend <= 0 or hinge.top_to_fold <= 0:
        return None
    return float(released_energy(hinge, 0.0, hinge.top_to_overbend))


def closed_holding_torque(hinge):
    if not hinge.pulls or hinge.top_to_overbend <= 0:
        return None
    return float(hinge.moment(hinge.overbend))


def closed_growth_rate(hinge):
    """sqrt(-stiffness / inertia) at the top (theory.md, section 3)."""
    if not hinge.pulls or hinge.nearest > 0:
        return None
    return math.sqrt(-float(hinge.stiffness(hinge.top)) / hinge.inertia)


def closed_states(hinge):
    """Ends of the ranges in which a hinge stays, rad, from the overbend to the fold limit.

    The energy falls from the top to both sides for half a turn, because the law pulls and the tendon is longest there.
    So a state is at a stop, or is the range up to it over which the tendon is slack. Beyond half a turn the energy
    rises again, as it fell.
    """
    if not hinge.pulls:
        return [(hinge.overbend, -hinge.fold_limit)]
    sides = ((hinge.top_to_overbend, hinge.overbend, 1), (hinge.top_to_fold, -hinge.fold_limit, -1))
    slack = hinge.slack_distance
    states = []
    for end, stop, side in sides:
        if end <= 0:
            continue
        least = math.pi if slack is None else slack
        if least >= end:
            states.append((stop, stop))
        else:
            farthest = stop if end <= 2 * math.pi - least else side * (2 * math.pi - least) - hinge.offset_angle
            states.append((side * least - hinge.offset_angle, farthest))
    return states

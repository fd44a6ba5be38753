"""Ageing of a tendon with fixed ends: the Maxwell branches of a taut tendon relax, a slack tendon recovers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.material.law.tendon_law import TendonLaw

# number of logarithmically spaced steps of a wait; a slack tendon shortens linearly in each step
_STEPS = 128
_FIRST = 1 / 64  # end of the first step, as a share of the shortest relaxation time, or of a shorter wait


@dataclass(frozen=True, kw_only=True)
class Aged:
    """A tendon after some time.

    Attributes:
        forces: forces of the branches, pulling positive, (branch,), relative to the distance of the ends.
        lost: energy dissipated in the dampers.
        stored_excess: energy that the branches seem to store, because their forces are relative to the distance of the
            ends, in excess of that of the slack tendon.
    """

    forces: Array
    lost: float
    stored_excess: float


def aged(law: TendonLaw, distance: float, forces: Array, time: float, *, drift: float = 0.0) -> Aged:
    """Compute a tendon after its ends have been fixed for some time, in the units of its law.

    If the tendon is taut, the force of every branch decays by exp(-t / time) (Maxwell 1867). A slack tendon that does
    not push, such as a strap that buckles, has the length at which the forces of spring and branches cancel, instead of
    the distance of its ends. As the branches relax, this length approaches the resting length (free recovery), unless
    the tendon becomes taut first. The update of a branch over each step is exact if the length changes linearly.

    Args:
        law: law of the tendon.
        distance: distance of the ends.
        forces: forces of the branches, pulling positive, (branch,), relative to that distance.
        time: duration, > 0.
        drift: distance by which the ends of a taut tendon move apart linearly during this time. The returned forces and
            energies are still relative to `distance`, as if the whole drift followed at the end.
    """
    stiffness = np.array([branch.stiffness for branch in law.branches])
    times = np.array([branch.time for branch in law.branches])
    # the spring outweighs all branches that push, so that it pulls all the time
    if not law.lets_go or _force(law, distance) + np.minimum(forces, 0.0).sum() >= 0:
        follows = stiffness * -np.expm1(-time / times) * times / time
        faded = forces * np.exp(-time / times) + (follows - stiffness) * drift
        return Aged(forces=faded, lost=float(np.sum((forces**2 - faded**2) / (2 * stiffness))), stored_excess=0.0)
    # actual length of the slack tendon, and the forces of the branches at this length
    length = _slack_length(law, distance, forces, stiffness)
    actual = forces + stiffness * (length - distance)
    first = _energy(law, length, actual, stiffness), float(np.sum(forces**2 / (2 * stiffness)))
    ends = np.geomspace(_FIRST * min(time, float(times.min())), time, _STEPS)
    for step in np.diff(ends, prepend=0.0):
        fading = np.exp(-step / times)
        follows = stiffness * -np.expm1(-step / times) * times / step
        shorter = _slack_length(law, distance, fading * actual + follows * (distance - length), follows)
        actual, length = fading * actual + follows * (shorter - length), shorter
    relative = actual - stiffness * (length - distance)
    last = _energy(law, length, actual, stiffness), float(np.sum(relative**2 / (2 * stiffness)))
    lost = first[0] - last[0]
    return Aged(forces=relative, lost=lost, stored_excess=last[1] - first[1] + lost)


def _slack_length(law: TendonLaw, distance: float, forces: Array, follows: Array) -> float:
    """Compute the length at which the total force is 0, or the distance of the ends if the tendon is taut.

    Args:
        law: law of the tendon.
        distance: distance of the ends.
        forces: forces of the branches at that distance, (branch,).
        follows: effective stiffness of the branches for a change of length, (branch,).
    """
    total, slope, rest = float(forces.sum()), float(follows.sum()), law.rest_length
    if _force(law, distance) + total >= 0:
        return distance
    linear, *others = law.stiffness
    if not any(others):
        return (linear * rest + slope * distance - total) / (linear + slope)
    # at this length spring and branches both pull
    end = max(rest, distance - total / slope)
    root = scipy.optimize.brentq(
        lambda length: _force(law, length) + total + slope * (length - distance), distance, end, xtol=1e-15
    )
    return float(root)


def _force(law: TendonLaw, length: float) -> float:
    """Return the force of the spring of the material, which pushes if it is shorter than its resting length."""
    rest = law.rest_length
    return float(np.copysign(law.elastic.force(rest + abs(length - rest)), length - rest))


def _energy(law: TendonLaw, length: float, forces: Array, stiffness: Array) -> float:
    rest = law.rest_length
    return float(law.elastic.energy(rest + abs(length - rest)) + np.sum(forces**2 / (2 * stiffness)))

"""What time does to a tendon whose ends stay where they are: taut, its Maxwell branches relax; slack, it recovers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.material.law.tendon_law import TendonLaw

# parts of a wait, evenly by its logarithm, over each of which a slack tendon grows shorter evenly
_PARTS = 128
_FIRST = 1 / 64  # of the shortest relaxation time, or of a shorter wait


@dataclass(frozen=True, kw_only=True)
class Aged:
    """A tendon after some time.

    Attributes:
        forces: of its branches, pulling positive, (branch,), as they count from the distance of its ends.
        lost: energy that its dampers turned into heat.
        spared: by how much more energy its branches seem to store, counted so, than a slack tendon does.
    """

    forces: Array
    lost: float
    spared: float


def aged(law: TendonLaw, distance: float, forces: Array, time: float, *, drift: float = 0.0) -> Aged:
    """A tendon after its ends have stayed where they are for some time; units are the law's.

    Taut, every branch fades by exp(-t / time) (Maxwell 1867). The branches of a slack tendon that lets go, a strap that
    buckles, are not as long as its ends are apart but as it is itself, where spring and branches cancel; as they relax
    that comes to its resting length (free recovery), or it is taut before. The update of a branch over each part is
    exact where the length changes evenly.

    Args:
        law: of the tendon.
        distance: of its ends.
        forces: of its branches, pulling positive, (branch,), as they count from that distance.
        time: that passes, > 0.
        drift: by which its ends move apart evenly meanwhile if it is taut. The forces still count from the distance
            before, as if it took place at once and afterwards; what is lost goes by them.
    """
    stiffness = np.array([branch.stiffness for branch in law.branches])
    times = np.array([branch.time for branch in law.branches])
    # the spring outweighs all branches that push, so that it pulls all the time
    if not law.lets_go or _force(law, distance) + np.minimum(forces, 0.0).sum() >= 0:
        follows = stiffness * -np.expm1(-time / times) * times / time
        faded = forces * np.exp(-time / times) + (follows - stiffness) * drift
        return Aged(forces=faded, lost=float(np.sum((forces**2 - faded**2) / (2 * stiffness))), spared=0.0)
    # of the tendon's own length and the forces at it
    length = _own_length(law, distance, forces, stiffness)
    own = forces + stiffness * (length - distance)
    first = _energy(law, length, own, stiffness), float(np.sum(forces**2 / (2 * stiffness)))
    ends = np.geomspace(_FIRST * min(time, float(times.min())), time, _PARTS)
    for part in np.diff(ends, prepend=0.0):
        fading = np.exp(-part / times)
        follows = stiffness * -np.expm1(-part / times) * times / part
        shorter = _own_length(law, distance, fading * own + follows * (distance - length), follows)
        own, length = fading * own + follows * (shorter - length), shorter
    counted = own - stiffness * (length - distance)
    last = _energy(law, length, own, stiffness), float(np.sum(counted**2 / (2 * stiffness)))
    lost = first[0] - last[0]
    return Aged(forces=counted, lost=lost, spared=last[1] - first[1] + lost)


def _own_length(law: TendonLaw, distance: float, forces: Array, follows: Array) -> float:
    """The length, no less than a distance, from which on it pulls; branches follow it with some stiffness."""
    total, slope, rest = float(forces.sum()), float(follows.sum()), law.rest_length
    if _force(law, distance) + total >= 0:
        return distance
    linear, *others = law.stiffness
    if not any(others):
        return (linear * rest + slope * distance - total) / (linear + slope)
    # there both pull
    end = max(rest, distance - total / slope)
    root = scipy.optimize.brentq(
        lambda length: _force(law, length) + total + slope * (length - distance), distance, end, xtol=1e-15
    )
    return float(root)


def _force(law: TendonLaw, length: float) -> float:
    """Of its spring, as the material has it that buckles: shorter than it rests it pushes."""
    rest = law.rest_length
    return float(np.copysign(law.elastic.force(rest + abs(length - rest)), length - rest))


def _energy(law: TendonLaw, length: float, forces: Array, stiffness: Array) -> float:
    rest = law.rest_length
    return float(law.elastic.energy(rest + abs(length - rest)) + np.sum(forces**2 / (2 * stiffness)))

"""What the parts of a net bear in a shape."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.statics.net.energy import membrane_stresses, sides_of
from forficula.statics.net.net import Net, Shape


@dataclass(frozen=True, kw_only=True, eq=False)
class Strength:
    """Strains, forces and moments, in the order of the net's parts.

    Attributes:
        strains: of the bars, (spring,); 0 for those without a resting length.
        forces: of the bars, tension positive, N, (spring,).
        moments: of the creases, slopes of their energies by their angles, N m, (crease,).
        pulls: of the tendons, N, (tendon,).
        extensions: of the tendons beyond their resting lengths, over these, (tendon,).
        stresses: of the membranes, principal second Piola-Kirchhoff stresses, the larger first, Pa, (triangle, 2).
    """

    strains: Array
    forces: Array
    moments: Array
    pulls: Array
    extensions: Array
    stresses: Array


def strength(net: Net, shape: Shape) -> Strength:
    """What every part bears."""
    bars, tendons, _, _ = sides_of(net, shape.positions)
    rest, length = net.springs.rest_length, np.linalg.norm(bars, axis=1)
    law, span = net.tendons.law, np.linalg.norm(tendons, axis=1)
    longer = np.maximum(span - law.rest_length, 0.0)
    return Strength(
        strains=np.divide(length - rest, rest, out=np.zeros_like(rest), where=rest > 0),
        forces=net.springs.stiffness * (length - rest),
        moments=net.creases.law.moment(shape.angles),
        pulls=law.force(span),
        extensions=np.divide(longer, law.rest_length, out=np.zeros_like(span), where=np.asarray(law.rest_length) > 0),
        stresses=membrane_stresses(net, shape),
    )

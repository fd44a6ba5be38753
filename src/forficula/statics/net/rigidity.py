"""Numbers of mechanisms and of states of self-stress of a net with rigid bars and flat facets."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, eye_array, kron, vstack

from forficula.arrays import Array, Indices
from forficula.pattern.facts.rigidity import nullity
from forficula.statics.net.energy import angle_slopes
from forficula.statics.net.net import Flags, Net, NetShape
from forficula.statics.net.supports import loose_motions


@dataclass(frozen=True, kw_only=True)
class NetRigidity:
    """Counts that follow from the rigidity matrix of a net.

    Attributes:
        degrees_of_freedom: number of first-order mechanisms, besides rigid-body motions.
        rigid_motions: number of rigid-body motions that the supports allow.
        self_stresses: number of states of self-stress, which are stresses in equilibrium without a load.
    """

    degrees_of_freedom: int
    rigid_motions: int
    self_stresses: int


def rigidity_matrix(net: Net, shape: NetShape, stiff: Flags) -> csr_array:
    """Compute the derivatives of bar lengths and of stiff creases' angles (times the net's size) by displacements.

    The rows are those of a truss (Pellegrino and Calladine 1986, doi 10.1016/0020-7683(86)90014-4), with facets kept
    flat as by Schenk and Guest (2011, Origami 5, 291-303).

    Args:
        net: net; only its bars with a resting length count.
        shape: of the net.
        stiff: creases that do not turn, such as diagonals of flat facets, (crease,).

    Returns:
        Dimensionless matrix, (bar and stiff crease, free coordinate).
    """
    slopes, layout = angle_slopes(net, shape)
    bars, tendons = layout.counts[:2]
    sides = layout.sides[:bars] @ shape.positions
    long = np.flatnonzero(net.springs.rest_length > 0)
    along = sides[long] / np.linalg.norm(sides[long], axis=1)[:, None]
    by_side = kron(csr_array(layout.sides), eye_array(3), format="csr")
    lengths = _rows(along.reshape(-1, 3), 3 * long[:, None] + np.arange(3), by_side.shape[0])
    turning = np.flatnonzero(stiff)
    sides_of_crease = bars + tendons + turning[:, None] + slopes.shape[2] * np.arange(3)
    columns = (3 * sides_of_crease[:, :, None] + np.arange(3)).reshape(-1, 9)
    angles = _rows(net.size * slopes[:, :, turning].T.reshape(-1, 9), columns, by_side.shape[0])
    return csr_array((vstack((lengths, angles), format="csr") @ by_side)[:, net.free.ravel()])


def rigidity(net: Net, shape: NetShape, stiff: Flags) -> NetRigidity:
    """Count mechanisms of first order and states of self-stress; arguments as for `rigidity_matrix`."""
    matrix = rigidity_matrix(net, shape, stiff)
    zeros, _ = nullity(matrix)
    rigid = loose_motions(net, shape.positions).shape[2]
    rank = matrix.shape[1] - zeros
    return NetRigidity(degrees_of_freedom=zeros - rigid, rigid_motions=rigid, self_stresses=matrix.shape[0] - rank)


def _rows(numbers: Array, columns: Indices, width: int) -> csr_array:
    count, per_row = numbers.shape
    return csr_array((numbers.ravel(), columns.ravel(), per_row * np.arange(count + 1)), shape=(count, width))

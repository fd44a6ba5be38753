"""Small vibrations of a net about rest: natural frequencies and the shapes of motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import csc_array, eye_array, kron
from scipy.sparse.linalg import LinearOperator, eigsh

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.statics.net.energy import expand
from forficula.statics.net.factor import as_dense, factored
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import rigid_motions

_DENSE = 200  # coordinates up to which all modes are computed
_SHIFT = 1e-6  # below 0, as a share of the scale of the eigenvalues
_LARGEST = 1e6  # shift that no eigenvalue exceeds, as a multiple of the largest stiffness per mass
_RIGID = 1e-3  # largest deforming share of a mode that counts as a rigid-body motion


@dataclass(frozen=True, kw_only=True, eq=False)
class Modes:
    """Natural modes of a net, the slowest first.

    Attributes:
        frequencies: Hz, (mode,); a negative one is the growth rate of an unstable mode, divided by 2 pi.
        shapes: normalised to a kinetic energy of 1/2 J at 1 m/s, (mode, node, 3).
        rigid: whether a mode is a rigid-body motion, (mode,).
    """

    frequencies: Array
    shapes: Array
    rigid: Flags


def natural_modes(net: Net, shape: NetShape, count: int = 10) -> Modes:
    """Compute the slowest modes about a resting shape from the generalised eigenproblem of Hessian and masses.

    The eigenproblem is inverted about a shift slightly below 0, which stays regular if rigid-body motions are free.
    Rounding in the stiffest modes then hardly disturbs the slowest ones. Larger nets are solved by Lanczos' method
    (Ericsson and Ruhe 1980, doi 10.1090/S0025-5718-1980-0583502-2).

    Args:
        net: net with its own supports only.
        shape: at rest.
        count: number of modes, including rigid-body motions.

    Raises:
        InputError: no mass moves, or a coordinate without a mass is not stable.
    """
    curvature = expand(net, shape).free
    flags = net.free.ravel()
    masses = csc_array(kron(net.mass_matrix, eye_array(3), format="csr")[flags][:, flags])
    heavy = masses.diagonal()
    if not np.any(heavy > 0):
        raise InputError("net.masses: need some > 0 that move, got none")
    size = len(heavy)
    count = min(count, int(np.count_nonzero(heavy > 0)))
    shift = _SHIFT * float(curvature.diagonal().max() / heavy[heavy > 0].mean())
    if size <= _DENSE or count > size // 2:
        squares, vectors = _dense_modes(as_dense(curvature), masses.toarray(), shift, count)
    else:
        parts = factored(csc_array(curvature + shift * masses))
        solve = LinearOperator((size, size), matvec=parts.solve, dtype=np.float64)
        begin = np.random.default_rng(0).standard_normal(size)
        squares, vectors = eigsh(curvature, count, masses, sigma=-shift, OPinv=solve, v0=begin)
    order = np.argsort(squares)
    shapes = np.zeros((count, *net.nodes.shape))
    shapes[:, net.free] = vectors.T[order]
    squares = squares[order]
    return Modes(
        frequencies=np.sign(squares) * np.sqrt(np.abs(squares)) / (2 * np.pi),
        shapes=shapes,
        rigid=_rigid(net, shape, shapes),
    )


def _dense_modes(stiffness: Array, masses: Array, shift: float, count: int) -> tuple[Array, Array]:
    """Compute the slowest modes; coordinates without a mass follow the others statically.

    The inverse of each shifted eigenvalue is an eigenvalue of the masses relative to the shifted stiffness. The shift
    grows until that stiffness is positive definite.
    """
    largest = _LARGEST * float(np.abs(stiffness).max() / masses.max())
    while factored(stiffness + shift * masses).index:
        shift *= 2
        if shift > largest:
            raise InputError("net.masses: need some > 0 at all coordinates that are not stable, got none at one")
    inverse, vectors = eigh(masses, stiffness + shift * masses)
    inverse, vectors = inverse[: -count - 1 : -1], vectors[:, : -count - 1 : -1]
    # normalised to the masses instead of the shifted stiffness
    return 1 / inverse - shift, vectors / np.sqrt(inverse)


def _rigid(net: Net, shape: NetShape, shapes: Array) -> Flags:
    motions = rigid_motions(shape.positions).reshape(net.nodes.size, -1)
    flat = shapes.reshape(len(shapes), -1)
    left = flat - flat @ motions @ motions.T
    return np.asarray(np.linalg.norm(left, axis=1) <= _RIGID * np.linalg.norm(flat, axis=1))

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
from forficula.statics.net.factor import Matrix, as_dense, factored
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import rigid_motions

_DENSE = 200  # coordinates up to which all modes are computed
_SHIFT = 1e-6  # below 0, as a share of the scale of the eigenvalues
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

    Larger nets are solved by Lanczos' method about a shift slightly below 0 (Ericsson and Ruhe 1980, doi
    10.1090/S0025-5718-1980-0583502-2), which stays regular if rigid-body motions are free.

    Args:
        net: net with its own supports only.
        shape: at rest.
        count: number of modes, including rigid-body motions.

    Raises:
        InputError: no mass moves.
    """
    curvature = expand(net, shape).free
    flags = net.free.ravel()
    masses = csc_array(kron(net.mass_matrix, eye_array(3), format="csr")[flags][:, flags])
    heavy = masses.diagonal()
    if not np.any(heavy > 0):
        raise InputError("net.masses: need some > 0 that move, got none")
    size = len(heavy)
    count = min(count, int(np.count_nonzero(heavy > 0)))
    if size <= _DENSE or count > size // 2:
        squares, vectors = _all_modes(curvature, masses)
        squares, vectors = squares[:count], vectors[:, :count]
    else:
        scale = float(curvature.diagonal().max() / heavy[heavy > 0].mean())
        sigma = -_SHIFT * scale
        parts = factored(csc_array(curvature - sigma * masses))
        solve = LinearOperator((size, size), matvec=parts.solve, dtype=np.float64)
        begin = np.random.default_rng(0).standard_normal(size)
        squares, vectors = eigsh(curvature, count, masses, sigma=sigma, OPinv=solve, v0=begin)
    order = np.argsort(squares)
    shapes = np.zeros((count, *net.nodes.shape))
    shapes[:, net.free] = vectors.T[order]
    squares = squares[order]
    return Modes(
        frequencies=np.sign(squares) * np.sqrt(np.abs(squares)) / (2 * np.pi),
        shapes=shapes,
        rigid=_rigid(net, shape, shapes),
    )


def _all_modes(curvature: Matrix, masses: csc_array) -> tuple[Array, Array]:
    """Compute all modes; coordinates without a mass follow the others statically."""
    stiff, heavy = as_dense(curvature), masses.toarray()
    light = np.asarray(np.abs(heavy).sum(axis=1)) == 0
    follow = np.eye(len(stiff))[:, ~light]
    if light.any():
        follow[light] = -np.linalg.lstsq(stiff[np.ix_(light, light)], stiff[np.ix_(light, ~light)])[0]
    squares, vectors = eigh(follow.T @ stiff @ follow, follow.T @ heavy @ follow)
    return squares, follow @ vectors


def _rigid(net: Net, shape: NetShape, shapes: Array) -> Flags:
    motions = rigid_motions(shape.positions).reshape(net.nodes.size, -1)
    flat = shapes.reshape(len(shapes), -1)
    left = flat - flat @ motions @ motions.T
    return np.asarray(np.linalg.norm(left, axis=1) <= _RIGID * np.linalg.norm(flat, axis=1))

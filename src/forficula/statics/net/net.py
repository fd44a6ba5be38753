"""A net of points, bars, creases, tendons and membranes: the model of the static solver for nets."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, diags_array

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_turn import CreaseTurn
from forficula.material.law.tendon_law import ElasticLaw
from forficula.statics.net.contact.net_contact import NetContact, Pressing
from forficula.statics.planes import Planes

Flags = NDArray[np.bool_]

_NO_PAIRS = np.zeros((0, 2), dtype=np.int64)
_NONE = np.zeros(0)
TIGHTER = 100.0  # stiffness of rigid parts with forces, divided by their stiffness on the way to an equilibrium


@dataclass(frozen=True, kw_only=True, eq=False)
class Springs:
    """Bars that pull and push: the energy is stiffness (length - rest_length)^2 / 2.

    Attributes:
        points: their ends, (spring, 2).
        stiffness: N/m, (spring,).
        rest_length: m, (spring,); 0 is allowed.
        rigid: numbers of bars and, after them, of pins with a rest length of 0, at the end of the springs, whose
            stretches vanish at equilibrium; see `rigid_forces`.
    """

    points: Indices = field(default_factory=lambda: _NO_PAIRS)
    stiffness: Array = field(default_factory=lambda: _NONE)
    rest_length: Array = field(default_factory=lambda: _NONE)
    rigid: tuple[int, int] = (0, 0)

    @property
    def rigid_parts(self) -> tuple[slice, slice]:
        """Return which springs are rigid bars and which are rigid pins."""
        bars, pins = self.rigid
        count = len(self.points)
        return slice(count - bars - pins, count - pins), slice(count - pins, count)

    def tightened(self, forces: RigidForces | None) -> Array:
        """Return the stiffness, N/m, (spring,): that of rigid parts is larger once these have forces."""
        if forces is None:
            return self.stiffness
        stiffness = self.stiffness.copy()
        stiffness[self.rigid_parts[0].start :] *= TIGHTER
        return stiffness


@dataclass(frozen=True, kw_only=True, eq=False)
class NetCreases:
    """Creases at which panels turn against each other, including diagonals of facets.

    Attributes:
        points: tail, head and the left corner of the panel on the left; tail, head and the right corner of the panel on
            the right, (crease, 6). If the crease does not open, both tails are the same point, and so are both heads.
        law: its numbers are scalars or (crease,).
    """

    points: Indices = field(default_factory=lambda: np.zeros((0, 6), dtype=np.int64))
    law: CreaseLaw = field(default_factory=lambda: CreaseLaw(stiffness=_NONE))


@dataclass(frozen=True, kw_only=True, eq=False)
class Tendons:
    """Springs that only pull.

    Attributes:
        points: their ends, (tendon, 2).
        law: its numbers are (tendon,).
    """

    points: Indices = field(default_factory=lambda: _NO_PAIRS)
    law: ElasticLaw = field(default_factory=lambda: ElasticLaw(rest_length=_NONE, linear=_NONE))  # type: ignore[arg-type]


@dataclass(frozen=True, kw_only=True, eq=False)
class Triangles:
    """Membranes: triangles of constant strain under plane stress.

    Attributes:
        points: corners, counterclockwise, (triangle, 3).
        built: positions of the corners without stress, m, (triangle, 3, 3): corner by corner.
        youngs_modulus: Pa, one or (triangle,).
        poisson_ratio: one or (triangle,).
        thickness: m, one or (triangle,).
    """

    points: Indices
    built: Array
    youngs_modulus: Array | float
    poisson_ratio: Array | float
    thickness: Array | float


@dataclass(frozen=True, kw_only=True, eq=False)
class NetPlanes:
    """Planes of a net: its table, and supports of points of plates.

    Attributes:
        planes: with their points.
        weights: of the nodes at these points, (plane, node).
    """

    planes: Planes
    weights: csr_array

    def depths(self, positions: Array) -> Array:
        """Return `Planes.depths`, m, (plane,), for positions of the nodes, m, (node, 3)."""
        return self.planes.depths(self.weights @ positions)


@dataclass(frozen=True, kw_only=True, eq=False)
class Net:
    """Nodes with coordinates, and elastic parts between points that are weighted sums of nodes.

    Attributes:
        nodes: as built, m, (node, 3).
        free: coordinates that no support holds, (node, 3).
        points: weights of the nodes, (point, node); rows add up to 1.
        masses: lumped, kg, (node,); or a matrix, the same for x, y and z, (node, node).
        springs: bars that pull and push.
        creases: between panels.
        tendons: that only pull.
        membranes: None for none.
        gravity: acceleration along `down`, m/s^2.
        down: unit vector along gravity.
        planes: above or on which points stay; None for none.
        contact: of its triangles; None if they pass through each other.

    Raises:
        InputError: arrays do not fit each other, or numbers are out of bounds.
    """

    nodes: Array
    free: Flags
    points: csr_array
    masses: csr_array | Array
    springs: Springs = field(default_factory=Springs)
    creases: NetCreases = field(default_factory=NetCreases)
    tendons: Tendons = field(default_factory=Tendons)
    membranes: Triangles | None = None
    gravity: float = 0.0
    down: tuple[float, float, float] = (0.0, 0.0, -1.0)
    planes: NetPlanes | None = None
    contact: NetContact | None = None

    def __post_init__(self) -> None:
        count = len(self.nodes)
        for name, got, need in (
            ("nodes", self.nodes.shape, (count, 3)),
            ("free", self.free.shape, (count, 3)),
            ("points", self.points.shape, (self.points.shape[0], count)),
            ("masses", self.masses.shape[:1], (count,)),
            ("springs.stiffness", self.springs.stiffness.shape, (len(self.springs.points),)),
            ("springs.rest_length", self.springs.rest_length.shape, (len(self.springs.points),)),
        ):
            if got != need:
                raise InputError(f"net.{name}: need an array of shape {need}, got {got}")
        if not np.all(np.isfinite(self.nodes)):
            raise InputError("net.nodes: need finite coordinates, got some that are not")
        if not (count and self.size > 0):
            raise InputError(f"net.nodes: need some that are apart, got {count} at one place")
        sums = np.asarray(self.points.sum(axis=1)).ravel()
        if not np.allclose(sums, 1.0):
            raise InputError(f"net.points: need weights that add up to 1, got {sums[np.argmax(np.abs(sums - 1))]:g}")
        used = [self.springs.points, self.creases.points, self.tendons.points]
        used += [] if self.membranes is None else [self.membranes.points]
        numbers = np.concatenate([points.ravel() for points in used])
        if len(numbers) and not (numbers.min() >= 0 and numbers.max() < len(sums)):
            raise InputError(f"net: need points between 0 and {len(sums) - 1}, got {numbers.min()} to {numbers.max()}")
        for name, value in (("stiffness", self.springs.stiffness), ("rest_length", self.springs.rest_length)):
            if not np.all(np.isfinite(value) & (value >= 0)):
                raise InputError(f"net.springs.{name}: need finite numbers >= 0, got {np.min(value):g}")

    @property
    def mass_matrix(self) -> csr_array:
        """Return the mass matrix of the nodes, the same for x, y and z, kg, (node, node)."""
        return csr_array(self.masses if self.masses.ndim == 2 else diags_array(np.asarray(self.masses)))

    @cached_property
    def size(self) -> float:
        """Return the largest extent as built of nodes that have a mass or move, m."""
        heavy = np.asarray(abs(self.mass_matrix).sum(axis=1)).ravel() > 0
        moving = heavy | self.free.any(axis=1)
        return float(np.ptp(self.nodes[moving] if moving.any() else self.nodes, axis=0).max())


@dataclass(frozen=True, kw_only=True, eq=False)
class RigidForces:
    """Forces of the rigid bars and pins of a net, at their exact lengths.

    Attributes:
        bars: tensions, N, (bar,).
        pins: on the second end of each pin, towards the first one, N, (3, pin).
        change: largest change of a force in the last update, as a share of the largest force.
        updates: number of updates since the net left another equilibrium.
    """

    bars: Array
    pins: Array
    change: float
    updates: int = 0


@dataclass(frozen=True, kw_only=True, eq=False)
class NetShape:
    """Shape of a net.

    Attributes:
        positions: of the nodes, m, (node, 3).
        angles: of the creases, rad, (crease,); beyond +-pi if one panel went through the other.
        turn: of the creases, by which the net moved to this shape: their memory and angles when the motion began, and
            its duration; None for new creases.
        pressing: forces between elements that touch, at equilibrium; None for none.
        rigid: forces of rigid bars and pins, at equilibrium; None for 0.
    """

    positions: Array
    angles: Array
    turn: CreaseTurn | None = None
    pressing: Pressing | None = None
    rigid: RigidForces | None = None

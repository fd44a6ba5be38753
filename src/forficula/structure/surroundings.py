"""Surroundings of a structure and of its parts: stops, contact, a table, supports of points, and air or water."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from forficula.arrays import Array, Indices
from forficula.structure.parts import PointMass


@dataclass(frozen=True, kw_only=True)
class Stops:
    """Compliance of stops, length limits or contacts, independent of the timestep.

    For an inertia I that meets it, a stop is a spring and a damper with the angular frequency 1 / (T zeta) and the
    damping ratio zeta. Its moment at a penetration r is -I (r / (T zeta)^2 + 2 r' / T), and it never pulls.

    Attributes:
        time_constant: T, s.
        damping_ratio: zeta, in (0, 1].
    """

    time_constant: float
    damping_ratio: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Contact:
    """Contact between bars and sheets.

    Attributes:
        thickness: distance between the mid-planes of touching sheets, m; for bars their diameters apply, for plates and
            facets their own distances if they have some.
        friction: Coulomb's friction coefficient.
        stops: compliance of a contact.
        automatic: whether the design leaves the time constant to the run, so that it is that of the first run.
    """

    thickness: float
    friction: float = 0.0
    stops: Stops
    automatic: bool = False


@dataclass(frozen=True, kw_only=True)
class Table:
    """A plane normal to gravity that no part passes through.

    Attributes:
        height: distance from the origin against the direction of gravity, m.
        friction: Coulomb's friction coefficient.
        stops: compliance of contact with the table.
    """

    height: float
    friction: float = 0.0
    stops: Stops


@dataclass(frozen=True, kw_only=True, eq=False)
class Hold:
    """A support that keeps a point of a plate at its position as built along one direction of the ground.

    Attributes:
        name: name of the support.
        point: number of the point.
        axis: unit vector, (3,).
    """

    name: str
    point: int
    axis: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Medium:
    """Air or water around a structure, which resists motion of its panels along their normals.

    A strip of a panel with width w has, per area, an added mass of pi rho w / 4 (Lamb 1932, Hydrodynamics, article 71:
    pi rho w^2 / 4 per length). At a speed v along the normal, the pressure on the strip is
    rho C_D v |v| / 2 + 32 mu v / (pi w). The first term is that of a plate at high Reynolds numbers (Hoerner 1965), the
    second that of a disc of diameter w at low ones (16 mu a U broadside: Lamb 1932, article 339). The model is
    quasi-steady: no vortices persist. It ignores resistance to motion in the plane of a panel, shielding of one panel
    by another, effects of the ends of a panel, and the resistance of bars.

    Attributes:
        density: kg/m^3.
        viscosity: Pa s.
        carriers: numbers of the bodies that carry the corners of triangles, (triangle, 3).
        places: positions of these corners in the axes of their bodies, m, (triangle, 3, 3).
        widths: widths of the strips to which the triangles belong, m, (triangle,).
        masses: added masses, which have no weight. They act in every direction, so too much for motion in the plane of
            a panel. In air, the added mass along normals has 1.2 % of the reference wing's kinetic energy, and the
            excess adds 0.4 % while the wing folds and 0.7 % while it opens. In water, the excess is 1.2 (folding) and
            0.9 times (opening) the energy of the added mass along normals.
    """

    density: float
    viscosity: float
    carriers: Indices
    places: Array
    widths: Array
    masses: tuple[PointMass, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Panel:
    """A triangle of a panel as built.

    Attributes:
        corners: positions of the corners, m, (3, 3).
        carriers: numbers of the bodies that carry the corners.
        width: width of the strip to which the triangle belongs, m.
    """

    corners: Array
    carriers: Sequence[int]
    width: float

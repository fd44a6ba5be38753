"""Membranes: elastic sheets between bodies, and their surfaces."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.arrays import Array, Indices


@dataclass(frozen=True, kw_only=True, eq=False)
class MembraneLaw:
    """The law of an elastic sheet that resists stretching only.

    Attributes:
        youngs_modulus: Pa.
        poisson_ratio: Poisson's ratio.
        thickness: m.
        damping: relaxation time of the Kelvin-Voigt damping, s.
    """

    youngs_modulus: float
    poisson_ratio: float
    thickness: float
    damping: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Surface:
    """The complete surface of an elastic sheet, including glued strips, as triangles whose corners bodies carry.

    Attributes:
        bodies: number of the body that carries each node, (node,).
        places: positions of the nodes in the axes of their bodies, m, (node, 3).
        triangles: three nodes each, (triangle, 3).
        panels: index in `names` of the panel of each triangle, (triangle,).
        names: names of the panels, which are separated by folds.
    """

    bodies: Indices
    places: Array
    triangles: Indices
    panels: Indices
    names: tuple[str, ...]

    @property
    def carried(self) -> list[tuple[int, tuple[float, ...]]]:
        """The body and position of each node, which are equal for nodes that two surfaces have in common."""
        return list(zip(self.bodies.tolist(), map(tuple, self.places.tolist()), strict=True))


@dataclass(frozen=True, kw_only=True, eq=False)
class Membrane:
    """An elastic sheet whose nodes are carried by bodies.

    Attributes:
        name: name of the membrane.
        bodies: number of the body that carries each node, (node,).
        places: positions of the nodes in the axes of their bodies, m, (node, 3).
        built: positions of the nodes in the built shape, in which the sheet is unstretched, m, (node, 3).
        triangles: three nodes each, (triangle, 3).
        law: elastic law.
        margin: width of the strip that is glued to a bar, m.
        roots: point on the bar from which each node is held, in the axes of its body, m, (node, 3); the strip between
            this point and the node is glued to the bar. It is the node itself for a node on the bar. None without bars,
            or if all nodes are on bars.
        surface: complete surface, for contact and crossings with other surfaces; None if it is not modelled.
    """

    name: str
    bodies: Indices
    places: Array
    built: Array
    triangles: Indices
    law: MembraneLaw
    margin: float
    roots: Array | None = None
    surface: Surface | None = None

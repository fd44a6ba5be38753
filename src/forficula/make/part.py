"""A part to make, and the set of all parts of a design."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from manifold3d import Error, Manifold

from forficula.arrays import Array
from forficula.design import Design
from forficula.errors import InputError
from forficula.make.flat.cut_lines import CutSheet
from forficula.make.hinge.hub import Root
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.hinge.strap_shape import StrapPlace
from forficula.make.solid.mesh import MILLIMETRES, solid_of
from forficula.make.solid.solids import Solid
from forficula.make.stock import Stock
from forficula.results import Result
from forficula.structure import Structure

# mm, volume / surface: thinner parts are lost in the single precision of meshes and their files
_THINNEST = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class Part:
    """A solid of one material.

    Attributes:
        name: unique name.
        kind: bar, pin, strap, hub, root or panel.
        stock: its material.
        solid: in its position in the flat structure, in the axes of the ground, m.
        body: index of the body with which it moves; GROUND for a fixed part, None for one that bends.
        count: number of pieces.
        printed: whether it is printed; otherwise it is bought.
        bed: rotation into its print orientation, (3, 3).
    """

    name: str
    kind: str
    stock: Stock
    solid: Solid
    body: int | None
    count: int = 1
    printed: bool = True
    bed: Array

    def __repr__(self) -> str:
        """Name, kind and material."""
        return f"<Part {self.name}: {self.kind} of {self.stock.name}>"

    @cached_property
    def shape(self) -> Manifold:
        """Solid as a mesh, mm.

        Raises:
            InputError: the part is empty.
        """
        shape = solid_of(self.solid)
        if shape.status() != Error.NoError or shape.volume() <= _THINNEST * shape.surface_area():
            raise InputError(
                f"{self.name}: nothing is left of this part; it is too thin, or bars are too short or too thin for the"
                " features on them"
            )
        return shape

    @property
    def volume(self) -> float:
        """Volume of one piece, m^3."""
        return float(self.shape.volume()) / MILLIMETRES**3

    @property
    def mass(self) -> float | None:
        """Mass of one piece, kg; None if the density is unknown."""
        return None if self.stock.density is None else self.stock.density * self.volume


@dataclass(frozen=True, kw_only=True, eq=False)
class PartSet(Result):
    """Parts of a design.

    Attributes:
        design: the design.
        structure: the structure that is built from them.
        joints: layout of each joint.
        roots: rods on which bars turn at the ground.
        straps: ends of straps, in the order of their parts.
        parts: solids; empty if only the sheet is made.
        sheet: the sheet to cut; None if only solids are made.
        fold: angles of all hinges along the fold path of thick panels, in equal steps of the largest fold angle, in
            own senses, rad, (pose, hinge); None for other parts, or if the path is not known.
    """

    design: Design
    structure: Structure
    joints: tuple[JointLayout, ...]
    roots: tuple[Root, ...]
    straps: tuple[StrapPlace, ...]
    parts: tuple[Part, ...]
    sheet: CutSheet | None
    fold: Array | None = None

    def __repr__(self) -> str:
        """Design and names of the parts."""
        names = [part.name for part in self.parts] + (["sheet"] if self.sheet is not None else [])
        listed = ", ".join(names[:6]) + (", ..." if len(names) > 6 else "")
        return f"<PartSet of {self.design.name}: {listed}>"

    def of_body(self, body: int) -> tuple[Part, ...]:
        """Return the parts that move with a body."""
        return tuple(part for part in self.parts if part.body == body)

    def strap_of(self, tendon: int) -> Part:
        """Return the straps of a tendon, by its index."""
        straps = (part for part in self.parts if part.kind == "strap")
        return next(part for part, place in zip(straps, self.straps, strict=True) if place.tendon == tendon)

"""A part to make, and all parts of a design."""

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

# mm, volume by surface: what is thinner is lost in the single precision of meshes and their files
_THINNEST = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class Part:
    """A solid of one material.

    Attributes:
        name: of its own.
        kind: what it is called with others of its kind: bar, pin, strap, hub, root.
        stock: what it is made of.
        solid: where it is as the structure is built flat, in the axes of the ground, m.
        body: number of the body that it moves with; GROUND for one that does not move, None for one that bends.
        count: how many of it there are, all in its place or beside it.
        printed: whether it is, or comes ready from a shop.
        bed: rotation after which it lies as it is printed, (3, 3).
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
        """Its solid as a mesh, mm.

        Raises:
            InputError: nothing is left of it.
        """
        shape = solid_of(self.solid)
        if shape.status() != Error.NoError or shape.volume() <= _THINNEST * shape.surface_area():
            raise InputError(
                f"{self.name}: nothing is left of this part; it is too thin, or bars are too short or too thin for what"
                " is on them"
            )
        return shape

    @property
    def volume(self) -> float:
        """Of one of it, m^3."""
        return float(self.shape.volume()) / MILLIMETRES**3

    @property
    def mass(self) -> float | None:
        """Of one of it, kg; None where the density is not known."""
        return None if self.stock.density is None else self.stock.density * self.volume


@dataclass(frozen=True, kw_only=True, eq=False)
class PartSet(Result):
    """What is to be made of a design.

    Attributes:
        design: whose parts they are.
        structure: that is built of them.
        joints: where everything of each joint is.
        roots: what bars turn on at the ground.
        straps: where straps end, in the order of their parts.
        parts: solids; empty where the sheet alone is made.
        sheet: what is cut; None where only solids are made.
    """

    design: Design
    structure: Structure
    joints: tuple[JointLayout, ...]
    roots: tuple[Root, ...]
    straps: tuple[StrapPlace, ...]
    parts: tuple[Part, ...]
    sheet: CutSheet | None

    def __repr__(self) -> str:
        """Design and names of the parts."""
        names = [part.name for part in self.parts] + (["sheet"] if self.sheet is not None else [])
        listed = ", ".join(names[:6]) + (", ..." if len(names) > 6 else "")
        return f"<PartSet of {self.design.name}: {listed}>"

    def of_body(self, body: int) -> tuple[Part, ...]:
        """The parts that move with a body."""
        return tuple(part for part in self.parts if part.body == body)

    def strap_of(self, tendon: int) -> Part:
        """The straps of a tendon that has some, by its number."""
        straps = (part for part in self.parts if part.kind == "strap")
        return next(part for part, place in zip(straps, self.straps, strict=True) if place.tendon == tendon)

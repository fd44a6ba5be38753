"""Section of a design on manufacturing: process, fits, pins, straps, and how the sheet is cut and creased."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, field_validator

from forficula.design.section import SMALL_LENGTH, Section, quantity
from forficula.errors import InputError
from forficula.material.law.law_file import named_laws
from forficula.names import one_of

_LARGEST = 0.1  # m, largest length of a detail of a part


def _detail(description: str, default: float | None, **bounds: Any) -> Any:
    """Define a field that holds a length of a few millimetres, m."""
    return quantity(SMALL_LENGTH, description, default=default, at_most=_LARGEST, **bounds)


class MakeSection(Section):
    """Materials and processes of the parts; the defaults suit a common filament printer and a laser cutter."""

    about: ClassVar[str] = (
        "Materials and processes of the parts; the defaults suit a common filament printer and a laser cutter"
    )

    heading: ClassVar[str] = "Parts to make"
    # properties of machines and hands, which do not scale with the structure
    natural: ClassVar[tuple[str, ...]] = ("nozzle", "layer", "clearance", "kerf")

    process: Annotated[
        Literal["filament", "powder"],
        Field(description="printing process; powder supports overhangs, filament does not"),
    ] = "filament"
    nozzle: float = _detail("width of a printed line; a wall has at least two lines", 0.4e-3, above=0)
    layer: float = _detail("height of a printed layer", 0.2e-3, above=0)
    clearance: float = _detail("least gap between parts that move past each other", 0.4e-3, above=0)
    bar_material: Annotated[str, Field(description="name of the material of bars and hinges")] = "petg"
    hinge: Annotated[
        Literal["pin", "print-in-place"],
        Field(description="a pin through printed knuckles, or an axle printed with them in one piece"),
    ] = "pin"
    pin_diameter: float = _detail("diameter of the pin or of the axle", 2e-3, above=0)
    pin_material: Annotated[str, Field(description="name of the material of a pin that is not printed")] = "steel"
    hinge_wall: float = _detail("wall thickness of the knuckles around the pin", 1.6e-3, above=0)
    hinge_width: float = _detail("width of all knuckles of a hinge together, along its axis", 10e-3, above=0)
    strap_material: Annotated[
        str | None,
        Field(description="name of the material of the straps; if not given, that of tendon.law, or else tpu-95a"),
    ] = None
    straps: Annotated[
        int,
        Field(
            strict=True,
            ge=1,
            le=2,
            description="number of straps of a tendon: two beside the bars, or one between them",
        ),
    ] = 2
    strap_thickness: float = _detail("thickness of a strap; its width follows from the tendon's area", 1e-3, above=0)
    anchors: Annotated[
        Literal["as designed", "on the bars"],
        Field(
            description="position of the pegs of straps: at the tendon's offsets from the hinge, or at the height of"
            " the bars, whose axes lie above the hinge"
        ),
    ] = "as designed"
    peg_diameter: float = _detail("diameter of the pegs that hold the straps", 5e-3, above=0)
    root_diameter: float = _detail("diameter of the flexible rods on which bars turn at the hub", 4e-3, above=0)
    root_length: float = _detail("length of such a rod between hub and bar", 10e-3, above=0)
    root_material: Annotated[str, Field(description="name of the material of these rods")] = "tpu-95a"
    kerf: float = _detail("width of material that the cutter removes", 0.1e-3, at_least=0)
    margin: float = _detail(
        "width by which the sheet is cut larger than its pattern all around; creases extend across it",
        0.0,
        at_least=0,
    )
    window: float = _detail("gap between the sheet and parts that pass through it", 1e-3, at_least=0)
    crease_style: Annotated[
        Literal["score", "perforation", "lattice"],
        Field(description="how a crease is made: a cut half through, a dashed cut, or rows of staggered cuts"),
    ] = "score"
    crease_cut: float = _detail("length of a cut of a perforation or lattice", 3e-3, above=0)
    crease_bridge: float = _detail("distance between two cuts in a row", 1e-3, above=0)
    lattice_rows: Annotated[int, Field(strict=True, ge=2, le=99, description="number of rows of a lattice")] = 3
    lattice_pitch: float = _detail("distance from row to row of a lattice", 1e-3, above=0)
    relief_hole: float | None = _detail(
        "diameter of the hole where creases meet; if not given, no hole for a score or a perforation, and the width of"
        " the lattice for a lattice",
        None,
        at_least=0,
    )

    @field_validator("bar_material", "pin_material", "strap_material", "root_material")
    @classmethod
    def _is_a_material(cls, name: str | None) -> str | None:
        if name is not None and name not in named_laws():
            raise InputError(f"need {one_of(named_laws(), name)}")
        return name

"""How the parts of a structure are made: process, fits, pins, straps, and how its sheet is cut and creased."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, field_validator

from forficula.design.section import SMALL_LENGTH, Section, quantity
from forficula.errors import InputError
from forficula.material.law.law_file import named_laws
from forficula.names import one_of

_LARGEST = 0.1  # m, of what is a detail of a part


def _detail(description: str, default: float | None, **bounds: Any) -> Any:
    """A field that holds a length of a few millimetres, m."""
    return quantity(SMALL_LENGTH, description, default=default, at_most=_LARGEST, **bounds)


class MakeSection(Section):
    """What parts are made of and by; every default suits a common filament printer, and a laser for the sheet."""

    about: ClassVar[str] = (
        "What parts are made of and by; every default suits a common filament printer, and a laser for the sheet"
    )

    heading: ClassVar[str] = "Parts to make"
    # of machines and hands, whatever the size of what they make
    natural: ClassVar[tuple[str, ...]] = ("nozzle", "layer", "clearance", "kerf")

    process: Annotated[
        Literal["filament", "powder"], Field(description="how parts are printed; powder holds overhangs, filament not")
    ] = "filament"
    nozzle: float = _detail("width of a printed line; no wall is thinner than two of them", 0.4e-3, above=0)
    layer: float = _detail("height of a printed layer", 0.2e-3, above=0)
    clearance: float = _detail("least gap between parts that move past one another", 0.4e-3, above=0)
    bar_material: Annotated[str, Field(description="of bars and hinges, by name")] = "petg"
    hinge: Annotated[
        Literal["pin", "print-in-place"],
        Field(description="a pin through printed knuckles, or an axle printed with them in one piece"),
    ] = "pin"
    pin_diameter: float = _detail("of the pin, or of the axle", 2e-3, above=0)
    pin_material: Annotated[str, Field(description="of a pin that is not printed, by name")] = "steel"
    hinge_wall: float = _detail("of the knuckles around the pin", 1.6e-3, above=0)
    hinge_width: float = _detail("of all knuckles of a hinge together, along its axis", 10e-3, above=0)
    strap_material: Annotated[
        str | None, Field(description="of the straps, by name; without it, that of tendon.law, or else tpu-95a")
    ] = None
    straps: Annotated[
        int,
        Field(strict=True, ge=1, le=2, description="of a tendon: two beside the bars, or one in their middle"),
    ] = 2
    strap_thickness: float = _detail("of a strap; its width follows from the tendon's area", 1e-3, above=0)
    anchors: Annotated[
        Literal["as designed", "on the bars"],
        Field(
            description="where pegs of straps are: at the tendon's offsets from the hinge, or at the height of the"
            " bars, which stand off the hinge"
        ),
    ] = "as designed"
    peg_diameter: float = _detail("of the pegs that straps are hung on", 5e-3, above=0)
    root_diameter: float = _detail("of the flexible rods that bars turn on at the hub", 4e-3, above=0)
    root_length: float = _detail("of a rod between hub and bar", 10e-3, above=0)
    root_material: Annotated[str, Field(description="of these rods, by name")] = "tpu-95a"
    kerf: float = _detail("width that the cutter takes away", 0.1e-3, at_least=0)
    margin: float = _detail(
        "by which the sheet is cut wider than its pattern, around its outside; creases run on in it", 0.0, at_least=0
    )
    window: float = _detail("gap between the sheet and what passes through it", 1e-3, at_least=0)
    crease_style: Annotated[
        Literal["score", "perforation", "lattice"],
        Field(description="a line half through, a dashed cut, or rows of staggered cuts"),
    ] = "score"
    crease_cut: float = _detail("length of a cut of a perforation or lattice", 3e-3, above=0)
    crease_bridge: float = _detail("between two cuts in a row", 1e-3, above=0)
    lattice_rows: Annotated[int, Field(strict=True, ge=2, le=99, description="of a lattice")] = 3
    lattice_pitch: float = _detail("from row to row of a lattice", 1e-3, above=0)
    relief_hole: float | None = _detail(
        "diameter of the hole where creases meet; without it, none for a score or perforation, and the width of the"
        " lattice for a lattice",
        None,
        at_least=0,
    )

    @field_validator("bar_material", "pin_material", "strap_material", "root_material")
    @classmethod
    def _is_a_material(cls, name: str | None) -> str | None:
        if name is not None and name not in named_laws():
            raise InputError(f"need {one_of(named_laws(), name)}")
        return name

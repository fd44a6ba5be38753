"""Bill of materials of a design: every part with its number, material, size and mass."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from forficula.csv_text import csv_table
from forficula.design import SheetDesign
from forficula.make.files.print_orientation import print_size
from forficula.make.made_values import printed_shares
from forficula.make.part import Part, PartSet
from forficula.structure import Structure, mass_of

_MM, _CM3, _GRAMS = 1e3, 1e6, 1e3
_DIGITS = 6


@dataclass(frozen=True, kw_only=True)
class BillRow:
    """A part of a bill.

    Attributes:
        part: name.
        kind: bar, pin, strap, hub, root, or sheet.
        count: number of pieces.
        material: name; None if the design names none, as for a sheet.
        comes: how it is obtained.
        size: size of the box around one piece in its print orientation, its longest rod along x, m; None if unknown.
        volume: volume of one piece, m^3; None if unknown.
        density: density of the material, kg/m^3; None if its sources give none.
        density_source: source of the density; "" without one.
        printed_share: fraction of the volume that remains after rounding to whole layers of a filament.
    """

    part: str
    kind: str
    count: int
    material: str | None
    comes: Literal["printed", "bought", "cut"]
    size: tuple[float | None, float | None, float | None]
    volume: float | None
    density: float | None
    density_source: str
    printed_share: float = 1.0

    @property
    def mass(self) -> float | None:
        """Mass of one piece, solid, with the printed fraction of its volume, kg; None if unknown."""
        if self.density is None or self.volume is None:
            return None
        return self.density * self.volume * self.printed_share


@dataclass(frozen=True, kw_only=True)
class BillTotal:
    """Total amount of a material.

    Attributes:
        material: name.
        count: number of pieces.
        volume: volume of all pieces, m^3.
        mass: mass of all pieces, kg; None if the density is unknown.
        density: kg/m^3; None if its sources give none.
        density_source: source of the density; "" without one.
    """

    material: str
    count: int
    volume: float
    mass: float | None
    density: float | None
    density_source: str


def bill_of(parts: PartSet) -> tuple[BillRow, ...]:
    """Return every part of a design, with its sheet last."""
    shares = printed_shares(parts)
    rows = [replace(_row(part), printed_share=shares.get(part.name, 1.0)) for part in parts.parts]
    if parts.sheet is None:
        return tuple(rows)
    length, width = (float(side) for side in parts.sheet.size)
    facet = parts.design.facet if isinstance(parts.design, SheetDesign) else None
    # with parts, the mass of the structure includes windows and hinges that are cut out of the sheet
    known = facet is not None and bool(facet.density) and not parts.parts
    sheet = BillRow(
        part="sheet",
        kind="sheet",
        count=1,
        material=None,
        comes="cut",
        size=(length, width, None),
        volume=_mass(parts.structure) / facet.density if facet is not None and facet.density and known else None,
        density=facet.density if facet is not None and known else None,
        density_source="the design" if known else "",
    )
    return (*rows, sheet)


def bill_totals(rows: Sequence[BillRow]) -> tuple[BillTotal, ...]:
    """Return the total of every named material, in the order of the rows."""
    totals = []
    for material in dict.fromkeys(row.material for row in rows if row.material is not None):
        of_material = [row for row in rows if row.material == material]
        masses = [row.count * row.mass for row in of_material if row.mass is not None]
        totals.append(
            BillTotal(
                material=material,
                count=sum(row.count for row in of_material),
                volume=sum(row.count * (row.volume or 0.0) for row in of_material),
                mass=sum(masses) if len(masses) == len(of_material) else None,
                density=of_material[0].density,
                density_source=of_material[0].density_source,
            )
        )
    return tuple(totals)


def bill_csv(rows: Sequence[BillRow]) -> str:
    """Return a bill as comma-separated text, one row per part; unknown values are empty."""
    lines = [_plain(row) for row in rows]
    for line in lines:
        # a spreadsheet has no lists in its cells
        size = line.pop("size_mm")
        line |= {f"size_{axis}_mm": side for axis, side in zip("xyz", size, strict=True)}
    return csv_table(lines)


def bill_json(rows: Sequence[BillRow]) -> dict[str, Any]:
    """Return a bill as plain data: its parts, and totals by material; unknown values are None."""
    totals = [
        {
            "material": total.material,
            "pieces": total.count,
            "volume_cm3": _rounded(total.volume, _CM3),
            "mass_g": _rounded(total.mass, _GRAMS),
            "density_kg_per_m3": total.density,
            "density_source": total.density_source or None,
        }
        for total in bill_totals(rows)
    ]
    return {"parts": [_plain(row) for row in rows], "totals": totals}


def _mass(structure: Structure) -> float:
    return sum(body.mass + mass_of(structure, number)[0] for number, body in enumerate(structure.bodies))


def _row(part: Part) -> BillRow:
    length, width, height = (float(side) for side in print_size(part))
    return BillRow(
        part=part.name,
        kind=part.kind,
        count=part.count,
        material=part.stock.name,
        comes="printed" if part.printed else "bought",
        size=(length, width, height),
        volume=part.volume,
        density=part.stock.density,
        density_source=part.stock.density_source,
    )


def _plain(row: BillRow) -> dict[str, Any]:
    return {
        "part": row.part,
        "kind": row.kind,
        "count": row.count,
        "material": row.material,
        "comes": row.comes,
        "size_mm": [_rounded(side, _MM) for side in row.size],
        "volume_cm3": _rounded(row.volume, _CM3),
        "mass_g": _rounded(row.mass, _GRAMS),
        "mass_of_all_g": _rounded(None if row.mass is None else row.count * row.mass, _GRAMS),
        "density_kg_per_m3": row.density,
        "density_source": row.density_source or None,
    }


def _rounded(value: float | None, factor: float) -> float | None:
    """Convert to another unit and round to significant digits."""
    return None if value is None else float(f"{factor * value:.{_DIGITS}g}")

"""What has to be had to make a design: every part, how many, of what, how large and how heavy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from forficula.csv_text import csv_text
from forficula.design import SheetDesign
from forficula.make.files.lying import lying_size
from forficula.make.made_values import printed_shares
from forficula.make.part import Part, PartSet
from forficula.structure import Structure, mass_of

_MM, _CM3, _GRAMS = 1e3, 1e6, 1e3
_DIGITS = 6


@dataclass(frozen=True, kw_only=True)
class BillRow:
    """A part of a bill.

    Attributes:
        part: its name.
        kind: of it: bar, pin, strap, hub, root, or sheet.
        count: how many.
        material: by name; None where the design names none, as for a sheet.
        comes: how one comes by it.
        size: of the box around one of it as it lies, the longest rod in it along x, m; None where that is not known.
        volume: of one of it, m^3; None where that is not known.
        density: of the material, kg/m^3; None where its sources give none.
        density_source: who says so; "" where nobody does.
        printed_share: of the volume, what whole layers of a filament make of it.
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
        """Of one of it, as solid as its volume but for the share that is printed, kg; None where it is not known."""
        if self.density is None or self.volume is None:
            return None
        return self.density * self.volume * self.printed_share


@dataclass(frozen=True, kw_only=True)
class BillTotal:
    """What is needed of a material.

    Attributes:
        material: its name.
        count: of pieces.
        volume: of all of them, m^3.
        mass: of all of them, kg; None where its density is not known.
        density: kg/m^3; None where its sources give none.
        density_source: who says so; "" where nobody does.
    """

    material: str
    count: int
    volume: float
    mass: float | None
    density: float | None
    density_source: str


def bill_of(parts: PartSet) -> tuple[BillRow, ...]:
    """Every part of a design, with its sheet last."""
    shares = printed_shares(parts)
    rows = [replace(_row(part), printed_share=shares.get(part.name, 1.0)) for part in parts.parts]
    if parts.sheet is None:
        return tuple(rows)
    length, width = (float(side) for side in parts.sheet.size)
    facet = parts.design.facet if isinstance(parts.design, SheetDesign) else None
    # windows and hinges cut out are still in it
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
    """What is needed of every material that has a name, in the order of the rows."""
    totals = []
    for material in dict.fromkeys(row.material for row in rows if row.material is not None):
        own = [row for row in rows if row.material == material]
        masses = [row.count * row.mass for row in own if row.mass is not None]
        totals.append(
            BillTotal(
                material=material,
                count=sum(row.count for row in own),
                volume=sum(row.count * (row.volume or 0.0) for row in own),
                mass=sum(masses) if len(masses) == len(own) else None,
                density=own[0].density,
                density_source=own[0].density_source,
            )
        )
    return tuple(totals)


def bill_csv(rows: Sequence[BillRow]) -> str:
    """A bill as comma-separated text, a row a part; what is not known is empty."""
    lines = [_plain(row) for row in rows]
    for line in lines:
        # a spreadsheet has no lists in its cells
        size = line.pop("size_mm")
        line |= {f"size_{axis}_mm": side for axis, side in zip("xyz", size, strict=True)}
    return csv_text([list(lines[0]), *([_cell(each) for each in line.values()] for line in lines)])


def bill_json(rows: Sequence[BillRow]) -> dict[str, Any]:
    """A bill as plain data: its parts, and what they come to by material; what is not known is None."""
    totals = [
        {
            "material": each.material,
            "pieces": each.count,
            "volume_cm3": _rounded(each.volume, _CM3),
            "mass_g": _rounded(each.mass, _GRAMS),
            "density_kg_per_m3": each.density,
            "density_source": each.density_source or None,
        }
        for each in bill_totals(rows)
    ]
    return {"parts": [_plain(row) for row in rows], "totals": totals}


def _mass(structure: Structure) -> float:
    return sum(body.mass + mass_of(structure, number)[0] for number, body in enumerate(structure.bodies))


def _row(part: Part) -> BillRow:
    length, width, height = (float(side) for side in lying_size(part))
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
    """In another unit, to as many digits as make no difference to what is made."""
    return None if value is None else float(f"{factor * value:.{_DIGITS}g}")


def _cell(value: object) -> object:
    return "" if value is None else value

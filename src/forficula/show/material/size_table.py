"""Sizes of tendons as text and as a table for spreadsheets."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from rich.console import Console, Group, RenderableType
from rich.text import Text

from forficula.analysis.sizing import TendonSizes
from forficula.csv_text import csv_text
from forficula.design.section import STIFFNESS
from forficula.material.characterisation import AREA, LENGTH
from forficula.material.law.law_keys import show_value
from forficula.material.law.material_law import MaterialLaw
from forficula.quantities import show_quantity
from forficula.show.material.material_table import plain_table, sentence

_COLUMNS = (
    *("length_m", "stiffness_N_per_m", "area_m2", "diameter_m", "area_by_mean_stiffness_to_flat_m2"),
    *("flat_strain", "flat_strain_beyond_measured"),
)


def print_sizes(law: MaterialLaw, sizes: Sequence[TendonSizes]) -> None:
    """Print the sizes of tendons of a material."""
    Console(width=110, highlight=False).print(size_table(law, sizes))


def size_table(law: MaterialLaw, sizes: Sequence[TendonSizes]) -> RenderableType:
    """Return a table for each length, with the tendon's state in the flat structure."""
    parts: list[RenderableType] = []
    for size in sizes:
        heading = f"{law.name}, length {show_quantity(size.length, LENGTH)}, {size.why}"
        blank = [Text()] if parts else []
        parts += [*blank, Text(heading, style="bold"), _table(law, size), Text(_flat(size, law))]
    remarks = [Text(sentence(remark)) for remark in _remarks(law)]
    return Group(*parts, *([Text(), *remarks] if remarks else []))


def sizes_json(sizes: Sequence[TendonSizes]) -> list[dict[str, float | bool | None]]:
    """Return the sizes as plain data in SI, one row for each tendon; None for missing values."""
    return [
        dict(
            zip(
                _COLUMNS,
                (
                    *(item.length, size.stiffness, size.area, size.diameter, size.mean_area),
                    *(item.flat_strain, item.beyond),
                ),
                strict=True,
            )
        )
        for item in sizes
        for size in item.sizes
    ]


def sizes_csv(sizes: Sequence[TendonSizes]) -> str:
    """Return the rows of `sizes_json` as comma-separated values; missing values are empty."""
    return csv_text([_COLUMNS, *([_cell(value) for value in row.values()] for row in sizes_json(sizes))])


def _cell(value: float | bool | None) -> str:
    if value is None:
        return ""
    return str(value).lower() if isinstance(value, bool) else repr(value)


def _table(law: MaterialLaw, sizes: TendonSizes) -> RenderableType:
    linear = _is_linear(law)
    headings = ["stiffness", "area", "diameter\nif round"]
    if not linear:
        headings[1:] = [
            "area, stiffness at\nsmall extension",
            "diameter\nif round",
            f"area, mean stiffness\nto the flat {sizes.whole}",
        ]
    table = plain_table(*headings)
    for size in sizes.sizes:
        cells = [show_quantity(size.stiffness, STIFFNESS), _area(size.area), show_quantity(size.diameter, LENGTH)]
        if not linear:
            cells.append("slack" if size.mean_area is None else _area(size.mean_area))
        table.add_row(*cells)
    return table


def _is_linear(law: MaterialLaw) -> bool:
    return law.moduli is not None and law.moduli[1:] == (0.0, 0.0) and law.yield_strain is None


def _flat(sizes: TendonSizes, law: MaterialLaw) -> str:
    if sizes.flat_strain <= law.residual_strain:
        return f"The tendon is slack in the flat {sizes.whole}."
    strain = f"The tendon is stretched by {100 * sizes.flat_strain:.3g} % in the flat {sizes.whole}"
    if sizes.beyond is None:
        return f"{strain}; the law does not report the strain up to which it was measured."
    shown = show_value("largest_strain", law.largest_strain or math.nan)
    return f"{strain}, {'beyond' if sizes.beyond else 'within'} the {shown} up to which {law.name} was measured."


def _remarks(law: MaterialLaw) -> Iterator[str]:
    if law.residual_strain:
        shown = show_value("residual_strain", law.residual_strain)
        yield f"the material is permanently {shown} longer; the length is that before, and the tendon pulls beyond it"
    if law.branches:
        yield "the stiffness is that of slow extension; fast extension adds the Maxwell branches"
    if law.softening is not None:
        yield "the stiffness is that of the first extension; below the largest strain so far the material is softer"


def _area(area: float) -> str:
    return show_quantity(area, AREA).replace("^2", "²")

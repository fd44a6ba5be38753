"""The sheet of a FOLD file in the tables of a design: read from where it is named, kept as what it holds."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.design.part import LENGTH
from forficula.errors import InputError
from forficula.pattern import CreasePattern, read_fold
from forficula.pattern.crease_pattern import check_flat
from forficula.quantities import format_quantity


def with_sheet_read(tables: Mapping[str, Any], *, folder: Path | None = None) -> dict[str, Any]:
    """Replace the path of a FOLD file by what the file holds, so that a design says all by itself.

    Args:
        tables: of a design file, or values by dotted key.
        folder: that a path starts from; the working folder if not given.

    Raises:
        InputError: the file cannot be read, or its sheet is not flat.
    """
    read = dict(tables)
    path = read.get("pattern.path")
    if isinstance(path, str):
        del read["pattern.path"]
        read |= {f"pattern.{key}": value for key, value in _sheet(path, folder).items()}
    pattern = read.get("pattern")
    if isinstance(pattern, dict) and isinstance(pattern.get("path"), str):
        own = {key: value for key, value in pattern.items() if key != "path"}
        read["pattern"] = own | _sheet(pattern["path"], folder)
    return read


def _sheet(path: str, folder: Path | None) -> dict[str, Any]:
    file = Path(path) if folder is None else folder / path
    try:
        pattern = read_fold(file)
        check_flat(pattern)
    except InputError as error:
        raise InputError(f"pattern.path: {error}") from None
    return sheet_values(pattern) | {"title": pattern.title or file.stem}


def sheet_values(pattern: CreasePattern) -> dict[str, Any]:
    """A flat pattern as the keys of a design's section."""
    across, upwards, _ = pattern.vertices_coords.T.tolist()
    return {
        "kind": "fold-file",
        "vertices_x": [format_quantity(value, LENGTH) for value in across],
        "vertices_y": [format_quantity(value, LENGTH) for value in upwards],
        "edges": pattern.edges_vertices.tolist(),
        "assignment": "".join(pattern.edges_assignment),
        "roles": list(pattern.edges_role),
        "facets": [list(facet) for facet in pattern.faces_vertices],
    }

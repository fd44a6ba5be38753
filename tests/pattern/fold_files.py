"""FOLD files in the forms that other programs write."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from forficula.pattern import CreasePattern, fold_pattern

OTHERS = Path(__file__).parent / "fold"
SQUARE: dict[str, Any] = {
    "frame_unit": "mm",
    "vertices_coords": [[0, 0], [10, 0], [10, 10], [0, 10]],
    "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
}


def written(path: Path, changes: dict[str, Any] | None = None, without: tuple[str, ...] = ()) -> Path:
    """A FOLD file of a square with a diagonal, 10 mm wide, as another program could write it."""
    document = {key: value for key, value in (SQUARE | (changes or {})).items() if key not in without}
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


def outcome(
    path: Path, changes: dict[str, Any] | None = None, without: tuple[str, ...] = (), **choices: Any
) -> tuple[CreasePattern, list[str]]:
    """Read the file of the square, with remarks."""
    return fold_pattern(written(path / "square.fold", changes, without), **choices)

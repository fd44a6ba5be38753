"""Crease patterns written as FOLD 1.2 files (Demaine, Ku and Lang), JSON that origami programs share."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.files import write_text
from forficula.pattern.crease_pattern import CreasePattern
from forficula.quantities import as_written

Frame = tuple[str, Array, Array]

ROLES = "forficula:edges_role"


def write_fold(
    pattern: CreasePattern,
    path: str | os.PathLike[str],
    *,
    frames: Sequence[Frame] = (),
    own: Mapping[str, Sequence[object]] | None = None,
) -> None:
    """Write a pattern, and folded states of it, to a FOLD 1.2 file.

    The file holds metres and degrees, valleys positive. It is complete or not there at all: it is written under
    another name in the same folder, then renamed. `read_fold` reads a pattern that was read from a FOLD file back with
    the same bits; of other patterns fold angles may differ in the last one, for the file holds degrees.

    Args:
        pattern: the sheet; it becomes the key frame.
        path: the file, replaced where it exists.
        frames: folded states: title, positions of the vertices in m, shape (N, 3), and fold angles in rad, shape (E,),
            nan where there is none.
        own: further values of the vertices, edges or faces, numbers, text or None, by key, such as "edges_stiffness".
            In the file the keys stand in the namespace "forficula:", so that other programs pass them over.

    Raises:
        InputError: a folded state of another shape or with positions that are not finite, own values of another number,
            or a file that cannot be written.
    """
    document: dict[str, object] = {
        "file_spec": 1.2,
        "file_creator": "forficula",
        "file_classes": ["singleModel"],
        "frame_title": pattern.title,
        "frame_classes": ["creasePattern"],
        "frame_attributes": ["2D" if not pattern.vertices_coords[:, 2].any() else "3D"],
        "frame_unit": "m",
        "vertices_coords": pattern.vertices_coords.tolist(),
        "edges_vertices": pattern.edges_vertices.tolist(),
        "edges_assignment": list(pattern.edges_assignment),
        "edges_foldAngle": _degrees_or_null(pattern.edges_fold_angle),
        "faces_vertices": [list(face) for face in pattern.faces_vertices],
        ROLES: list(pattern.edges_role),
    }
    for key, values in (own or {}).items():
        document[f"forficula:{key}"] = _own_values(pattern, key, values)
    if frames:
        document["file_frames"] = [_folded_frame(pattern, number, *frame) for number, frame in enumerate(frames)]
    write_text(Path(path), json.dumps(document, allow_nan=False, indent=1) + "\n")


def _own_values(pattern: CreasePattern, key: str, values: Sequence[object]) -> list[object]:
    """Values that FOLD knows no key for."""
    counts = {
        "vertices": len(pattern.vertices_coords),
        "edges": len(pattern.edges_vertices),
        "faces": len(pattern.faces_vertices),
    }
    of = key.partition("_")[0]
    if of not in counts or key == "edges_role":
        raise InputError(f"own: need keys that begin with vertices_, edges_ or faces_, got {as_written(key)}")
    if len(values) != counts[of]:
        raise InputError(f"own.{key}: need one value for each of the {counts[of]} {of}, got {len(values)}")
    for number, value in enumerate(values):
        if isinstance(value, float) and not math.isfinite(value):
            raise InputError(f"own.{key}[{number}]: need a finite number, text or None, got {value}")
    return list(values)


def _degrees_or_null(angles: Array) -> list[float | None]:
    """Fold angles as FOLD writes them."""
    return [None if math.isnan(angle) else _degrees(angle) for angle in angles.tolist()]


def _degrees(angle: float) -> float:
    """The shortest number of degrees that `math.radians` turns into the same bits, or the nearest number."""
    nearest = math.degrees(angle)
    rounded = [float(f"{nearest:.{digits}g}") for digits in (12, 14, 15, 16)]
    beside = [math.nextafter(nearest, math.inf), math.nextafter(nearest, -math.inf)]
    return next((degrees for degrees in [*rounded, nearest, *beside] if math.radians(degrees) == angle), nearest)


def _folded_frame(
    pattern: CreasePattern, number: int, title: str, coords: Array, fold_angles: Array
) -> dict[str, object]:
    """A folded state that inherits the rest from the key frame."""
    if coords.shape != pattern.vertices_coords.shape or not np.isfinite(coords).all():
        raise InputError(
            f"frames[{number}]: need finite positions, shape {pattern.vertices_coords.shape}, got shape {coords.shape}"
        )
    if fold_angles.shape != pattern.edges_fold_angle.shape or np.isinf(fold_angles).any():
        raise InputError(
            f"frames[{number}]: need finite fold angles or nan, shape {pattern.edges_fold_angle.shape}, "
            f"got shape {fold_angles.shape}"
        )
    return {
        "frame_title": title,
        "frame_classes": ["foldedForm"],
        "frame_attributes": ["3D"],
        "frame_parent": 0,
        "frame_inherit": True,
        "vertices_coords": coords.tolist(),
        "edges_foldAngle": _degrees_or_null(fold_angles),
    }

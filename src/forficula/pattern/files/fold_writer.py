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
FOLDS = "forficula:edges_fold"


def write_fold(
    pattern: CreasePattern,
    path: str | os.PathLike[str],
    *,
    frames: Sequence[Frame] = (),
    extra: Mapping[str, Sequence[object]] | None = None,
    description: str = "",
    metadata: Mapping[str, object] | None = None,
) -> None:
    """Write a pattern, and folded states of it, to a FOLD 1.2 file.

    Lengths in the file are in metres, angles in degrees with valleys positive. The file is written under another name
    in the same folder and then renamed, so that it is never incomplete. If a pattern comes from a FOLD file,
    `read_fold` reads exactly the same values again; in other patterns the last bit of fold angles can differ, because
    the file contains degrees.

    Args:
        pattern: pattern of the sheet; it becomes the key frame.
        path: path of the file; an existing file is replaced.
        frames: folded states: title, positions of the vertices in m, shape (N, 3), and fold angles in rad, shape (E,),
            nan where there is none.
        extra: further values of the vertices, edges or faces, numbers, text or None, by key, such as "edges_stiffness".
            In the file the keys are in the namespace "forficula:", which other programs ignore.
        description: description of the frame for readers, such as its source.
        metadata: further values of the whole file that JSON can contain, by key, such as "picture". In the file the
            keys are in the namespace "forficula:".

    Raises:
        InputError: a folded state has another shape or positions that are not finite, `extra` has another number of
            values, or the file cannot be written.
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
    if (pattern.edges_share < 1).any():
        document[FOLDS] = pattern.edges_fold.tolist()
    if description:
        document["frame_description"] = description
    for key, value in (metadata or {}).items():
        document[f"forficula:{key}"] = value
    for key, values in (extra or {}).items():
        document[f"forficula:{key}"] = _own_values(pattern, key, values)
    if frames:
        document["file_frames"] = [_folded_frame(pattern, number, *frame) for number, frame in enumerate(frames)]
    write_text(Path(path), json.dumps(document, allow_nan=False, indent=1) + "\n")


def _own_values(pattern: CreasePattern, key: str, values: Sequence[object]) -> list[object]:
    """Check further values, for which FOLD has no key."""
    counts = {
        "vertices": len(pattern.vertices_coords),
        "edges": len(pattern.edges_vertices),
        "faces": len(pattern.faces_vertices),
    }
    of = key.partition("_")[0]
    if of not in counts or key in ("edges_role", "edges_fold"):
        raise InputError(f"own: need keys that begin with vertices_, edges_ or faces_, got {as_written(key)}")
    if len(values) != counts[of]:
        raise InputError(f"own.{key}: need one value for each of the {counts[of]} {of}, got {len(values)}")
    for number, value in enumerate(values):
        if isinstance(value, float) and not math.isfinite(value):
            raise InputError(f"own.{key}[{number}]: need a finite number, text or None, got {value}")
    return list(values)


def _degrees_or_null(angles: Array) -> list[float | None]:
    """Convert fold angles to the form of FOLD files."""
    return [None if math.isnan(angle) else _degrees(angle) for angle in angles.tolist()]


def _degrees(angle: float) -> float:
    """Return the shortest number of degrees that `math.radians` converts to exactly the same angle, or the nearest."""
    nearest = math.degrees(angle)
    rounded = [float(f"{nearest:.{digits}g}") for digits in (12, 14, 15, 16)]
    beside = [math.nextafter(nearest, math.inf), math.nextafter(nearest, -math.inf)]
    return next((degrees for degrees in [*rounded, nearest, *beside] if math.radians(degrees) == angle), nearest)


def _folded_frame(
    pattern: CreasePattern, number: int, title: str, coords: Array, fold_angles: Array
) -> dict[str, object]:
    """Return a folded state that inherits the other keys from the key frame."""
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

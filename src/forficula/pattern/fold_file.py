"""Crease patterns as FOLD 1.2 files (specification by Demaine, Ku and Lang), JSON that origami programs share."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from forficula.errors import InputError
from forficula.files import write_text
from forficula.pattern.crease_pattern import CreasePattern, check_edges, check_vertex, face_sides
from forficula.quantities import as_written

Frame = tuple[str, NDArray[np.float64], NDArray[np.float64]]

_METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "nm": 1e-9, "in": 0.0254, "pt": 0.0254 / 72}
_ROLES = "forficula:edges_role"
_FOLDED_FLAT = 180 * (1 + 1e-9)  # deg; more is only rounding


def write_fold(pattern: CreasePattern, path: str | os.PathLike[str], *, frames: Sequence[Frame] = ()) -> None:
    """Write a pattern, and folded states of it, to a FOLD 1.2 file.

    The file holds metres and degrees, valleys positive. It is complete or not there at all: it is written under
    another name in the same folder, then renamed.

    Args:
        pattern: the sheet; it becomes the key frame.
        path: the file, replaced where it exists.
        frames: folded states: title, positions of the vertices in m, shape (N, 3), and fold angles in rad, shape (E,),
            nan where there is none.

    Raises:
        InputError: a folded state of another shape or with positions that are not finite, or a file that cannot be
            written.
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
        _ROLES: list(pattern.edges_role),
    }
    if frames:
        document["file_frames"] = [_folded_frame(pattern, number, *frame) for number, frame in enumerate(frames)]
    write_text(Path(path), json.dumps(document, allow_nan=False, indent=1) + "\n")


def _degrees_or_null(angles: NDArray[np.float64]) -> list[float | None]:
    """Fold angles as FOLD writes them."""
    return [None if math.isnan(angle) else angle for angle in np.degrees(angles).tolist()]


def _folded_frame(
    pattern: CreasePattern, number: int, title: str, coords: NDArray[np.float64], fold_angles: NDArray[np.float64]
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


def read_fold(path: str | os.PathLike[str]) -> CreasePattern:
    """Read the key frame of a FOLD file.

    Lengths are converted by `frame_unit`. Two coordinates get z = 0. Without assignments every edge is unassigned; a
    join, "J", is flat. Faces of a flat sheet are turned counterclockwise; where the file has none they are found from
    the edges.

    Args:
        path: the file.

    Returns:
        The pattern in metres and radians.

    Raises:
        InputError: the file cannot be read, is no FOLD file, names no unit of length, or holds what is no pattern; the
            message names the file and the key.
    """
    file = Path(path)
    try:
        return _pattern_of(_document(file))
    except InputError as error:
        raise InputError(f"{file}: {error}") from error


def read_folded_frames(path: str | os.PathLike[str]) -> list[Frame]:
    """Read the folded states of a FOLD file: those of its `file_frames` whose classes have "foldedForm".

    Where a frame says `frame_inherit`, what it does not hold is that of its parent; every frame without a
    `frame_unit` has that of the file. Two coordinates get z = 0.

    Args:
        path: the file.

    Returns:
        Of each state: title, positions of the vertices in m, shape (N, 3), and fold angles in rad, shape (E,), nan
        where there is none; as `write_fold` takes them.

    Raises:
        InputError: the file cannot be read, is no FOLD file, names no unit of length, or holds what is no folded state;
            the message names the file, the frame and the key.
    """
    file = Path(path)
    frames: list[Frame] = []
    try:
        document = _document(file)
        others, known = _frames(document), {0: document}
        for number in range(len(others)):
            try:
                frame = _inherited(others, number + 1, known)
                if "frame_classes" in frame and "foldedForm" in _list(frame, "frame_classes"):
                    frames.append(_folded_state({"frame_unit": document.get("frame_unit")} | frame))
            except InputError as error:
                raise InputError(f"file_frames[{number}]: {error}") from error
    except InputError as error:
        raise InputError(f"{file}: {error}") from error
    return frames


def _frames(document: dict[str, object]) -> list[object]:
    """The frames beside the key frame."""
    return _list(document, "file_frames") if "file_frames" in document else []


def _inherited(frames: Sequence[object], number: int, known: dict[int, dict[str, object]]) -> dict[str, object]:
    """A frame with what it inherits; of those that are known already, number 0 is the key frame.

    Parents are looked up one by one and not by recursion: a chain of them may be as long as a film.
    """
    below: dict[int, dict[str, object]] = {}
    while number not in known:
        frame = frames[number - 1]
        if not isinstance(frame, dict):
            raise InputError(f"need a JSON object with FOLD keys, got {type(frame).__name__}")
        if frame.get("frame_inherit", False) is not True:
            known[number] = frame
            break
        below[number] = frame
        number = _parent(frame, len(frames))
        if number in below:
            raise InputError(f"frame_parent: need a parent that does not inherit from the frame itself, got {number}")
    above = known[number]
    for number, frame in reversed(below.items()):
        if "vertices_coords" in frame and "edges_vertices" not in frame:
            own, others = (len(_list(each, "vertices_coords")) for each in (frame, above))
            if own != others:
                raise InputError(f"vertices_coords: need {others} positions, as many as in the parent, got {own}")
        above = known[number] = above | frame
    return above


def _parent(frame: dict[str, object], count: int) -> int:
    """The number of a frame's parent."""
    parent = frame.get("frame_parent")
    if isinstance(parent, bool) or not isinstance(parent, int) or not 0 <= parent <= count:
        raise InputError(f"frame_parent: need the number of a frame, 0 to {count}, got {as_written(parent)}")
    return parent


def _folded_state(frame: dict[str, object]) -> Frame:
    """Title, positions and fold angles of a frame."""
    coords = _coords(frame) * _metres(frame)
    edge_count = len(_vertex_lists(frame, "edges_vertices", len(coords))) if "edges_vertices" in frame else 0
    fold_angles = _fold_angles(frame, edge_count)
    if len(fold_angles) != edge_count:
        raise InputError(f"edges_foldAngle: need one for each of the {edge_count} edges, got {len(fold_angles)}")
    return str(frame.get("frame_title", "")), coords, fold_angles


def _document(file: Path) -> dict[str, object]:
    """Parse the JSON of a file."""
    try:
        document = json.loads(file.read_text(encoding="utf-8-sig"), parse_constant=_refuse_constant)
    except OSError as error:
        raise InputError(f"need a file that can be read, got {error.strerror}") from error
    except InputError:
        raise
    except json.JSONDecodeError as error:
        reason = f"{error.msg} (at line {error.lineno}, column {error.colno})"
        raise InputError(f"need JSON, as FOLD files are: {reason}") from error
    except UnicodeDecodeError as error:
        raise InputError(f"need JSON, as FOLD files are: not UTF-8 text from byte {error.start} on") from error
    except (ValueError, RecursionError) as error:
        reason = "nested too deeply" if isinstance(error, RecursionError) else "a whole number has too many digits"
        raise InputError(f"need JSON, as FOLD files are: {reason}") from error
    if not isinstance(document, dict):
        raise InputError(f"need a JSON object with FOLD keys, got {type(document).__name__}")
    spec = document.get("file_spec", 1)
    if isinstance(spec, bool) or not isinstance(spec, int | float) or not 1 <= spec < 2:
        raise InputError(f"file_spec: need a version from 1 to below 2 of the FOLD format, got {as_written(spec)}")
    return document


def _refuse_constant(name: str) -> NoReturn:
    """NaN and Infinity are no JSON, and no place for a vertex."""
    raise InputError(f"need finite numbers only, got {name}")


def _pattern_of(document: dict[str, object]) -> CreasePattern:
    """Turn the keys of a FOLD frame into a pattern."""
    coords = _coords(document) * _metres(document)
    pairs = _vertex_lists(document, "edges_vertices", len(coords))
    for edge, ends in enumerate(pairs):
        if len(ends) != 2:
            raise InputError(f"edges_vertices[{edge}]: need two vertices, got {len(ends)}")
    edges = check_edges(np.array(pairs, dtype=np.int64).reshape(-1, 2), coords)
    if document.get("faces_vertices"):
        faces = _vertex_lists(document, "faces_vertices", len(coords))
        if not np.ptp(coords[:, 2]) > 0:
            faces = [face if _doubled_area(coords, face) > 0 else face[::-1] for face in faces]
    else:
        faces = _faces_between(coords, edges)
    letters = _list(document, "edges_assignment") if "edges_assignment" in document else ["U"] * len(edges)
    roles = _list(document, _ROLES) if _ROLES in document else [""] * len(edges)
    return CreasePattern(
        vertices_coords=coords,
        edges_vertices=edges,
        edges_assignment=tuple("F" if letter == "J" else str(letter) for letter in letters),
        edges_fold_angle=_fold_angles(document, len(edges), letters),
        faces_vertices=tuple(tuple(face) for face in faces),
        edges_role=tuple(str(role) for role in roles),
        title=str(document.get("frame_title", document.get("file_title", ""))),
    )


def _list(document: dict[str, object], key: str) -> list[object]:
    """A list that must be there."""
    if key not in document:
        raise InputError(f"{key}: need a list, but the key is missing")
    values = document[key]
    if not isinstance(values, list):
        raise InputError(f"{key}: need a list, got {type(values).__name__}")
    return values


def _metres(document: dict[str, object]) -> float:
    """Length of the file's unit, m."""
    unit = document.get("frame_unit")
    if not isinstance(unit, str) or unit not in _METRES:
        got = "no frame_unit" if unit is None else as_written(unit)
        raise InputError(
            f"frame_unit: need a unit of length, one of {', '.join(_METRES)}, got {got}; write that of its lengths into"
            ' the file, as in "frame_unit": "cm"'
        )
    return _METRES[unit]


def _number(value: object, key: str) -> float:
    """A finite number, none of JSON's other kinds."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{key}: need a number, got {value!r}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(f"{key}: need a finite number, got {number:g}")
    return number


def _coords(document: dict[str, object]) -> NDArray[np.float64]:
    """Positions in the file's unit, shape (N, 3)."""
    rows: list[list[float]] = []
    for vertex, position in enumerate(_list(document, "vertices_coords")):
        key = f"vertices_coords[{vertex}]"
        if not isinstance(position, list) or len(position) not in (2, 3):
            raise InputError(f"{key}: need two or three numbers, got {position!r}")
        rows.append([_number(value, key) for value in [*position, 0.0][:3]])
    if not rows:
        raise InputError("vertices_coords: need at least one vertex, got none")
    return np.array(rows, dtype=np.float64)


def _vertex_lists(document: dict[str, object], key: str, vertex_count: int) -> list[list[int]]:
    """Lists of existing vertices."""
    lists: list[list[int]] = []
    for number, vertices in enumerate(_list(document, key)):
        where = f"{key}[{number}]"
        if not isinstance(vertices, list):
            raise InputError(f"{where}: need a list of vertices, got {vertices!r}")
        checked: list[int] = []
        for vertex in vertices:
            if isinstance(vertex, bool) or not isinstance(vertex, int):
                raise InputError(f"{where}: need whole numbers, got {vertex!r}")
            check_vertex(where, vertex, vertex_count)
            checked.append(vertex)
        lists.append(checked)
    return lists


def _fold_angles(document: dict[str, object], edge_count: int, letters: Sequence[object] = ()) -> NDArray[np.float64]:
    """Fold angles, rad, nan where the file has none; raise InputError where one contradicts its edge's letter."""
    if "edges_foldAngle" not in document:
        return np.full(edge_count, np.nan)
    values = _list(document, "edges_foldAngle")
    degrees = [
        math.nan if value is None else _number(value, f"edges_foldAngle[{edge}]") for edge, value in enumerate(values)
    ]
    for edge, angle in enumerate(degrees):
        letter = letters[edge] if edge < len(letters) else ""
        for wrong, rule in (
            (abs(angle) > _FOLDED_FLAT, "-180 to 180 deg"),
            (letter == "M" and angle > 0, "<= 0 on a mountain"),
            (letter == "V" and angle < 0, ">= 0 on a valley"),
        ):
            if wrong:
                raise InputError(f"edges_foldAngle[{edge}]: need {rule}, got {angle:.6g}")
    return np.radians(np.array(degrees, dtype=np.float64))


def _doubled_area(coords: NDArray[np.float64], face: list[int]) -> float:
    """Twice the area of a face seen from +z, positive where it runs counterclockwise (shoelace formula)."""
    sides = face_sides(face) if face else []
    return math.fsum(coords[a, 0] * coords[b, 1] - coords[b, 0] * coords[a, 1] for a, b in sides)


def _faces_between(coords: NDArray[np.float64], edges: NDArray[np.int64]) -> list[list[int]]:
    """Find the faces of a flat sheet: along every side, turn left as sharply as the edges allow."""
    unknown = "faces_vertices: need the key in the file, for without it faces are found only"
    if np.ptp(coords[:, 2]) > 0:
        raise InputError(f"{unknown} in a sheet in one plane z, got a solid shape")
    around: dict[int, list[int]] = {}
    for tail, head in edges.tolist():
        around.setdefault(tail, []).append(head)
        around.setdefault(head, []).append(tail)
    following: dict[tuple[int, int], tuple[int, int]] = {}
    for vertex, ends in around.items():
        away = coords[ends] - coords[vertex]
        turn = np.argsort(np.arctan2(away[:, 1], away[:, 0])).tolist()
        for position, end in enumerate(turn):
            following[(ends[end], vertex)] = (vertex, ends[turn[position - 1]])
    faces: list[list[int]] = []
    while following:
        start, side = next(iter(following.items()))
        del following[start]
        face = [start[1]]
        while side != start:
            face.append(side[1])
            side = following.pop(side)
        faces.append(face)
    if len(around) - len(edges) + len(faces) != 2:  # Euler's formula for a connected plane graph
        raise InputError(
            f"{unknown} between edges that hang together and do not cross, got edges that lie apart or cross"
        )
    return [face for face in faces if _doubled_area(coords, face) > 0]

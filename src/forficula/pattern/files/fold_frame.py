"""The arrays of a FOLD frame, each entry checked: positions, edges, faces, assignments and fold angles."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import ASSIGNMENTS, check_vertex, face_sides
from forficula.pattern.files.edge_names import letter_of_name
from forficula.pattern.files.fold_document import FoldFrame, list_at
from forficula.quantities import as_written, is_whole, show_value

_METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "nm": 1e-9, "in": 0.0254, "pt": 0.0254 / 72}
_FOLDED_FLAT = 180 * (1 + 1e-9)  # deg, with an allowance for rounding
_LARGEST = 1e100  # squares of lengths must be finite
_SMALLEST_SHEET, _LARGEST_SHEET = 1e-12, 1e12  # m
_TARGETS = {"M": -math.pi, "V": math.pi, "F": 0.0}


CHOSEN_SIZE = 0.2  # m; [chosen] a sheet that one holds in two hands
# remark on a file that states no unit of length, and what to do about it on the command line
CHOSEN_UNIT = "the file states no unit of length: its largest dimension is taken as 20 cm [chosen]"
UNIT_OPTION = 'set the length of one unit with --unit, such as --unit "1 cm", or with pattern.unit in a design file'


def chosen_unit(extent: float) -> float:
    """Return the length of one unit, m, with which a sheet of an extent in units is as large as `CHOSEN_SIZE`."""
    return CHOSEN_SIZE / extent if extent > 0 else 1.0


def lacks_unit(frame: FoldFrame) -> bool:
    """Return whether a frame has no unit of length, or the unit "unit", which has no length."""
    return frame.get("frame_unit") in (None, "unit")


def metres_of(frame: FoldFrame, unit: float | None) -> float:
    """Return the length of the file's unit.

    Args:
        frame: frame of the file.
        unit: length of the unit from the caller, m; None where there is none.

    Returns:
        Length of the unit, m.

    Raises:
        InputError: neither the frame nor the caller gives a unit of length, or they contradict each other.
    """
    if unit is not None and not (math.isfinite(unit) and unit > 0):
        raise InputError(f"unit: need a length > 0, got {unit:g} m")
    name = frame.get("frame_unit")
    known = _METRES.get(name) if isinstance(name, str) else None
    if unit is None and known is None:
        got = "no frame_unit" if name is None else as_written(name)
        raise InputError(
            f"frame_unit: need a unit of length, one of {', '.join(_METRES)}, got {got}; set the length of the unit: in"
            ' a design pattern.unit = "1 cm", on the command line --unit "1 cm"'
        )
    if unit is not None and known is not None and not math.isclose(unit, known, rel_tol=1e-9):
        raise InputError(
            f"frame_unit: need no unit that contradicts that of the file, {as_written(name)}, got"
            f" {show_value(unit, 'm')}; remove it, or change frame_unit"
        )
    if known is not None:
        return known
    assert unit is not None  # one of the two is there
    return unit


def coords_in_metres(frame: FoldFrame, unit: float | None) -> Array:
    """Return the positions in m, shape (N, 3), z = 0 where there are two coordinates.

    Args:
        frame: frame of the file.
        unit: length of the unit from the caller, m; None where there is none.

    Raises:
        InputError: as for `coords_of` and `metres_of`, or the sheet is larger than 1e12 m or smaller than 1e-12 m.
    """
    coords, metres = coords_of(frame), metres_of(frame, unit)
    extent = float(np.ptp(coords, axis=0).max())
    # edges without a length are refused as such
    if extent and not _SMALLEST_SHEET <= extent * metres <= _LARGEST_SHEET:
        raise InputError(
            f"vertices_coords: need a sheet of a size from {_SMALLEST_SHEET:g} m to {_LARGEST_SHEET:g} m, got"
            f" {extent:g} units of {metres:g} m each; is the unit right?"
        )
    return coords * metres


def coords_of(frame: FoldFrame) -> Array:
    """Return the positions in the file's unit, shape (N, 3), z = 0 where there are two coordinates.

    Raises:
        InputError: there are no positions, or an entry is not a position.
    """
    rows: list[list[float]] = []
    for vertex, position in enumerate(list_at(frame, "vertices_coords")):
        key = f"vertices_coords[{vertex}]"
        if not isinstance(position, list) or len(position) not in (2, 3):
            raise InputError(f"{key}: need two or three numbers, got {position!r}")
        rows.append([_number(value, key) for value in [*position, 0.0][:3]])
    if not rows:
        raise InputError("vertices_coords: need at least one vertex, got none")
    coords = np.array(rows, dtype=np.float64)
    if (largest := float(np.abs(coords).max())) > _LARGEST:
        raise InputError(f"vertices_coords: need numbers up to {_LARGEST:g}, got {largest:g}")
    return coords


def _number(value: object, key: str) -> float:
    """Convert a JSON value to a finite number."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{key}: need a number, got {value!r}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(f"{key}: need a finite number, got {number:g}")
    return number


def vertex_lists(frame: FoldFrame, key: str, vertex_count: int) -> list[list[int]]:
    """Return lists of existing vertices; whole numbers may be written as 2.0.

    Raises:
        InputError: the key is missing, or an entry is not a list of existing vertices.
    """
    lists: list[list[int]] = []
    for number, vertices in enumerate(list_at(frame, key)):
        where = f"{key}[{number}]"
        if not isinstance(vertices, list):
            raise InputError(f"{where}: need a list of vertices, got {vertices!r}")
        checked: list[int] = []
        for value in vertices:
            vertex = int(value) if isinstance(value, float) and value.is_integer() else value
            if isinstance(vertex, bool) or not isinstance(vertex, int):
                raise InputError(f"{where}: need whole numbers, got {vertex!r}")
            check_vertex(where, vertex, vertex_count)
            checked.append(vertex)
        lists.append(checked)
    return lists


def edges_of(frame: FoldFrame, vertex_count: int) -> Indices:
    """Take the edges, shape (E, 2); where the frame has none, they are the sides of its faces.

    Raises:
        InputError: there is neither, or an entry is no pair of existing vertices.
    """
    if "edges_vertices" not in frame and frame.get("faces_vertices"):
        for key in frame:
            if key.startswith("edges_") and frame[key]:
                raise InputError(f"edges_vertices: need the key in the file, for {key} says something of every edge")
        sides = (side for face in vertex_lists(frame, "faces_vertices", vertex_count) for side in face_sides(face))
        pairs = list(map(list, dict.fromkeys((min(side), max(side)) for side in sides)))
    else:
        pairs = vertex_lists(frame, "edges_vertices", vertex_count)
    for edge, ends in enumerate(pairs):
        if len(ends) != 2:
            raise InputError(f"edges_vertices[{edge}]: need two vertices, got {len(ends)}")
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def letters_of(frame: FoldFrame, edge_count: int) -> list[str] | None:
    """Return the letters of the edges; lowercase letters and words are allowed, "J" (join) is flat, null unassigned.

    Returns:
        None where the frame has no letters.

    Raises:
        InputError: there are too many or too few letters, or one is unknown.
    """
    if "edges_assignment" not in frame:
        return None
    letters: list[str] = []
    for edge, value in enumerate(values_of(frame, "edges_assignment", edge_count)):
        letter = "U" if value is None else letter_of_name(value) if isinstance(value, str) else None
        if letter is None:
            allowed = ", ".join(f"{known} ({meaning})" for known, meaning in ASSIGNMENTS.items())
            raise InputError(f"edges_assignment[{edge}]: need one of {allowed}, got {value!r}")
        letters.append(letter)
    return letters


def values_of(frame: FoldFrame, key: str, edge_count: int) -> list[object]:
    """Return the values of a key with one value per edge.

    Raises:
        InputError: the key is missing, or the number of values differs from the number of edges.
    """
    values = list_at(frame, key)
    if len(values) != edge_count:
        what = "letter" if key == "edges_assignment" else "value"
        raise InputError(f"{key}: need one {what} for each of the {edge_count} edges, got {len(values)}")
    return values


def folds_of(frame: FoldFrame, key: str, edge_count: int) -> Indices:
    """Return the number of the fold of every edge, (E,); none if the key is missing.

    Raises:
        InputError: the number of values differs from the number of edges, or one is no whole number of an edge.
    """
    if key not in frame:
        return np.zeros(0, dtype=np.int64)
    numbers = []
    for edge, value in enumerate(values_of(frame, key, edge_count)):
        if not is_whole(value, 0, edge_count - 1):
            raise InputError(f"{key}[{edge}]: need a whole number from 0 to {edge_count - 1}, got {as_written(value)}")
        numbers.append(value)
    return np.array(numbers, dtype=np.int64)


def fold_angles_of(frame: FoldFrame, edge_count: int, letters: Sequence[str] | None = None) -> tuple[Array, list[str]]:
    """Return the fold angles.

    The key is "edges_foldAngles" in FOLD 1.0; Origami Simulator wrote radians under that name.

    Returns:
        Fold angles, rad, shape (E,), nan where the file has none, and remarks.

    Raises:
        InputError: there are too many or too few, or one is beyond 180 deg or contradicts the letter of its edge.
    """
    key = "edges_foldAngles" if "edges_foldAngle" not in frame and "edges_foldAngles" in frame else "edges_foldAngle"
    if key not in frame:
        return np.full(edge_count, np.nan), []
    values = [
        math.nan if value is None else _number(value, f"{key}[{edge}]")
        for edge, value in enumerate(list_at(frame, key))
    ]
    if len(values) != edge_count:
        raise InputError(f"{key}: need one for each of the {edge_count} edges, got {len(values)}")
    remarks = []
    largest = max((abs(value) for value in values if not math.isnan(value)), default=0.0)
    if (
        key == "edges_foldAngles"
        and largest <= math.pi * (1 + 1e-6)
        and "Origami Simulator" in str(frame.get("file_creator", ""))
    ):
        values = [math.degrees(value) for value in values]
        remarks = ["edges_foldAngles: taken as radians, which Origami Simulator wrote under this name"]
    for edge, angle in enumerate(values):
        letter = letters[edge] if letters is not None else ""
        for wrong, rule in (
            (abs(angle) > _FOLDED_FLAT, "-180 to 180 deg"),
            (letter == "M" and angle > 0, "<= 0 on a mountain"),
            (letter == "V" and angle < 0, ">= 0 on a valley"),
        ):
            if wrong:
                raise InputError(f"{key}[{edge}]: need {rule}, got {angle:.6g}")
    return np.radians(np.array(values, dtype=np.float64)), remarks


def letters_by_angle(fold_angles: Array, rim: Flags) -> list[str]:
    """Assign letters by the sign of the fold angle, for a file without any; border at the rim, unassigned otherwise.

    Args:
        fold_angles: fold angles, rad, shape (E,), nan where there is none.
        rim: whether an edge has a face on one side only, shape (E,).
    """
    return [
        "B" if at_rim else "V" if angle > 0 else "M" if angle < 0 else "F" if angle == 0 else "U"
        for angle, at_rim in zip(fold_angles.tolist(), rim.tolist(), strict=True)
    ]


def target_angles(letters: Sequence[str], fold_angles: Array) -> Array:
    """Set missing fold angles by the letters: -180 deg on mountains, 180 deg on valleys, 0 on flat edges.

    Args:
        letters: letters of the edges, E.
        fold_angles: fold angles, rad, shape (E,), nan where there is none.

    Returns:
        Fold angles, rad, shape (E,), nan on borders, cuts and unassigned edges without an angle.
    """
    targets = np.array([_TARGETS.get(letter, math.nan) for letter in letters])
    folding = np.array([letter not in "BC" for letter in letters])
    filled: Array = np.where(folding, np.where(np.isnan(fold_angles), targets, fold_angles), np.nan)
    return filled

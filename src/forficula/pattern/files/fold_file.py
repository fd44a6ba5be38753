"""Crease patterns and their folded states read from FOLD 1.x files (specification by Demaine, Ku and Lang)."""

from __future__ import annotations

import os
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.files import shown_path
from forficula.names import listed, one_line
from forficula.pattern.crease_pattern import CreasePattern, check_edges, face_area, face_sides
from forficula.pattern.drawings.flat_faces import (
    check_edges_apart,
    check_face_sides,
    check_faces_apart,
    faces_between,
    parts_of,
)
from forficula.pattern.files.fold_document import FoldFrame, all_frames, chosen_frame, fold_document, frame_classes
from forficula.pattern.files.fold_frame import (
    CHOSEN_UNIT,
    chosen_unit,
    coords_in_metres,
    coords_of,
    edges_of,
    fold_angles_of,
    folds_of,
    lacks_unit,
    letters_by_angle,
    letters_of,
    target_angles,
    values_of,
    vertex_lists,
)
from forficula.pattern.files.fold_writer import FOLDS, ROLES, Frame
from forficula.pattern.files.sheet_plane import SheetPlane, sheet_plane
from forficula.quantities import as_written

_MOST_NAMED = 8


@dataclass(frozen=True, kw_only=True, eq=False)
class _Sheet:
    """A pattern and the relation to its frame: the vertices and edges used, the rotation, and remarks."""

    pattern: CreasePattern
    vertices: Indices  # numbers in the file
    edges: Indices  # numbers in the file
    counts: tuple[int, int]  # numbers of vertices and edges in the file
    plane: SheetPlane | None
    remarks: list[str]
    unit: float | None = None  # given or chosen, m


def read_fold(path: str | os.PathLike[str], unit: float | None = None, frame: int | str | None = None) -> CreasePattern:
    """Read a pattern from a FOLD file, like `fold_pattern` but without its remarks."""
    return fold_pattern(path, unit, frame)[0]


def fold_pattern(
    path: str | os.PathLike[str],
    unit: float | None = None,
    frame: int | str | None = None,
    *,
    choose_unit: bool = False,
) -> tuple[CreasePattern, list[str]]:
    """Read a pattern from a FOLD file.

    Data that files of other programs lack is added where possible:

    - Lengths are converted by `frame_unit`; if it is missing or "unit", by the argument `unit`.
    - Positions with two coordinates get z = 0. A flat sheet in any other plane is rotated into z = 0 with that side up
      from which its faces are counterclockwise (see `sheet_plane`); a folded sheet is not moved.
    - Faces of a flat sheet are made counterclockwise, those of other sheets made to have one orientation. If the file
      has no faces, they are found between the edges, or for a folded sheet copied from a flat frame with the same
      edges. In a folded form that lies flat, the faces that are turned over are clockwise.
    - Without assignments, edges are valleys or mountains by the sign of their fold angle, flat at 0, borders at the rim
      and unassigned otherwise; a join, "J", is flat, and a border between two faces is a cut. Without a fold angle,
      valleys get 180 deg, mountains -180 deg and flat edges 0; borders, cuts and unassigned edges have none.
    - Flat edges that end inside a face, edges without a face and vertices without an edge are left out, and later
      numbers move up.

    Args:
        path: path of the file.
        unit: length of the file's unit, m, for a file without one; a different unit in the file is an error.
        frame: number (0 is the key frame), title or class of a frame; with None the key frame, or, if it has no
            vertices, the first crease pattern.
        choose_unit: as for `read_pattern`.

    Returns:
        The pattern in metres and radians, and remarks on changes to the data of the file.

    Raises:
        InputError: the file cannot be read, is not a FOLD file, has no unit of length, or does not contain a valid
            pattern; the message names the file and the key.
    """
    try:
        sheet = _sheet(all_frames(fold_document(Path(path))), unit, frame, choose_unit=choose_unit)
    except InputError as error:
        raise InputError(f"{shown_path(Path(path))}: {error}") from error
    return sheet.pattern, sheet.remarks


def read_folded_frames(
    path: str | os.PathLike[str],
    unit: float | None = None,
    frame: int | str | None = None,
    *,
    choose_unit: bool = False,
) -> list[Frame]:
    """Read the folded states of a FOLD file: the frames in `file_frames` with the class "foldedForm".

    A frame with `frame_inherit` has the missing keys of its parent; every frame without a `frame_unit` has that of the
    file. Positions with two coordinates get z = 0. The states are rotated like the pattern, and vertices and edges that
    the pattern leaves out are left out.

    Args:
        path: path of the file.
        unit: length of the file's unit, m, as for `read_fold`.
        frame: frame of the pattern, as for `read_fold`; it does not count as a folded state.
        choose_unit: as for `read_pattern`.

    Returns:
        Title, positions of the vertices in m, shape (N, 3), and fold angles in rad, shape (E,), nan where there is
        none, of every state, in the format of `write_fold`.

    Raises:
        InputError: the file cannot be read, is not a FOLD file, has no unit of length, or contains an invalid pattern
            or folded state; the message names the file, the frame and the key.
    """
    states: list[Frame] = []
    try:
        frames = all_frames(fold_document(Path(path)))
        sheet = _sheet(frames, unit, frame, choose_unit=choose_unit)
        chosen, unit = chosen_frame(frames, frame), sheet.unit
        for number, item in enumerate(frames[1:], 1):
            try:
                if number != chosen and "foldedForm" in frame_classes(item):
                    states.append(_folded_state(item, unit, sheet))
            except InputError as error:
                raise InputError(f"file_frames[{number - 1}]: {error}") from error
    except InputError as error:
        raise InputError(f"{shown_path(Path(path))}: {error}") from error
    return states


def _folded_state(frame: FoldFrame, unit: float | None, sheet: _Sheet) -> Frame:
    """Read the title, positions and fold angles of a frame."""
    coords = coords_in_metres(frame, unit)
    edge_count = len(edges_of(frame, len(coords))) if "edges_vertices" in frame or "faces_vertices" in frame else 0
    fold_angles, _ = fold_angles_of(frame, edge_count)
    if (len(coords), edge_count) == sheet.counts:
        coords, fold_angles = coords[sheet.vertices], fold_angles[sheet.edges]
    if sheet.plane is not None:
        coords = sheet.plane.turned(coords)
    return str(frame.get("frame_title", "")), coords, fold_angles


def _sheet(
    frames: Sequence[FoldFrame], unit: float | None, chosen: int | str | None, *, choose_unit: bool = False
) -> _Sheet:
    """Read the pattern of the chosen frame."""
    number = chosen_frame(frames, chosen)
    try:
        choose_unit = choose_unit and unit is None and lacks_unit(frames[number])
        if choose_unit:
            unit = chosen_unit(float(np.ptp(coords_of(frames[number]), axis=0).max()))
        sheet = _sheet_of(frames, number, unit)
    except InputError as error:
        raise InputError(f"file_frames[{number - 1}]: {error}" if number else str(error)) from error
    sheet = replace(sheet, unit=unit, remarks=[*[CHOSEN_UNIT] * choose_unit, *sheet.remarks])
    if chosen is None and number:
        title = as_written(str(frames[number].get("frame_title", "")))
        remark = f"file_frames[{number - 1}]: used, {title}, because the key frame has no vertices"
        return replace(sheet, remarks=[remark, *sheet.remarks])
    return sheet


def _sheet_of(frames: Sequence[FoldFrame], number: int, unit: float | None) -> _Sheet:
    """Convert the keys of a frame to a pattern."""
    frame = frames[number]
    coords = coords_in_metres(frame, unit)
    edges = check_edges(edges_of(frame, len(coords)), coords)
    letters = letters_of(frame, len(edges))
    given_angles, remarks = fold_angles_of(frame, len(edges), letters)
    faces = vertex_lists(frame, "faces_vertices", len(coords)) if frame.get("faces_vertices") else None
    plane = sheet_plane(coords, faces or [])
    if plane is not None:
        coords = _laid_flat(coords, plane, remarks)
    kept = np.arange(len(edges))
    folded_flat = faces is not None and plane is not None and _is_folded_flat(coords, faces, frame)
    if faces is None:
        kept = _edges_that_close(edges, letters) if plane is not None else kept
        faces = _found_faces(frames, number, coords if plane is not None else None, edges, kept)
        remarks.append(f"faces_vertices: {len(faces)} found between the edges")
    elif plane is not None and not folded_flat:
        faces = [face if face_area(coords, face) > 0 else face[::-1] for face in faces]
    else:
        faces, turned = oriented_faces(faces)
        if turned:
            remarks.append(f"faces_vertices: {len(turned)} of {len(faces)} reversed to the orientation of the others")
    faces_at = Counter(frozenset(side) for face in faces for side in face_sides(face))
    counts = np.array([faces_at[frozenset(ends)] for ends in edges.tolist()])
    letters = letters or letters_by_angle(given_angles, counts == 1)
    letters = _with_cuts(letters, counts, remarks)
    whole = CreasePattern(
        vertices_coords=coords,
        edges_vertices=edges,
        edges_assignment=tuple(letters),
        edges_fold_angle=target_angles(letters, given_angles),
        faces_vertices=tuple(tuple(face) for face in faces),
        edges_role=tuple(map(str, values_of(frame, ROLES, len(edges)))) if ROLES in frame else (),
        edges_fold=folds_of(frame, FOLDS, len(edges)),
        title=one_line(str(frame.get("frame_title", frame.get("file_title", "")))),
    )
    _check_geometry(whole, kept, counts, lies_flat=plane is not None and not folded_flat)
    return _without_loose_ends(whole, np.flatnonzero(counts > 0), plane, remarks)


def _laid_flat(coords: Array, plane: SheetPlane, remarks: list[str]) -> Array:
    """Move the vertices of a flat sheet to one z; positions that are there already do not change in any bit."""
    if plane.rotation[2, 2] != 1:
        toward = listed(f"{share:.3g}" for share in plane.rotation[2].tolist())
        up = toward.replace(" and", ",")
        remarks.append(f"vertices_coords: the sheet is rotated into z = 0; in the file, up is along ({up})")
        coords = plane.turned(coords)
        coords[:, 2] = 0
    elif np.ptp(coords[:, 2]) > 0:
        remarks.append("vertices_coords: z values that differ by less than 1e-6 of the sheet's size are taken as equal")
        coords[:, 2] = coords[:, 2].mean()
    return coords


def _is_folded_flat(coords: Array, faces: Sequence[Sequence[int]], frame: FoldFrame) -> bool:
    """Return whether a frame is a folded form that lies flat with some faces turned over."""
    if "foldedForm" not in frame_classes(frame):
        return False
    sides = [side for face in faces for side in face_sides(face)]
    turned_over = {face_area(coords, face) > 0 for face in faces}
    return len(turned_over) == 2 and len(set(sides)) == len(sides)


def _edges_that_close(edges: Indices, letters: Sequence[str] | None) -> Indices:
    """Return the numbers of the edges without flat ones that have a free end; raise InputError if others have one."""
    kept = np.arange(len(edges))
    while True:
        degrees = np.bincount(edges[kept].ravel(), minlength=edges.max() + 1)
        free = (degrees[edges[kept]] == 1).any(axis=1)
        drop = free & np.array([letters is not None and letters[edge] == "F" for edge in kept.tolist()], dtype=bool)
        if not drop.any():
            break
        kept = kept[~drop]
    used = np.unique(edges[kept])
    parts = len(np.unique(parts_of(int(edges.max()) + 1, edges[kept])[used]))
    if parts != 1:
        raise InputError(
            "faces_vertices: need the key in the file, because without it faces are found only between edges that are"
            f" connected, got {parts} separate pieces"
        )
    if free.any():
        edge = int(kept[np.argmax(free)])
        vertex = next(end for end in edges[edge].tolist() if degrees[end] == 1)
        raise InputError(
            f"edges_vertices[{edge}]: need edges without a free end, got one with a free end at vertex {vertex};"
            ' extend it, remove it, or assign it "F" (flat), which leaves it out'
        )
    return kept


def _found_faces(
    frames: Sequence[FoldFrame],
    number: int,
    flat: Array | None,
    edges: Indices,
    kept: Indices,
) -> list[list[int]]:
    """Find the faces between the edges of a flat sheet, or of a flat frame with the same edges."""
    if flat is not None:
        check_edges_apart(flat[:, :2], edges[kept], kept)
        return faces_between(flat, edges[kept])
    for other, frame in enumerate(frames):
        if other == number or not frame.get("vertices_coords") or "edges_vertices" not in frame:
            continue
        coords = coords_of(frame)
        if len(coords) <= edges.max() or not np.array_equal(edges_of(frame, len(coords)), edges):
            continue
        if frame.get("faces_vertices"):
            return vertex_lists(frame, "faces_vertices", len(coords))
        plane = sheet_plane(coords, [])
        if plane is not None:
            turned = plane.turned(coords)
            check_edges_apart(turned[:, :2], edges, kept)
            return faces_between(turned, edges)
    raise InputError(
        "faces_vertices: need the key in the file, because without it faces are found only in a flat sheet, got a shape"
        " that is not flat, and no flat frame with the same edges"
    )


def _with_cuts(letters: Sequence[str], counts: Indices, remarks: list[str]) -> list[str]:
    """Replace borders between two faces by cuts, for which FOLD had no letter before version 1.2."""
    inside = [edge for edge, letter in enumerate(letters) if letter == "B" and counts[edge] > 1]
    if inside:
        remarks.append(f"edges_assignment: border between two faces taken as a cut, {_named('edge', inside)}")
    return ["C" if letter == "B" and counts[edge] > 1 else letter for edge, letter in enumerate(letters)]


def _check_geometry(pattern: CreasePattern, kept: Indices, counts: Indices, *, lies_flat: bool) -> None:
    """Raise InputError for a sheet that cannot be built."""
    coords, edges, faces = pattern.vertices_coords, pattern.edges_vertices, pattern.faces_vertices
    if (counts > 2).any():
        edge = int(np.argmax(counts > 2))
        raise InputError(
            f"edges_vertices[{edge}]: need at most two faces at an edge, got {counts[edge]}; split the edge"
        )
    check_face_sides(coords, faces)
    if lies_flat:
        beside_faces = np.intersect1d(kept, np.flatnonzero(counts > 0))
        check_edges_apart(coords[:, :2], edges[beside_faces], beside_faces)
        check_faces_apart(coords[:, :2], edges[beside_faces], faces)


def _without_loose_ends(whole: CreasePattern, edges: Indices, plane: SheetPlane | None, remarks: list[str]) -> _Sheet:
    """Leave out edges without a face and vertices without an edge."""
    vertices = np.unique(whole.edges_vertices[edges])
    for what, all_of, kept in (
        ("edge", len(whole.edges_vertices), edges),
        ("vertex", len(whole.vertices_coords), vertices),
    ):
        if lost := sorted(set(range(all_of)) - set(kept.tolist())):
            reason = "no face is beside" if what == "edge" else "no edge is at"
            plural = {"edge": "edges_vertices", "vertex": "vertices_coords"}[what]
            remarks.append(f"{plural}: left out, as {reason} it, {_named(what, lost)}; later numbers move up")
    number = {vertex: place for place, vertex in enumerate(vertices.tolist())}
    _, first, place = np.unique(whole.edges_fold[edges], return_index=True, return_inverse=True)
    pattern = CreasePattern(
        vertices_coords=whole.vertices_coords[vertices],
        edges_vertices=np.searchsorted(vertices, whole.edges_vertices[edges]),
        edges_assignment=tuple(whole.edges_assignment[edge] for edge in edges.tolist()),
        edges_fold_angle=whole.edges_fold_angle[edges],
        faces_vertices=tuple(tuple(number[vertex] for vertex in face) for face in whole.faces_vertices),
        edges_role=tuple(whole.edges_role[edge] for edge in edges.tolist()),
        edges_fold=first[place],
        title=whole.title,
    )
    counts = len(whole.vertices_coords), len(whole.edges_vertices)
    return _Sheet(pattern=pattern, vertices=vertices, edges=edges, counts=counts, plane=plane, remarks=remarks)


def _named(what: str, numbers: Sequence[int]) -> str:
    """Return a few numbers in words, such as "edges 3 and 5"."""
    plural = {"edge": "edges", "vertex": "vertices"}[what]
    shown = [str(number) for number in numbers[:_MOST_NAMED]]
    if len(numbers) > _MOST_NAMED:
        return f"{len(numbers)} {plural}, {', '.join(shown)} ..."
    return f"{what if len(shown) == 1 else plural} {listed(shown)}"


def oriented_faces(faces: Sequence[Sequence[int]]) -> tuple[list[list[int]], list[int]]:
    """Reverse faces so that two faces that share an edge pass along it in opposite directions.

    As few faces as possible of every connected piece are reversed; if both choices reverse half of them, the first face
    is not reversed.

    Args:
        faces: vertices of the faces, in order around them.

    Returns:
        The faces, and the numbers of the reversed ones.

    Raises:
        InputError: no choice works, because the sheet has one side only.
    """
    neighbours = _neighbours(faces)
    sense: dict[int, bool] = {}
    turned: list[int] = []
    for first in range(len(faces)):
        if first in sense:
            continue
        sense[first], piece = True, [first]
        for face in piece:
            for other, alike in neighbours[face]:
                if other not in sense:
                    sense[other] = sense[face] == alike
                    piece.append(other)
                elif sense[other] != (sense[face] == alike):
                    raise InputError(
                        f"faces_vertices[{other}]: need a sheet with two sides, got one with only one side, like a"
                        f" Moebius strip: its orientation cannot match that of face {face}"
                    )
        unlike = [face for face in piece if not sense[face]]
        turned += unlike if 2 * len(unlike) <= len(piece) else [face for face in piece if sense[face]]
    over = set(turned)
    return [[*face[::-1]] if number in over else [*face] for number, face in enumerate(faces)], sorted(turned)


def _neighbours(faces: Sequence[Sequence[int]]) -> dict[int, list[tuple[int, bool]]]:
    """Return the neighbours of every face across edges, and whether both pass along the edge in opposite directions."""
    at = defaultdict[frozenset[int], list[tuple[int, tuple[int, int]]]](list)
    for number, face in enumerate(faces):
        for side in face_sides(face):
            at[frozenset(side)].append((number, side))
    result = defaultdict[int, list[tuple[int, bool]]](list)
    for pair in at.values():
        if len(pair) == 2:
            (one, side), (other, opposite) = pair
            result[one].append((other, side != opposite))
            result[other].append((one, side != opposite))
    return result

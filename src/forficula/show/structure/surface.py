"""The drawn surface of a structure at a time of a run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record
from forficula.show.structure.shape import Shape, vertex_places
from forficula.structure.membrane_stress import principal_strains

_FLAT = 1e-9  # squared area below which a triangle has no strain, as a share of its squared size


@dataclass(frozen=True, kw_only=True)
class DrawnSurface:
    """Structure in 3-D.

    Attributes:
        faces: faces of sheets and plates, m, (face, corner, axis); triangles repeat their last corner.
        regions: region of each face, (face,).
        two_sided: whether the two sides have different colours.
        bars: ends of bars, m, (bar, end, axis).
        radii: radii of bars, m, (bar,).
        lines: ends of creases and edges, m, (line, end, axis).
        folds: fold angles of lines, valleys positive, rad, (line,); nan for lines without a shown angle.
        held: supported vertices, m, (vertex, axis).
        tendons: ends of tendons, m, (tendon, end, axis).
        thickness: reference for the width of lines, m.
        span: span of the structure, m.
        bar_regions: region whose hue each bar has, -1 for none, (bar,); None if regions are not groups of bodies.
    """

    faces: Array
    regions: Indices
    two_sided: bool
    bars: Array
    radii: Array
    lines: Array
    folds: Array
    held: Array
    tendons: Array
    thickness: float
    span: float
    bar_regions: Indices | None = None


def surface_at(record: Record, shape: Shape, time: float) -> DrawnSurface:
    """Return the surface at a time.

    Args:
        record: the simulated motion.
        shape: drawn parts of its structure.
        time: s; positions are interpolated between samples, and constant outside of them.
    """
    moved = (at_time(record, name, time) for name in ("point_position", "membrane_position"))
    senses = np.array([hinge.sense for hinge in record.structure.hinges])
    folds = senses * at_time(record, "hinge_angle", time)
    return surface_of(shape, np.concatenate(list(moved)), folds, two_sided=bool(record.structure.facets))


def surface_of(shape: Shape, places: Array, folds: Array, *, two_sided: bool) -> DrawnSurface:
    """Return the surface for given positions of points.

    Args:
        shape: drawn parts of a structure.
        places: positions of its points, then of the nodes of its membranes, m, (point, axis).
        folds: fold angles of its hinges, valleys positive, rad, (hinge,).
        two_sided: whether the faces have backs of another colour.
    """
    vertices = vertex_places(shape, places[shape.anchors])
    corners = np.array([(*face, face[-1])[:4] for face in shape.faces], dtype=np.int64).reshape(-1, 4)
    ends = [pair for line in shape.lines for pair in zip(line.path[:-1], line.path[1:], strict=True)]
    angles = np.append(folds, np.nan)
    groups = [-1 if bar.region is None else bar.region for bar in shape.bars]
    hinges = [-1 if line.hinge is None else line.hinge for line in shape.lines for _ in line.path[1:]]
    return DrawnSurface(
        faces=vertices[corners],
        regions=shape.face_region,
        two_sided=two_sided,
        bars=vertices[np.array([bar.ends for bar in shape.bars], dtype=np.int64).reshape(-1, 2)],
        radii=np.array([bar.radius for bar in shape.bars]),
        lines=vertices[np.array(ends, dtype=np.int64).reshape(-1, 2)],
        folds=angles[np.array(hinges, dtype=np.int64)],
        held=vertices[shape.held],
        tendons=vertices[np.array(shape.tendons, dtype=np.int64).reshape(-1, 2)],
        thickness=shape.thickness,
        span=shape.span,
        bar_regions=np.array(groups, dtype=np.int64) if shape.grouped else None,
    )


def face_strains(shape: Shape, surface: DrawnSurface) -> Array:
    """Return the largest principal Green strain of each face, 0 in the built shape, (face,).

    For a face of four corners, that of the more stretched of its two triangles.
    """
    corners = np.array([(*face, face[-1])[:4] for face in shape.faces], dtype=np.int64).reshape(-1, 4)
    both = [_largest_strains(shape.built[corners[:, half]], surface.faces[:, half]) for half in ([0, 1, 2], [0, 2, 3])]
    return np.asarray(np.fmax(*both))


def _largest_strains(built: Array, now: Array) -> Array:
    """Return the largest principal strains of triangles, (triangle, corner, axis); nan for triangles without area."""
    sides = built[:, 1:] - built[:, :1]
    metric = sides @ sides.swapaxes(1, 2)
    flat = np.linalg.det(metric) <= _FLAT * np.trace(metric, axis1=1, axis2=2) ** 2
    largest = np.full(len(built), np.nan)
    largest[~flat] = principal_strains(built[~flat], now[~flat])[:, 1]
    return largest


def at_time(record: Record, name: str, time: float) -> Array:
    """Return a series at a time (s), interpolated between samples, in SI, (...)."""
    values, times = record.series[name], record.time
    after = int(np.clip(np.searchsorted(times, time), 1, len(times) - 1)) if len(times) > 1 else 0
    before = max(after - 1, 0)
    gap = times[after] - times[before]
    share = float(np.clip((time - times[before]) / gap, 0, 1)) if gap > 0 else 1.0
    return np.asarray(values[before] + share * (values[after] - values[before]))

"""The drawn surface of a structure at a moment of a run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record
from forficula.show.structure.shape import Shape, vertex_places

_FLAT = 1e-9  # of a triangle's squared size: what has no area has no strain


@dataclass(frozen=True, kw_only=True)
class DrawnSurface:
    """A structure in space.

    Attributes:
        faces: of sheets and plates, m, (face, corner, axis); of three corners the last one stands twice.
        regions: number of each one's region, (face,).
        two_sided: whether their two sides are told apart.
        bars: ends of each, m, (bar, end, axis).
        radii: of these, m, (bar,).
        lines: ends of what folds and of what ends, m, (line, end, axis).
        folds: how far these are folded, valleys positive, rad, (line,); nan of those of which that is not shown.
        held: vertices that are held, m, (vertex, axis).
        tendons: ends of each, m, (tendon, end, axis).
        thickness: that lines are drawn by, m.
        span: a length of the size of the whole, m.
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


def surface_at(record: Record, shape: Shape, time: float) -> DrawnSurface:
    """Find the surface at a time.

    Args:
        record: what happened.
        shape: of its structure.
        time: s; between two samples positions are interpolated, outside of them it is as at the nearest.
    """
    moved = (at_time(record, name, time) for name in ("point_position", "membrane_position"))
    senses = np.array([hinge.sense for hinge in record.structure.hinges])
    folds = senses * at_time(record, "hinge_angle", time)
    return surface_of(shape, np.concatenate(list(moved)), folds, two_sided=bool(record.structure.facets))


def surface_of(shape: Shape, places: Array, folds: Array, *, two_sided: bool) -> DrawnSurface:
    """Lay the surface through points.

    Args:
        shape: of a structure.
        places: of its points, then of the nodes of its membranes, m, (point, axis).
        folds: how far its hinges are folded, valleys positive, rad, (hinge,).
        two_sided: whether the faces have backs.
    """
    vertices = vertex_places(shape, places[shape.anchors])
    corners = np.array([(*face, face[-1])[:4] for face in shape.faces], dtype=np.int64).reshape(-1, 4)
    ends = [pair for line in shape.lines for pair in zip(line.path[:-1], line.path[1:], strict=True)]
    angles = np.append(folds, np.nan)
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
    )


def face_strains(shape: Shape, surface: DrawnSurface) -> Array:
    """The largest principal strain of each face, Green's, 0 where it is as built, (face,).

    Of a face of four corners it is that of its two triangles which is stretched further: (l - 1) / 2 with l the larger
    eigenvalue of the metric of its sides by that of these as built.
    """
    corners = np.array([(*face, face[-1])[:4] for face in shape.faces], dtype=np.int64).reshape(-1, 4)
    both = [_largest_strains(shape.built[corners[:, half]], surface.faces[:, half]) for half in ([0, 1, 2], [0, 2, 3])]
    return np.asarray(np.fmax(*both))


def _largest_strains(built: Array, now: Array) -> Array:
    """Largest principal strains of triangles, (triangle, corner, axis); nan of those without an area."""
    before, after = (each[:, 1:] - each[:, :1] for each in (built, now))
    metric, stretched = (each @ each.swapaxes(1, 2) for each in (before, after))
    flat = np.linalg.det(metric) <= _FLAT * np.trace(metric, axis1=1, axis2=2) ** 2
    metric[flat] = np.eye(2)
    relative = np.linalg.solve(metric, stretched)
    half, product = np.trace(relative, axis1=1, axis2=2) / 2, np.linalg.det(relative)
    largest = half + np.sqrt(np.maximum(half**2 - product, 0.0))
    return np.where(flat, np.nan, (largest - 1) / 2)


def at_time(record: Record, name: str, time: float) -> Array:
    """A series at a time (s), interpolated between two samples, in SI, (...)."""
    values, times = record.series[name], record.time
    after = int(np.clip(np.searchsorted(times, time), 1, len(times) - 1)) if len(times) > 1 else 0
    before = max(after - 1, 0)
    gap = times[after] - times[before]
    share = float(np.clip((time - times[before]) / gap, 0, 1)) if gap > 0 else 1.0
    return np.asarray(values[before] + share * (values[after] - values[before]))

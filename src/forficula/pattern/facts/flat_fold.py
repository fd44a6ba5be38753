"""The flat-folded state of a sheet without thickness: positions, area and number of layers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, is_unfolded
from forficula.pattern.facts.flat_folding import flat_folding_faults
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.kinematics import folded_coordinates

# fold angles of a flat-folded sheet by letter; nan on borders and unassigned creases
_CLOSED = {"M": -np.pi, "V": np.pi, "F": 0.0}
_ROUNDING = 1e-4  # rad, of target angles that a drawing states as opacities of six digits
# samples of a facet, as shares of the way from its centre to its corners; of sheets with more facets, centres alone
_SAMPLES, _MOST_FACETS = (0.3, 0.6, 0.9), 400


@dataclass(frozen=True, kw_only=True, eq=False)
class FlatFold:
    """A sheet that is folded flat along all its mountains and valleys, without thickness.

    Attributes:
        places: positions of the vertices, m, (N, 3).
        area: area of the sheet, m^2: the sum of its facets.
        outline_area: area of the convex outline of the folded sheet, m^2.
        layers: largest number of facets on top of one another, at samples on all facets; in sheets of more than 400
            facets at their centres.
    """

    places: Array
    area: float
    outline_area: float
    layers: int


def flat_fold(pattern: CreasePattern) -> FlatFold | None:
    """Fold a sheet flat.

    Returns:
        None for a sheet that does not fold flat: it is folded as drawn, has no mountain or valley, has unassigned
        creases, violates a condition of flat folding at a vertex, or consists of several pieces. Whether layers collide
        is not checked.
    """
    if not is_unfolded(pattern) or not {"M", "V"} & set(pattern.edges_assignment) or flat_folding_faults(pattern):
        return None
    try:
        places = folded_coordinates(pattern, _closed_angles(pattern))
    except InputError:
        return None
    facets = [places[list(face), :2] for face in pattern.faces_vertices]
    normals = [polygon_normal(pattern.vertices_coords[list(face)]) for face in pattern.faces_vertices]
    area = float(np.linalg.norm(normals, axis=1).sum()) / 2
    try:
        outline = float(scipy.spatial.ConvexHull(places[:, :2]).volume)
    except scipy.spatial.QhullError:
        return None
    return FlatFold(places=places, area=area, outline_area=outline, layers=_layers(facets))


def _closed_angles(pattern: CreasePattern) -> Array:
    """Return the fold angles of the flat-folded sheet, rad, (edge,); both edges of a split fold share 180 deg."""
    return np.asarray(pattern.edges_share * [_CLOSED.get(letter, np.nan) for letter in pattern.edges_assignment])


def flat_fold_text(pattern: CreasePattern) -> list[str]:
    """Describe in a sentence the size of a flat-folded sheet; none for a sheet that does not fold flat."""
    fold = flat_fold(pattern)
    if fold is None:
        return []
    closed, targets = _closed_angles(pattern), pattern.edges_fold_angle
    partly = int((np.abs(targets) < np.abs(closed) - _ROUNDING).sum())
    beyond = f", beyond the target angles of {partly} creases, and" if partly else ""
    return [
        f"Folded flat{beyond} without thickness, it has an outline of {100 * fold.outline_area / fold.area:.3g} % of"
        f" its area (folding ratio {fold.area / fold.outline_area:.3g}) and up to {fold.layers} layers."
    ]


def _layers(facets: list[Array]) -> int:
    """Return the largest number of polygons, (corner, 2) each, that contain one of the samples on all polygons."""
    centres = [facet.mean(axis=0) for facet in facets]
    shares = _SAMPLES if len(facets) <= _MOST_FACETS else ()
    beside = [
        centre + share * (facet - centre) for facet, centre in zip(facets, centres, strict=True) for share in shares
    ]
    samples = np.concatenate([*beside, np.array(centres)])
    counts = np.zeros(len(samples), dtype=np.int64)
    for facet in facets:
        counts += _inside(facet, samples)
    return int(counts.max())


def _inside(polygon: Array, points: Array) -> Flags:
    """Return whether points lie inside a polygon: a ray to the right crosses its outline an odd number of times."""
    start, end = polygon, np.roll(polygon, -1, axis=0)
    x, y = points[:, 0, None], points[:, 1, None]
    between = (start[:, 1] > y) != (end[:, 1] > y)
    rise = np.where(start[:, 1] == end[:, 1], 1.0, end[:, 1] - start[:, 1])
    crossing = start[:, 0] + (y - start[:, 1]) / rise * (end[:, 0] - start[:, 0])
    return np.asarray((between & (x < crossing)).sum(axis=1) % 2 == 1)

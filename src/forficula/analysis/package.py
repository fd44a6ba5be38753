"""Packaged size of a structure: the smallest slab and box around a shape of a run, or around the flat-folded sheet."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.pattern import FlatFold, flat_fold
from forficula.serial import Metres, SquareMetres, Written
from forficula.statics.tree.pose import pose, tree_of
from forficula.structure import Structure, goal_coordinates, goal_of, state_of

_FLAT = 1e-9  # share of the size of a shape: thinner shapes have no volume
_ALIKE = 1e-9  # tolerance of unit vectors
_ROUNDING = 1e-9  # s, tolerance of times that are multiples of the timestep


@dataclass(frozen=True, kw_only=True)
class Package:
    """Packaged size of a shape. It is too small where panels pass through each other.

    Attributes:
        height: of the thinnest slab that contains the shape, m.
        width: of the narrowest strip in the plane of the slab, m.
        length: along that strip, m.
        area: of the convex outline, seen perpendicular to the slab, m^2.
        upwards: unit vector perpendicular to the slab, (3,).
        across: unit vector across the strip, (3,).
        area_ratio: area divided by the area at the start of the run.
    """

    height: Metres
    width: Metres
    length: Metres
    area: SquareMetres
    upwards: Annotated[Array, Written.NEVER]
    across: Annotated[Array, Written.NEVER]
    area_ratio: float = 1.0


@dataclass(frozen=True, kw_only=True)
class FlatPackage:
    """Size of a structure whose sheet is folded flat along all its creases, by geometry alone.

    The layers lie on top of one another without the space that folds of thick layers need, and no layer collides. Thick
    panels that fold flat (`Plate.solids`) have their exact size.

    Attributes:
        folding_ratio: area of the open sheet divided by the area of the convex outline of the folded one, with a margin
            of half the thickness of the thickest bar, plate or facet.
        layers: largest number of facets on top of one another.
        height: layers times that thickness, m.
    """

    folding_ratio: float
    layers: int
    height: Metres


def flat_package(structure: Structure) -> FlatPackage | None:
    """Compute the size of a structure whose sheet is folded flat; None without a sheet that folds flat."""
    pattern = structure.appearance.pattern
    fold = None if pattern is None else flat_fold(pattern)
    if pattern is None or fold is None:
        return None
    if any(plate.solids for plate in structure.plates):
        return _thick_package(structure, fold, pattern.edges_share)
    radius = _radius(structure)
    outline = package_of(fold.places, radius)
    return FlatPackage(folding_ratio=fold.area / outline.area, layers=fold.layers, height=2 * radius * fold.layers)


def _thick_package(structure: Structure, fold: FlatFold, shares: Array) -> FlatPackage | None:
    """Compute the size of thick panels that are folded flat; None if stops prevent it.

    Args:
        structure: with the panels.
        fold: flat-folded sheet without thickness.
        shares: parts of the angles of folds by which edges fold, (edge,).
    """
    closed = np.pi * shares[[hinge.edge for hinge in structure.hinges]]
    folds = np.array([hinge.assignment in ("M", "V") for hinge in structure.hinges])
    angles = np.where(folds, closed, [hinge.built for hinge in structure.hinges])
    if any(hinge.upper < angle for hinge, angle in zip(structure.hinges, closed, strict=True)):
        return None
    at = pose(tree_of(structure), angles[None])
    points = [structure.points[point] for plate in structure.plates for solid in plate.solids for point in solid]
    places = np.array([at.origins[0, point.body] + at.frames[0, point.body] @ point.place for point in points])
    package = package_of(places, 0.0)
    return FlatPackage(folding_ratio=fold.area / package.area, layers=fold.layers, height=package.height)


def package_of(places: Array, radius: float) -> Package:
    """Compute the packaged size of balls of one radius around positions, m, (place, 3).

    In the thinnest slab, a convex body touches one plane with a face, or both planes with an edge (Houle and Toussaint
    1988, doi 10.1109/34.6790), so these directions are tried. In the plane, the directions of the sides of the outline
    are tried for the same reason.
    """
    places = np.unique(places, axis=0)
    upwards = _thinnest(places)
    height = float(np.ptp(places @ upwards))
    plane = np.linalg.svd(upwards[None])[2][1:]
    outline = places @ plane.T
    hull = scipy.spatial.ConvexHull(outline)
    sides = np.diff(outline[[*hull.vertices, hull.vertices[0]]], axis=0)
    normals = np.column_stack([-sides[:, 1], sides[:, 0]]) / np.linalg.norm(sides, axis=1)[:, None]
    widths = np.ptp(outline @ normals.T, axis=0)
    narrow = normals[int(np.argmin(widths))]
    # Steiner: a margin adds its width along the outline and a full circle
    area = hull.volume + radius * float(np.linalg.norm(sides, axis=1).sum()) + np.pi * radius**2
    return Package(
        height=height + 2 * radius,
        width=float(widths.min()) + 2 * radius,
        length=float(np.ptp(outline @ np.array([-narrow[1], narrow[0]]))) + 2 * radius,
        area=float(area),
        upwards=upwards,
        across=narrow @ plane,
    )


def _thinnest(places: Array) -> Array:
    """Return the direction in which the extent of positions is least, (3,)."""
    centred = places - places.mean(axis=0)
    _, sizes, axes = np.linalg.svd(centred, full_matrices=False)
    if len(sizes) < 3 or sizes[2] <= _FLAT * sizes[0]:
        return np.asarray(axes[2])
    try:
        hull = scipy.spatial.ConvexHull(centred)
    except scipy.spatial.QhullError:
        return np.asarray(axes[2])
    pairs = np.unique(np.sort(hull.simplices[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0)
    edges = centred[pairs[:, 1]] - centred[pairs[:, 0]]
    edges = edges / np.linalg.norm(edges, axis=1)[:, None]
    one, other = np.triu_indices(len(edges), 1)
    crossed = np.cross(edges[one], edges[other])
    lengths = np.linalg.norm(crossed, axis=1)
    tried = np.concatenate([hull.equations[:, :3], crossed[lengths > _ALIKE] / lengths[lengths > _ALIKE, None]])
    corners = centred[hull.vertices]
    return np.asarray(tried[int(np.argmin(np.ptp(corners @ tried.T, axis=0)))])


def packages(record: Record) -> dict[str, tuple[float, Package]]:
    """Compute, for each named state that held, the time of its end, s, and the packaged size at that time.

    A run that diverged, and a structure on a line, have none. The balls have the radius of the thickest bar, or half
    the thickness of the thickest plate or facet.
    """
    structure, result = record.structure, dict[str, tuple[float, Package]]()
    named = [(end.end, name) for end, name in zip(record.stages, structure.stage_states, strict=False) if name]
    if record.diverged_at is not None or not named or not _not_collinear(_places(record, 0)):
        return result
    begin = open_package(record).area
    for time, name in named:
        row = min(int(np.searchsorted(record.time, time - _ROUNDING)), len(record.time) - 1)
        places = _places(record, row)
        if _not_collinear(places) and _holds(record, name, row):
            package = package_of(places, _radius(structure))
            result[name] = (float(record.time[row]), replace(package, area_ratio=package.area / begin))
    return result


def _holds(record: Record, name: str, row: int) -> bool:
    """Return whether a structure is in a state in a row of a record; true for a state without bounds."""
    state = state_of(record.structure, name)
    if state is None:
        return True
    distances = record.series.get("distance")
    values = goal_coordinates(
        record.structure, record.series["hinge_angle"][[row]], None if distances is None else distances[[row]]
    )[0]
    goal = goal_of(record.structure, state.goal)
    return bool(np.all((values >= goal.least) & (values <= goal.most)))


def open_package(record: Record) -> Package:
    """Compute the packaged size at the start of a run."""
    return package_of(_places(record, 0), _radius(record.structure))


def smallest_package(record: Record) -> tuple[str, float, Package] | None:
    """Return name, time, s, and packaged size of the state with the least area; None without states."""
    result = packages(record)
    if not result:
        return None
    name = min(result, key=lambda shape: result[shape][1].area)
    return (name, *result[name])


def _not_collinear(places: Array) -> bool:
    """Return whether positions do not all lie on a line."""
    sizes = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
    return len(sizes) > 1 and bool(sizes[1] > _FLAT * sizes[0])


def _radius(structure: Structure) -> float:
    """Return half the thickness of the thickest part whose points lie in its middle, m."""
    bars = [bar.diameter for bar in structure.bars]
    plates = [plate.thickness for plate in structure.plates if not plate.solids]
    return max([*bars, *plates, *(facet.thickness for facet in structure.facets)], default=0.0) / 2


def _places(record: Record, row: int) -> Array:
    """Return positions of the structure's points and membrane nodes in a row of a record, m, (place, 3)."""
    moving = [number for number, point in enumerate(record.structure.points) if point.role != "ground"]
    places = record.series["point_position"][row, moving]
    if "membrane_position" in record.series:
        places = np.concatenate([places, record.series["membrane_position"][row]])
    return np.asarray(places)

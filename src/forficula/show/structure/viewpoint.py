"""Viewpoints of structures in parallel projection, and the one from which several shapes are seen best."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.show.structure.raster import rasterise
from forficula.show.structure.surface import DrawnSurface

# direction to the eye, that of the first view of the pages (web/src/camera.js)
TOWARDS_EYE = (0.37, -0.695, 0.616)
_AROUND = 12  # number of directions around the structure that are compared
_ELEVATIONS = np.radians([-60.0, -30.0, 30.0, 47.0, 60.0])  # of the eye, for structures that nothing holds
_GRID = 48  # pixels across a picture in which visible faces are counted
# visible share of the faces and bars that another direction must gain over that of the pages
_GAIN = 0.14
_MOST_COMPARED = 8  # largest number of shapes that are compared


@dataclass(frozen=True, kw_only=True)
class Viewpoint:
    """Viewpoint of a structure, in parallel projection.

    Attributes:
        right: direction to the right of the picture, unit vector, (axis,).
        up: upward direction of the picture, unit vector, (axis,).
        towards: direction to the eye, unit vector, (axis,).
    """

    right: Array
    up: Array
    towards: Array

    def project(self, points: Array) -> Array:
        """Project points onto the picture, m, (..., 3) -> (..., 2)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


def page_view(turn: float = 0.0, elevation: float | None = None) -> Viewpoint:
    """Return the view obliquely from above with which the pages begin, turned about the vertical, rad.

    Args:
        turn: angle about the vertical, rad.
        elevation: of the eye, rad; that of the pages by default.
    """
    x, y, z = np.array(TOWARDS_EYE) / np.linalg.norm(TOWARDS_EYE)
    if elevation is not None:
        level = np.cos(elevation) / np.hypot(x, y)
        x, y, z = level * x, level * y, np.sin(elevation)
    cosine, sine = np.cos(turn), np.sin(turn)
    towards = np.array([cosine * x - sine * y, sine * x + cosine * y, z])
    right = np.cross([0.0, 0.0, 1.0], towards)
    right /= np.linalg.norm(right)
    return Viewpoint(right=right, up=np.cross(towards, right), towards=towards)


def readable_view(surfaces: Sequence[DrawnSurface], *, free: bool = False) -> Viewpoint:
    """Return the viewpoint that shows the worst visible of several shapes best.

    It is the view of the pages unless a view from another side shows considerably more.

    Args:
        surfaces: the shapes.
        free: whether nothing holds the structure. Its orientation is then arbitrary: the best of views from above and
            below is taken, and one that shows a part of every face is preferred.
    """
    compared = surfaces[:: -(-len(surfaces) // _MOST_COMPARED) or 1]
    turns = np.linspace(0, 2 * np.pi, _AROUND, endpoint=False)
    views = [page_view(turn, elevation) for elevation in (_ELEVATIONS if free else (None,)) for turn in turns]
    views.insert(0, page_view())
    shares = [min((_visible_share(surface, view, by_face=free) for surface in compared), default=0.0) for view in views]
    best = int(np.argmax(shares))
    return views[best] if free or shares[best] > shares[0] + _GAIN else views[0]


def _visible_share(surface: DrawnSurface, view: Viewpoint, *, by_face: bool = False) -> float:
    """Return the mean of the visible shares of faces and bars; foreshortened parts count less."""
    shares = []
    if len(surface.faces):
        shares.append(_visible_faces(surface.faces, view, by_face=by_face))
    if len(surface.bars):
        along = surface.bars[:, 1] - surface.bars[:, 0]
        lengths = np.maximum(np.linalg.norm(along, axis=1), 1e-300)
        shares.append(float(np.mean(np.linalg.norm(view.project(along), axis=1) / lengths)))
    return float(np.mean(shares)) if shares else 0.0


def _visible_faces(faces: Array, view: Viewpoint, *, by_face: bool) -> float:
    """Return the share of the area of faces, m, (face, 4, axis), that is visible in a picture.

    If `by_face`, return the mean over faces of the root of the share of each, which is larger if it is similar for all.
    """
    areas = np.linalg.norm(np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1]), axis=1) / 2
    placed = np.concatenate([view.project(faces), (faces @ view.towards)[..., np.newaxis]], axis=-1)
    low, high = placed[..., :2].min(axis=(0, 1)), placed[..., :2].max(axis=(0, 1))
    pixel = max(float((high - low).max()) / _GRID, 1e-300)
    triangles = ((placed - [*low, 0.0]) / [pixel, pixel, pixel])[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3)
    # the colour of a face is its number
    numbers = np.repeat(np.arange(len(faces)), 2)
    colours = np.column_stack([numbers % 256, numbers // 256 % 256, numbers // 65536]) / 255
    drawn = rasterise(triangles, colours, (_GRID, _GRID), samples=1).astype(np.int64)
    in_front = (drawn[..., 0] + 256 * drawn[..., 1] + 65536 * drawn[..., 2])[drawn[..., 3] > 0]
    visible = np.bincount(in_front, minlength=len(faces))[: len(faces)] * pixel**2
    if by_face:
        return float(np.mean(np.sqrt(visible / np.maximum(areas, pixel**2))))
    return float(visible.sum() / max(float(areas.sum()), 1e-300))

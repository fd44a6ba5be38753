"""Responses of a workbench about the fold of a structure: its picture, its fold path as it grows, and drags."""

from __future__ import annotations

from dataclasses import replace
from time import monotonic
from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.show.page.data.fold_view import fold_view
from forficula.show.page.data.live_data import read_aloud
from forficula.show.page.data.packing import packed
from forficula.show.page.data.shape_mesh import ShapeMesh, shape_mesh
from forficula.show.page.data.shown_path import shown_path
from forficula.show.page.live_page import live_page_data
from forficula.show.page.playback import Clip
from forficula.statics import DraggedPoint, DraggedShape, QuasiStaticPath, quasi_static_path, start_drag
from forficula.structure import GROUND, Structure, structure_of
from forficula.workbench.requests import DesignRequest, DragRequest, FoldRequest, Opened, requested_design
from forficula.workbench.worker import Report

_AS_BUILT = {"name": "as built", "start": 0.0, "end": 0.0, "driven": False}
_BETWEEN, _SPARING = 0.2, 4.0  # time between paths that are sent: at least, s, and as a multiple of the time for one


class FoldResponses:
    """Responses about folds; the last fold path is kept, because the next one and drags continue from it."""

    def __init__(self) -> None:
        self._design: DesignRequest | None = None
        self._path: QuasiStaticPath | None = None
        self._mesh: ShapeMesh | None = None
        self._drag: DraggedPoint | None = None
        self._dragged: DraggedShape | None = None

    def follow(self, request: FoldRequest, opened: Opened, report: Report) -> None:
        """Report the picture of a structure as built, then its fold path whenever the path has grown or is refined.

        The path is computed first around the shape that the page shows, if a path of a similar structure is known.

        Args:
            request: the design, and the position of the slider.
            opened: design with which the workbench was opened.
            report: receives parts of the result as data for JSON.

        Raises:
            InputError: the design cannot be read or built, or nothing folds it.
            StoppedError: the page sent a later request.
        """
        design = requested_design(request, opened)
        structure = structure_of(design)
        mesh = shape_mesh(structure)
        report({"picture": _built_view(structure, mesh, design.name)})
        share = request.share
        near = None if self._path is None or share is None else self._path.point(share)
        due = -np.inf

        def send(path: QuasiStaticPath) -> bool:
            nonlocal due
            began = monotonic()
            # the first points may have one position
            if path.complete or (began >= due and path.length > 0):
                self._path = _shown(path, share or 0.0)
                report({"path": _path_data(self._path, mesh)})
                # most of the time is for the computation
                due = monotonic() + max(_BETWEEN, _SPARING * (monotonic() - began))
            return True

        # until a part of the path is known, there is nothing to drag
        self._design = self._drag = None
        path = quasi_static_path(structure, near=near, follow=send)
        if self._path is None or not self._path.complete or self._path.structure is not structure:
            send(path)
        self._design, self._mesh = _design_of(request), mesh

    def drag(self, request: DragRequest) -> dict[str, Any]:
        """Return the equilibrium of a structure while a page drags a point, and the force, for JSON.

        Raises:
            InputError: the page shows no fold path of this structure, or the point cannot be dragged.
        """
        if self._path is None or self._mesh is None or self._design != _design_of(request):
            raise InputError("the fold path of this design is not computed yet; drag it once it is")
        anchors = self._mesh.anchors
        if unknown := [point for point in request.weights if point >= len(anchors)]:
            raise InputError(f"weights: need points from 0 to {len(anchors) - 1}, got {unknown[0]}")
        weights = {int(anchors[point]): weight for point, weight in request.weights.items()}
        if request.begins or self._drag is None or self._drag.places != weights:
            self._drag = start_drag(self._path.structure, weights, near=self._path.point(request.share or 0.0))
            self._dragged = None
        near = None if self._dragged is None else self._dragged.point
        self._dragged = self._drag.to(np.array(request.target), near)
        return {
            "points": packed(self._dragged.point.positions[anchors], "f4"),
            "reached": self._dragged.reached,
            "text": self._dragged.text,
        }


def _design_of(request: DesignRequest) -> DesignRequest:
    """Return only the design of a request."""
    return DesignRequest(design=request.design, files=request.files, unit=request.unit, settings=request.settings)


def _built_view(structure: Structure, mesh: ShapeMesh, name: str) -> dict[str, Any]:
    """Return a structure as built, as data for JSON: its shape, the names of its movable points, and its legend."""
    data = live_page_data(_built_clip(structure, mesh, name))
    points = [structure.points[anchor] if anchor < len(structure.points) else None for anchor in mesh.anchors.tolist()]
    data["points"] = [
        # nodes of membranes follow their bodies
        None if point is None or point.body == GROUND else read_aloud(point.name)
        for point in points
    ]
    return data | {"clips": [data["clips"][0] | {"stages": [_AS_BUILT]}]}


def _built_clip(structure: Structure, mesh: ShapeMesh, name: str) -> Clip:
    """Return a structure as built, as a clip of one frame."""
    tendons = len(structure.tendons)
    return Clip(
        name=name,
        structure=structure,
        time=np.zeros(1),
        points=mesh.built[None],
        mesh=mesh,
        marks=(),
        stages=(),
        readings=(),
        tendon_energy=np.zeros((1, tendons)),
        stored_energy={},
        largest_energy={},
        rest_length=np.array([[tendon.law.rest_length for tendon in structure.tendons]]).reshape(1, tendons),
    )


def _path_data(path: QuasiStaticPath, mesh: ShapeMesh) -> dict[str, Any]:
    """Return a path as data for JSON, without the mesh, which the picture has."""
    return fold_view(path, beside_run=True, mesh=mesh) | {"complete": path.complete, "reached": path.reached}


def _shown(path: QuasiStaticPath, share: float) -> QuasiStaticPath:
    """Return a path as the page shows it.

    Args:
        path: the path; while it grows, the shape from which it is computed keeps the position of the slider.
        share: position of the slider.

    Raises:
        InputError: nothing moves on the path.
    """
    whole, path = path, shown_path(path)
    if path.complete or whole.at is None:
        return path
    at = path.share[min(whole.index(whole.at), len(path.share) - 1)]

    def moved(shares: Array) -> Array:
        return np.asarray(np.interp(shares, [0.0, at, 1.0], [0.0, share, 1.0]))

    marks = []
    for mark in path.marks:
        begin, end = moved(np.array([mark.share, mark.end])).tolist()
        marks.append(replace(mark, share=begin, end=end))
    return replace(path, share=moved(path.share), marks=tuple(marks))

"""Responses of a workbench about the fold of a structure: its picture, its fold path as it grows, and drags along it."""

from __future__ import annotations

from dataclasses import replace
from time import monotonic
from typing import Any

import numpy as np

from forficula.errors import InputError
from forficula.show.page.data.fold_view import fold_view, shown_path
from forficula.show.page.data.shape_mesh import ShapeMesh, shape_mesh
from forficula.show.page.live_page import live_page_data
from forficula.show.page.playback import Clip
from forficula.statics import QuasiStaticPath, quasi_static_path
from forficula.structure import Structure, structure_of
from forficula.workbench.requests import DesignRequest, FoldRequest, Opened, requested_design
from forficula.workbench.worker import Report

_AS_BUILT = {"name": "as built", "start": 0.0, "end": 0.0, "driven": False}
_BETWEEN, _SPARING = 0.2, 4.0  # time between paths that are sent: at least, s, and as a multiple of the time for one


class FoldResponses:
    """Responses about folds; the last fold path is kept, because the next one continues from it."""

    def __init__(self) -> None:
        self._path: QuasiStaticPath | None = None

    def follow(self, request: FoldRequest, opened: Opened, report: Report) -> None:
        """Report the picture of a structure as built, then its fold path whenever the path has grown or is refined.

        The path is computed first around the shape that the page shows, if a path of a similar structure is known.

        Args:
            request: the design, and the position of the slider.
            opened: design with which the workbench was opened.
            report: receives parts of the result as data for JSON.

        Raises:
            InputError: the design cannot be read or built, or nothing drives its fold.
            StoppedError: the page sent a later request.
        """
        design = requested_design(request, opened)
        structure = structure_of(design)
        mesh = shape_mesh(structure)
        report({"picture": _built_view(structure, mesh, design.name)})
        near = None if self._path is None else self._path.point(request.share)
        due, latest = -np.inf, self._path

        def send(path: QuasiStaticPath) -> bool:
            nonlocal due, latest
            began = monotonic()
            if path.complete or began >= due:
                report({"path": _path_data(path, mesh, request.share)})
                latest = path
                # most of the time is for the computation
                due = monotonic() + max(_BETWEEN, _SPARING * (monotonic() - began))
            return True

        self._path = quasi_static_path(structure, near=near, follow=send)
        if latest is not self._path:
            send(self._path)

    def drag(self, request: DesignRequest, opened: Opened) -> dict[str, Any]:
        """Return the equilibrium of a structure of which a page drags a point, and the force, for JSON.

        Raises:
            InputError: the page shows no fold path of this structure, or the point cannot be dragged.
        """
        raise InputError("this structure cannot be dragged")


def _built_view(structure: Structure, mesh: ShapeMesh, name: str) -> dict[str, Any]:
    """Return a structure as built, as data for JSON: its shape and what a picture needs."""
    data = live_page_data(_built_clip(structure, mesh, name))
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


def _path_data(path: QuasiStaticPath, mesh: ShapeMesh, share: float) -> dict[str, Any]:
    """Return a path as data for JSON, without the mesh, which the picture has.

    Args:
        path: the path; while it grows, the shape from which it is computed keeps the position of the slider.
        mesh: mesh of the structure.
        share: position of the slider.
    """
    if not path.complete and path.at is not None:
        path = _placed(path, path.at, share)
    return fold_view(shown_path(path), beside_run=True, mesh=mesh) | {"complete": path.complete, "reached": path.reached}


def _placed(path: QuasiStaticPath, at: float, share: float) -> QuasiStaticPath:
    """Return a path on which one position is moved to another one, and all others in proportion."""

    def moved(shares: Any) -> Any:
        return np.interp(shares, [0.0, at, 1.0], [0.0, share, 1.0])

    marks = [replace(mark, share=float(moved(mark.share)), end=float(moved(mark.end))) for mark in path.marks]
    return replace(path, share=moved(path.share), marks=tuple(marks))

"""Quasi-static path that a page shows: up to its goal, and in as few shapes as look the same."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from forficula.arrays import Indices
from forficula.errors import InputError
from forficula.kept_frames import kept_frames
from forficula.show.page.data.shape_mesh import ShapeMesh
from forficula.statics import PathMark, QuasiStaticPath, quasi_static_path
from forficula.structure import Structure, goal_coordinates, goal_of, point_distances

# bytes of the positions, angles and moments of a path; as text in the page they grow by a third
BUDGET = 120_000
_TOLERANCE = 5e-4  # largest error of a structure drawn between two shapes, as a share of its span
_STILL = 1e-4  # share of the slider for all parts of a path without a motion
_CLOSED = np.radians(1)  # beyond 180 deg, panels of a closed crease pass through each other


@dataclass(frozen=True, kw_only=True)
class Fold:
    """Fold path of a page.

    Attributes:
        path: the path; None if it cannot be computed.
        missing: a sentence that says why there is no path; empty if there is one.
    """

    path: QuasiStaticPath | None
    missing: str = ""


def fold_of(structure: Structure) -> Fold:
    """Compute the quasi-static path of a structure for its page: that of the first transition that moves it."""
    reasons = list[str]()
    try:
        for name in tuple(transition.name for transition in structure.transitions) or (None,):
            try:
                return Fold(path=shown_path(quasi_static_path(structure, name, error=_TOLERANCE / 10)))
            except InputError as error:
                reasons.append(str(error))
        return Fold(path=None, missing=f"This page has no fold path: {reasons[0]}.")
    except (ArithmeticError, ValueError) as error:  # a page of a run must not be lost because its statics failed
        return Fold(path=None, missing=f"This page has no fold path, because its computation failed: {error}.")


def shown_path(path: QuasiStaticPath) -> QuasiStaticPath:
    """Return a path as a slider shows it: without panels that pass through each other, and with rising positions.

    Raises:
        InputError: nothing moves on the path.
    """
    if len(path.share) < 2 or path.length == 0:
        moves = f'the drive "{path.drive.name}" does not move the {path.structure.appearance.whole}'
        raise InputError("; ".join([moves, *path.remarks]))
    path = without_crossing(path)
    # a drive that grows without a motion takes a little of the slider, so that no two points have one position
    share = path.share + np.linspace(0.0, _STILL, len(path.share))
    return replace(path, share=share / share[-1])


def without_crossing(path: QuasiStaticPath) -> QuasiStaticPath:
    """Return a path up to its goal, or up to where panels have turned through each other if that comes first.

    A snap under a constant force may continue beyond the goal until panels pass through each other. A path on which no
    crease turns beyond 180 deg is returned as it is.
    """
    structure = path.structure
    creases = [number for number, hinge in enumerate(structure.hinges) if hinge.flaps is not None]
    crossed = np.flatnonzero(np.any(np.abs(path.angles[:, creases]) > np.pi + _CLOSED, axis=1))
    if not len(crossed):
        return path
    transition = next((item for item in structure.transitions if item.name == path.name), None)
    before = range(int(crossed[0]))
    at_goal = [] if transition is None else [row for row in before if is_within(path, row, transition.goal)]
    last = at_goal[0] if at_goal else int(crossed[0]) - 1
    if last < 1:
        return path
    whole = structure.appearance.whole
    where = "at the goal, because beyond it" if at_goal else "short of the goal, because from there on"
    remark = f"The path ends {where} panels of the {whole} pass through each other, which statics do not prevent."
    rows, end = slice(0, last + 1), float(path.share[last])
    kept = [mark for mark in path.marks if mark.share < end and mark.kind in ("snap", "branch", "contact")]
    marks = [
        replace(
            mark,
            share=mark.share / end,
            end=min(mark.end / end, 1.0),
            # the released energy is that of the whole snap
            text=mark.text if mark.end <= end else f"{mark.text.partition(';')[0]}.",
        )
        for mark in kept
    ]
    kind: Literal["goal", "lost"] = "goal" if at_goal else "lost"
    strength = float(path.strength[last])
    marks.append(PathMark(kind=kind, share=1.0, end=1.0, strength=strength, released=0.0, text=remark))
    return replace(
        path,
        share=path.share[rows] / end,
        strength=path.strength[rows],
        resting=path.resting[rows],
        angles=path.angles[rows],
        positions=path.positions[rows],
        coordinates=path.coordinates[rows],
        energy={name: values[rows] for name, values in path.energy.items()},
        force=path.force[rows],
        contacts={name: forces[rows] for name, forces in path.contacts.items()},
        memory=path.memory[:, rows],
        losses={name: energies[rows] for name, energies in path.losses.items()},
        length=path.length * end,
        marks=tuple(marks),
        reached=bool(at_goal),
    )


def is_within(path: QuasiStaticPath, row: int, name: str) -> bool:
    """Return whether a shape of a path is within the bounds of a goal, by name or as text."""
    structure = path.structure
    goal = goal_of(structure, name)
    read = goal_coordinates(structure, path.angles[row], point_distances(structure, path.positions[row]))
    return bool(np.all((read >= goal.least) & (read <= goal.most)))


def shown_rows(path: QuasiStaticPath, mesh: ShapeMesh, budget: int = BUDGET) -> Indices:
    """Choose the points of a path between which interpolation is exact enough; those at events are kept.

    Between them, positions are exact to `_TOLERANCE` of the span, energy and drive to this share of their ranges.
    """
    points = path.positions[:, mesh.anchors]
    events = [share for mark in path.marks for share in (mark.share, mark.end)]
    # of a point of the path: positions in 2 bytes, angles and moments in 2 or 4 bytes
    size = 2 * points[0].size + 12 * len(path.structure.hinges) + 4 * len(path.structure.tendons) + 8
    # energy and drive as coordinates of a further point, each over the span
    ends = np.stack([path.stored, path.strength, np.zeros(len(path.share))], axis=1)
    further = path.structure.span * ends / np.where(np.ptp(ends, axis=0) > 0, np.ptp(ends, axis=0), 1.0)
    tolerance = _TOLERANCE * path.structure.span
    drawn = np.concatenate([points, further[:, None]], axis=1)
    return kept_frames(path.share, drawn, events, most=max(budget // size, 2), tolerance=tolerance)

"""Quasi-static path of a structure as a view of its page: a clip over the fold, its plots, events and single creases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.kept_frames import kept_frames
from forficula.names import listed
from forficula.kept_frames import kept_frames
from forficula.quantities import reading_unit
from forficula.show.page.data.landscape_curves import tendon_energies
from forficula.show.page.data.packing import packed, packed_steps
from forficula.show.page.data.shape_mesh import ShapeMesh, shape_mesh
from forficula.show.page.data.time_spans import Span, span_data
from forficula.show.page.parts.efforts import effort_word
from forficula.show.page.parts.plots import Line, Plot, energy_plot, plot_data
from forficula.show.page.parts.run_sentences import reading_range, readable, shape_text
from forficula.show.page.playback import (
    Clip,
    Readings,
    clip_data,
    energy_scale,
    legend_data,
    readings_of,
    structure_noun,
)
from forficula.show.run.state_names import state_letters
from forficula.show.structure.labels import condensed, label_of, reading_labels, shown_angles
from forficula.statics import PathMark, QuasiStaticPath, quasi_static_path
from forficula.structure import (
    Measure,
    Structure,
    built_frames,
    built_points,
    distances_of,
    first_state,
    goal_coordinates,
    goal_of,
    hinge_groups,
    read_angles,
)

# bytes of the positions, angles and moments of a path; as text in the page they grow by a third
_BUDGET = 120_000
_TOLERANCE = 5e-4  # largest error of a structure drawn between two shapes, as a share of its span
_SECONDS = 6.0  # duration of a path that is played
_PERCENT = 100.0
_ROUNDING = 1e-9  # a moment below this share of the largest one is a rounding error
_STILL = 1e-4  # share of the slider for all parts of a path without a motion
_CLOSED = np.radians(1)  # beyond 180 deg, panels of a closed crease pass through each other
_SAME = 1e-6  # points closer than this share of the span count as one
_LETTERS = {"snap": "S", "branch": "B", "goal": "G", "lost": "L"}
# keys of a clip that do not depend on the motion, which the page takes from the clip of a run
_MESH = (
    *("span_m", "pointCount", "between", "share", "triangles", "regions", "solid", "tubes", "built", "faces", "base"),
    *("joints", "jointRadius"),
)


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
    """Compute the quasi-static path of a structure for its page."""
    try:
        return Fold(path=shown_path(quasi_static_path(structure, error=_TOLERANCE / 10)))
    except InputError as error:
        return Fold(path=None, missing=f"This page has no fold path: {error}.")


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
    at_goal = [row for row in range(int(crossed[0])) if _reaches(path, row)]
    last = at_goal[0] if at_goal else int(crossed[0]) - 1
    if last < 1:
        return path
    whole = structure.appearance.whole
    where = "at the goal, because beyond it" if at_goal else "short of the goal, because from there on"
    remark = f"The path ends {where} panels of the {whole} pass through each other, which statics do not prevent."
    rows, end = slice(0, last + 1), float(path.share[last])
    kept = [mark for mark in path.marks if mark.share < end and mark.kind in ("snap", "branch")]
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
        length=path.length * end,
        marks=tuple(marks),
        reached=bool(at_goal),
    )


def _reaches(path: QuasiStaticPath, row: int) -> bool:
    """Return whether a shape of a path is within the goal of the path's transition."""
    structure = path.structure
    transition = next((item for item in structure.transitions if item.name == path.name), None)
    if transition is None:
        return False
    goal = goal_of(structure, transition.goal)
    pairs = [list(measure.points) for measure in distances_of(structure) if measure.points is not None]
    distances = np.array([np.linalg.norm(path.positions[row, one] - path.positions[row, other]) for one, other in pairs])
    read = goal_coordinates(structure, path.angles[row], distances)
    return bool(np.all((read >= goal.least) & (read <= goal.most)))


def fold_view(
    path: QuasiStaticPath, *, beside_run: bool, budget: int = _BUDGET, mesh: ShapeMesh | None = None
) -> dict[str, Any]:
    """Return a path as data for JSON: a view that a page shows alone, or as an alternative to a run.

    Args:
        path: path of the structure.
        beside_run: whether the page has a run of the same structure, from which it takes the mesh.
        budget: largest number of bytes for positions, angles and moments.
        mesh: mesh of the structure, if it is known.
    """
    mesh = shape_mesh(path.structure) if mesh is None else mesh
    rows = shown_rows(path, mesh, budget)
    clip = path_clip(path, mesh, rows)
    along = [("energy", path.stored[rows], "J")] * bool(path.energy)
    along.append((effort_word(path.structure, path.drive), path.strength[rows], path.unit))
    view = pose_view(
        clip,
        path.angles[rows],
        path.moments[rows],
        along,
        name="fold",
        title="slowly along its quasi-static path",
        notes=_notes(path),
        plots=_plots(path, clip, rows),
        beside_run=beside_run,
    )
    view["clips"][0] |= {"marks": _marks(path), "stages": _stages(path)}
    return view


def pose_view(
    clip: Clip,
    angles: Array,
    moments: Array,
    along: Sequence[tuple[str, Array, str]],
    *,
    name: str,
    title: str,
    notes: Sequence[str],
    plots: Sequence[dict[str, Any]],
    beside_run: bool,
) -> dict[str, Any]:
    """Return poses of a structure as data for JSON: a view through which a slider from 0 to 100 % moves.

    Args:
        clip: clip whose times are positions of the slider, %.
        angles: of all hinges, in their own senses, rad, (pose, hinge).
        moments: of their springs, N m, (pose, hinge).
        along: names, values and SI units of numbers beside the slider.
        name: name of the view and of the slider.
        title: phrase on how the structure moves.
        notes: sentences below the picture.
        plots: plots over the slider, from `plot_data`.
        beside_run: whether the page has a run of the same structure, from which it takes the mesh.
    """
    data = clip_data(clip) | {
        "points": packed_steps(clip.points.reshape(len(clip.time), -1)),
        "stages": [{"name": "", "start": 0.0, "end": _PERCENT, "driven": False}],
        "along": [_along_data(*numbers) for numbers in along],
        "creases": _creases(clip.structure, clip.mesh, angles, moments),
    }
    span = Span(name=name, label=name, start=0.0, end=_PERCENT, origins=(0.0,))
    return {
        "name": name,
        "title": title,
        "whole": structure_noun([clip]),
        "clips": [{key: value for key, value in data.items() if not (beside_run and key in _MESH)}],
        "spans": [span_data(span) | {"unit": "%", "seconds": _SECONDS}],
        "plots": list(plots),
        "energy": energy_scale([clip]),
        "legend": legend_data([clip]),
        "text": f"{shape_text(clip.structure)}, moved {title}.",
        "notes": list(notes),
    }


def shown_rows(path: QuasiStaticPath, mesh: ShapeMesh, budget: int = _BUDGET) -> Indices:
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


def path_clip(path: QuasiStaticPath, mesh: ShapeMesh, rows: Indices) -> Clip:
    """Return some points of a path as a clip, with the moments of springs among its readings."""
    energy = {name: values[rows] for name, values in path.energy.items()}
    clip = posed_clip(path.structure, mesh, path.share[rows], path.positions[rows], path.angles[rows], energy)
    return replace(clip, readings=(*clip.readings, *_moments(path, rows)))


def posed_clip(
    structure: Structure, mesh: ShapeMesh, share: Array, positions: Array, angles: Array, energy: Mapping[str, Array]
) -> Clip:
    """Return poses as a clip whose times are positions of a slider, %.

    Args:
        structure: the structure.
        mesh: its mesh.
        share: position of each pose, from 0 to 1, (pose,).
        positions: of points, then of the nodes of membranes, m, (pose, place, 3).
        angles: of all hinges, in their own senses, rad, (pose, hinge).
        energy: stored energy by part, J, (pose,) each.
    """

    def measured(measure: Measure) -> Array:
        if measure.points is None:
            return read_angles(measure, angles)
        one, other = measure.points
        return np.asarray(np.linalg.norm(positions[:, [other]] - positions[:, [one]], axis=2))

    return Clip(
        name=structure.name,
        structure=structure,
        time=_PERCENT * share,
        points=positions[:, mesh.anchors],
        mesh=mesh,
        marks=(),
        stages=(),
        readings=tuple(readings_of(structure, measured)),
        tendon_energy=tendon_energies(structure, positions),
        stored_energy=energy,
        largest_energy={name: float(values.max(initial=0.0)) for name, values in energy.items()},
        rest_length=np.array([[tendon.law.rest_length for tendon in structure.tendons]]),
    )


def _signs(structure: Structure) -> Array:
    """Return the factors from the angles of hinges in their own senses to those that tables show, (hinge,)."""
    signs = np.ones(len(structure.hinges))
    for measure in shown_angles(structure):
        signs[list(measure.hinges)] = measure.signs
    return signs


def _sprung(structure: Structure, moments: Array) -> list[int]:
    """Return the hinges with a moment, N m, (pose, hinge), without the bends of facets."""
    bends = hinge_groups(structure).get("facet bends", ())
    return [hinge for hinge in np.flatnonzero(np.any(moments != 0, axis=0)).tolist() if hinge not in bends]


def _moments(path: QuasiStaticPath, rows: Indices) -> list[Readings]:
    """Return the moments of springs in hinges and creases as readings; none if no hinge has one."""
    structure, hinges = path.structure, _sprung(path.structure, path.moments)
    if not hinges:
        return []
    signs = tuple(_signs(structure)[hinges].astype(int).tolist())
    measure = Measure(name="moment of springs", kind="angle", hinges=tuple(hinges), signs=signs, label="moment")
    values = condensed(structure, measure, read_angles(measure, path.moments[rows]))
    largest = float(np.abs(values).max())
    values = np.where(np.abs(values) > _ROUNDING * largest, values, 0.0)
    unit, factor = reading_unit("N m", largest)
    creases = all(structure.hinges[hinge].flaps is not None for hinge in hinges)
    return [
        Readings(
            measure=measure,
            title=f"moment of the springs in {'creases' if creases else 'hinges'}",
            row=f"moment ({unit})",
            unit=unit,
            factor=factor,
            labels=tuple(reading_labels(structure, measure)),
            values=values,
        )
    ]


def _marks(path: QuasiStaticPath) -> list[dict[str, Any]]:
    """Return the start and the events of a path as marks on the slider and in plots."""
    structure = path.structure
    start = first_state(structure, [state.name for state in structure.states])
    marks = [{"letter": state_letters(structure)[start], "name": start, "time": 0.0}] if start else []
    numbers = dict.fromkeys(_LETTERS, 0)
    for mark in path.marks:
        numbers[mark.kind] += 1
        name = mark.kind if numbers[mark.kind] == 1 else f"{mark.kind} {numbers[mark.kind]}"
        marks.append({"letter": _LETTERS[mark.kind], "name": name, "time": _PERCENT * mark.share})
    return [mark | {"readings": {}, "tendonEnergy_J": None} for mark in marks]


def _stages(path: QuasiStaticPath) -> list[dict[str, Any]]:
    """Return the parts of a path between snaps, and the snaps, which are shaded."""
    stages, before = [], 0.0
    for mark in path.marks:
        if mark.kind == "snap":
            stages += [(before, mark.share, False), (mark.share, mark.end, True)]
            before = mark.end
    stages.append((before, 1.0, False))
    return [
        {"name": "snap" if snaps else "at rest", "start": _PERCENT * start, "end": _PERCENT * end, "driven": snaps}
        for start, end, snaps in stages
    ]


def _along_data(name: str, values: Array, si: str) -> dict[str, Any]:
    """Return numbers beside the slider in a legible unit."""
    unit, factor = reading_unit(si, float(np.abs(values).max(initial=0.0)))
    return {"name": name, "unit": unit, "values": packed(factor * values, "f4")}


def _plots(path: QuasiStaticPath, clip: Clip, rows: Indices) -> list[dict[str, Any]]:
    """Return the plots of a path over the fold: energies, drive, readings and strains; the first two have a ball."""
    balls = [*energies_plot(clip), _drive_plot(path, rows)]
    others = [reading_plot(readings, number) for number, readings in enumerate(clip.readings)]
    others += _strain_plot(path, rows)
    data = plot_data([*balls, *others])
    return [plot | {"ball": 0} for plot in data[: len(balls)]] + data[len(balls) :]


def energies_plot(clip: Clip) -> list[Plot]:
    """Return the plot of the stored energies of a clip: their sum first, if there are several; none without energy."""
    if not clip.stored_energy:
        return []
    parts = [(name, 0, values) for name, values in clip.stored_energy.items()]
    total = [("total", 0, np.sum([values for *_, values in parts], axis=0))] if len(parts) > 1 else []
    most = ", ".join(f"{name} {readable(value, 'J')}" for name, value in clip.largest_energy.items())
    return [energy_plot("energy", [*total, *parts], f"Stored energy along the path. Largest values: {most}.")]


def _drive_plot(path: QuasiStaticPath, rows: Indices) -> Plot:
    """Return the strength of the drive; of a displacement, its force."""
    forced = bool(np.any(path.force))
    word = "force" if forced else effort_word(path.structure, path.drive)
    values, si = (path.force, "N") if forced else (path.strength, path.unit)
    unit, factor = reading_unit(si, float(np.abs(values).max(initial=0.0)))
    largest = readable(float(values[np.argmax(np.abs(values))]), si)
    return Plot(
        title=f'{word} of the drive "{path.drive.name}"',
        unit=unit,
        lines=(Line(name=path.drive.name, clip=0, values=factor * values[rows]),),
        text=f"{word.capitalize()} at which the {path.structure.appearance.whole} is at rest; largest value {largest}.",
    )


def reading_plot(readings: Readings, number: int) -> Plot:
    """Return the plot of one measure over the fold."""
    first, last = (reading_range(readings.factor * readings.values[row], readings.unit) for row in (0, -1))
    title = readings.title
    return Plot(
        title=title,
        unit=readings.unit,
        lines=tuple(
            Line(name=label, clip=0, values=(readings.measure.name, index)) for index, label in enumerate(readings.labels)
        ),
        text=f"{title[:1].upper()}{title[1:]} along the path: {first} at the start, {last} at the end.",
    )


def _strain_plot(path: QuasiStaticPath, rows: Indices) -> list[Plot]:
    """Return the largest strain of each kind of elastic part, %."""
    lines, texts = [], []
    for name, strains in path.strains.items():
        sizes = np.abs(strains[:, np.isfinite(strains).all(axis=0)])
        if sizes.shape[1]:
            largest = _PERCENT * sizes.max(axis=1)
            lines.append(Line(name=name, clip=0, values=largest[rows]))
            texts.append(f"{name} {largest.max():.3g} %".replace("-", "−"))
    text = f"Largest strain of any part at every position. Largest values: {', '.join(texts)}."
    return [Plot(title="largest strain", unit="%", lines=tuple(lines), text=text)] if lines else []


def _creases(structure: Structure, mesh: ShapeMesh, angles: Array, moments: Array) -> dict[str, Any] | None:
    """Return the lines of hinges in the picture, with their angles and moments; None if no line shows a hinge."""
    signs, sprung = _signs(structure), set(_sprung(structure, moments))
    hinges_at = _hinges_by_line(structure, mesh)
    if not hinges_at:
        return None
    unit, factor = reading_unit("N m", float(np.abs(moments).max(initial=0.0)))
    labels = [label_of(structure.hinges[hinges[0]]) for hinges in hinges_at.values()]
    lines, columns, values = [], list[dict[str, str]](), list[Array]()
    for (ends, hinges), label in zip(hinges_at.items(), labels, strict=True):
        first = len(columns)
        roles = [structure.hinges[hinge].role for hinge in hinges]
        for hinge, role in zip(hinges, roles, strict=True):
            columns.append({"name": role if len(hinges) > 1 else "angle", "unit": "°"})
            values.append(np.degrees(signs[hinge] * angles[:, hinge]))
            if hinge in sprung:
                columns.append({"name": "moment" if len(hinges) == 1 else f"moment of {role}", "unit": unit})
                values.append(factor * signs[hinge] * moments[:, hinge])
        name = label if labels.count(label) == 1 else f"{label}, {listed(roles)}"
        lines.append({"name": name, "ends": list(ends), "columns": list(range(first, len(columns)))})
    kind = "crease" if all(hinge.flaps is not None for hinge in structure.hinges) else "hinge"
    return {"kind": kind, "lines": lines, "columns": columns, "values": packed_steps(np.stack(values, axis=1))}


def _hinges_by_line(structure: Structure, mesh: ShapeMesh) -> dict[tuple[int, int], list[int]]:
    """Return the hinges whose angle a line in the picture shows, by the line's two vertices.

    The line of a crease is the crease, that of a joint is the bar of its body or the side of its body's plate that lies
    on its axis. Bends of facets are not drawn.
    """
    at_point = {
        int(mesh.anchors[first]): vertex
        for vertex, ((first, _), share) in enumerate(zip(mesh.between.tolist(), mesh.share.tolist(), strict=True))
        if share == 0
    }
    bends = hinge_groups(structure).get("facet bends", ())
    result: dict[tuple[int, int], list[int]] = {}
    for hinge in range(len(structure.hinges)):
        points = None if hinge in bends else _line_points(structure, hinge)
        if points is not None and all(point in at_point for point in points):
            result.setdefault((at_point[points[0]], at_point[points[1]]), []).append(hinge)
    return result


def _line_points(structure: Structure, number: int) -> tuple[int, int] | None:
    """Return the two points of a hinge's line; None if it has none."""
    hinge = structure.hinges[number]
    if hinge.flaps is not None:
        return hinge.flaps[0], hinge.flaps[1]
    for bar in structure.bars:
        if bar.body == hinge.body:
            return bar.points
    origins, frames = built_frames(structure)
    axis = frames[hinge.body] @ hinge.axis
    for plate in structure.plates:
        if plate.body == hinge.body:
            away = built_points(structure)[list(plate.points)] - origins[hinge.body]
            along = away @ axis
            on_axis = np.linalg.norm(away - along[:, None] * axis, axis=1) <= _SAME * structure.span
            if on_axis.sum() >= 2:
                corners = np.flatnonzero(on_axis)
                ends = corners[[np.argmin(along[corners]), np.argmax(along[corners])]]
                return plate.points[ends[0]], plate.points[ends[1]]
    return None


def _notes(path: QuasiStaticPath) -> list[str]:
    """Return sentences on how the path was computed, on its events and on its limits."""
    whole, word = path.structure.appearance.whole, effort_word(path.structure, path.drive)
    first = (
        f'The {word} of the drive "{path.drive.name}" grows so slowly that the {whole} is at rest at every position'
        " outside snaps. Statics compute the shapes, without inertia, damping and contact between bodies."
    )
    return [first, *(mark.text for mark in path.marks), *path.remarks]

"""Runs as clips: the data that a page needs to play back a run."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from forficula.analysis import Outcome, State
from forficula.arrays import Array, Flags, Indices
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.kept_frames import kept_frames
from forficula.quantities import reading_unit
from forficula.show.page.data.packing import packed
from forficula.show.page.data.shape_mesh import ShapeMesh, Tube, moving_points, shape_mesh
from forficula.show.page.parts.efforts import Efforts, efforts_data, efforts_of
from forficula.show.run.energies_figure import largest_energies, stored_energies
from forficula.show.run.state_names import state_letters, table_name
from forficula.show.structure.labels import (
    aligned,
    condensed,
    driven_angles,
    label_of,
    parts_of,
    reading_labels,
    shown_angles,
    shown_distances,
    title_of,
)
from forficula.structure import Measure, Structure

# bytes of one clip; as text in the page they grow by a third
BUDGET = 2_500_000
_SERIES = 5  # numbers of a frame besides positions and readings: stored energies
# names of energies in plots where they differ from those in figures
_STORED = {"gravitational": "weight"}
# largest error of a structure drawn between two frames: m, and as a share of its span
_TOLERANCE, _RELATIVE_TOLERANCE = 5e-7, 1e-5


@dataclass(frozen=True, kw_only=True)
class StateMark:
    """State on the time line.

    Attributes:
        letter: a, b or c, the letters of Binder et al. 2025.
        name: name of the state, such as "folded", or "after folding" if the run did not reach it.
        state: means over the last part of its stage, whose end is the time of the mark.
    """

    letter: str
    name: str
    state: State

    @property
    def time(self) -> float:
        """End of the state's stage, s."""
        return self.state.time


@dataclass(frozen=True, kw_only=True)
class Readings:
    """Angles or distances over the frames of a clip.

    Attributes:
        measure: the measure.
        title: heading of its plot.
        row: name of its row in a table.
        unit: unit that the page shows.
        factor: factor from rad or m to that unit.
        labels: names of the readings, (reading,).
        values: readings, rad or m, (time, reading).
    """

    measure: Measure
    title: str
    row: str
    unit: str
    factor: float
    labels: tuple[str, ...]
    values: Array


@dataclass(frozen=True, kw_only=True)
class Clip:
    """Run that can be played back.

    Attributes:
        name: name of the run on the page.
        structure: structure that moves.
        time: times of the frames, s, (time,).
        points: points of the mesh, m, (time, point, 3).
        mesh: surfaces and lines between the points.
        marks: states that the run reached.
        stages: stages of the protocol that took place.
        readings: measures, then the driven angles that are not measured.
        tendon_energy: energies of the tendons, J, (time, tendon).
        stored_energy: stored energy by name (tendons, membrane, ...), J, (time,).
        largest_energy: maximum of each stored energy over the whole run, J; that of the kinetic one may lie between
            frames.
        rest_length: rest lengths of the tendons, m, (time, tendon), or (1, tendon) if no tendon yields.
        efforts: actions of the drives.
    """

    name: str
    structure: Structure
    time: Array
    points: Array
    mesh: ShapeMesh
    marks: tuple[StateMark, ...]
    stages: tuple[StageEnd, ...]
    readings: tuple[Readings, ...]
    tendon_energy: Array
    stored_energy: Mapping[str, Array]
    largest_energy: Mapping[str, float]
    rest_length: Array
    efforts: Efforts | None = None


def make_clip(record: Record, outcome: Outcome, *, name: str = "", budget: int = BUDGET) -> Clip:
    """Convert a run to a clip.

    Rows of the record are left out where interpolation between their neighbours is within 0.5 µm of them (1e-5 of the
    span for structures smaller than 5 cm), so that a structure at rest takes few rows. If the budget allows fewer
    rows, those with the most uneven motion are kept; rows at states and at the ends of stages are
    always kept.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        name: name on the page; the design's name if empty.
        budget: largest number of bytes for positions, angles and energies.
    """
    structure = record.structure
    mesh = shape_mesh(structure)
    points = moving_points(record, mesh)
    readings = readings_of(structure, lambda measure: record.measured(measure.name))
    points[diverged_rows(record)] = np.nan
    marks = state_marks(structure, outcome)
    moments = [mark.time for mark in marks]
    for end in record.stages:
        moments += [end.start, end.end, *([] if end.goal_time is None else [end.goal_time])]
    tolerance = min(_TOLERANCE, _RELATIVE_TOLERANCE * structure.span)
    read = sum(reading.values.shape[1] for reading in readings) + len(structure.tendons)
    bytes_per_frame = 8 + 4 * (points[0].size + read + _SERIES)
    most = max(budget // bytes_per_frame, 2)
    rows = kept_frames(record.time, points, moments, most=most, tolerance=tolerance)
    shown_until = record.time[rows[-1]]
    return Clip(
        name=name or record.design.name,
        structure=structure,
        time=record.time[rows],
        points=points[rows],
        mesh=mesh,
        marks=tuple(mark for mark in marks if mark.time <= shown_until),
        stages=tuple(end for end in record.stages if end.start <= shown_until),
        readings=tuple(replace(reading, values=reading.values[rows]) for reading in readings),
        tendon_energy=record.series["tendon_energy"][rows],
        stored_energy={_STORED.get(name, name): values[rows] for name, (values, _) in stored_energies(record).items()},
        largest_energy={_STORED.get(name, name): value for name, value in largest_energies(record).items()},
        rest_length=_rest_lengths(record, rows),
        efforts=efforts_of(record, rows),
    )


def _rest_lengths(record: Record, rows: Indices) -> Array:
    """Return lengths below which tendons are slack, m, (time, tendon), or (1, tendon) if no tendon yields."""
    if (grown := record.series.get("tendon_rest_length")) is not None:
        return grown[rows]
    return np.array([[tendon.law.rest_length for tendon in record.structure.tendons]])


def state_marks(structure: Structure, outcome: Outcome) -> tuple[StateMark, ...]:
    """Return the marks of the states on the time line."""
    letters = state_letters(structure)
    return tuple(
        StateMark(letter=letters[state.name], name=table_name(state, outcome), state=reached)
        for state in structure.states
        if (reached := outcome.states[state.name]) is not None
    )


def diverged_rows(record: Record) -> Flags:
    """Return which rows of a diverged run are meaningless, (time,): from a full turn of a hinge beyond its stops on."""
    if record.diverged_at is None:
        return np.zeros(len(record.time), dtype=np.bool_)
    angles = np.abs(record.series["hinge_angle"])
    stopped = [np.isfinite(hinge.lower) or np.isfinite(hinge.upper) for hinge in record.structure.hinges]
    most = np.where(stopped, 2 * np.pi, np.inf)
    # nan exceeds every limit, and inf exceeds the limit of a hinge without stops
    return np.logical_or.accumulate(~((angles <= most) & np.isfinite(angles)).all(axis=1))


def mark_readings(clip: Clip, readings: Readings, mark: StateMark) -> tuple[Array, Array | None]:
    """Return the readings in a state: means, and half the ranges if the state has them, rad or m, (reading,)."""
    measured = mark.state.readings.get(readings.measure.name)
    if measured is not None:
        mean, low, high = (
            condensed(clip.structure, readings.measure, item) for item in (measured.mean, measured.low, measured.high)
        )
        return mean, (high - low) / 2
    # the outcome has no means of driven angles
    return readings.values[np.argmin(np.abs(clip.time - mark.time))], None


def clip_data(clip: Clip) -> dict[str, Any]:
    """Return a clip as data for JSON: lists and texts, long arrays packed by `packed`."""
    mesh, (heading, names, places) = clip.mesh, _columns(clip)
    return {
        "name": clip.name,
        "span_m": clip.structure.span,
        **_surroundings_data(clip.structure),
        "time": packed(clip.time, "f8"),
        "points": packed(clip.points, "f4"),
        "pointCount": len(mesh.anchors),
        "between": mesh.between.ravel().tolist(),
        "share": mesh.share.tolist(),
        "triangles": mesh.triangles.ravel().tolist(),
        "regions": mesh.regions.tolist(),
        "solid": list(mesh.solid),
        "tubes": [_tube_data(tube) for tube in mesh.tubes],
        "built": packed(mesh.built, "f4") if clip.structure.membranes else None,
        "faces": mesh.faces.tolist() if clip.structure.membranes else None,
        "membraneLaw": _law_data(clip.structure),
        "base": {"rods": mesh.base.tolist(), "radius": mesh.base_radius},
        "efforts": None if clip.efforts is None else efforts_data(clip.efforts, mesh.anchors),
        "restLength_m": packed(clip.rest_length, "f4"),
        "joints": mesh.joints.tolist(),
        "jointRadius": mesh.joint_radius,
        "marks": [_mark_data(clip, mark) for mark in clip.marks],
        "stages": [
            {"name": end.stage.name, "start": end.start, "end": end.end, "driven": bool(stage_drives(end.stage))}
            for end in clip.stages
        ],
        "parts": {"heading": heading, "names": list(names)},
        "readings": [
            {
                "name": reading.measure.name,
                "label": title_of(reading.measure),
                "row": reading.row,
                "unit": reading.unit,
                "parts": place,
                "values": packed(reading.factor * reading.values, "f4"),
            }
            for reading, place in zip(clip.readings, places, strict=False)
        ],
        "tendonParts": places[-1],
        "tendonEnergy_J": packed(clip.tendon_energy, "f4"),
    }


def _tube_data(tube: Tube) -> dict[str, Any]:
    data = {"kind": tube.kind, "crease": tube.crease, "ends": tube.ends, "radius": tube.radius}
    return data if tube.region is None else data | {"region": tube.region}


def _law_data(structure: Structure) -> dict[str, float | str] | None:
    """Return the law of the membranes, from which the page computes stresses as `principal_stresses` does."""
    if not structure.membranes:
        return None
    # the engine has one law for all membranes
    law = structure.membranes[0].law
    return {"youngs_modulus_Pa": law.youngs_modulus, "poisson_ratio": law.poisson_ratio, "unit": "Pa"}


def readings_of(structure: Structure, measured: Callable[[Measure], Array]) -> list[Readings]:
    """Return the readings of the measures and of the driven angles that are not measured.

    Args:
        structure: the structure.
        measured: function that returns the readings of a measure over the frames, rad or m, (time, reading).
    """
    titles, angles = structure.appearance.titles, shown_angles(structure)
    driven = driven_angles(structure, angles)
    readings = []
    for measure in (*angles, *shown_distances(structure), *driven):
        values = measured(measure)
        unit, factor = "deg", float(np.degrees(1.0))
        if measure.kind == "distance":
            unit, factor = reading_unit("m", float(np.nanmax(np.abs(values), initial=0.0)) or structure.span)
        row = measure.name if measure in driven else title_of(measure)
        readings.append(
            Readings(
                measure=measure,
                title=titles.get(measure.name, title_of(measure)),
                row=f"{row} ({unit})",
                unit=unit,
                factor=factor,
                labels=tuple(reading_labels(structure, measure)),
                values=condensed(structure, measure, values),
            )
        )
    return readings


def _columns(clip: Clip) -> tuple[str, tuple[str, ...], list[list[int]]]:
    """Return the columns of a table of all readings and energies by hinge and tendon.

    Returns:
        The word with which all names begin, or ""; the names; and the column indices of each reading's numbers, then
        of the tendons'.
    """
    rows = [list(reading.labels) for reading in clip.readings] + [
        [label_of(tendon) for tendon in clip.structure.tendons]
    ]
    columns, places = aligned(rows)
    parts = parts_of(columns)
    return parts.heading, parts.names, places


def _mark_data(clip: Clip, mark: StateMark) -> dict[str, Any]:
    """Return a state as data for JSON, with the numbers of the summary."""
    states = {}
    for reading in clip.readings:
        mean, swing = mark_readings(clip, reading, mark)
        if swing is not None:
            states[reading.measure.name] = {
                "mean": (reading.factor * mean).tolist(),
                "swing": (reading.factor * swing).tolist(),
            }
    return {
        "letter": mark.letter,
        "name": mark.name,
        "time": mark.time,
        "readings": states,
        "tendonEnergy_J": mark.state.tendon_energy.tolist(),
    }


def _surroundings_data(structure: Structure) -> dict[str, Any]:
    """Return the direction of gravity where there is gravity, and the height of a level table, as data for JSON."""
    data: dict[str, Any] = {}
    if structure.gravity:
        data["gravity"] = (np.sign(structure.gravity) * np.array(structure.down)).tolist()
    # the grid of a page is level
    if structure.table is not None and structure.down[2] == -1.0:
        data["table_m"] = structure.table.height
    return data


def legend_data(clips: Sequence[Clip]) -> list[dict[str, str]]:
    """Return the legend of all clips as data for JSON: a sample that the page's script knows, and a text."""
    entries: dict[str, str] = {}
    for clip in clips:
        # the region's entry explains bars of a group of bodies
        looks, tubes = clip.structure.appearance, [tube for tube in clip.mesh.tubes if tube.region is None]
        letters = {tube.crease for tube in tubes if tube.kind in ("bar", "crease")}
        folded = {tube.kind for tube in tubes if tube.crease in ("M", "V")}
        for letter, name, stroke in (("M", "mountain", "dash-dotted"), ("V", "valley", "dashed")):
            lines = [f"{stroke} {looks.crease}"] * ("crease" in folded) + [f"{looks.bar}s"] * ("bar" in folded)
            if letter in letters:
                entries.setdefault(name, f"{name} ({', '.join(lines)})")
        if any(tube.kind == "bar" and tube.crease == "B" for tube in tubes):
            entries.setdefault("border", f"{looks.bar} at the rim" if "bar" in folded else looks.bar)
        if any(tube.kind == "edge" for tube in tubes):
            entries.setdefault("edge", "edge of a plate")
        for region, name in enumerate(clip.mesh.names):
            entries.setdefault(f"region {region}", name)
        if len(clip.mesh.joints):
            entries.setdefault("joint", "support" if clip.mesh.held else "hinge")
        if len(clip.mesh.base):
            entries.setdefault("base", "fixed")
        if clip.structure.tendons:
            entries.setdefault("tendon", "tendon, coloured by stored energy")
        if clip.structure.gravity:
            entries.setdefault("gravity", "direction of gravity")
        if "table_m" in _surroundings_data(clip.structure):
            entries.setdefault("table", "table")
    order = ("mountain", "valley", "border", "edge", "region", "joint", "base", "tendon", "gravity", "table")
    return [
        {"sample": sample, "text": text}
        for sample, text in sorted(entries.items(), key=lambda item: order.index(item[0].partition(" ")[0]))
    ]


def structure_noun(clips: Sequence[Clip]) -> str:
    """Return the common noun of the structures of clips, such as "wing"."""
    names = {clip.structure.appearance.whole for clip in clips}
    return names.pop() if len(names) == 1 else "structure"


def energy_scale(clips: Sequence[Clip]) -> dict[str, Any]:
    """Return the unit of the energies of all tendons, and the largest energy of a tendon, J, as data for JSON."""
    largest = max(float(clip.tendon_energy.max(initial=0.0)) for clip in clips)
    unit, factor = reading_unit("J", largest)
    return {"unit": unit, "factor": factor, "largest_J": largest}

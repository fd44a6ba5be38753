"""A run as a clip: what a page needs to show the structure moving."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from heapq import heappop, heappush
from itertools import pairwise
from typing import Any

import numpy as np

from forficula.analysis import Outcome, State
from forficula.arrays import Array, Flags, Indices
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit
from forficula.show.page.data.packing import packed
from forficula.show.page.data.shape_mesh import ShapeMesh, moving_points, shape_mesh
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

# bytes of one clip; as text in the page they take a third more
BUDGET = 2_500_000
_SERIES = 5  # numbers of a frame beside the positions and what is read: stored energies
# what a plot calls an energy where a figure has another word
_STORED = {"gravitational": "weight"}
# a structure drawn between two frames is no further from the record: m, and by its length
_TOLERANCE, _RELATIVE_TOLERANCE = 5e-7, 1e-5


@dataclass(frozen=True, kw_only=True)
class Mark:
    """A state on the time line.

    Attributes:
        letter: a, b or c, as Binder et al. 2025 call the states.
        name: what it is, such as "folded", or "after folding" where it is not.
        state: means over the last part of its stage, which ends at the mark.
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
        measure: what is read.
        title: heading of their plot.
        row: what a row of a table calls them.
        unit: of what is shown.
        factor: to it from rad or m.
        labels: what they are called, (reading,).
        values: rad or m, (time, reading).
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
    """A run that can be played.

    Attributes:
        name: what it is called on the page.
        structure: what was built.
        time: of the frames, s, (time,).
        points: of the mesh, m, (time, point, 3).
        mesh: what is drawn between them.
        marks: the states that the run got to.
        stages: of the protocol, those that took place.
        readings: what is measured, then what is driven beside it.
        tendon_energy: J, (time, tendon).
        stored_energy: of tendons, membrane and what else there is, by name, J, (time,).
        largest_energy: of each of these over the whole run, J; the kinetic one may lie between two frames.
        rest_length: of the tendons, m, (time, tendon), or (1, tendon) where none yields.
        efforts: what drives do.
    """

    name: str
    structure: Structure
    time: Array
    points: Array
    mesh: ShapeMesh
    marks: tuple[Mark, ...]
    stages: tuple[StageEnd, ...]
    readings: tuple[Readings, ...]
    tendon_energy: Array
    stored_energy: Mapping[str, Array]
    largest_energy: Mapping[str, float]
    rest_length: Array
    efforts: Efforts | None = None


def make_clip(record: Record, outcome: Outcome, *, name: str = "", budget: int = BUDGET) -> Clip:
    """Turn a run into a clip.

    Rows of the record are left out where the structure drawn between their neighbours is within 0.5 µm of them (in one
    shorter than 5 cm, within 1e-5 of its length), so that what rests takes few. Where that is more than the budget
    allows, the rows are taken in which it moves least evenly; those of the states and at the ends of the stages are
    always there.

    Args:
        record: what happened.
        outcome: what it means.
        name: what to call it; that of the design if empty.
        budget: most bytes for positions, angles and energies.
    """
    structure = record.structure
    mesh = shape_mesh(structure)
    points, readings = moving_points(record, mesh), _readings(record)
    points[blown_up(record)] = np.nan
    marks = state_marks(structure, outcome)
    moments = [mark.time for mark in marks]
    for end in record.stages:
        moments += [end.start, end.end, *([] if end.goal_time is None else [end.goal_time])]
    tolerance = min(_TOLERANCE, _RELATIVE_TOLERANCE * structure.span)
    read = sum(each.values.shape[1] for each in readings) + len(structure.tendons)
    a_frame = 8 + 4 * (points[0].size + read + _SERIES)
    most = max(budget // a_frame, 2)
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
        readings=tuple(replace(each, values=each.values[rows]) for each in readings),
        tendon_energy=record.series["tendon_energy"][rows],
        stored_energy={_STORED.get(name, name): values[rows] for name, (values, _) in stored_energies(record).items()},
        largest_energy={_STORED.get(name, name): value for name, value in largest_energies(record).items()},
        rest_length=_rest_lengths(record, rows),
        efforts=efforts_of(record, rows),
    )


def _rest_lengths(record: Record, rows: Indices) -> Array:
    """Lengths below which tendons are slack, m, (time, tendon), or (1, tendon) where none yields."""
    if (grown := record.series.get("tendon_rest_length")) is not None:
        return grown[rows]
    return np.array([[tendon.law.rest_length for tendon in record.structure.tendons]])


def state_marks(structure: Structure, outcome: Outcome) -> tuple[Mark, ...]:
    """Where the states are on the time line."""
    letters = state_letters(structure)
    return tuple(
        Mark(letter=letters[state.name], name=table_name(state, outcome), state=found)
        for state in structure.states
        if (found := outcome.states[state.name]) is not None
    )


def blown_up(record: Record) -> Flags:
    """Which rows of a diverged run mean nothing, (time,): from where a hinge has passed its stops by a full turn."""
    if record.diverged_at is None:
        return np.zeros(len(record.time), dtype=np.bool_)
    angles = np.abs(record.series["hinge_angle"])
    stopped = [np.isfinite(hinge.lower) or np.isfinite(hinge.upper) for hinge in record.structure.hinges]
    most = np.where(stopped, 2 * np.pi, np.inf)
    # nan is beyond everything, inf is beyond what has no stop, too
    return np.logical_or.accumulate(~((angles <= most) & np.isfinite(angles)).all(axis=1))


def mark_readings(clip: Clip, readings: Readings, mark: Mark) -> tuple[Array, Array | None]:
    """What is read in a state: the means, and half the swings where the state knows them, both rad or m, (reading,)."""
    measured = mark.state.readings.get(readings.measure.name)
    if measured is not None:
        mean, low, high = (
            condensed(clip.structure, readings.measure, each) for each in (measured.mean, measured.low, measured.high)
        )
        return mean, (high - low) / 2
    # an outcome has no such means
    return readings.values[np.argmin(np.abs(clip.time - mark.time))], None


def clip_data(clip: Clip) -> dict[str, Any]:
    """A clip as data for JSON: lists and texts, long arrays packed by `packed`."""
    mesh, (heading, names, places) = clip.mesh, _columns(clip)
    return {
        "name": clip.name,
        "span_m": clip.structure.span,
        "time": packed(clip.time, "f8"),
        "points": packed(clip.points, "f4"),
        "pointCount": len(mesh.anchors),
        "between": mesh.between.ravel().tolist(),
        "share": mesh.share.tolist(),
        "triangles": mesh.triangles.ravel().tolist(),
        "regions": mesh.regions.tolist(),
        "solid": list(mesh.solid),
        "tubes": [
            {"kind": tube.kind, "crease": tube.crease, "ends": tube.ends, "radius": tube.radius} for tube in mesh.tubes
        ],
        "built": packed(mesh.built, "f4") if clip.structure.membranes else None,
        "faces": mesh.faces.tolist() if clip.structure.membranes else None,
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
                "name": each.measure.name,
                "label": title_of(each.measure),
                "row": each.row,
                "unit": each.unit,
                "parts": place,
                "values": packed(each.factor * each.values, "f4"),
            }
            for each, place in zip(clip.readings, places, strict=False)
        ],
        "tendonParts": places[-1],
        "tendonEnergy_J": packed(clip.tendon_energy, "f4"),
    }


def _readings(record: Record) -> list[Readings]:
    """What is measured, and the angles that are driven beside it."""
    structure, titles = record.structure, record.structure.appearance.titles
    measured = shown_angles(structure)
    driven = driven_angles(structure, measured)
    found = []
    for measure in (*measured, *shown_distances(structure), *driven):
        values = record.measured(measure.name)
        unit, factor = "deg", float(np.degrees(1.0))
        if measure.kind == "distance":
            unit, factor = reading_unit("m", float(np.nanmax(np.abs(values), initial=0.0)) or structure.span)
        row = measure.name if measure in driven else title_of(measure)
        found.append(
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
    return found


def _columns(clip: Clip) -> tuple[str, tuple[str, ...], list[list[int]]]:
    """The columns of a table of everything by hinge and tendon: their heading, their names, and which has what.

    Returns:
        The word that all names begin with, or none; the names; and for all readings, then for the tendons, the column
        of each of their numbers.
    """
    rows = [list(each.labels) for each in clip.readings] + [[label_of(tendon) for tendon in clip.structure.tendons]]
    columns, places = aligned(rows)
    parts = parts_of(columns)
    return parts.heading, parts.names, places


def _mark_data(clip: Clip, mark: Mark) -> dict[str, Any]:
    """A state with the numbers that the summary states for it."""
    states = {}
    for each in clip.readings:
        mean, swing = mark_readings(clip, each, mark)
        if swing is not None:
            states[each.measure.name] = {"mean": (each.factor * mean).tolist(), "swing": (each.factor * swing).tolist()}
    return {
        "letter": mark.letter,
        "name": mark.name,
        "time": mark.time,
        "readings": states,
        "tendonEnergy_J": mark.state.tendon_energy.tolist(),
    }


def legend_data(clips: Sequence[Clip]) -> list[dict[str, str]]:
    """What the colours of all clips mean, as data for JSON: a sample, as the page's script knows it, and a text."""
    told: dict[str, str] = {}
    for clip in clips:
        looks, tubes = clip.structure.appearance, clip.mesh.tubes
        letters = {tube.crease for tube in tubes if tube.kind in ("bar", "crease")}
        folded = {tube.kind for tube in tubes if tube.crease in ("M", "V")}
        for letter, name, stroke in (("M", "mountain", "dash-dotted"), ("V", "valley", "dashed")):
            lines = [f"{stroke} {looks.crease}"] * ("crease" in folded) + [f"{looks.bar}s"] * ("bar" in folded)
            if letter in letters:
                told.setdefault(name, f"{name} ({', '.join(lines)})")
        if any(tube.kind == "bar" and tube.crease == "B" for tube in tubes):
            told.setdefault("border", f"{looks.bar} at the rim" if "bar" in folded else looks.bar)
        if any(tube.kind == "edge" for tube in tubes):
            told.setdefault("edge", "edge of a plate")
        for region, name in enumerate(clip.mesh.names):
            told.setdefault(f"region {region}", name)
        if len(clip.mesh.joints):
            told.setdefault("joint", "held vertex" if clip.mesh.held else "hinge")
        if len(clip.mesh.base):
            told.setdefault("base", "held fast")
        if clip.structure.tendons:
            told.setdefault("tendon", "tendon, energy stored")
    order = ("mountain", "valley", "border", "edge", "region", "joint", "base", "tendon")
    return [
        {"sample": sample, "text": text}
        for sample, text in sorted(told.items(), key=lambda item: order.index(item[0].partition(" ")[0]))
    ]


def whole_of(clips: Sequence[Clip]) -> str:
    """What the structures of clips are called, one of them."""
    names = {clip.structure.appearance.whole for clip in clips}
    return names.pop() if len(names) == 1 else "structure"


def energy_scale(clips: Sequence[Clip]) -> dict[str, Any]:
    """One unit for the energies of all tendons, and the largest energy of one of them, J, as data for JSON."""
    largest = max(float(clip.tendon_energy.max(initial=0.0)) for clip in clips)
    unit, factor = reading_unit("J", largest)
    return {"unit": unit, "factor": factor, "largest_J": largest}


def kept_frames(time: Array, points: Array, moments: Iterable[float], *, most: int, tolerance: float) -> Indices:
    """Choose rows so that what is drawn between them goes as it went.

    The rows nearest to the moments, the first and the last are kept. Then, again and again, the row is added at which
    what is drawn between its neighbours is furthest from the record (Douglas and Peucker 1973, with time
    as the line's parameter), until none is further than the tolerance or there are enough rows.

    Args:
        time: s, (time,).
        points: m, (time, point, 3); rows that are not finite as floats of four bytes are never kept.
        moments: times that must be kept, s.
        most: number of rows; more are kept only where the moments are more.
        tolerance: distance that no one sees, m.

    Returns:
        Rows, rising, (kept,).
    """
    with np.errstate(over="ignore"):
        sound = np.flatnonzero(np.isfinite(points.astype(np.float32)).all(axis=(1, 2)))
    if not len(sound):
        return sound
    time, points = time[sound], points[sound]
    kept = {int(np.argmin(np.abs(time - moment))) for moment in moments} | {0, len(sound) - 1}
    gaps: list[tuple[float, int, int, int]] = []
    for ends in pairwise(sorted(kept)):
        _push(gaps, time, points, *ends)
    while gaps and len(kept) < most and -gaps[0][0] > tolerance:
        _, first, worst, last = heappop(gaps)
        kept.add(worst)
        _push(gaps, time, points, first, worst)
        _push(gaps, time, points, worst, last)
    return np.asarray(sound[sorted(kept)])


def _push(gaps: list[tuple[float, int, int, int]], time: Array, points: Array, first: int, last: int) -> None:
    """Add a gap between two kept rows to the heap, by how far what is drawn across it is from the record."""
    if last - first < 2:
        return
    inside = slice(first + 1, last)
    share = (time[inside] - time[first]) / (time[last] - time[first])
    drawn = points[first] + share[:, np.newaxis, np.newaxis] * (points[last] - points[first])
    errors = np.square(drawn - points[inside]).sum(axis=2).max(axis=1)
    worst = int(np.argmax(errors))
    heappush(gaps, (-float(np.sqrt(errors[worst])), first, first + 1 + worst, last))

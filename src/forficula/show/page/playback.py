"""A run as a clip: what a page needs to show the wing moving."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.analysis import Outcome, State
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit
from forficula.show.page.frames import kept_frames
from forficula.show.page.wing_mesh import WingMesh, moving_points, wing_mesh

Array = NDArray[np.float64]

# bytes of one clip; as text in the page they take a third more
BUDGET = 2_500_000
_SERIES_BY_VEIN, _SERIES = 3, 5  # numbers of a frame beside the positions: angles and energies
# a wing drawn between two frames is no further from the record: m, and by the length of the wing
_TOLERANCE, _RELATIVE_TOLERANCE = 5e-7, 1e-5


@dataclass(frozen=True, kw_only=True)
class Mark:
    """A state on the time line.

    Attributes:
        letter: a, b or c, as Binder et al. 2025 call the states.
        name: what it is, such as "folded", or "after folding" where the wing is not.
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
class Clip:
    """A run that can be played.

    Attributes:
        name: what it is called on the page.
        time: of the frames, s, (time,).
        points: of the mesh, m, (time, point, 3).
        mesh: what is drawn between them.
        marks: the states that the run got to.
        stages: of the protocol, those that took place.
        distal_angle: rad, (time, vein).
        turn_angle: rad, (time, vein).
        tendon_energy: J, (time, vein).
        stored_energy: of tendons, membrane and what else there is, by name, J, (time,).
    """

    name: str
    time: Array
    points: Array
    mesh: WingMesh
    marks: tuple[Mark, ...]
    stages: tuple[StageEnd, ...]
    distal_angle: Array
    turn_angle: Array
    tendon_energy: Array
    stored_energy: Mapping[str, Array]


def make_clip(record: Record, outcome: Outcome, *, name: str = "", budget: int = BUDGET) -> Clip:
    """Turn a run into a clip.

    Rows of the record are left out where the wing drawn between their neighbours is within 0.5 µm of them (in a wing
    shorter than 5 cm, within 1e-5 of its length), so that a wing at rest takes few. Where that is more than the budget
    allows, the rows are taken in which the wing moves least evenly; those of the states and at the ends of the stages
    are always there.

    Args:
        record: what happened.
        outcome: what it means.
        name: what to call it; that of the design if empty.
        budget: most bytes for positions, angles and energies.
    """
    points, pattern = moving_points(record), record.design.pattern
    points[blown_up(record)] = np.nan
    marks = state_marks(outcome)
    moments = [mark.time for mark in marks]
    for end in record.stages:
        moments += [end.start, end.end, *([] if end.goal_time is None else [end.goal_time])]
    tolerance = min(_TOLERANCE, _RELATIVE_TOLERANCE * (pattern.proximal_length + pattern.distal_length))
    a_frame = 8 + 4 * (points[0].size + _SERIES_BY_VEIN * len(record.series["distal_angle"][0]) + _SERIES)
    most = max(budget // a_frame, 2)
    rows = kept_frames(record.time, points, moments, most=most, tolerance=tolerance)
    shown_until = record.time[rows[-1]]
    series = {key: values[rows] for key, values in record.series.items()}
    return Clip(
        name=name or record.design.name,
        time=record.time[rows],
        points=points[rows],
        mesh=wing_mesh(record.design),
        marks=tuple(mark for mark in marks if mark.time <= shown_until),
        stages=tuple(end for end in record.stages if end.start <= shown_until),
        distal_angle=series["distal_angle"],
        turn_angle=series["turn_angle"],
        tendon_energy=series["tendon_energy"],
        stored_energy=_stored(record, series),
    )


def state_marks(outcome: Outcome) -> tuple[Mark, ...]:
    """Where the states are on the time line."""
    states = (
        ("a", outcome.flat_name, outcome.flat),
        ("b", "folded" if outcome.folded else "after folding", outcome.folded_state),
        ("c", "opened" if outcome.opened else "after unfolding", outcome.opened_state),
    )
    return tuple(Mark(letter=letter, name=name, state=state) for letter, name, state in states if state is not None)


def blown_up(record: Record) -> NDArray[np.bool_]:
    """Which rows of a diverged run mean nothing, (time,): from where a hinge has passed its stops by a full turn."""
    if record.diverged_at is None:
        return np.zeros(len(record.time), dtype=np.bool_)
    angles = np.concatenate([record.series["distal_angle"], record.series["turn_angle"]], axis=1)
    # nan is beyond everything
    return np.logical_or.accumulate(~(np.abs(angles) <= 2 * np.pi).all(axis=1))


def clip_data(clip: Clip) -> dict[str, Any]:
    """A clip as data for JSON: lists and texts, long arrays packed by `packed`."""
    mesh = clip.mesh
    return {
        "name": clip.name,
        "time": packed(clip.time, "f8"),
        "points": packed(clip.points, "f4"),
        "pointCount": mesh.points,
        "between": mesh.between.ravel().tolist(),
        "share": mesh.share.tolist(),
        "triangles": mesh.triangles.ravel().tolist(),
        "regions": mesh.regions.tolist(),
        "tubes": [
            {"kind": tube.kind, "crease": tube.crease, "vein": tube.vein, "ends": tube.ends, "radius": tube.radius}
            for tube in mesh.tubes
        ],
        "joints": mesh.joints.tolist(),
        "jointRadius": mesh.joint_radius,
        "marks": [_mark_data(mark) for mark in clip.marks],
        "stages": [
            {"name": end.stage.name, "start": end.start, "end": end.end, "drive": end.stage.drive}
            for end in clip.stages
        ],
        "distalAngle_deg": packed(np.degrees(clip.distal_angle), "f4"),
        "turnAngle_deg": packed(np.degrees(clip.turn_angle), "f4"),
        "tendonEnergy_J": packed(clip.tendon_energy, "f4"),
    }


def _mark_data(mark: Mark) -> dict[str, Any]:
    """A state with the numbers that the summary states for it."""
    state = mark.state
    return {
        "letter": mark.letter,
        "name": mark.name,
        "time": mark.time,
        "distalAngle_deg": np.degrees(state.distal_angle).tolist(),
        "distalSwing_deg": np.degrees((state.distal_angle_high - state.distal_angle_low) / 2).tolist(),
        "tendonEnergy_J": state.tendon_energy.tolist(),
    }


def energy_scale(clips: Sequence[Clip]) -> dict[str, Any]:
    """One unit for the energies of all tendons, and the largest energy of one of them, J, as data for JSON."""
    largest = max(float(clip.tendon_energy.max(initial=0.0)) for clip in clips)
    unit, factor = reading_unit("J", largest)
    return {"unit": unit, "factor": factor, "largest_J": largest}


def packed(values: ArrayLike, kind: str) -> str:
    """Pack numbers as little-endian floats of four ("f4") or eight ("f8") bytes, row by row, in base64."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=f"<{kind}").tobytes()).decode("ascii")


def _stored(record: Record, series: Mapping[str, Array]) -> dict[str, Array]:
    """What stores energy, J, (time,), by name."""
    energies = {
        "tendons": series["tendon_energy"].sum(axis=1),
        "membrane": series["membrane_energy"],
        "kinetic": series["kinetic_energy"],
    }
    if "branch_energy" in series:
        energies["Maxwell branches"] = series["branch_energy"].sum(axis=1)
    if record.design.protocol.gravity:
        energies["weight"] = series["gravitational_energy"]
    return energies

"""Angles over time from clicked points of a film, and the facts that they give for `identify`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
import tomli_w

from forficula.arrays import Array
from forficula.design import Design, key_value
from forficula.design.file_fields import DESIGN, SETTINGS, DesignName, FolderName, Settings, entry
from forficula.design.files.rejection import read_section
from forficula.design.protocol import StageSection, read_goal
from forficula.design.section import ANGLE, LENGTH, TIME, Section, quantity
from forficula.errors import InputError, error_prefix
from forficula.goals.clicks.clicked_angles import foreshortened_angles, turn_angles
from forficula.goals.clicks.clicked_scale import clicked_point, picture_matrix
from forficula.names import one_of
from forficula.pattern.picture.homography import metres_per_pixel
from forficula.quantities import as_written, parse_quantity, show_quantity, show_value
from forficula.results import Result
from forficula.serial import Radians, Seconds, Written
from forficula.structure import Transition, structure_of
from forficula.study.files.named_file import base_design

Method = Literal["turn", "foreshortening"]
_DEVIATIONS = 3.0  # [chosen] standard deviations that the tolerance of a fact allows
_FEWEST_FRAMES = 3
_FRAME_WORDS = ("time", "picture")


class AngleTable(Section):
    """A table `angle.NAME` of a file with the clicked points of a film."""

    points: Annotated[Any, "list of names of points"] = entry(
        "three points for the turn at the second one, or two for the foreshortening of the length between them", ...
    )
    length: float | None = quantity(LENGTH, "true distance of two points", default=None, above=0)
    sense: Annotated[Any, "1 or -1"] = entry("1: a counterclockwise turn in the picture is positive; -1: negative", 1)
    key: str | None = entry(
        "key of the design that is set to the size of the angle in every fact", left_out="the goal of the stage"
    )


class MotionFile(Section):
    """Content of a file with the clicked points of a film."""

    about: ClassVar[str] = "Forficula clicks: points of a film of one folding structure"

    name: FolderName = entry("name of the film in outputs", "", left_out="the file's name")
    source: str = entry("source of the film", "")
    design: DesignName = DESIGN
    settings: Settings = SETTINGS
    transition: str = entry("transition that the film shows", ...)
    start: float = quantity(TIME, "time in the film at which the drive begins", default=0.0)
    accuracy: Annotated[Any, "number > 0"] = entry("standard uncertainty of a click along x and y, pixels", ...)
    facts: Annotated[Any, "whole number"] = entry("largest number of angles that become facts", 4)
    scale: Annotated[Any, "two points in pixels"] = entry("two points at a known distance, for foreshortening")
    length: Annotated[Any, "length"] = entry("distance of the two points of scale")
    angle: Annotated[dict[str, AngleTable], "tables [angle.NAME]"] = entry(
        "angles by the names that goals of the design use", ...
    )
    frame: Annotated[Any, "tables"] = entry("one table for each picture: time, and the position of every point", ...)
    unknown: Annotated[dict[str, Any], "as in an observations file"] = entry(
        "priors, which are copied to the observations file", {}
    )
    sampling: Annotated[dict[str, Any], "as in an observations file"] = entry(
        "number of samples, which is copied to the observations file", {}
    )


@dataclass(frozen=True, kw_only=True)
class ObservedAngle:
    """Angle over time.

    Attributes:
        name: name of the angle in the design.
        method: "turn" about an axis along the view, or "foreshortening" of a known length, which has no sign.
        times: times from the start of the drive, s.
        angles: angles, rad.
        deviations: their standard uncertainties from that of a click, rad.
    """

    name: str
    method: Method
    times: tuple[Seconds, ...]
    angles: tuple[Radians, ...]
    deviations: tuple[Radians, ...]


@dataclass(frozen=True, kw_only=True)
class ObservedPassage:
    """Time at which an angle passes a value: a fact for `identify`.

    Attributes:
        name: name of the angle.
        angle: value that the angle passes, rad.
        time: time from the start of the drive, s.
        tolerance: tolerance of the time, s.
    """

    name: str
    angle: Radians
    time: Seconds
    tolerance: Seconds


@dataclass(frozen=True, kw_only=True, eq=False)
class ObservedMotion(Result):
    """Angles over time from the clicked points of a film.

    Attributes:
        name: name of the film.
        design: name of the design.
        transition: transition that the film shows.
        accuracy: standard uncertainty of a click, pixels.
        angles: angles over time.
        passages: times at which angles pass values.
        remarks: quantities that one view measures, and points that are not used, as sentences.
        observations: observations file as tables.
    """

    name: Annotated[str, Written.ALWAYS]
    design: str
    transition: str
    accuracy: float
    angles: tuple[ObservedAngle, ...]
    passages: tuple[ObservedPassage, ...]
    remarks: tuple[str, ...]
    observations: Annotated[Mapping[str, Any], Written.NEVER]

    def __repr__(self) -> str:
        """Return the film, its angles and the number of facts."""
        frames = len(self.angles[0].times)
        names = ", ".join(angle.name for angle in self.angles)
        return f"<Motion of {self.name or 'a film'}: {names} in {frames} pictures, {len(self.passages)} facts>"

    @property
    def observations_text(self) -> str:
        """Return the content of the observations file."""
        named = self.observations["design"]
        return tomli_w.dumps({**self.observations, "design": named if isinstance(named, str) else self.design})


def observed_motion(tables: Mapping[str, object], folder: Path) -> ObservedMotion:
    """Compute angles over time from the clicked points of a film.

    Args:
        tables: content of the file.
        folder: folder that the path of the design is relative to.

    Raises:
        InputError: a value that is not allowed, or fewer than 3 pictures.
    """
    file = read_section(MotionFile, tables)
    design = base_design(file.design, file.settings, folder)
    transition = _transition(design, file.transition)
    accuracy = _positive(file.accuracy, "accuracy")
    times, places = _frames(file)
    angles, passages, facts = [], [], []
    remarks = [
        "One view measures the turn about an axis along the view, and the inclination of a segment of known length to"
        " the picture plane without its sign. Other turns appear as projected angles, which are not fold angles."
    ]
    if not isinstance(file.facts, int) or isinstance(file.facts, bool) or file.facts < 1:
        raise InputError(f"facts: need a whole number >= 1, got {as_written(file.facts)}")
    for name, table in file.angle.items():
        with error_prefix(f"angle.{name}."):
            values, deviations, method = _angle(file, table, places, accuracy)
            angle = ObservedAngle(
                name=name,
                method=method,
                times=tuple(times.tolist()),
                angles=tuple(values.tolist()),
                deviations=tuple(deviations.tolist()),
            )
            angles.append(angle)
            most = _level(design, transition, name, table, values)
            new_passages = list(_passages(angle, most, file.facts))
            if not new_passages:
                remarks.append(f"{name} passes no value that differs by more than its uncertainty from the first one.")
            passages += new_passages
            facts += [_fact(design, transition, table, passage) for passage in new_passages]
    observations = {
        key: value
        for key, value in {
            "name": file.name or "film",
            "source": file.source or "clicked points of a film",
            "design": _design_name(file, folder),
            "settings": dict(file.settings),
            "unknown": dict(file.unknown),
            "sampling": dict(file.sampling),
            "fact": facts,
        }.items()
        if value
    }
    if not file.unknown:
        remarks.append("The observations file has no unknown values yet: add [unknown] with a prior for each.")
    return ObservedMotion(
        name=file.name,
        design=design.name,
        transition=transition.name,
        accuracy=accuracy,
        angles=tuple(angles),
        passages=tuple(passages),
        remarks=tuple(remarks),
        observations=observations,
    )


def _design_name(file: MotionFile, folder: Path) -> object:
    """Return the design for the observations file; the path of a design file becomes absolute."""
    name = file.design
    return str((folder / name).resolve()) if isinstance(name, str) and (folder / name).is_file() else name


def _transition(design: Design, name: str) -> Transition:
    transitions = structure_of(design).transitions
    named = next((transition for transition in transitions if transition.name == name), None)
    if named is None:
        raise InputError(f"transition: need {one_of([transition.name for transition in transitions], name)}")
    if named.stage is None:
        raise InputError(f"transition: need one that a stage of the protocol drives, got {name}")
    return named


def _positive(value: object, key: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < math.inf:
        raise InputError(f"{key}: need a number > 0, got {as_written(value)}")
    return float(value)


def _frames(file: MotionFile) -> tuple[Array, dict[str, Array]]:
    """Return the times of the pictures from the start of the drive, s, and positions by name, pixels, (frames, 2)."""
    frames = file.frame
    if not isinstance(frames, Sequence) or len(frames) < _FEWEST_FRAMES:
        count = len(frames) if isinstance(frames, Sequence) and not isinstance(frames, str) else 0
        raise InputError(f"frame: need at least {_FEWEST_FRAMES} tables [[frame]], one for each picture, got {count}")
    times, names = [], [key for key in frames[0] if key not in _FRAME_WORDS]
    places: dict[str, list[Array]] = {name: [] for name in names}
    for number, frame in enumerate(frames):
        with error_prefix(f"frame {number}: "):
            if "time" not in frame:
                raise InputError('time: is missing; give the time of the picture, such as "0.12 s"')
            with error_prefix("time: "):
                times.append(parse_quantity(frame["time"], TIME))
            for name in names:
                if name not in frame:
                    raise InputError(f"{name}: is missing; click the same points in every picture")
                places[name].append(clicked_point(frame[name], name))
    if (np.diff(times) <= 0).any():
        raise InputError("frame: need pictures in the order of their times, each later than the previous one")
    return np.array(times) - file.start, {name: np.array(shown) for name, shown in places.items()}


def _angle(
    file: MotionFile, table: AngleTable, places: Mapping[str, Array], accuracy: float
) -> tuple[Array, Array, Method]:
    names = table.points
    if not isinstance(names, Sequence) or isinstance(names, str) or len(names) not in (2, 3):
        raise InputError(f"points: need the names of three points, or of two and their length, got {as_written(names)}")
    for name in names:
        if name not in places:
            raise InputError(f"points: need {one_of(places, name)}")
    if table.sense not in (1, -1):
        raise InputError(f"sense: need 1 or -1, got {as_written(table.sense)}")
    shown = np.stack([places[name] for name in names], axis=1)
    if (np.linalg.norm(np.diff(shown, axis=1), axis=-1) <= 5 * accuracy).any() and len(names) == 3:
        raise InputError(f"points: need neighbouring points at least 5 times the accuracy of {accuracy:g} pixels apart")
    if len(names) == 3:
        if table.length is not None:
            raise InputError("length: is for two points, got three")
        angles, deviations = turn_angles(shown, accuracy)
        return table.sense * angles, deviations, "turn"
    if table.length is None:
        raise InputError('length: is missing; give the true distance of the two points, such as "5 cm"')
    matrix = picture_matrix(file.scale, file.length, None, None)
    pixel = float(metres_per_pixel(matrix, np.zeros((1, 2)))[0])
    lengths = pixel * np.linalg.norm(shown[:, 1] - shown[:, 0], axis=1)
    slack = table.length + 5 * pixel * accuracy
    if (lengths > slack).any():
        raise InputError(
            f"length: need at least the longest clicked distance, {show_value(float(lengths.max()), 'm')}, got"
            f" {show_value(table.length, 'm')}; check the scale"
        )
    angles, deviations = foreshortened_angles(lengths, table.length, pixel * accuracy)
    return table.sense * angles, deviations, "foreshortening"


def _stage(design: Design, transition: Transition) -> StageSection:
    assert transition.stage is not None
    return design.protocol.stages[transition.stage]


def _level(design: Design, transition: Transition, name: str, table: AngleTable, values: Array) -> float:
    """Return the angle at which the stage ends, rad: later pictures show another drive."""
    stage = _stage(design, transition)
    goal = read_goal(stage.until)
    if goal is not None and goal.name != name:
        raise InputError(
            f"name: need {goal.name}, on which the goal of the stage {stage.name} of {design.name} is a bound, got"
            f" {name}"
        )
    if goal is not None and table.key is not None:
        raise InputError(f"key: is for a named goal, got a stage {stage.name} with the bound {stage.until}")
    if goal is not None:
        return parse_quantity(goal.value, ANGLE)
    if table.key is None:
        raise InputError(
            f"key: is missing; give the key that sets the angle of the goal {stage.until} of {design.name}, such as"
            " protocol.folded_angle"
        )
    with error_prefix("key: "):
        return math.copysign(float(key_value(design, table.key)), -1.0 if values[-1] < values[0] else 1.0)


def _passages(angle: ObservedAngle, most: float, count: int) -> list[ObservedPassage]:
    """Return times at which an angle passes values that no earlier picture had, within its uncertainty."""
    times, values, deviations = map(np.array, (angle.times, angle.angles, angle.deviations))
    sense = math.copysign(1.0, most - values[0])
    rates = np.gradient(values, times)
    chosen, last = [], 0
    for frame in range(1, len(times)):
        apart = _DEVIATIONS * math.hypot(deviations[frame], deviations[last])
        is_new = sense * (values[frame] - values[:frame].max() if sense > 0 else values[frame] - values[:frame].min())
        within = sense * (most - values[frame]) >= 0
        resolved = abs(rates[frame]) * (times[-1] - times[0]) > deviations[frame]
        if times[frame] > 0 and is_new > apart and within and resolved and sense * rates[frame] > 0:
            chosen.append(frame)
            last = frame
    if len(chosen) > count:
        chosen = [chosen[round(index)] for index in np.linspace(0, len(chosen) - 1, count)]
    return [
        ObservedPassage(
            name=angle.name,
            angle=float(values[frame]),
            time=float(times[frame]),
            tolerance=float(_DEVIATIONS * deviations[frame] / abs(rates[frame])),
        )
        for frame in chosen
    ]


def _fact(design: Design, transition: Transition, table: AngleTable, passage: ObservedPassage) -> dict[str, Any]:
    """Return a table [[fact]]: the time at which the angle passes a value, as the time of a goal with this value."""
    angle = f"{math.degrees(passage.angle):.5g} deg"
    stage = _stage(design, transition)
    if table.key is None:
        goal = read_goal(stage.until)
        assert goal is not None
        settings = {f"protocol.stages.{transition.stage}.until": f"{passage.name} {goal.relation} {angle}"}
    else:
        settings = {table.key: f"{abs(math.degrees(passage.angle)):.5g} deg"}
    with error_prefix("the goal of a fact cannot be set: "):
        design.with_values(settings)
    return {
        "name": f"{passage.name} passes {angle}",
        "quantity": f"{transition.name}_time",
        "until": transition.name,
        "settings": settings,
        "absent": show_quantity(stage.time_limit, TIME),
        "equals": show_quantity(passage.time, TIME, 6),
        "tolerance": show_quantity(passage.tolerance, TIME, 3),
    }

"""Protocol: the stages in which a structure is driven, and the criteria by which a run is judged."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import BeforeValidator, Field, field_validator

from forficula.design.section import ACCELERATION, ANGLE, ANGULAR_SPEED, LONG_TIME, SHORT_TIME, TIME, Section, quantity
from forficula.errors import InputError
from forficula.names import one_of, shown_name
from forficula.quantities import Unit, as_written, parse_quantity, show_quantity

_BOUND = re.compile(r"\s*(?P<name>[^<>=]+?)\s*(?P<relation>[<>])=?\s*(?P<value>[^<>=]+?)\s*")

# s, a thousand million days: every step of a wait is at most twice the previous one, so 1e300 d would never end
_LONGEST_WAIT = 1e9 * 86400

_AXES = {
    f"{sign}{axis}": tuple(float(f"{sign}1") if axis == other else 0.0 for other in "xyz")
    for axis in "xyz"
    for sign in ("", "-")
}


def _read_direction(direction: object) -> object:
    """Read a direction: the name of an axis, or a vector; a vector along an axis becomes its name."""
    written = direction.strip() if isinstance(direction, str) else None
    if written in _AXES:
        return written
    vector = tuple(direction) if isinstance(direction, list | tuple) else ()
    if not (len(vector) == len("xyz") and all(type(part) in (int, float) and math.isfinite(part) for part in vector)):
        raise InputError(
            f'need "x", "y", "z", "-x", "-y", "-z" or a vector such as [0, -1, -1], got {as_written(direction)}'
        )
    if not any(vector):
        raise InputError(f'need a direction that is not zero, such as "-z" or [0, -1, -1], got {as_written(direction)}')
    size = max(map(abs, vector))
    return next((name for name, axis in _AXES.items() if tuple(part / size for part in vector) == axis), vector)


class StageSection(Section):
    """A stage of the protocol: the drives that act, and the goal that ends it."""

    about: ClassVar[str] = "A stage of the protocol: the drives that act, and the goal that ends it"

    natural: ClassVar[tuple[str, ...]] = ("wait",)
    later: ClassVar[tuple[str, ...]] = ("motion",)

    name: Annotated[str, Field(min_length=1, description="name of the stage in figures and tables")]
    drive: Annotated[str | tuple[str, ...], Field(description="drive that acts, a list of drives, or none")]
    until: Annotated[
        str,
        Field(description='goal that ends the stage: time, rest, a named goal, or a bound such as "ring < -150 deg"'),
    ]
    state: Annotated[
        str | None, Field(description="name of the state at the end of the stage", examples=["folded"])
    ] = None
    hold: float = quantity(TIME, "how long the goal must hold before the stage ends", default=0.0, at_least=0)
    time_limit: float = quantity(
        TIME,
        "longest duration of the stage; with a wait, the longest time until the structure rests; in a quasi-static"
        " stage, the time over which the drive grows to its strength, and the longest time of a return to rest",
        above=0,
    )
    motion: Annotated[
        Literal["quasi-static"] | None,
        Field(
            description='"quasi-static": the drive grows evenly over the time limit, so slowly that the structure'
            ' passes through equilibria, which statics computes; if not given, or "dynamic": the motion is simulated',
            examples=["quasi-static"],
        ),
    ] = None
    wait: float | None = quantity(
        LONG_TIME,
        "how long the structure stays at rest while Maxwell branches of its tendons and creases relax; this time is not"
        " simulated"
        ' step by step; needs until = "rest"',
        default=None,
        at_least=0,
        at_most=_LONGEST_WAIT,
    )

    @field_validator("name")
    @classmethod
    def _on_one_line(cls, name: str) -> str:
        return shown_name(name)

    @field_validator("motion", mode="before")
    @classmethod
    def _simulated_without_motion(cls, motion: object) -> object:
        """Read "dynamic" as an absent value, so that both have the same hash."""
        if motion not in ("dynamic", "quasi-static", None):
            raise InputError(f'need "dynamic" or "quasi-static", got {as_written(motion)}')
        return None if motion == "dynamic" else motion

    @property
    def quasi_static(self) -> bool:
        """Return whether statics computes the stage."""
        return self.motion is not None

    @field_validator("drive", mode="before")
    @classmethod
    def _names_drives(cls, drive: object) -> object:
        """Refuse a value that is neither a name nor a list of names, with one message instead of one for each type."""
        names = [drive] if isinstance(drive, str) else drive
        if not isinstance(names, list | tuple) or not names or not all(isinstance(name, str) for name in names):
            raise InputError(f'need a drive by name in quotes, a list of them, or "none", got {as_written(drive)}')
        return drive


class Protocol(Section):
    """The stages in which the structure is driven, and the criteria by which a run is judged."""

    about: ClassVar[str] = "The stages in which the structure is driven, and the criteria by which a run is judged"

    natural: ClassVar[tuple[str, ...]] = ("gravity",)
    later: ClassVar[tuple[str, ...]] = ("shortest_timestep", "device", "gravity_direction")

    timestep: float | Literal["auto"] = quantity(
        SHORT_TIME,
        'step of the integrator, or "auto": halved until verdict and times converge and the energy balance closes',
        above=0,
        words=("auto",),
    )
    shortest_timestep: float | None = quantity(
        SHORT_TIME,
        'shortest step that "auto" tries; if not given, the first one halved eight times',
        default=None,
        above=0,
        examples=["1 µs"],
    )
    sample_interval: float = quantity(SHORT_TIME, "time between two rows of the record", above=0)
    rise: float = quantity(TIME, "time over which torques rise linearly from 0; 0: at once", default=0.0, at_least=0)
    rest_speed: float = quantity(ANGULAR_SPEED, "speed below which a hinge counts as at rest", above=0)
    window: float = quantity(
        TIME,
        "averaging window of a state; a run is stuck once it has rested short of its goal for this long plus three"
        " relaxation times of the slowest Maxwell branch; branches slower than the stages are not counted",
        above=0,
    )
    least_hold: Annotated[
        float,
        Field(
            strict=True,
            ge=0,
            description="shortest time for which a goal must hold, divided by the time taken to reach it; anything"
            " shorter is a bounce",
        ),
    ] = 0.25
    residual_limit: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            le=1,
            description="largest residual of the energy balance, as a share of the exchanged energy; above it the"
            " verdict is untrusted",
        ),
    ] = 0.005
    gravity: float = quantity(ACCELERATION, "gravity along protocol.gravity_direction; 0 switches gravity off")
    gravity_direction: Annotated[
        str | tuple[float, float, float],
        BeforeValidator(_read_direction),
        Field(
            description="direction of gravity in the axes of the structure, as a vector of any length or as an axis"
            ' such as "-y"; "-z" is normal to a flat sheet and downwards',
            examples=["-y", [0, -1, -1]],
        ),
    ] = "-z"
    contact: Annotated[bool, Field(strict=True, description="whether bodies touch each other")]
    device: Annotated[
        Literal["gpu", "warp-cpu"] | None,
        Field(
            description='"gpu": simulated in single precision on a graphics processor, by MuJoCo Warp; "warp-cpu": the'
            ' same on the processor, slowly, for tests; if not given, or "cpu": in double precision on the processor',
            examples=["gpu"],
        ),
    ] = None
    stages: Annotated[tuple[StageSection, ...], Field(min_length=1, description="stages of the protocol, in order")]

    @property
    def down(self) -> tuple[float, float, float]:
        """Return the unit vector along gravity."""
        direction = self.gravity_direction
        x, y, z = _AXES[direction] if isinstance(direction, str) else direction
        length = math.hypot(x, y, z)
        return x / length, y / length, z / length

    @field_validator("device", mode="before")
    @classmethod
    def _processor_without_device(cls, device: object) -> object:
        """Read "cpu" as an absent value, so that both have the same hash."""
        if device not in ("cpu", "gpu", "warp-cpu", None):
            raise InputError(f'need "cpu", "gpu" or "warp-cpu", got {as_written(device)}')
        return None if device == "cpu" else device


class CommonProtocol(Protocol):
    """The stages in which the structure is driven, and the criteria by which a run is judged.

    All keys but the stages have defaults.
    """

    timestep: float | Literal["auto"] = quantity(
        SHORT_TIME,
        'step of the integrator, or "auto": halved until verdict and times converge and the energy balance closes',
        default="auto",
        above=0,
        words=("auto",),
    )
    sample_interval: float = quantity(SHORT_TIME, "time between two rows of the record", default=2e-3, above=0)
    rest_speed: float = quantity(
        ANGULAR_SPEED, "speed below which a hinge counts as at rest", default=math.radians(2.0), above=0
    )
    window: float = quantity(
        TIME,
        "averaging window of a state; a run is stuck once it has rested short of its goal for this long plus three"
        " relaxation times of the slowest Maxwell branch; branches slower than the stages are not counted",
        default=0.1,
        above=0,
    )
    gravity: float = quantity(
        ACCELERATION, "gravity along protocol.gravity_direction; 0 switches gravity off", default=0.0
    )
    contact: Annotated[bool, Field(strict=True, description="whether bodies touch each other")] = False


@dataclass(frozen=True, kw_only=True)
class GoalText:
    """A bound as text, split into its three terms.

    Attributes:
        name: name of a measure or role of hinges.
        relation: "<" or ">".
        value: a quantity with its unit.
    """

    name: str
    relation: str
    value: str


def read_goal(text: str) -> GoalText | None:
    """Split a bound into its terms; return None for text that is not a bound."""
    match = _BOUND.fullmatch(text)
    return None if match is None else GoalText(**match.groupdict())


def stage_drives(stage: StageSection) -> tuple[str, ...]:
    """Return the names of the drives of a stage."""
    names = (stage.drive,) if isinstance(stage.drive, str) else stage.drive
    return tuple(name for name in names if name != "none")


def check_stages(protocol: Protocol, drives: Sequence[str], goals: Sequence[str], measures: dict[str, Unit]) -> None:
    """Refuse stages with an unknown drive or goal.

    Args:
        protocol: protocol with the stages.
        drives: allowed names of drives, besides "none".
        goals: allowed names of goals, besides "time" and "rest".
        measures: names that a bound may have, with their units.

    Raises:
        InputError: an unknown name, or a bound that cannot be read.
    """
    for number, stage in enumerate(protocol.stages):
        names = stage_drives(stage)
        for name in names:
            if name not in drives:
                raise InputError(f"protocol.stages.{number}.drive: need {one_of(['none', *drives], name)}")
            if names.count(name) > 1:
                raise InputError(f"protocol.stages.{number}.drive: need each drive once, got {as_written(stage.drive)}")
        if stage.wait and stage.until != "rest":
            rule = 'need until = "rest", because a wait begins at rest'
            raise InputError(f"protocol.stages.{number}.wait: {rule}, got until = {as_written(stage.until)}")
        if stage.wait and stage.wait <= protocol.window:
            least = f"need > {show_quantity(protocol.window, TIME)}, which is protocol.window, or no wait"
            raise InputError(f"protocol.stages.{number}.wait: {least}, got {show_quantity(stage.wait, TIME)}")
        if stage.quasi_static:
            _check_quasi_static(protocol, number)
        if stage.until in ("time", "rest", *goals):
            continue
        key, written = f"protocol.stages.{number}.until", read_goal(stage.until)
        # a bound whose value comes first is not allowed either
        if written is None or written.value in measures:
            bound = f'a bound such as "{next(iter(measures))} < -150 deg"'
            raise InputError(f"{key}: need {one_of(['time', 'rest', *goals], stage.until, [bound])}")
        if written.name not in measures:
            raise InputError(f"{key}: need a bound on {one_of(measures, written.name)}")
        try:
            parse_quantity(written.value, measures[written.name])
        except InputError as error:
            raise InputError(f"{key}: {error}") from None


def _check_quasi_static(protocol: Protocol, number: int) -> None:
    """Refuse keys that have no meaning in a quasi-static stage."""
    stage, key = protocol.stages[number], f"protocol.stages.{number}"
    for name, value in (("wait", stage.wait), ("hold", stage.hold)):
        if value:
            raise InputError(
                f"{key}.{name}: need 0 s in a quasi-static stage, because the structure rests at every moment of it,"
                f" got {show_quantity(value, TIME)}"
            )


def check_states(protocol: Protocol, states: Sequence[str]) -> None:
    """Refuse stages with an unknown state, and two stages with the same state.

    Args:
        protocol: protocol with the stages.
        states: allowed names of states.

    Raises:
        InputError: an unknown name, or a repeated one.
    """
    previous: list[str] = []
    for number, stage in enumerate(protocol.stages):
        if stage.state is None:
            continue
        key = f"protocol.stages.{number}.state"
        if stage.state not in states:
            raise InputError(f"{key}: need {one_of(states, stage.state)}")
        if stage.state in previous:
            raise InputError(f"{key}: need a name that is not used yet, got {as_written(stage.state)} again")
        previous.append(stage.state)


def check_bounds(protocol: Protocol, stops: dict[str, tuple[float, float]]) -> None:
    """Refuse bounds on angles that the stops of hinges make unreachable.

    Args:
        protocol: protocol whose stages have been checked by `check_stages`.
        stops: smallest and largest angle, rad, by the name that a bound may have; other names have no stops.

    Raises:
        InputError: a bound beyond a stop.
    """
    for number, stage in enumerate(protocol.stages):
        written = read_goal(stage.until)
        if written is not None and written.name in stops:
            check_bound(f"protocol.stages.{number}.until", written, *stops[written.name], whose=written.name)


def check_bound(key: str, written: GoalText, low: float, high: float, *, whose: str) -> None:
    """Refuse a bound on an angle that cannot be met between the stops `low` and `high`, rad."""
    value, above = parse_quantity(written.value, ANGLE), written.relation == ">"
    if value > high if above else value < low:
        bound = f"<= {show_quantity(high, ANGLE)}" if above else f">= {show_quantity(low + 0.0, ANGLE)}"  # not -0
        raise InputError(
            f"{key}: a stop keeps {whose} from reaching it: need a value {bound}, got {show_quantity(value, ANGLE)}"
        )

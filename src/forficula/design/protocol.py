"""Protocol: what is done to a structure, stage by stage, and what counts as done."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import Field, field_validator

from forficula.design.section import ACCELERATION, ANGLE, ANGULAR_SPEED, LONG_TIME, SHORT_TIME, TIME, Section, quantity
from forficula.errors import InputError
from forficula.names import one_of, shown_name
from forficula.quantities import Unit, as_written, parse_quantity, show_quantity

_WRITTEN = re.compile(r"\s*(?P<name>[^<>=]+?)\s*(?P<relation>[<>])=?\s*(?P<value>[^<>=]+?)\s*")

# s, a thousand million days: every leap is twice the last one at most, and a wait of 1e300 d would never end
_LONGEST_WAIT = 1e9 * 86400


class StageSection(Section):
    """A part of the protocol: what drives the structure, and when it ends."""

    about: ClassVar[str] = "A part of the protocol: what drives the structure, and when it ends"

    natural: ClassVar[tuple[str, ...]] = ("wait",)

    name: Annotated[str, Field(min_length=1, description="what figures and tables call it")]
    drive: Annotated[str | tuple[str, ...], Field(description="what acts: a drive by name, a list of them, or none")]
    until: Annotated[
        str, Field(description='goal that ends it: time, rest, one by name, or a bound such as "ring < -150 deg"')
    ]
    state: Annotated[str | None, Field(description="what to call the state at its end", examples=["folded"])] = None
    hold: float = quantity(TIME, "how long the goal must hold before the stage ends", default=0.0, at_least=0)
    time_limit: float = quantity(TIME, "longest duration; of a stage with a wait, until it rests", above=0)
    wait: float | None = quantity(
        LONG_TIME,
        "how long it stays at rest, which is not simulated step by step: tendons with Maxwell branches relax meanwhile;"
        ' needs until = "rest"',
        default=None,
        at_least=0,
        at_most=_LONGEST_WAIT,
    )

    @field_validator("name")
    @classmethod
    def _on_one_line(cls, name: str) -> str:
        return shown_name(name)

    @field_validator("drive", mode="before")
    @classmethod
    def _names_drives(cls, drive: object) -> object:
        """Refuse what is no name and no list of names in one sentence; pydantic would have one for each."""
        names = [drive] if isinstance(drive, str) else drive
        if not isinstance(names, list | tuple) or not names or not all(isinstance(name, str) for name in names):
            raise InputError(f'need a drive by name in quotes, a list of them, or "none", got {as_written(drive)}')
        return drive


class Protocol(Section):
    """What is done to a structure, and what counts as done."""

    about: ClassVar[str] = "What is done to a structure, and what counts as done"

    natural: ClassVar[tuple[str, ...]] = ("gravity",)
    later: ClassVar[tuple[str, ...]] = ("shortest_timestep",)

    timestep: float | Literal["auto"] = quantity(
        SHORT_TIME,
        'step of the integrator, or "auto": halved until verdict and times stay, and the energy balance closes',
        above=0,
        words=("auto",),
    )
    shortest_timestep: float | None = quantity(
        SHORT_TIME,
        'shortest step that "auto" tries; without it, the first one halved eight times',
        default=None,
        above=0,
        examples=["1 µs"],
    )
    sample_interval: float = quantity(SHORT_TIME, "time between two rows of the record", above=0)
    rise: float = quantity(TIME, "time over which torques rise evenly from 0; 0: at once", default=0.0, at_least=0)
    rest_speed: float = quantity(ANGULAR_SPEED, "at rest means that every hinge is slower", above=0)
    window: float = quantity(
        TIME,
        "over which a state is averaged, as far as it rests; what rests so long short of its goal, and three times as"
        " long as those of its tendons' Maxwell branches take to relax that are no slower than its stages, is stuck",
        above=0,
    )
    least_hold: Annotated[
        float,
        Field(
            strict=True,
            ge=0,
            description="how long a goal must hold at least, by the time that it took; less is a bounce",
        ),
    ] = 0.25
    residual_limit: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            le=1,
            description="largest share of the energy that was exchanged that may be missing in a run to be trusted",
        ),
    ] = 0.005
    gravity: float = quantity(ACCELERATION, "gravity across the sheet, downwards where it lies flat; 0 switches it off")
    contact: Annotated[bool, Field(strict=True, description="whether bodies touch each other")]
    stages: Annotated[tuple[StageSection, ...], Field(min_length=1, description="what happens, in order")]


@dataclass(frozen=True, kw_only=True)
class GoalText:
    """A bound as it is written.

    Attributes:
        name: of a measure or of the role of hinges.
        relation: "<" or ">".
        value: a quantity with its unit.
    """

    name: str
    relation: str
    value: str


def read_goal(text: str) -> GoalText | None:
    """Take a written bound apart; None where it is none."""
    found = _WRITTEN.fullmatch(text)
    return None if found is None else GoalText(**found.groupdict())


def stage_drives(stage: StageSection) -> tuple[str, ...]:
    """Names of the drives of a stage."""
    names = (stage.drive,) if isinstance(stage.drive, str) else stage.drive
    return tuple(name for name in names if name != "none")


def check_stages(protocol: Protocol, drives: Sequence[str], goals: Sequence[str], measures: dict[str, Unit]) -> None:
    """Refuse stages that name no drive or no goal.

    Args:
        protocol: with the stages.
        drives: names that a stage may give, but for "none".
        goals: names that it may give, but for "time" and "rest".
        measures: what it may bound, and in which unit.

    Raises:
        InputError: a name that is not known, or a bound that cannot be read.
    """
    for number, stage in enumerate(protocol.stages):
        names = stage_drives(stage)
        for name in names:
            if name not in drives:
                raise InputError(f"protocol.stages.{number}.drive: need {one_of(['none', *drives], name)}")
            if names.count(name) > 1:
                raise InputError(f"protocol.stages.{number}.drive: need each drive once, got {as_written(stage.drive)}")
        if stage.wait and stage.until != "rest":
            rule = 'need until = "rest", for it waits at rest'
            raise InputError(f"protocol.stages.{number}.wait: {rule}, got until = {as_written(stage.until)}")
        if stage.wait and stage.wait <= protocol.window:
            least = f"need > {show_quantity(protocol.window, TIME)}, the protocol.window of a state, or none"
            raise InputError(f"protocol.stages.{number}.wait: {least}, got {show_quantity(stage.wait, TIME)}")
        if stage.until in ("time", "rest", *goals):
            continue
        key, written = f"protocol.stages.{number}.until", read_goal(stage.until)
        # the value may stand first, which is no bound either
        if written is None or written.value in measures:
            bound = f'a bound such as "{next(iter(measures))} < -150 deg"'
            raise InputError(f"{key}: need {one_of(['time', 'rest', *goals], stage.until, [bound])}")
        if written.name not in measures:
            raise InputError(f"{key}: need a bound on {one_of(measures, written.name)}")
        try:
            parse_quantity(written.value, measures[written.name])
        except InputError as error:
            raise InputError(f"{key}: {error}") from None


def check_states(protocol: Protocol, states: Sequence[str]) -> None:
    """Refuse stages that call their end something there is not, or two ends the same.

    Args:
        protocol: with the stages.
        states: names that a stage may give.

    Raises:
        InputError: another name, or one that comes twice.
    """
    given: list[str] = []
    for number, stage in enumerate(protocol.stages):
        if stage.state is None:
            continue
        key = f"protocol.stages.{number}.state"
        if stage.state not in states:
            raise InputError(f"{key}: need {one_of(states, stage.state)}")
        if stage.state in given:
            raise InputError(f"{key}: need a name of its own, got {as_written(stage.state)} again")
        given.append(stage.state)


def check_bounds(protocol: Protocol, stops: dict[str, tuple[float, float]]) -> None:
    """Refuse bounds on angles that stops keep hinges from.

    Args:
        protocol: its stages have been checked by `check_stages`.
        stops: rad, the least and the largest angle of what a stage may bound; what is not there has no stops.

    Raises:
        InputError: which stage, and what it may bound.
    """
    for number, stage in enumerate(protocol.stages):
        written = read_goal(stage.until)
        if written is not None and written.name in stops:
            check_bound(f"protocol.stages.{number}.until", written, *stops[written.name], whose=written.name)


def check_bound(key: str, written: GoalText, low: float, high: float, *, whose: str) -> None:
    """Refuse a bound on an angle, between its stops in rad, that they keep from being met."""
    value, above = parse_quantity(written.value, ANGLE), written.relation == ">"
    if value > high if above else value < low:
        bound = f"<= {show_quantity(high, ANGLE)}" if above else f">= {show_quantity(low, ANGLE)}"
        raise InputError(
            f"{key}: a stop keeps {whose} from there: need a value {bound}, got {show_quantity(value, ANGLE)}"
        )

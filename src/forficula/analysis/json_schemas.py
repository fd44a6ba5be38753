"""JSON schemas of what commands write: `summary.json`, `landscape.json`, the rows of a study, `assumptions.json`.

A number is None where there is none, and its key ends in its unit. What a structure calls its states, measures, drives
and parts stands in keys, too.
"""

from __future__ import annotations

from typing import Any, Literal, NotRequired

from pydantic import ConfigDict, TypeAdapter, with_config
from typing_extensions import TypedDict

from forficula.analysis.verdict import Verdict
from forficula.errors import InputError
from forficula.names import one_of

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_OPEN = ConfigDict(extra="allow")
_CLOSED = ConfigDict(extra="forbid")
_UNITS = "deg|m|m2|s|J|N|Pa|Hz|N_m|N_per_m|kg_m2|per_s|rad_per_s|m_per_s2"
_NUMBERS = {"anyOf": [{"type": "number"}, {"type": "null"}, {"type": "array", "items": {"type": ["number", "null"]}}]}
_BY_UNIT = {"patternProperties": {f"_({_UNITS})$": _NUMBERS}}

Number = float | None


@with_config(_CLOSED)
class Transition(TypedDict):
    """What became of a transition, such as folding; beside it the strength of its drive, in a key of its unit."""

    succeeded: bool
    time_s: Number
    work_J: Number
    time_uncertainty_s: NotRequired[float]
    work_uncertainty_J: NotRequired[float]
    largest_force_N: NotRequired[float]
    torque_N_m: NotRequired[float]
    force_N: NotRequired[float]
    displacement_m: NotRequired[float]
    rest_angle_deg: NotRequired[float]


@with_config(_CLOSED)
class Stage(TypedDict):
    """How a stage of the protocol went."""

    drive: str | list[str]
    goal: str
    reached: bool | None
    time_s: Number
    work_J: float
    waited_s: NotRequired[float]


@with_config(_OPEN)
class State(TypedDict):
    """A state, the mean over the last part of a stage. Keys of measures and springs consist of their name and unit.

    A key with `_uncertainty` before the unit has the numerical uncertainty of the key without `_uncertainty`. Such keys
    exist in runs with second runs.
    """

    time_s: float
    tendon_length_m: list[float]
    tendon_energy_J: list[float]
    membrane_energy_J: Number
    tendon_length_uncertainty_m: NotRequired[list[float]]
    tendon_energy_uncertainty_J: NotRequired[list[float]]
    membrane_energy_uncertainty_J: NotRequired[float]


@with_config(_CLOSED)
class Peak(TypedDict):
    """The largest strain of a kind of parts, where and when."""

    strain: Number
    stress_Pa: NotRequired[float]
    strength_Pa: NotRequired[float]
    part: str
    time_s: float


@with_config(_CLOSED)
class Fold(TypedDict):
    """The crease that folds furthest."""

    angle_deg: float
    crease: str
    time_s: float


@with_config(_CLOSED)
class Room(TypedDict):
    """The room that a state takes, and its area by that of the first one."""

    height_m: float
    width_m: float
    length_m: float
    area_m2: float
    area_ratio: float


@with_config(_CLOSED)
class Package(Room):
    """The room that the smallest state takes, and every one."""

    state: str
    states: dict[str, Room]


@with_config(_CLOSED)
class Crossing(TypedDict):
    """How far panels pass through each other, deepest."""

    depth_m: float
    panels: list[str]
    time_s: float


@with_config(_CLOSED)
class Branch(TypedDict):
    """Which way a sheet left its flat state."""

    as_assigned: int
    against: int
    flat: int
    decided_by: list[str]


@with_config(_CLOSED)
class Wait(TypedDict):
    """What a wait did to tendons."""

    stage: str
    state: str | None
    wait_s: float
    pull_before_N: list[float] | None
    pull_after_N: list[float] | None
    pull_lost: Number
    branch_damping_J: float
    membrane_energy_J: Number


@with_config(_CLOSED)
class Storage(TypedDict):
    """Every wait, and in words."""

    waits: list[Wait]
    in_words: list[str]


@with_config(_CLOSED)
class Balance(TypedDict):
    """The account of the energy; terms of what the structure does not have are left out."""

    residual: Number
    work_J: Number
    tendon_energy_change_J: Number
    membrane_energy_change_J: Number
    kinetic_energy_change_J: Number
    gravitational_energy_change_J: Number
    hinge_damping_J: Number
    elastic_damping_J: Number
    stops_J: Number
    missing_J: Number
    contacts_J: NotRequired[Number]
    friction_J: NotRequired[Number]
    branch_energy_change_J: NotRequired[Number]
    branch_damping_J: NotRequired[Number]
    yielding_J: NotRequired[Number]
    letting_go_J: NotRequired[Number]
    hinge_energy_change_J: NotRequired[Number]
    spring_energy_change_J: NotRequired[Number]
    coupling_energy_change_J: NotRequired[Number]
    closures_J: NotRequired[Number]
    drag_J: NotRequired[Number]


@with_config(_CLOSED)
class Scale(TypedDict):
    """What groups are measured by."""

    part: str
    moment_N_m: float
    inertia_kg_m2: Number
    time_s: Number


@with_config(_OPEN)
class Groups(TypedDict):
    """Dimensionless numbers by their names, what they are measured by, and what comes first."""

    measured_by: Scale
    in_words: str


@with_config(_CLOSED)
class SecondRun(TypedDict):
    """A second run of the same design, in which only the computation differs."""

    name: str
    timestep_s: float
    verdict: Verdict
    status: str


@with_config(_CLOSED)
class Confirmed(TypedDict):
    """Whether second runs have the same verdict, and which values differ between them by more than 2 %."""

    confirmed: bool
    checks: list[SecondRun]
    unsettled: list[str]


@with_config(_OPEN)
class Summary(TypedDict):
    """What a run came to. Beside these keys, by name: whether a state was reached and held, and every transition."""

    design: str
    status: str
    verdict: Verdict
    residual: Number
    advice: str
    confirmation: NotRequired[Confirmed]
    states: dict[str, State | None]
    stages: dict[str, Stage]
    largest_strains: dict[str, Peak]
    furthest_fold: NotRequired[Fold]
    branch: NotRequired[Branch]
    package: NotRequired[Package]
    storage: NotRequired[Storage]
    crossing: NotRequired[Crossing]
    energy_balance: Balance
    closure_gap_m: NotRequired[float]
    groups: Groups | None
    diverged_at_s: Number
    warnings: list[str]
    design_hash: str
    key: NotRequired[str]
    versions: dict[str, str]


@with_config(_OPEN)
class Stable(TypedDict):
    """A stable state on a curve of energy."""

    kind: str
    energy_J: float
    holding_torque_N_m: Number


@with_config(_OPEN)
class Curve(TypedDict):
    """The energy over an angle, its stable states and what they withstand."""

    energy_J: list[float]
    moment_N_m: list[float]
    stable_states: list[Stable]
    barrier_J: Number


@with_config(_CLOSED)
class PartialFold(TypedDict):
    """Let go with some hinges folded."""

    folded: list[int]
    stable: bool
    stays_folded: list[int]
    distal_angle_deg: list[float]
    energy_J: float
    tendon_energy_J: float
    membrane_energy_J: float
    independent_energy_J: Number


@with_config(_CLOSED)
class Rest(TypedDict):
    """Where a structure rests without torques."""

    name: str
    angles_deg: list[float]
    energy_J: float
    stored_J: dict[str, float]
    stable: bool
    same_as: str | None


@with_config(_CLOSED)
class Tips(TypedDict):
    """How stiff the tips are."""

    deflection_m: Number
    holding_force_N: Number
    flat_along_N_per_m: Number
    flat_against_N_per_m: Number
    unlocked_along_N_per_m: Number
    unlocked_against_N_per_m: Number


@with_config(_CLOSED)
class InertialHelp(TypedDict):
    """A snap after which inertia may make a transition with less than the least slow torque."""

    torque_N_m: float
    released_J: float
    barrier_J: float


@with_config(_CLOSED)
class Landscape(TypedDict):
    """What statics say of a design; `net` is of points that slide and of plates in loops."""

    design: str
    hinge: Curve | None
    tendons: list[Curve]
    wing: Curve | None
    levels_J: list[float] | None
    partial_folds: list[PartialFold]
    rests: list[Rest]
    least_torques_N_m: dict[str, Number]
    least_torque_ranges_N_m: NotRequired[dict[str, list[Number]]]
    inertial_help: NotRequired[dict[str, InertialHelp | None]]
    tips: Tips | None
    remarks: list[str]
    net: NotRequired[dict[str, Any]]
    rests_apart_m: NotRequired[dict[str, Number]]
    simulation: NotRequired[dict[str, Any] | None]
    figures: NotRequired[list[str]]
    design_hash: str
    versions: NotRequired[dict[str, str]]


@with_config(_OPEN)
class Row(TypedDict):
    """A point of a study: the values of its factors and what became of it; by name and unit."""

    status: str
    verdict: Verdict


@with_config(_CLOSED)
class AssumptionRun(TypedDict):
    """A run with one modelling assumption changed, or of the design itself; times and works by transition."""

    name: str
    label: str
    meaning: str
    effect: Literal["verdict", "numbers", "nothing", "unknown"]
    timestep_s: float
    verdict: Verdict
    goal: str
    word: str
    status: str
    time_s: dict[str, Number]
    work_J: dict[str, Number]


@with_config(_CLOSED)
class TransitionName(TypedDict):
    """What a transition is called, and its time."""

    name: str
    time: str
    noun: str


@with_config(_CLOSED)
class Assumptions(TypedDict):
    """What every modelling assumption of a design does to its result.

    `left_out` has the reasons why assumptions do not apply; `uncertainty` is numerical and of the design's own run.
    """

    design: str
    design_hash: str
    verdict: str
    transitions: list[TransitionName]
    own: AssumptionRun
    runs: list[AssumptionRun]
    left_out: dict[str, str]
    uncertainty: dict[str, float]
    design_file: str
    versions: dict[str, str]


_KINDS: dict[str, Any] = {"summary": Summary, "landscape": Landscape, "row": Row, "assumptions": Assumptions}
Kind = Literal["summary", "landscape", "row", "assumptions"]


def json_schema(kind: Kind) -> dict[str, Any]:
    """The JSON schema (draft 2020-12) of what commands write, and print with `--json`.

    Args:
        kind: "summary" of a run, "landscape", "row" of a study, or "assumptions".

    Raises:
        InputError: another kind.

    >>> sorted(ff.json_schema("row")["required"])
    ['status', 'verdict']
    """
    if kind not in _KINDS:
        raise InputError(f"need {one_of(_KINDS, kind)}")
    schema = TypeAdapter(_KINDS[kind]).json_schema()
    parts = schema.get("$defs", {})
    # open tables have keys that the structure names, each of its unit
    for name in {"State", "Stable", "Curve"} & parts.keys():
        parts[name] |= _BY_UNIT
    if "Groups" in parts:
        parts["Groups"]["additionalProperties"] = {"type": ["number", "null"]}
    if kind == "summary":
        parts["Transition"] = TypeAdapter(Transition).json_schema()
        held = {"type": ["boolean", "null"]}
        schema["additionalProperties"] = {"anyOf": [held, {"$ref": "#/$defs/Transition"}]}
    if kind == "row":
        schema["additionalProperties"] = {"type": ["number", "string", "boolean", "null"]}
    return {"$schema": _DIALECT, "$id": f"forficula-{kind}", **schema}

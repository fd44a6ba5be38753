"""JSON schema of `landscape.json`."""

from __future__ import annotations

from typing import Any, NotRequired

from pydantic import ConfigDict, TypeAdapter, with_config
from typing_extensions import TypedDict

_OPEN = ConfigDict(extra="allow")
_CLOSED = ConfigDict(extra="forbid")
_UNITS = "deg|m|m2|s|J|N|Pa|Hz|N_m|N_per_m|kg_m2|per_s|rad_per_s|m_per_s2"
_NUMBERS = {"anyOf": [{"type": "number"}, {"type": "null"}, {"type": "array", "items": {"type": ["number", "null"]}}]}
_BY_UNIT = {"patternProperties": {f"_({_UNITS})$": _NUMBERS}}

Number = float | None


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


def landscape_schema() -> dict[str, Any]:
    """Return the JSON schema of `landscape.json`."""
    schema = TypeAdapter(Landscape).json_schema()
    for name in ("Stable", "Curve"):
        schema["$defs"][name] |= _BY_UNIT
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "$id": "forficula-landscape", **schema}

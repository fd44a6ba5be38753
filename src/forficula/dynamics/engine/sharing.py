"""Sharing of simulations: structures with the same first stages."""

from __future__ import annotations

from collections.abc import Container, Sequence

from forficula.design import StageSection, put
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stage_plan import Effort, stage_torques


def followers(models: Sequence[Model], held: Container[int] = ()) -> dict[int, tuple[int, int]]:
    """For each structure, return an earlier one with the same first stages, and their number; held ones never lead."""
    leaders: dict[int, tuple[int, int]] = {}
    similar: dict[tuple[int, str], list[int]] = {}
    sequences = [_driven_stages(model) for model in models]
    for row, model in enumerate(models):
        earlier = similar.setdefault((id(model.engine), _all_but_stages(model)), [])
        shared = [(_shared_stages(sequences[leader], sequences[row]), -leader) for leader in earlier]
        stages, leader = max(shared, default=(0, 0))
        if stages:
            leaders[row] = -leader, stages
        if row not in held:
            earlier.append(row)
    return leaders


def _all_but_stages(model: Model) -> str:
    """Return a key of a protocol that ignores its stages and the strengths of their drives."""
    protocol = put(model.design.protocol, "stages", ())
    for drive in model.structure.drives:
        section, _, name = drive.key.partition(".")
        if section == "protocol":
            protocol = put(protocol, name, 0.0)
    return protocol.model_dump_json()


def _driven_stages(model: Model) -> list[tuple[StageSection, tuple[Effort, ...]]]:
    """Return the stages of a structure, each with its torques."""
    return [(stage, stage_torques(model, stage)) for stage in model.design.protocol.stages]


def _shared_stages(one: Sequence[object], other: Sequence[object]) -> int:
    """Return the number of first stages that two sequences share, to the last bit."""
    equal = [a == b for a, b in zip(one, other, strict=False)]
    return [*equal, False].index(False)

"""Sharing of simulations: structures with the same first stages, and structures that wait for another's result."""

from __future__ import annotations

from collections.abc import Container, Sequence

from forficula.design import Design, StageSection, put
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stage_plan import Effort, stage_torques
from forficula.structure import Structure, drive_of


def successors(models: Sequence[Model]) -> dict[int, int]:
    """For each structure, return the next one that differs only in the strength of its last transition's drive."""
    following: dict[int, int] = {}
    last: dict[tuple[int, str], int] = {}
    for row, model in enumerate(models):
        key = id(model.engine), _but_last_drive(model)
        if key in last:
            following[last[key]] = row
        last[key] = row
    return following


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


def key_without_last_drive(design: Design, structure: Structure) -> str:
    """Return a key of a design that ignores the strength of the drive of its last transition."""
    for transition in structure.transitions[-1:]:
        design = put(design, drive_of(structure, transition.drive).key, 0.0)
    return design.hash


def _but_last_drive(model: Model) -> str:
    """Return such a key for models of one engine, which can differ only in their protocols and drives."""
    structure = model.structure
    last = [transition.drive for transition in structure.transitions[-1:]]
    others = [drive.strength for drive in structure.drives if drive.name not in last]
    keys = [drive_of(structure, name).key for name in last]
    return f"{_but_drives(model, keys)} {others}"


def _all_but_stages(model: Model) -> str:
    """Return a key of a protocol that ignores its stages and the strengths of their drives."""
    return _but_drives(model, [drive.key for drive in model.structure.drives], stages=False)


def _but_drives(model: Model, keys: Sequence[str], *, stages: bool = True) -> str:
    """Return a protocol without some of its values, as text."""
    protocol = model.design.protocol if stages else put(model.design.protocol, "stages", ())
    for key in keys:
        section, _, name = key.partition(".")
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

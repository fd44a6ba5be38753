"""Which structures go through their first stages together, and which wait for another's result."""

from __future__ import annotations

from collections.abc import Container, Sequence

from forficula.design import Design, StageSection, put
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stage_plan import Effort, stage_torques
from forficula.structure import Structure, drive_of


def successors(models: Sequence[Model]) -> dict[int, int]:
    """By structure, the next one that only the strength of its last transition's drive tells apart."""
    following: dict[int, int] = {}
    last: dict[tuple[int, str], int] = {}
    for row, model in enumerate(models):
        key = id(model.engine), _but_last_drive(model)
        if key in last:
            following[last[key]] = row
        last[key] = row
    return following


def followers(models: Sequence[Model], held: Container[int] = ()) -> dict[int, tuple[int, int]]:
    """By structure, an earlier one, not held back, that goes through the same first stages, and how many of them."""
    leaders: dict[int, tuple[int, int]] = {}
    alike: dict[tuple[int, str], list[int]] = {}
    ways = [_way(model) for model in models]
    for row, model in enumerate(models):
        earlier = alike.setdefault((id(model.engine), _all_but_stages(model)), [])
        shared = [(_shared_stages(ways[leader], ways[row]), -leader) for leader in earlier]
        stages, leader = max(shared, default=(0, 0))
        if stages:
            leaders[row] = -leader, stages
        if row not in held:
            earlier.append(row)
    return leaders


def but_last_drive(design: Design, structure: Structure) -> str:
    """What names a design but for the strength of the drive of its last transition."""
    for transition in structure.transitions[-1:]:
        design = put(design, drive_of(structure, transition.drive).key, 0.0)
    return design.hash


def _but_last_drive(model: Model) -> str:
    """The same of models of one engine, which differ in their protocols and drives at most."""
    structure = model.structure
    last = [transition.drive for transition in structure.transitions[-1:]]
    others = [drive.strength for drive in structure.drives if drive.name not in last]
    keys = [drive_of(structure, name).key for name in last]
    return f"{_but_drives(model, keys)} {others}"


def _all_but_stages(model: Model) -> str:
    """What names a protocol but for its stages and the strengths of their drives."""
    return _but_drives(model, [drive.key for drive in model.structure.drives], stages=False)


def _but_drives(model: Model, keys: Sequence[str], *, stages: bool = True) -> str:
    """A protocol without some of its values, as text."""
    protocol = model.design.protocol if stages else put(model.design.protocol, "stages", ())
    for key in keys:
        section, _, name = key.partition(".")
        if section == "protocol":
            protocol = put(protocol, name, 0.0)
    return protocol.model_dump_json()


def _way(model: Model) -> list[tuple[StageSection, tuple[Effort, ...]]]:
    """The stages of a structure, each with what drives it."""
    return [(stage, stage_torques(model, stage)) for stage in model.design.protocol.stages]


def _shared_stages(one: Sequence[object], other: Sequence[object]) -> int:
    """How many first stages two ways have in common, to the last bit."""
    alike = [a == b for a, b in zip(one, other, strict=False)]
    return [*alike, False].index(False)

"""Which wings go through their first stages together, and which wait for another's result."""

from __future__ import annotations

from collections.abc import Container, Sequence

from forficula.design import Stage
from forficula.dynamics.fleet import stage_torques
from forficula.dynamics.model import WingModel


def successors(wings: Sequence[WingModel]) -> dict[int, int]:
    """By wing, the next one that only its unfold torque tells apart."""
    following: dict[int, int] = {}
    last: dict[tuple[int, str], int] = {}
    for row, wing in enumerate(wings):
        protocol = wing.design.protocol.model_copy(update={"unfold_torque": 0.0})
        key = id(wing.engine), protocol.model_dump_json()
        if key in last:
            following[last[key]] = row
        last[key] = row
    return following


def followers(wings: Sequence[WingModel], held: Container[int] = ()) -> dict[int, tuple[int, int]]:
    """By wing, an earlier one that goes through the same first stages and is not held back, and how many stages."""
    leaders: dict[int, tuple[int, int]] = {}
    alike: dict[tuple[int, str], list[int]] = {}
    ways = [_way(wing) for wing in wings]
    for row, wing in enumerate(wings):
        earlier = alike.setdefault((id(wing.engine), _all_but_stages(wing)), [])
        shared = [(_shared_stages(ways[leader], ways[row]), -leader) for leader in earlier]
        stages, leader = max(shared, default=(0, 0))
        if stages:
            leaders[row] = -leader, stages
        if row not in held:
            earlier.append(row)
    return leaders


def _all_but_stages(wing: WingModel) -> str:
    """What names a protocol but for its stages and their torques."""
    parting = {"fold_torque": 0.0, "unfold_torque": 0.0, "stages": ()}
    return wing.design.protocol.model_copy(update=parting).model_dump_json()


def _way(wing: WingModel) -> list[tuple[Stage, tuple[float, float]]]:
    """The stages of a wing, each with what drives it."""
    return [(stage, stage_torques(wing, stage)) for stage in wing.design.protocol.stages]


def _shared_stages(one: Sequence[object], other: Sequence[object]) -> int:
    """How many first stages two ways have in common, to the last bit."""
    alike = [a == b for a, b in zip(one, other, strict=False)]
    return [*alike, False].index(False)

"""Which wings go through their first stages together, and which wait for another's result."""

from __future__ import annotations

from collections.abc import Container, Sequence

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
    alike: dict[int, list[int]] = {}
    for row, wing in enumerate(wings):
        earlier = alike.setdefault(id(wing.engine), [])
        shared = [(_shared_stages(wings[leader], wing), -leader) for leader in earlier]
        stages, leader = max(shared, default=(0, 0))
        if stages:
            leaders[row] = -leader, stages
        if row not in held:
            earlier.append(row)
    return leaders


def _shared_stages(one: WingModel, other: WingModel) -> int:
    """How many first stages two wings of one engine model have in common, to the last bit."""
    parting = {"fold_torque": 0.0, "unfold_torque": 0.0, "stages": ()}
    protocols = [wing.design.protocol for wing in (one, other)]
    if protocols[0].model_copy(update=parting) != protocols[1].model_copy(update=parting):
        return 0
    pairs = zip(*(protocol.stages for protocol in protocols), strict=False)
    alike = [a == b and stage_torques(one, a) == stage_torques(other, b) for a, b in pairs]
    return [*alike, False].index(False)

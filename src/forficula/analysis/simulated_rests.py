"""Comparison of the resting shapes of a run with those of statics."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import net_states
from forficula.statics.net.net_of import point_positions as net_places


def rest_distances(landscape: EnergyLandscape, record: Record) -> Mapping[str, float]:
    """Compute by state the largest difference between distances of points in a run and in statics, m.

    Distances do not depend on the position and orientation of the structure. Only states at the ends of stages are
    compared, and only if the run reached them.

    Args:
        landscape: of the simulated design; without sliding points, nothing is compared.
        record: of the run.
    """
    point_positions = record.series.get("point_position")
    if landscape.net is None or point_positions is None or record.diverged_at is not None:
        return {}
    shapes = {state.name: state.rest.shape for state in net_states(landscape)}
    shapes |= {
        rest.name: rest.shape for rest in landscape.rests if rest.within and rest.stable and rest.shape is not None
    }
    count, net = len(landscape.structure.points), landscape.net.net
    known = {name: net_places(net, shape)[:count] for name, shape in shapes.items()}
    result = {}
    for end in record.stages:
        if end.stage.state in known:
            row = int(np.searchsorted(record.time, end.end, side="right")) - 1
            result[end.stage.state] = float(
                np.abs(_distances(point_positions[row]) - _distances(known[end.stage.state])).max()
            )
    return result


def _distances(point_positions: Array) -> Array:
    """Return distances between all points, m, (point, point)."""
    return np.asarray(np.linalg.norm(point_positions[:, None] - point_positions[None], axis=2))

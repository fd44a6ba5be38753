"""Where a run came to rest beside where statics says that it does."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import net_states
from forficula.statics.net.net_of import places as net_places


def rest_distances(landscape: EnergyLandscape, record: Record) -> Mapping[str, float]:
    """By how much distances between points at rest differ at most in a run and in statics, m, by state.

    Distances are the same however the whole lies. Only states that end stages are compared, where the run deserved
    their name.

    Args:
        landscape: of the design that was run; of points that slide, or nothing is compared.
        record: of the run.
    """
    places = record.series.get("point_position")
    if landscape.net is None or places is None or record.diverged_at is not None:
        return {}
    shapes = {state.name: state.rest.shape for state in net_states(landscape)}
    shapes |= {
        rest.name: rest.shape for rest in landscape.rests if rest.within and rest.stable and rest.shape is not None
    }
    count, net = len(landscape.structure.points), landscape.net.net
    known = {name: net_places(net, shape)[:count] for name, shape in shapes.items()}
    found = {}
    for end in record.stages:
        if end.stage.state in known:
            row = int(np.searchsorted(record.time, end.end, side="right")) - 1
            found[end.stage.state] = float(np.abs(_apart(places[row]) - _apart(known[end.stage.state])).max())
    return found


def _apart(places: Array) -> Array:
    """Distances of all points, m, (point, point)."""
    return np.asarray(np.linalg.norm(places[:, None] - places[None], axis=2))

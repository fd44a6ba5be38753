"""The wing's drawn surface at a moment: panels, veins and tendons in space."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.design.places import mesh_rows, tendon_ends
from forficula.dynamics import Record

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class WingSurface:
    """A wing in space.

    Attributes:
        quads: of the membrane, the strips between veins and margins included, m, (quad, corner, axis).
        distal: whether each lies beyond the ring fold, (quad,).
        veins: hub end, ring vertex and tip of each, m, (vein, point, axis).
        tendons: proximal and distal end of each, m, (vein, end, axis).
    """

    quads: Array
    distal: NDArray[np.bool_]
    veins: Array
    tendons: Array


def wing_surface(record: Record, time: float) -> WingSurface:
    """Find the wing's surface at a time.

    Args:
        record: what happened.
        time: s; between two samples positions are interpolated, outside of them the wing is as at the nearest.
    """
    veins, nodes = at_time(record, "vein_position", time), at_time(record, "membrane_position", time)
    hub, ring, tip = veins[:, 0], veins[:, 1], veins[:, 2]
    membrane = record.design.membrane
    rows = len(membrane.proximal_rows) + len(membrane.distal_rows) + 2
    panels = nodes.reshape(len(veins) - 1, rows, 2, 3)
    quads = []
    for panel, nearby in enumerate(panels):
        along = mesh_rows(hub[panel], ring[panel], tip[panel], record.design)
        edge, far = nearby[:, 0], nearby[:, 1]
        for row in range(rows - 1):
            # the strip between vein and margin is wing, too
            for near, beyond in ((along, edge), (edge, far)):
                quads.append([near[row], near[row + 1], beyond[row + 1], beyond[row]])
    beyond_fold = np.arange(rows - 1) >= len(membrane.proximal_rows)
    return WingSurface(
        quads=np.array(quads),
        distal=np.tile(np.repeat(beyond_fold, 2), len(panels)),
        veins=veins,
        tendons=np.stack(tendon_ends(hub, ring, tip, record.design), axis=1),
    )


def at_time(record: Record, name: str, time: float) -> Array:
    """A series at a time (s), interpolated between two samples, in SI, (...)."""
    values, times = record.series[name], record.time
    after = int(np.clip(np.searchsorted(times, time), 1, len(times) - 1)) if len(times) > 1 else 0
    before = max(after - 1, 0)
    gap = times[after] - times[before]
    share = float(np.clip((time - times[before]) / gap, 0, 1)) if gap > 0 else 1.0
    return np.asarray(values[before] + share * (values[after] - values[before]))

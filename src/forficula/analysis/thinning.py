"""A record with fewer rows, for keeping: it means the same, and it shows every motion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from forficula.arrays import Flags
from forficula.dynamics import Record
from forficula.structure import drawn_points

# A row for every motion by this share of the size of the whole, and for every so many seconds.
_SHARE_OF_SIZE = 0.005
_LONGEST_GAP = 5e-3


def thin_record(record: Record) -> Record:
    """Leave out rows where little moves.

    What `measure` looks at stays, so that the outcome has the same bits: both ends of every stage and the protocol's
    window before its end. Elsewhere a row stays for every 0.5 % of the size of the whole that some point of it has
    moved, as measured along its path, and for every 5 ms.

    Args:
        record: sampled at an interval.

    Returns:
        The same run with some of its rows.
    """
    drawn, nodes = drawn_points(record.structure), record.series["membrane_position"]
    points = np.concatenate([record.series["point_position"][:, drawn], nodes], axis=1)
    size = float(np.ptp(points[0], axis=0).max())
    kept = _needed(record)
    with np.errstate(over="ignore", invalid="ignore"):  # of what diverged
        moved = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1)
        ways = np.stack([np.cumsum(moved) / (_SHARE_OF_SIZE * size), (record.time[1:] - record.time[0]) / _LONGEST_GAP])
        kept[1:] |= (np.diff(np.floor(ways), prepend=0.0) > 0).any(axis=0)
    kept[[0, -1]] = True
    return replace(record, time=record.time[kept], series={name: rows[kept] for name, rows in record.series.items()})


def _needed(record: Record) -> Flags:
    """The rows that states and transitions are read from, (time,)."""
    protocol = record.design.protocol
    half = float(protocol.timestep) / 2  # times are multiples of the timestep up to rounding
    needed = np.zeros(len(record.time), dtype=bool)
    for end in record.stages:
        window = record.time >= max(end.start, end.end - protocol.window) - half
        needed |= window & (record.time <= end.end + half)
        needed[[int(np.argmin(np.abs(record.time - moment))) for moment in (end.start, end.end)]] = True
    return needed

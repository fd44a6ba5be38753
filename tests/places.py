"""Where the points of a record are, by their role."""

import numpy as np

from forficula.dynamics import Record


def places(record: Record, role: str) -> np.ndarray:
    """Places of the points of a role, m, (time, point, 3)."""
    points = [number for number, point in enumerate(record.structure.points) if point.role == role]
    return record.series["point_position"][:, points]

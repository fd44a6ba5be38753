"""A pyramid of four facets whose apex snaps through its rim: von Mises' truss of four bars as a design."""

import numpy as np

from forficula.design import load_design, with_values

SIDE, SECTOR = 0.04, 88.0  # m, of a slanting edge, and deg
RISE = SIDE * np.sqrt(1 - 2 * np.sin(np.radians(SECTOR / 2)) ** 2)  # of the apex above the rim, from the sectors
DEEP = 0.2  # m below the apex as built, from where its height is measured
_FORCE = {"kind": "force", "of": "vertex 0", "force": 0.1, "rise": 1.0}
_HEIGHT = {"name": "height", "kind": "distance", "from": "vertex 0", "to": "ground"}


def pyramid(**values):
    """The design, with other values; its apex is pushed down and pulled up again."""
    drives = [
        {"name": "push", "direction": [0, 0, -1], **_FORCE},
        {"name": "pull", "direction": [0, 0, 1], **_FORCE},
    ]
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "state": "up", "hold": 0.0, "time_limit": 0.05},
        {"name": "push", "drive": "push", "until": f"height < {apex() + DEEP - 2 * RISE + 0.002:.4f} m"},
        {"name": "release down", "drive": "none", "until": "rest", "hold": 0.05, "state": "down"},
        {"name": "pull", "drive": "pull", "until": f"height > {apex() + DEEP - 0.002:.4f} m"},
        {"name": "release up", "drive": "none", "until": "rest", "hold": 0.05, "state": "up again"},
    ]
    basic = {
        "name": "pyramid",
        "pattern.sectors": [np.radians(SECTOR)] * 4,
        "pattern.assignment": "MMMM",
        "pattern.fold": None,
        "facet.youngs_modulus": 1e6,
        "crease.stiffness": 1e-5,
        "crease.rest_angle": "as built",
        "crease.damping": 1e-6,
        "tendon": [],
        "support": [{"of": f"vertex {vertex}"} for vertex in range(1, 5)],
        "measure": [{**_HEIGHT, "ground": [0.0, 0.0, -DEEP]}],
        "protocol.timestep": 1e-4,
        "protocol.sample_interval": 5e-4,
        "drive": drives,
        "protocol.stages": [{"hold": 0.0, "time_limit": 2.0, **stage} for stage in stages],
    }
    return with_values(load_design("bistable-clasp"), basic | values)


def apex():
    """Height of the apex as built, m."""
    return float(_BUILT[0, 2])


_BUILT = with_values(
    load_design("bistable-clasp"),
    {"pattern.sectors": [np.radians(SECTOR)] * 4, "pattern.assignment": "MMMM", "pattern.fold": None},
).sheet.vertices_coords

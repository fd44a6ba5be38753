"""Sheets rest in the same shapes and snap at the same loads in statics and dynamics, which share no energy function.

Statics descends a closed-form energy and follows its equilibria. Dynamics moves damped nodes in the engine until they
rest, or increases a load slowly until they snap. Rests must agree within 1e-3 of an edge, and snaps within 2 %.
"""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.statics.net.load import point_forces
from forficula.statics.net.load_path import load_path
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_of import net_of, point_positions, start_shape
from forficula.structure import structure_of
from forficula.study.running.runs import run

REST = {"name": "rest", "drive": "none", "until": "rest", "hold": 0.05, "time_limit": 5.0}
BAND = {"name": "band", "from": "vertex 0", "to": "vertex 8", "stiffness": 2.0, "rest_length": 0.03}
EDGE = 0.02


def apart(one, other):
    """Largest difference of distances between points, m, which does not depend on position and orientation."""
    first, second = (np.linalg.norm(item[:, None] - item[None], axis=2) for item in (one, other))
    return float(np.abs(first - second).max())


def both(design):
    """Resting shapes of a design released as built, by statics and by dynamics."""
    structure = structure_of(design)
    net = net_of(structure)
    statics = minimum(net, start_shape(structure, net))
    record = run(design)
    assert statics.stable
    assert record.diverged_at is None
    return point_positions(net, statics.shape)[: len(structure.points)], record.series["point_position"][-1]


def small(name, **values):
    """A design that is only released, with damped creases so that it rests soon."""
    nothing = {"drive": [], "measure": [], "protocol.stages": [REST]}
    return with_values(load_design(name), nothing | values)


@pytest.mark.parametrize(
    "values",
    [
        {"crease.rest_angle": 1.2},
        {"crease.rest_angle": 0.0, "tendon": [BAND]},
        {"crease.law": "locking", "crease.lock_angle": 0.9, "tendon": [BAND]},
        {"facet.kind": "membrane", "crease.rest_angle": 0.9},
        {"facet.kind": "rigid", "crease.rest_angle": 1.2, "crease.back_limit": 3.0},
        {"tendon": [BAND | {"from": "edge 0 at 0.5", "to": "facet 3 at centre"}]},
    ],
    ids=["creases", "tendon", "locking", "membrane", "rigid", "places between vertices"],
)
def test_a_small_miura_sheet_rests_equally_in_statics_and_dynamics(holds, values):
    support = [{"of": "facet 0"}]
    sizes = {"pattern.columns": 2, "pattern.rows": 2, "pattern.fold": 0.7}
    statics, dynamics = both(small("miura-sheet", **{"support": support}, **sizes, **values))
    holds(
        "difference of distances divided by an edge",
        apart(statics, dynamics) / EDGE,
        below=1e-3,
        by="statics and dynamics",
    )


def test_plates_with_opening_creases_rest_equally_in_statics_and_dynamics(holds):
    """Four plates that lack 10 deg of a flat sheet, let go where their creases want to be flat."""
    statics, dynamics = both(small("four-plate-snap", **{"crease.rest_angle": 0.2}))
    holds(
        "difference of distances divided by an edge",
        apart(statics, dynamics) / 0.02,
        below=1e-3,
        by="statics and dynamics",
    )


def test_a_vertex_with_a_band_rests_equally_in_statics_and_dynamics(holds):
    statics, dynamics = both(small("bistable-clasp"))
    holds(
        "difference of distances divided by an edge",
        apart(statics, dynamics) / 0.04,
        below=1e-3,
        by="statics and dynamics",
    )
    # it has moved, because the band pulls the corners together
    built = load_design("bistable-clasp").sheet.vertices_coords
    assert apart(statics, built) > 0.01


def test_a_pyramid_snaps_under_a_slow_force_at_its_static_limit(agree):
    """von Mises' truss of four bars: a vertex whose sectors add up to 320 deg, held at its rim and pushed at its apex.

    The force grows over hundreds of swings; it is taken to snap where it is level with its rim.
    """
    push = {"name": "push", "kind": "force", "of": "vertex 0", "force": 1.0, "direction": [0, 0, -1], "rise": 1.0}
    stage = {"name": "push", "drive": "push", "until": "time", "hold": 0.0, "time_limit": 1.0}
    values = {
        "pattern.sectors": [np.deg2rad(80.0)] * 4,
        "pattern.assignment": "MMMM",
        "pattern.fold": None,
        "facet.youngs_modulus": 1e7,
        "crease.stiffness": 1e-4,
        "crease.rest_angle": "as built",
        "crease.damping": 1e-6,
        "tendon": [],
        "support": [{"of": f"vertex {vertex}"} for vertex in range(1, 5)],
        "measure": [],
        "protocol.timestep": 1e-4,
        "protocol.sample_interval": 5e-4,
        "drive": [push],
        "protocol.stages": [stage],
    }
    design = with_values(load_design("bistable-clasp"), values)
    structure = structure_of(design)
    net = net_of(structure)
    start = minimum(net, start_shape(structure, net))
    load = point_forces(net, np.array([0]), np.array([[0.0, 0.0, -1.0]]))
    limit = load_path(net, start.shape, load, step=0.002 * net.size, events=1).events[0].point
    most = 1.1 * float(limit.factor)
    record = run(with_values(design, {"drive.push.force": most}))
    height = record.series["point_position"][:, 0, 2]
    rim = record.series["point_position"][0, 1, 2]
    snapped = record.time[np.argmax(height < rim)]
    agree("snap force", most * snapped, limit.factor, unit="N", by="limit of statics", rel=0.02)

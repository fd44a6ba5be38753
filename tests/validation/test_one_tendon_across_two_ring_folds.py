"""Tendons across two ring folds agree with the closed form of a chain of three bars with parallel hinges.

The distance of the ends along the hinges is that in the flat sheet. Perpendicular to the hinges, the chain consists of
p cos(s/2 - e) of the proximal bar, the height h + 2 k q of the gusset and d cos(s/2 + e) of the distal bar. p and d are
the attachments, s the sector angle, e the angle from the radius to a vein, h the lowest gusset, q the pitch and k the
number of layers inside. The squared length of a chain of A, B and C with angles x and y between them is
A^2 + B^2 + C^2 + 2 (A B cos x + B C cos y + A C cos(x + y)). Simulation and statics compute such tendons independently.
"""

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.design import with_values
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.lines import line_energy
from forficula.structure import hinges_of

THICK = ff.load_design("binder2025-thick", {"protocol.contact": False})


def lengths(design, inner, outer):
    """Lengths of all tendons, m, (..., vein), from the angles of their vein's ring folds, rad, (..., vein)."""
    fan, tendon = design.fan, design.tendon
    apart = fan.epsilon if fan.tangent == "right" else -fan.epsilon
    veins = np.arange(fan.vein_count)
    layers = veins if fan.tangent == "right" else veins[::-1]
    near, far = fan.sector_angle / 2 - apart, fan.sector_angle / 2 + apart
    height = fan.gusset_height + 2 * fan.pitch * layers
    first, last = tendon.proximal_attachment * math.cos(near), tendon.distal_attachment * math.cos(far)
    beyond = height / math.cos(far) + tendon.distal_attachment
    along = tendon.proximal_attachment * math.sin(near) + beyond * math.sin(far)
    square = first**2 + height**2 + last**2 + 2 * first * height * np.cos(inner)
    square = square + 2 * height * last * np.cos(outer) + 2 * first * last * np.cos(inner + outer)
    return np.sqrt(square + along**2)


def energies(design, inner, outer):
    """Total energy of all tendons, J."""
    stretched = np.maximum(lengths(design, inner, outer) - design.tendon.rest_length, 0)
    return design.tendon.stiffness / 2 * (stretched**2).sum(axis=-1)


angles = st.lists(st.floats(-math.pi / 2, math.radians(3)), min_size=6, max_size=6)


@settings(max_examples=10)
@given(angles, st.sampled_from(["left", "right"]), st.floats(0, 0.03), st.floats(0.01, 0.09), st.floats(0.01, 0.09))
def test_statics_give_the_energy_of_the_closed_form(agree, drawn, tangent, hub, proximal, distal):
    design = with_values(
        THICK,
        {
            "pattern.tangent": tangent,
            "pattern.hub_radius": hub,
            "tendon.proximal_attachment": proximal,
            "tendon.distal_attachment": distal,
            "guard.stretch": 2.0,
        },
    )
    wings = ensemble_of([design])
    position = np.zeros((1, wings.size))
    position[:, list(hinges_of(wings.structure, "ring"))] = drawn
    inner, outer = np.array(drawn).reshape(-1, 2).T
    result, known = line_energy(wings.lines, position)[0], energies(design, inner, outer)
    agree("energy of the tendons", result, known, unit="J", by="chain of three bars", rel=1e-9, abs=1e-12)


def test_the_simulation_gives_the_lengths_and_energies_of_the_closed_form(agree):
    fold = {"name": "fold", "drive": "fold", "until": "time", "hold": 0.0, "time_limit": 1.0}
    flat = {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.05}
    run = ff.run(with_values(THICK, {"protocol.stages": [flat, fold], "protocol.timestep": 2e-4}), confirm=False)
    rings = run.angles("ring").reshape(len(run.time), -1, 2)
    assert rings.min() < -math.radians(89)
    inner, outer = np.moveaxis(rings, -1, 0)
    by = "a chain of three bars"
    result, known = 100 * run.series["tendon_length"], 100 * lengths(THICK, inner, outer)
    agree("length of the tendons", result, known, unit="cm", by=by, rel=1e-9)
    total, stored = run.series["tendon_energy"].sum(axis=1), energies(THICK, inner, outer)
    time = ("time (s)", run.time)
    agree("energy of the tendons", total, stored, unit="J", by=by, rel=1e-7, abs=1e-9, over=time)

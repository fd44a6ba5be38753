"""Tendon lengths and energies of the wing follow from its geometry and are close to those of the paper.

Geometry: the tendon's ends are 5.5 cm before and beyond the ring vertex, and the distal bar turns about the ring crease
(Rodrigues 1840). Numbers of Binder et al. 2025, doi 10.3390/biomimetics11010009: open tendons of about 11 cm; more than
35 J for the stiffest tendon without resting length; about 6 J for 10 N/cm without resting length.
"""

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.design import with_values

SETTLE = [{"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.3}]


def direction(angle):
    return np.array([math.cos(angle), math.sin(angle), 0.0])


def turned(vector, axis, angles):
    """Points rotated by Rodrigues' formula, (angle, 3)."""
    cosine, sine = np.cos(angles)[..., None], np.sin(angles)[..., None]
    return vector * cosine + np.cross(axis, vector) * sine + axis * (axis @ vector) * (1 - cosine)


def tendon_length(design, angles):
    """Tendon length at angles of the distal hinge, m, from the four numbers of the pattern."""
    pattern, tendon = design.pattern, design.tendon
    radius = math.hypot(pattern.proximal_length, pattern.hub_radius)
    epsilon = math.asin(pattern.hub_radius / radius)
    vertex, following = radius * direction(0), radius * direction(pattern.sector_angle)
    crease = (following - vertex) / np.linalg.norm(following - vertex)
    # the proximal vein meets the ring at epsilon to the radius; the distal one is deflected by twice epsilon
    before = -tendon.proximal_attachment * direction(epsilon)
    beyond = turned(tendon.distal_attachment * direction(-epsilon), crease, np.asarray(angles))
    return np.linalg.norm(beyond - before, axis=-1)


def tendon_energy(design, angles):
    extension = np.maximum(tendon_length(design, angles) - design.tendon.rest_length, 0)
    return design.tendon.stiffness / 2 * extension**2


def settled(reference, values):
    return ff.measure(ff.run(with_values(reference, {**values, "protocol.stages": SETTLE}), confirm=False)).states[
        "flat"
    ]


def test_tendon_lengths_and_energies_follow_from_the_angles_during_the_whole_reference_run(reference_run, agree):
    data, design = reference_run.data, reference_run.design
    angles = reference_run.angles("ring")
    assert np.degrees(angles).min() < -170
    # rounding
    geometry = tendon_length(design, angles)
    agree(
        "length of the tendons",
        100 * data["tendon_length"].values,
        100 * geometry,
        unit="cm",
        by="Rodrigues",
        abs=1e-10,
    )
    energy = tendon_energy(design, angles)
    agree("energy of the tendons", data["tendon_energy"].values, energy, unit="J", by="k (L - l₀)² / 2", abs=1e-12)


def test_the_flat_opened_and_folded_states_have_the_energies_of_their_angles(agree, reference_run, reference_outcome):
    for state in reference_outcome.states.values():
        # a state is a mean over its window, whose energy differs from the mean energy by second order in a swing
        # of up to 0.1 deg
        energy = tendon_energy(reference_run.design, state.readings["distal_angle"].mean)
        agree("energy of tendons in a state", state.tendon_energy, energy, unit="J", by="that of the angles", abs=1e-6)
    assert reference_outcome.states["flat"].tendon_energy.min() > 0.1
    assert reference_outcome.states["folded"].tendon_energy.max() == 0


@settings(max_examples=6, deadline=None)
@given(hub=st.floats(0, 0.04), sector=st.floats(15, 30), before=st.floats(0.02, 0.12), beyond=st.floats(0.02, 0.1))
def test_tendon_lengths_follow_from_the_geometry_in_other_fans(agree, reference, hub, sector, before, beyond):
    geometry = {
        "pattern.hub_radius": hub,
        "pattern.sector_angle": math.radians(sector),
        "tendon.proximal_attachment": before,
        "tendon.distal_attachment": beyond,
        "tendon.rest_length": 0.0,
        # at 0.2 ms, twice the torque would push some hinges more than 10 deg into their stops
        "protocol.timestep": 5e-5,
    }
    folding = [{**SETTLE[0], "time_limit": 0.01}, {**SETTLE[0], "drive": "fold", "time_limit": 0.04}]
    record = ff.run(
        with_values(reference, {**geometry, "protocol.stages": folding, "protocol.fold_torque": 1.0}), confirm=False
    )
    assert record.diverged_at is None
    # rounding
    lengths = tendon_length(record.design, record.angles("ring"))
    result = 100 * record.data["tendon_length"].values
    agree("length of tendons", result, 100 * lengths, unit="cm", by="Rodrigues", abs=1e-10)


def test_open_tendons_are_about_11_cm_long(reference_outcome, agree):
    # "about": to the centimetre
    length = reference_outcome.states["flat"].tendon_length
    agree("length of the flat wing's tendons", 100 * length, 11, unit="cm", by="the paper, about", abs=0.5)


def test_the_stiffest_tendon_without_resting_length_stores_more_than_35_joules(holds, reference):
    flat = settled(reference, {"tendon.stiffness": 6000.0, "tendon.rest_length": 0.0})
    holds("energy of a tendon, 60 N/cm, resting length 0", flat.tendon_energy, above=35, unit="J", by="the paper")


def test_the_softest_tendon_without_resting_length_stores_about_6_joules(reference, agree):
    flat = settled(reference, {"tendon.stiffness": 1000.0, "tendon.rest_length": 0.0})
    # "about": to the joule
    agree(
        "energy of a tendon, 10 N/cm, resting length 0", flat.tendon_energy, 6, unit="J", by="the paper, about", abs=0.5
    )


def test_with_equal_attachments_a_folded_tendon_without_resting_length_stores_little_energy(holds, reference):
    flat, folded = tendon_energy(with_values(reference, {"tendon.rest_length": 0.0}), [0.0, -math.pi])
    # the crease is not at right angles to the vein: the ends pass each other at a distance, from twice its slant:
    # (2 sin(theta / 2))^2 times the squared length for small epsilon
    holds("energy when folded divided by energy when flat", folded / flat, below=0.04, by="the crease's slant")

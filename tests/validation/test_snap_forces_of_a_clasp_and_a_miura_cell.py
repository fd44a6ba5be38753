"""A clasp and a Miura cell with rubber bands snap at the forces of their closed forms.

The clasp has two plates of lengths a and b with a hinge between them, a band from end to end,
L^2 = a^2 + b^2 + 2 a b cos t, and a force perpendicular to the held plate, whose lever is b cos t. Folds and sizes of
the cell are those of Schenk and Guest 2013, doi 10.1073/pnas.1217998110, equations 1 to 4; a force along its height H
is the derivative of its energy by H. Both have a stop, which statics model as a spring a million times as stiff as its
crease.
"""

import math
from functools import cache

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, simulate
from forficula.statics.net.energy import stored_by_part
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_landscape import slow_courses
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of

STOP = 1e6
CLASP, CELL = load_design("force-clasp"), load_design("bistable-miura")


def clasp_forces(design):
    """Fold angles, rad, and the force that would hold the clasp open against its band at these angles, N."""
    (near, far), crease, band = design.pattern.panel_lengths, design.crease, design.tendon[0]
    angle = np.linspace(-1.0, 1.5, 100_001)
    length = np.sqrt(near**2 + far**2 + 2 * near * far * np.cos(angle))
    spring = crease.stiffness * design.pattern.width
    pull = band.stiffness * np.maximum(length - band.rest_length, 0) * near * far * np.sin(angle) / length
    stops = np.maximum(angle - crease.fold_limit, 0) - np.maximum(-crease.back_limit - angle, 0)
    return angle, (pull - spring * (angle - crease.rest_angle) - STOP * spring * stops) / (far * np.cos(angle))


def cell_forces(design):
    """Heights, m, and the upward force that would hold the cell at these heights, N."""
    long, short, acute = design.pattern.long_side, design.pattern.short_side, design.pattern.acute_angle
    (zigzags, straights), band = design.crease.group, design.tendon[0]
    fold = np.linspace(0.1, 2.6, 200_001)
    share = 1 - (np.sin(fold / 2) * np.sin(acute)) ** 2
    height, across = long * np.sqrt(1 - share), 2 * short * np.sqrt(1 - np.cos(acute) ** 2 / share)

    def straight(fold):
        return 2 * np.arctan(np.cos(acute) * np.tan(fold / 2))

    zigzag_spring, rest = design.crease.stiffness * 2 * short, design.pattern.fold
    energy = zigzag_spring * ((fold - rest) ** 2 + STOP * np.maximum(fold - zigzags.fold_limit, 0) ** 2)
    energy += straights.stiffness * 2 * long * (straight(fold) - straight(rest)) ** 2
    energy += band.stiffness * np.maximum(across - band.rest_length, 0) ** 2
    return height, np.gradient(energy / 2, height)


def snaps(forces):
    """Largest upward force from the first state to the saddle, and largest downward force from the second state."""
    signs = np.flatnonzero(np.diff(np.sign(forces)))
    low, ridge, high = signs
    return forces[low:ridge].max(), -forces[ridge:high].min()


@cache
def slow(design):
    return {course.name: course.least for course in slow_courses(structure_of(design))}


def test_a_stiff_clasp_opens_and_closes_at_the_forces_of_the_closed_form(agree):
    """The deflection of the hinge under the band's pull is proportional to the stiffness of the hinge's own spring."""
    stiff = slow(with_values(CLASP, {"crease.extension": 3e7}))
    shut, opened = snaps(-clasp_forces(CLASP)[1])
    for name, closed_form in (("open", opened), ("shut", shut)):
        agree(f"least force, {name}", stiff[name], closed_form, unit="N", by="closed form", rel=3e-3)
    # in the example's design the hinge opens slightly
    agree("least force, open, as designed", slow(CLASP)["open"], opened, unit="N", by="closed form", rel=0.02)
    assert 5.0 < opened < 8.0


def test_a_miura_cell_with_stiff_facets_snaps_up_and_down_at_the_forces_of_the_closed_form(agree):
    _, forces = cell_forces(CELL)
    up, down = snaps(forces)
    stiff = slow(with_values(CELL, {"facet.youngs_modulus": 5e9, "facet.bend_stiffness": 1e3}))
    agree("least force, up", stiff["raise"], up, unit="N", by="Schenk and Guest 2013", rel=2e-3)
    agree("least force, down", stiff["lower"], down, unit="N", by="Schenk and Guest 2013", rel=5e-3)
    # soft facets bend under a force on one vertex, most near the stop, where its lever is short
    soft = slow(CELL)
    agree("least force, up, as designed", soft["raise"], up, unit="N", by="Schenk and Guest 2013", rel=0.05)
    assert down < soft["lower"] < 1.5 * down


def test_a_simulated_clasp_opens_at_the_force_of_statics():
    """The load grows over many periods of the closed clasp; statics and simulation share no code."""
    stages = CLASP.as_tables()["protocol"]["stages"]
    bear = stages[1] | {"until": "time", "time_limit": 0.12}
    least = slow(CLASP)["open"]
    designs = [
        with_values(
            CLASP,
            {"drive.load.value": share * least, "drive.load.rise": 0.08, "protocol.stages": [stages[0], bear]},
        )
        for share in (0.97, 1.03)
    ]
    records = simulate([compile_model(design) for design in designs])
    below, above = (np.degrees(record.series["hinge_angle"][-1, 0]) for record in records)
    assert below > 50
    assert above < -20


@pytest.mark.parametrize(
    ("name", "drive", "stage", "between"), [("raise", "pull", 2, 0.0237), ("lower", "press", 5, 0.026)]
)
def test_a_simulated_miura_cell_snaps_at_the_force_of_statics(name, drive, stage, between):
    """Compared at the height of the limit, with less damping than in the design; beyond it the cell passes flat."""
    least, stages = slow(CELL)[name], list(CELL.as_tables()["protocol"]["stages"])
    beyond = []
    slowly = stages[stage] | {"until": "time", "time_limit": 0.18}
    values = {f"drive.{drive}.rise": 0.12, "crease.damping": 2e-3, "protocol.stages": [*stages[:stage], slowly]}
    designs = [with_values(CELL, values | {f"drive.{drive}.force": share * least}) for share in (0.95, 1.05)]
    for record in simulate([compile_model(design) for design in designs]):
        heights = record.series["distance"][record.time > record.stages[-1].start, 0]
        beyond.append(heights.max() > between if name == "raise" else heights.min() < between)
    assert beyond == [False, True]


def test_the_band_of_a_clasp_closed_on_its_stop_stores_the_energy_of_its_length(agree):
    """A stop that yielded by 3.6 deg had left 36.8 mJ, with the band stretched by 10.8 mm."""
    stiff = structure_of(with_values(CLASP, {"crease.extension": 3e8}))
    net = net_of(stiff)
    _, creases, bands, *_ = stored_by_part(net, minimum(net, start_shape(stiff, net)).shape)
    length = math.sqrt(0.03**2 + 0.04**2 + 2 * 0.03 * 0.04 * math.cos(math.radians(60)))
    known = 800 / 2 * (length - 0.05) ** 2
    agree("energy of the band", 1e3 * bands, 1e3 * known, unit="mJ", by="law of cosines", rel=5e-4)
    # 0.02 N m/rad, turned by 30 deg
    agree("energy of the film", 1e3 * creases.sum(), 10 * math.radians(30) ** 2, unit="mJ", by="k x²/2", rel=1e-3)


def test_a_stop_yields_by_its_moment_divided_by_its_stiffness(agree):
    """The default stiffness is 1000 times that of the crease, 20 N m/rad for 0.02 N m/rad; a design can set another."""
    settle = {"protocol.stages": [CLASP.as_tables()["protocol"]["stages"][0]]}
    designs = [with_values(CLASP, settle | provided) for provided in ({}, {"crease.stop_stiffness": 500.0})]
    records = simulate([compile_model(design) for design in designs])
    for record, stiffness in zip(records, (20.0, 500 * 0.02), strict=True):
        angle = float(record.series["hinge_angle"][-1, 0])
        length = math.sqrt(0.03**2 + 0.04**2 + 2 * 0.03 * 0.04 * math.cos(angle))
        moment = 800 * (length - 0.05) * 0.03 * 0.04 * math.sin(angle) / length - 0.02 * (angle - math.radians(30))
        beyond = math.degrees(angle) - 60
        # the film opens by about 1 % of the lever
        agree(
            "deflection of a stop",
            beyond,
            math.degrees(moment / stiffness),
            unit="deg",
            by="moment divided by stiffness",
            rel=0.04,
        )

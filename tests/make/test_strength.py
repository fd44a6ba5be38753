"""Strengths of parts agree with closed forms of strength of materials."""

import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.make.as_made import as_made
from forficula.make.checks.strength_checks import BucklingColumn, column_of, euler_load, strength_checks
from forficula.make.hinge.stop_load import stop_load
from forficula.make.make_parts import make_parts
from forficula.make.solid.sections import bar_section, peg_modulus
from forficula.statics import tendon_hinges
from forficula.structure import structure_of
from tests.make.conftest import MADE

SECTION, MODULUS, LENGTH = bar_section(5e-3), 2e9, 0.11
# in the sheet's plane, in which a bar with a flat is stiffer
STIFF = math.pi**2 * MODULUS * SECTION.in_sheet / LENGTH**2


def column(offsets, lengths=(0.06, 0.05)):
    return BucklingColumn(lengths=lengths, offsets=np.array(offsets), section=SECTION, youngs_modulus=MODULUS)


def test_the_section_of_a_bar_with_a_flat_has_the_moments_of_its_polygon():
    # Green's theorem on a fine polygon
    angles = np.linspace(math.pi / 4, 2 * math.pi - math.pi / 4, 20001)
    x, y = 2.5e-3 * np.cos(angles), 2.5e-3 * np.sin(angles)
    ahead = np.roll(x, -1), np.roll(y, -1)
    cross = x * ahead[1] - ahead[0] * y
    area = cross.sum() / 2
    middle = np.array([((x + ahead[0]) * cross).sum(), ((y + ahead[1]) * cross).sum()]) / (6 * area)
    along = ((x**2 + x * ahead[0] + ahead[0] ** 2) * cross).sum() / 12 - area * middle[0] ** 2
    across = ((y**2 + y * ahead[1] + ahead[1] ** 2) * cross).sum() / 12 - area * middle[1] ** 2
    result = bar_section(5e-3)
    assert result.area == pytest.approx(area, rel=1e-6)
    # the flat is at the end of the first axis
    assert result.centre == pytest.approx(middle[0], rel=1e-6)
    assert (result.out_of_sheet, result.in_sheet) == pytest.approx((along, across), rel=1e-6)


def test_a_flat_reduces_the_stiffness_of_a_bar_by_a_quarter():
    # Euler: 2 GPa, 5 mm, 11 cm: 50 N; the flat takes 24 per cent of the least second moment
    full = math.pi / 64 * 5e-3**4
    assert math.pi**2 * 2e9 * full / 0.11**2 == pytest.approx(50, abs=0.5)
    assert bar_section(5e-3).least / full == pytest.approx(0.74, abs=0.02)


def test_strength_of_a_peg_with_flats_equals_the_sum_over_its_strips(joint_of):
    joint = joint_of(**{"make.peg_diameter": "6 mm"}).joints[0]
    z = np.linspace(0.2e-3 - joint.standoff, joint.top - joint.standoff, 200001)
    strips = 2 / 3 * (3e-3**2 - z**2) ** 1.5
    assert peg_modulus(joint, joint.proximal) == pytest.approx(np.trapezoid(strips, z) / 3e-3, rel=1e-6)
    # for the whole circle pi d^3 / 32; the flats reduce it by a twelfth
    assert 0.85 < peg_modulus(joint, joint.proximal) / (math.pi * 6e-3**3 / 32) < 0.95


@pytest.mark.parametrize("share", [0.01, 0.3, 0.7])
def test_a_column_pressed_beside_its_axis_bows_by_the_secant_formula(share):
    push = share * column(np.zeros((3, 2))).buckles_at
    bows = column([[1e-3, 0.0]] * 3, lengths=(LENGTH / 2, LENGTH / 2)).bows(push)
    secant = 1e-3 / math.cos(math.pi / 2 * math.sqrt(push / STIFF))
    assert np.abs(bows[:, 0]).max() == pytest.approx(secant, rel=1e-12)
    assert np.abs(bows[:, 1]).max() == 0


def test_a_bent_column_bows_as_a_chain_of_rods_and_springs_does():
    # v'' = -push / (E I) v away from the bend, by finite differences; at the bend the curvature is the
    # jump of the slope
    made, push, count = np.array([0.5e-3, 6e-3, -1e-3]), 0.6 * column(np.zeros((3, 2))).buckles_at, 1100
    step, bend = LENGTH / count, 600
    at = np.arange(1, count)
    rows = np.diag(np.full(count - 1, -2 + step**2 * push / (MODULUS * SECTION.in_sheet)))
    rows += np.diag(np.ones(count - 2), 1) + np.diag(np.ones(count - 2), -1)
    right = np.where(at == bend, -step * ((made[1] - made[0]) / 0.06 + (made[1] - made[2]) / 0.05), 0.0)
    right[0] -= made[0]
    right[-1] -= made[2]
    bows = column(np.column_stack([made, np.zeros(3)])).bows(push)[:, 0]
    assert bows[[0, -1]] == pytest.approx(made[[0, 2]])
    assert np.abs(bows).max() == pytest.approx(np.abs(np.linalg.solve(rows, right)).max(), rel=1e-4)


def test_a_straight_column_bears_eulers_load_and_a_bent_one_less():
    straight = column(np.zeros((3, 2)))
    # 50 N without its flat: 2 GPa, 5 mm, 11 cm
    assert straight.buckles_at == pytest.approx(SECTION.least / (math.pi / 64 * 5e-3**4) * 50, rel=0.01)
    assert straight.bears(44e6) == pytest.approx(euler_load(LENGTH, SECTION, MODULUS), rel=1e-5)
    # slightly bent to its stiffer side, it still buckles to the weaker one
    assert column([[0, 0], [0.1e-3, 0], [0, 0]]).bears(44e6) == pytest.approx(straight.buckles_at, rel=1e-5)
    bears = [column([[0, 0], [0, bend], [0, 0]]).bears(44e6) for bend in (1e-3, 3e-3, 7e-3)]
    assert straight.buckles_at > bears[0] > bears[1] > bears[2]


def test_a_section_is_stressed_as_its_outermost_fibres_are():
    # pure bending out of the sheet: the edges of the flat are further from the centroid than the round side
    reach = max(2.5e-3 + SECTION.centre, math.sqrt(0.5) * 2.5e-3 - SECTION.centre)
    assert SECTION.stress(0.0, np.array([0.0, 0.1])) == pytest.approx(0.1 * reach / SECTION.out_of_sheet, rel=1e-9)
    assert SECTION.stress(10.0, np.zeros(2)) == pytest.approx(10 / SECTION.area)


def test_the_line_of_a_tendon_passes_beside_bars_that_an_oblique_hinge_bends(made_joint):
    # 87.1 and 107.1 deg to the hinge: bars in the sheet at 194 deg, pegs at 58.5 and 51.5 mm on them
    joint, (place,) = made_joint.joints[0], made_joint.straps
    level = column_of(replace(joint, upper=0.0), place, MODULUS)
    p, d = 58.5e-3, 51.5e-3
    bend = math.acos(-float(joint.proximal.along @ joint.distal.along))
    chord = math.sqrt(p**2 + d**2 + 2 * p * d * math.cos(bend))
    assert abs(level.offsets[1, 0]) == pytest.approx(p * d * math.sin(bend) / chord, rel=1e-9)
    assert abs(level.offsets[1, 0]) > 6e-3
    assert level.offsets[:, 1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("offset", ["0 mm", "3 mm"])
def test_a_stop_takes_the_moment_that_the_tendon_has_there_in_closed_form(joint_of, offset):
    values = {"tendon.proximal_offset": offset, "tendon.distal_offset": offset, "make.anchors": "as designed"}
    parts = joint_of(**values, **{"make.straps": 1})
    joint, (place,) = parts.joints[0], parts.straps
    load = stop_load(parts.structure, joint, place, "overbend")
    (hinge, *_) = tendon_hinges(structure_of(as_made(parts, ("attachments", "offsets"))))
    assert load.by_tendon == pytest.approx(float(hinge.moment(joint.upper)), rel=1e-6)
    # the wing's drive on distal hinges opens with 1 N m
    assert (load.drive, load.by_drive) == ("unfold", pytest.approx(1.0))
    assert load.force == pytest.approx((load.by_tendon + 1.0) / 3.98e-3, rel=0.01)


def test_resultant_of_pull_and_stop_force_loads_the_pin(joint_of):
    parts = joint_of()
    output = {check.name: check for check in strength_checks(parts)}
    load = stop_load(parts.structure, parts.joints[0], parts.straps[0], "overbend")
    assert load.on_pin == pytest.approx(load.force - load.pull)
    assert f"up to {load.on_pin:.1f} N" in output["shear of the pin"].text


def test_straps_of_each_tendon_have_the_strength_of_their_material():
    settings = {"tendon.0.law": "tpu-82a", "tendon.0.area": "8 mm^2"}
    parts = make_parts(load_design("binder2025").with_values(MADE | settings), "section")
    output = {check.part: check for check in strength_checks(parts) if check.name == "straps tear"}
    # no source gives the strength of tpu-82a
    assert {name: (check.ok, check.text.split()[5]) for name, check in output.items()} == {
        "fold0": (None, "tpu-82a"),
        "fold1": (True, "tpu-95a"),
        "fold2": (True, "tpu-95a"),
    }

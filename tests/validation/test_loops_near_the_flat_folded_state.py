"""Load paths of rigid facets in loops agree with a closed form up to 0.5 deg before the flat-folded state.

In a Miura sheet the fold angles of zigzag creases are equal, and the half-angle tangents of straight creases are theirs
times the cosine of the acute angle (Schenk and Guest 2013, doi 10.1073/pnas.1217998110). The torque on every zigzag
crease follows from virtual work. Thick panels with shifted hinges move along the same angles, and split folds along
half of those of straight creases (Chen, Peng and You 2015, doi 10.1126/science.aab2870).
"""

import math

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.statics import quasi_static_path
from forficula.statics.net import plate_nodes, rigid_forces
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_landscape import slow_courses
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of

COSINE = math.cos(math.radians(60))


def sheet(method="none", thickness="1 um", **more):
    values = {"facet.thickness_method": method, "facet.thickness": thickness, "contact.thickness": "1 um"}
    return with_values(load_design("thick-miura"), values | more)


def straight_and_rate(zigzag):
    """Fold angle of straight creases, rad, and its derivative by that of zigzag creases."""
    tangent = np.tan(zigzag / 2)
    return 2 * np.arctan(COSINE * tangent), COSINE * (1 + tangent**2) / (1 + (COSINE * tangent) ** 2)


def torque(structure, zigzag, folds):
    """Torque on each zigzag crease by virtual work, N m, with straight creases split into some folds."""
    roles = np.array([hinge.role for hinge in structure.hinges])
    stiffness = np.array([hinge.stiffness for hinge in structure.hinges])
    start = min(abs(hinge.rest_angle) for hinge, role in zip(structure.hinges, roles, strict=True) if role == "zigzag")
    zigzags, others = stiffness[roles == "zigzag"], stiffness[roles != "zigzag"]
    angle, rate = straight_and_rate(zigzag)
    begin, _ = straight_and_rate(np.array(start))
    work = zigzags.sum() * (zigzag - start) + others.sum() * (angle - begin) / folds * rate / folds
    return work / len(zigzags)


@pytest.mark.parametrize(
    ("method", "thickness", "folds"), [("none", "1 um", 1), ("hinge-shift", "4 mm", 1), ("split", "4 mm", 2)]
)
def test_loops_stay_closed_up_to_half_a_degree_before_the_flat_folded_state(agree, method, thickness, folds):
    structure = structure_of(sheet(method, thickness))
    path = quasi_static_path(structure)
    assert path.reached
    assert not path.remarks
    assert [mark.kind for mark in path.marks] == ["goal"]  # without snaps
    zigzag = path.angles[:, [hinge.role == "zigzag" for hinge in structure.hinges]]
    assert np.degrees(zigzag[-1].min()) == pytest.approx(179.5)
    mean = zigzag.mean(axis=1)
    by, over = f"the closed form, {method}", ("fold angle (deg)", np.degrees(mean))
    agree("fold angles of zigzag creases", np.degrees(zigzag), np.degrees(zigzag[:, :1]), by=by, unit="deg", abs=1e-5)
    known = np.degrees(straight_and_rate(mean)[0])[:, None] / folds
    others = np.degrees(path.angles[:, [hinge.role != "zigzag" for hinge in structure.hinges]])
    agree("fold angles of straight creases", others, known, by=by, unit="deg", abs=1e-4)
    expected = torque(structure, mean, folds)
    agree("torque", 100 * path.strength, 100 * expected, by=by, unit="N cm", rel=1e-6, abs=1e-9, over=over)


def test_the_least_torque_of_the_landscape_is_that_of_the_closed_form_at_the_goal(agree):
    structure = structure_of(sheet("hinge-shift", "4 mm"))
    known = torque(structure, np.radians(179.5), 1)
    least = slow_courses(structure)[0].least
    agree("least slow torque", 100 * least, 100 * known, by="virtual work", unit="N cm", rel=1e-6)


def test_the_stiffness_of_bars_and_pins_does_not_change_where_a_loop_rests(monkeypatch, holds):
    structure = structure_of(sheet(**{"crease.rest_angle": "175 deg"}))
    angles = []
    for stiffness in (1e5, 1e6, 1e7):
        monkeypatch.setattr(plate_nodes, "_STIFF", stiffness)
        net = net_of(structure)
        rest = minimum(net, start_shape(structure, net))
        assert rest.stable
        assert rigid_forces.is_exact(net, rest.shape)
        angles.append(np.degrees(rest.shape.angles))
    apart = np.ptp(angles, axis=0).max()
    holds("difference of fold angles", apart, below=1e-6, unit="deg", by="other stiffnesses of bars and pins")


def test_a_path_that_cannot_close_its_loops_ends_before_its_goal_with_a_remark():
    design = sheet()
    stages = [stage.model_copy(update={"until": "zigzag > 179.9 deg"}) for stage in design.protocol.stages[:1]]
    path = quasi_static_path(with_values(design, {"protocol.stages": stages}))
    assert not path.reached
    assert np.degrees(path.angles.max()) > 179.5
    assert any("statics cannot close loops of facets exactly" in remark for remark in path.remarks)


def test_equilibria_of_loops_that_are_not_closed_exactly_are_reported_as_unreliable(monkeypatch):
    monkeypatch.setattr(rigid_forces, "_STEPS", 0)
    structure = structure_of(sheet())
    net = net_of(structure)
    rest = minimum(net, start_shape(structure, net))
    (remark,) = rigid_forces.loop_remarks(net, 'in "folded"', [rest.shape])
    assert remark.startswith('in "folded", loops of facets are not closed exactly in 1 of 1 equilibria')
    assert remark.endswith("are unreliable")

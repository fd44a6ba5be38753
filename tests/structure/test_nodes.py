"""Sheets of nodes: positions, bars and creases, supports and drives."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import in_units, load_design, with_values
from forficula.errors import InputError
from forficula.pattern import miura_pattern, pleat_pattern, write_fold
from forficula.structure import GROUND, built_creases, built_points, goal_of, measure_of, structure_of

MIURA = load_design("miura-sheet")
CLASP = load_design("bistable-clasp")
BAND = {"name": "band", "from": "vertex 2", "to": "vertex 4", "stiffness": 1.0, "rest_length": 0.05}
WAIT = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 1.0}


def bare(design, **values):
    """A design without drives, tendons and measures."""
    nothing = {"tendon": [], "support": [], "drive": [], "measure": [], "protocol.stages": [WAIT]}
    return with_values(design, nothing | values)


def spring_energy(structure, points):
    """Energy of all bars, J."""
    ends = np.array([spring.points for spring in structure.springs])
    lengths = np.linalg.norm(points[ends[:, 1]] - points[ends[:, 0]], axis=1)
    rest = np.array([spring.rest_length for spring in structure.springs])
    stiffness = np.array([spring.stiffness for spring in structure.springs])
    return float((stiffness * (lengths - rest) ** 2 / 2).sum())


def test_every_vertex_is_a_node_and_their_masses_add_up_to_the_sheet():
    structure, sheet = structure_of(MIURA), MIURA.sheet
    assert built_points(structure)[:25] == pytest.approx(sheet.vertices_coords, abs=1e-15)
    area = 16 * 0.02**2 * math.sin(math.radians(60))
    assert sum(body.mass for body in structure.bodies) == pytest.approx(1270 * 0.2e-3 * area)
    assert {body.parent for body in structure.bodies} == {GROUND}
    assert [len(facet.points) for facet in structure.facets] == [4] * 16


@settings(max_examples=20, deadline=None)
@given(
    sides=st.tuples(*[st.floats(0.01, 0.05)] * 2), angle=st.floats(30, 85), fold=st.floats(0, 150), nu=st.floats(0, 0.4)
)
def test_bars_store_the_energy_of_the_evenly_stretched_sheet(sides, angle, fold, nu):
    """E S t e^2 / (1 - nu) of a sheet of area S under the strain e in all directions (plane stress)."""
    design = bare(
        MIURA,
        **{
            "pattern.long_side": sides[0],
            "pattern.short_side": sides[1],
            "pattern.acute_angle": math.radians(angle),
            "pattern.fold": math.radians(fold),
            "facet.youngs_modulus": 3e9,
            "facet.poisson_ratio": nu,
        },
    )
    structure, strain = structure_of(design), 1e-3
    area = 16 * sides[0] * sides[1] * math.sin(math.radians(angle))
    stored = spring_energy(structure, (1 + strain) * built_points(structure))
    assert stored == pytest.approx(3e9 * area * 0.2e-3 * strain**2 / (1 - nu), rel=1e-9)


def test_creases_rest_as_built_or_flat_or_at_an_angle():
    for rest, where in (("as built", None), ("flat", 0.0), (0.7, 0.7)):
        structure = structure_of(bare(MIURA, **{"crease.rest_angle": rest}))
        creases = [hinge for hinge in structure.hinges if hinge.role != "facet bend"]
        for hinge in creases:
            assert hinge.rest_angle == (hinge.start if where is None else where)
        # as built they are folded as assigned, by the closed form of Miura's vertices
        zigzag = {round(math.degrees(hinge.start), 9) for hinge in creases if hinge.role == "zigzag"}
        straight = 2 * math.atan(math.cos(math.radians(60)) * math.tan(math.radians(15)))
        assert zigzag == {30.0}
        assert [hinge.start for hinge in creases if hinge.role == "straight"] == pytest.approx([straight] * 12)
    assert [hinge.start for hinge in structure.hinges] == pytest.approx(built_creases(structure).tolist(), abs=1e-12)


def test_the_stiffness_of_a_crease_is_proportional_to_its_length():
    structure = structure_of(bare(MIURA, **{"pattern.long_side": 0.03}))
    stiffness = {hinge.role: hinge.stiffness for hinge in structure.hinges}
    assert stiffness["straight"] == pytest.approx(2e-2 * 0.03)
    assert stiffness["zigzag"] == pytest.approx(2e-2 * 0.02)


def test_facets_bend_along_their_diagonals():
    structure = structure_of(bare(MIURA, **{"facet.bend_stiffness": 0.5}))
    bends = [hinge for hinge in structure.hinges if hinge.role == "facet bend"]
    assert len(bends) == 16
    # the shorter diagonal of a rhombus of 60 deg is as long as its sides
    assert [hinge.stiffness for hinge in bends] == pytest.approx([0.5 * 0.02] * 16)
    assert [hinge.rest_angle for hinge in bends] == pytest.approx([0.0] * 16, abs=1e-12)
    assert len([spring for spring in structure.springs if spring.role == "diagonal"]) == 16


def test_groups_differ_from_the_others():
    group = {"name": "gates", "of": "role:zigzag and assignment:M", "stiffness": 0.3, "law": "locking"}
    measure = {"name": "gate", "kind": "fold-angle", "of": "gates"}
    structure = structure_of(bare(MIURA, **{"crease.group": [group], "measure": [measure]}))
    watched = measure_of(structure, "gate").hinges
    assert 0 < len(watched) < 12
    for number, hinge in enumerate(structure.hinges):
        if number in watched:
            assert (hinge.role, hinge.sense) == ("zigzag", -1)
            assert hinge.stiffness == pytest.approx(0.3 * 0.02)
            assert (hinge.lock_below, hinge.lock_above) == pytest.approx((-math.radians(135), math.radians(135)))
        elif hinge.role != "facet bend":
            assert hinge.stiffness == pytest.approx(2e-2 * 0.02)
            assert hinge.lock_above == math.inf


def test_supports_hold_facets_vertices_and_single_axes():
    held = [{"of": "facet 5"}, {"of": "vertex 0", "axes": "xz"}, {"of": "vertex 0", "axes": "z"}, {"of": "vertex 24"}]
    structure = structure_of(bare(MIURA, support=held))
    slides = [body.slides for body in structure.bodies]
    assert [slides[node] for node in (0, 24)] == [(1,), ()]
    assert all(slides[node] == () for node in MIURA.sheet.faces_vertices[5])
    assert sum(slide == (0, 1, 2) for slide in slides) == 25 - 4 - 2


def test_a_sheet_opens_along_a_cut(tmp_path):
    sheet = pleat_pattern([0.1, 0.1, 0.1], 0.2, "MV")
    write_fold(sheet, tmp_path / "strip.fold")
    text = (tmp_path / "strip.fold").read_text().replace('"M"', '"C"', 1).replace("-180.0", "null", 1)
    (tmp_path / "strip.fold").write_text(text)
    pattern = {"pattern.kind": "fold-file", "pattern.path": str(tmp_path / "strip.fold")}
    structure = structure_of(bare(MIURA, **pattern, support=[{"of": "vertex 1 of facet 1"}]))
    assert len(structure.bodies) == 10
    assert [hinge.name for hinge in structure.hinges if hinge.role != "facet bend"] == ["crease1"]
    assert [body.name for body in structure.bodies if not body.slides] == ["vertex1_1"]
    assert not set(structure.facets[0].points) & set(structure.facets[1].points)


def test_a_drive_moves_rest_angles_to_their_targets():
    drive = {"name": "fold", "kind": "rest-angle", "of": "creases", "to": "target"}
    stage = {"name": "fold", "drive": "fold", "until": "target", "state": "folded", "hold": 0.0, "time_limit": 1.0}
    structure = structure_of(bare(MIURA, drive=[drive], **{"protocol.stages": [stage]}))
    (motor,), (driven,) = structure.motors, structure.drives
    assert motor.kind == "rest-angle"
    for hinge, gain in zip(motor.hinges, motor.gains, strict=True):
        end = structure.hinges[hinge].rest_angle + gain * driven.strength
        assert end == pytest.approx(math.pi)
    # and that is the goal "target", within 5 deg
    goal = goal_of(structure, "target")
    assert goal.least[list(motor.hinges)] == pytest.approx([math.radians(175)] * 24)
    assert np.isneginf(goal.least[24:]).all()


def test_a_force_acts_at_vertices_along_its_direction():
    drive = {"name": "pull", "kind": "force", "of": ["vertex 3", "vertex 24"], "direction": [0, 3, -4], "force": 0.2}
    structure = structure_of(bare(MIURA, drive=[drive]))
    (motor,), (driven,) = structure.motors, structure.drives
    assert (motor.kind, motor.points, driven.strength, driven.key) == ("force", (3, 24), 0.2, "drive.pull.force")
    assert motor.direction.tolist() == pytest.approx([0, 0.6, -0.8])


@pytest.mark.parametrize("axes", [None, "yz"])
def test_a_force_needs_a_vertex_that_is_free_in_its_direction(axes):
    values = {"drive": [{"name": "pull", "kind": "force", "of": "vertex 3", "direction": [0, 0, -1], "force": 0.2}]}
    message = r'drive\.0\.of: need a vertex that is free along drive\.0\.direction, got "vertex 3"'
    with pytest.raises(InputError, match=message):
        structure_of(bare(MIURA, support=[{"of": "vertex 3", "axes": axes}], **values))
    (motor,) = structure_of(bare(MIURA, support=[{"of": "vertex 3", "axes": "xy"}], **values)).motors
    assert motor.points == (3,)


def test_ends_on_the_ground_do_not_move():
    measure = {"name": "height", "kind": "distance", "from": "vertex 0", "to": "ground", "ground": [0.0, 0.0, -0.2]}
    structure = structure_of(bare(load_design("waterbomb-base"), measure=[measure]))
    start, end = measure_of(structure, "height").points
    assert (structure.points[start].name, structure.points[end].body) == ("vertex0", GROUND)
    assert built_points(structure)[end].tolist() == [0, 0, -0.2]


def test_a_tendon_is_never_longer_than_the_path_along_edges():
    structure = structure_of(CLASP)
    (tendon,) = structure.tendons
    assert tendon.longest == pytest.approx(0.08)
    assert np.linalg.norm(np.diff(built_points(structure)[list(tendon.points)], axis=0)) < tendon.longest


def test_a_tendon_can_have_the_law_of_a_material():
    band = {key: value for key, value in BAND.items() if key != "stiffness"} | {"law": "tpu-82a", "area": 2e-6}
    design = with_values(CLASP, {"tendon": [band]})
    (tendon,) = structure_of(design).tendons
    assert tendon.material.name == "tpu-82a"
    assert tendon.law.stiffness[0] == pytest.approx(4.8e6 * 2e-6 / 0.05)
    (spring,) = structure_of(with_values(design, {"tendon.band.law": "none"})).tendons
    assert (spring.material, spring.law.stiffness[0]) == (None, pytest.approx(tendon.law.stiffness[0]))


def test_a_membrane_spans_all_triangles():
    structure = structure_of(bare(MIURA, **{"facet.kind": "membrane", "pattern.fold": 0.0}))
    (membrane,) = structure.membranes
    assert (len(membrane.triangles), len(structure.springs)) == (32, 0)


def test_a_structure_in_other_units_is_the_same():
    units = {"length": 1e-2, "mass": 1e-3, "time": 1e-2}
    one, other = structure_of(CLASP), structure_of(in_units(CLASP, **units))
    per_length = units["mass"] / units["time"] ** 2
    for current, present in zip(one.springs, other.springs, strict=True):
        assert present.stiffness * per_length == pytest.approx(current.stiffness)
        assert present.damping * units["mass"] / units["time"] == pytest.approx(current.damping)
    for current, present in zip(one.hinges, other.hinges, strict=True):
        assert present.stiffness * per_length * units["length"] ** 2 == pytest.approx(current.stiffness)
        assert present.rest_angle == current.rest_angle
    assert [body.mass * 1e-3 for body in other.bodies] == pytest.approx([body.mass for body in one.bodies])


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"support": [{"of": "vertex 99"}]}, r"support\.0\.of: need a vertex from 0 to 24, got 99"),
        ({"support": [{"of": "side 3"}]}, r'support\.0\.of: need a vertex such as "vertex 4"'),
        ({"crease.start": 0.1}, r"crease\.start: is for rigid facets"),
        (
            {"crease.fold_limit": 0.5},
            r"crease\.fold_limit: need >= 30 deg, at which crease \d+ is built, got 28\.65 deg",
        ),
        ({"crease.group": [{"of": "role:zigzg"}]}, r'crease\.group\.0\.of: need .*; did you mean "role:zigzag"'),
        (
            {"crease.group": [{"of": "role:zigzag and crease 0"}]},
            "need creases that are all of these at once, got none",
        ),
        (
            {"drive": [{"name": "a", "kind": "torque", "of": "crease 99", "value": 1.0}]},
            r"drive\.0\.of: need .*, got \"crease 99\"",
        ),
        (
            {"drive": [{"name": "a", "kind": "force", "of": "vertex 1", "value": 1.0}]},
            r"drive\.0\.direction: is missing",
        ),
        (
            {"drive": [{"name": "a", "kind": "torque", "of": "creases", "angle": 1.0}]},
            r'drive\.0\.angle: is not for kind = "torque"',
        ),
        (
            {
                "tendon": [
                    {"name": "a", "from": "facet 99 at centre", "to": "vertex 1", "stiffness": 1.0, "rest_length": 0.1}
                ]
            },
            r"tendon\.0\.from: need a facet from 0 to 15, got 99",
        ),
        (
            {"measure": [{"name": "a", "kind": "distance", "from": "vertex 1", "to": "ground"}]},
            r"measure\.0\.ground: need x, y and z",
        ),
    ],
)
def test_what_cannot_be_built_is_refused(values, message):
    with pytest.raises(InputError, match=message):
        bare(MIURA, **values)


def test_a_facet_that_is_not_flat_cannot_be_rigid():
    sheet = miura_pattern(2, 1, 0.02, 0.02, 1.0)
    coords = sheet.vertices_coords.copy()
    coords[0, 2] = 0.001
    values = {"kind": "fold-file", "vertices_x": coords[:, 0].tolist(), "vertices_y": coords[:, 1].tolist()}
    values |= {"vertices_z": coords[:, 2].tolist(), "edges": sheet.edges_vertices.tolist()}
    values |= {"assignment": "".join(sheet.edges_assignment), "facets": [list(face) for face in sheet.faces_vertices]}
    assert len(structure_of(bare(MIURA, pattern=values)).bodies) == 6
    with pytest.raises(InputError, match=r"need flat facets to be rigid, got facet 0, which is not"):
        bare(MIURA, pattern=values, **{"facet.kind": "rigid"})

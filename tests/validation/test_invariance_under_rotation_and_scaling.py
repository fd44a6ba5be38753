"""Rotating a sheet in space, renumbering its vertices and scaling it change neither fold angles nor scaled energies.

Dimensional analysis: at fixed modulus and density energies are proportional to the cube of the size, and times to the
size (Ilton et al. 2018, arXiv 1711.04920).
"""

import json
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from forficula.design import scale_design, with_values
from forficula.dynamics import compile_model, simulate
from forficula.pattern import miura_pattern, write_fold
from forficula.statics.net import minimum
from forficula.statics.net.net_of import motor_load, net_of, start_shape
from tests.sheets import fold_angles, sheet_design, stage, stored_energy

VALUES = {
    "facet.youngs_modulus": 2e7,
    "facet.bend_stiffness": 0.5,
    "crease.rest_angle": "as built",
    "crease.damping": 2e-4,
    "drive": [{"name": "fold", "kind": "torque", "of": "crease 0", "value": 1.2e-3, "rise": 0.02}],
    "protocol.timestep": 4e-5,
    "protocol.stages": [stage("fold", limit=0.06)],
}
MIURA = miura_pattern(2, 2, 0.03, 0.02, np.deg2rad(65), 0.7)


def turned(pattern, rotation, shift=(0.0, 0.0, 0.0)):
    return replace(pattern, vertices_coords=pattern.vertices_coords @ rotation.as_matrix().T + np.asarray(shift))


def renumbered(pattern, order):
    """The same sheet with vertex `order[k]` as number k."""
    place = np.argsort(order)
    return replace(
        pattern,
        vertices_coords=pattern.vertices_coords[order],
        edges_vertices=place[pattern.edges_vertices],
        faces_vertices=tuple(tuple(int(place[vertex]) for vertex in face) for face in pattern.faces_vertices),
    )


def moved(pattern):
    (record,) = simulate([compile_model(sheet_design(pattern, VALUES))])
    return record


def rest_of(design):
    """Static rest of a design's sheet under its drive: fold angles and energy."""
    record_structure = compile_model(design).structure
    net = net_of(record_structure)
    load = motor_load(record_structure, net, tuple(drive.value for drive in design.drive))
    return minimum(net, start_shape(record_structure, net), load, 1.0)


@cache
def known():
    return moved(MIURA)


def assert_alike(agree, record, tolerance):
    angles, edges = fold_angles(record)
    expected, known_edges = fold_angles(known())
    assert edges.tolist() == known_edges.tolist()
    assert np.ptp(expected[:, 0]) > 0.2
    agree("fold angles", angles, expected, unit="rad", by="original sheet", abs=tolerance)
    energy = stored_energy(known())
    ours, theirs = stored_energy(record) / energy.max(), energy / energy.max()
    agree("energy divided by its largest value", ours, theirs, by="original sheet", abs=tolerance)


ANGLES = st.floats(-np.pi, np.pi)


@settings(max_examples=2, phases=(Phase.explicit, Phase.generate))
@given(ANGLES, ANGLES, ANGLES, st.lists(st.floats(-0.1, 0.1), min_size=3, max_size=3))
def test_rotating_and_shifting_a_sheet_does_not_change_its_folding(agree, about_z, about_y, about_x, shift):
    rotation = Rotation.from_euler("zyx", (about_z, about_y, about_x))
    # rounding, amplified by the sheet's motion
    assert_alike(agree, moved(turned(MIURA, rotation, shift)), 1e-7)


@settings(max_examples=2, phases=(Phase.explicit, Phase.generate))
@given(st.permutations(range(9)))
def test_renumbering_the_vertices_of_a_sheet_does_not_change_its_folding(agree, order):
    assert_alike(agree, moved(renumbered(MIURA, np.array(order))), 1e-7)


def test_rotating_a_fold_file_and_changing_its_unit_does_not_change_its_folding(agree, tmp_path):
    write_fold(turned(MIURA, Rotation.from_euler("z", 0.3)), tmp_path / "sheet.fold")
    document = json.loads((tmp_path / "sheet.fold").read_text())
    document["vertices_coords"] = (1000 * np.array(document["vertices_coords"])).tolist()
    document["frame_unit"] = "mm"
    (tmp_path / "sheet.fold").write_text(json.dumps(document))
    values = {"pattern": {"kind": "fold-file", "path": str(tmp_path / "sheet.fold")}}
    design = with_values(sheet_design(MIURA, VALUES), values)
    assert_alike(agree, simulate([compile_model(design)])[0], 1e-7)


@pytest.mark.parametrize("factor", [0.1, 1 / 3, 7.0])
def test_a_sheet_of_another_size_folds_identically_in_scaled_time(agree, factor):
    scaled = scale_design(sheet_design(MIURA, VALUES), factor)
    (record,) = simulate([compile_model(scaled)])
    by = "the sheet as it was"
    agree("times divided by the size", record.time / factor, known().time, unit="s", by=by, rel=1e-12)
    agree("fold angles", fold_angles(record)[0], fold_angles(known())[0], unit="rad", by=by, abs=1e-7)
    largest = stored_energy(known()).max()
    ours, theirs = stored_energy(record) / factor**3 / largest, stored_energy(known()) / largest
    agree("energy divided by size³ and its largest value", ours, theirs, by=by, abs=1e-7)


def test_static_equilibria_do_not_depend_on_orientation_numbering_and_scale(agree):
    design = sheet_design(MIURA, VALUES)
    rest = rest_of(design)
    assert rest.stable
    turn = Rotation.from_euler("zyx", (0.4, 1.1, -2.0))
    order = np.random.default_rng(3).permutation(9)
    for other, scale in (
        (sheet_design(turned(MIURA, turn), VALUES), 1.0),
        (sheet_design(renumbered(MIURA, order), VALUES), 1.0),
        (scale_design(design, 0.2), 0.2),
    ):
        present = rest_of(other)
        by = "the sheet as it was"
        agree("fold angles at rest", present.shape.angles, rest.shape.angles, unit="rad", by=by, abs=1e-7)
        agree(
            "energy at rest divided by size³",
            1e6 * present.energy / scale**3,
            1e6 * rest.energy,
            unit="µJ",
            by=by,
            rel=1e-7,
        )

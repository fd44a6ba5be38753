"""Masses and inertias of solids agree with closed forms, and with an independent program."""

import math

import numpy as np
import pytest

from forficula.make.solid.mass_properties import mesh_properties, parts_properties
from forficula.make.solid.mesh import mesh_of, solid_of
from forficula.make.solid.solids import Rod, box
from forficula.pattern.rotation import rotation_about

DENSITY = 1270.0


def properties(solid):
    return mesh_properties(mesh_of(solid_of(solid)), DENSITY)


def test_a_box_has_the_inertia_of_its_closed_form_wherever_it_is():
    sides, frame = np.array([12e-3, 5e-3, 40e-3]), rotation_about(np.array([0.6, 0.0, 0.8]), 0.7)
    origin = np.array([0.3, -0.1, 0.05])
    result = properties(box((0, 0, 0), tuple(sides), origin, frame))
    mass = DENSITY * sides.prod()
    principal = mass / 12 * np.diag((sides**2).sum() - sides**2)
    assert result.mass == pytest.approx(mass, rel=1e-6)
    assert result.centre == pytest.approx(origin + frame @ sides / 2, abs=1e-9)
    assert result.inertia == pytest.approx(frame @ principal @ frame.T, rel=1e-5, abs=1e-12)


def test_a_rod_has_the_inertia_of_a_cylinder_about_its_end():
    diameter, length = 5e-3, 0.1
    result = properties(Rod(start=np.zeros(3), end=np.array([0, 0, length]), diameter=diameter))
    mass = DENSITY * math.pi / 4 * diameter**2 * length
    across = mass * ((diameter / 2) ** 2 / 4 + length**2 / 3)
    assert result.about(np.array([1.0, 0, 0]), np.zeros(3)) == pytest.approx(across, rel=1e-5)
    # a polygon of the same area has a slightly larger second moment of area
    assert result.about(np.array([0, 0, 1.0]), np.zeros(3)) == pytest.approx(mass * (diameter / 2) ** 2 / 2, rel=1e-5)


def test_a_half_of_a_joint_has_the_mass_and_inertia_that_trimesh_finds(made_joint):
    trimesh = pytest.importorskip("trimesh")
    (part,) = made_joint.of_body(made_joint.joints[0].distal.body)
    mesh = mesh_of(part.shape)
    theirs = trimesh.Trimesh(mesh.points / 1e3, mesh.triangles, process=False)
    theirs.density = part.stock.density
    ours = parts_properties([part])
    assert theirs.is_watertight
    assert ours.mass == pytest.approx(theirs.mass, rel=1e-9)
    assert ours.centre == pytest.approx(theirs.center_mass, abs=1e-10)
    assert ours.inertia == pytest.approx(theirs.moment_inertia, rel=1e-6, abs=1e-14)

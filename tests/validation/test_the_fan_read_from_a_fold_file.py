"""The fan of binder2025, written as FOLD and read as a general sheet, folds along its closed form.

With the magnitudes p of the fold angle of the veins and r of the ring creases, tan(r / 2) = sin(epsilon) /
cos(sector_angle / 2) tan(p / 2) (`fan_fold_angles`; flat-foldable vertices of four creases, Huffman 1976; Tachi 2009).
"""

from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate
from forficula.pattern import earwig_pattern, fan_fold_angles, write_fold
from forficula.statics.net import minimum
from forficula.statics.net.net_of import bends, net_of, start_shape
from forficula.structure import structure_of
from tests.sheets import BARS, fold_angles, stage

FAN = load_design("binder2025").fan
PLEATS = ("proximal", "distal")


def of_its_file(fan, folder, values):
    """Design of the fan's FOLD file with driven pleats."""
    write_fold(earwig_pattern(fan), folder / "fan.fold")
    kept = {"pattern": {"kind": "fold-file", "path": str(folder / "fan.fold")}}
    return with_values(load_design("miura-sheet"), BARS | kept | values)


def assert_on_the_path(agree, fan, angles, edges, tolerance):
    """Compare fold angles, (time, crease), at several times with those of the closed form for the mean pleat."""
    pattern = earwig_pattern(fan)
    pleats = np.isin(np.array(pattern.edges_role)[edges], PLEATS)
    sizes = np.abs(angles[:, pleats]).mean(axis=1)
    assert sizes.max() > np.deg2rad(95)
    for size in np.deg2rad((10, 30, 50, 70, 90)):
        place = int(np.argmax(sizes > size))
        known = fan_fold_angles(fan, sizes[place])[edges]
        ours, theirs = np.rad2deg(angles[place]), np.rad2deg(known)
        agree("fold angles", ours, theirs, unit="deg", by="Huffman 1976, Tachi 2009", abs=tolerance)


@pytest.mark.parametrize(("units", "sector", "tolerance"), [(1, 20, 0.05), (2, 15, 0.7)])
def test_rigid_plates_fold_along_the_closed_form(agree, holds, tmp_path, units, sector, tolerance):
    """One loop agrees to 0.05 deg; three loops, each closed to about 1e-5 of an edge, deviate by their gaps."""
    fan = replace(FAN, units=units, sector_angle=np.deg2rad(sector))
    values = {
        "facet.kind": "rigid",
        "crease.stiffness": 0.1,
        "crease.damping": 3e-3,
        "drive": [{"name": of, "kind": "torque", "of": f"role:{of}", "value": 0.02, "rise": 0.2} for of in PLEATS],
        "protocol.timestep": 1e-4,
        "protocol.stages": [stage("pleats", limit=0.4) | {"drive": list(PLEATS)}],
    }
    (record,) = simulate([compile_model(of_its_file(fan, tmp_path, values))])
    assert_on_the_path(agree, fan, *fold_angles(record), tolerance)
    holds("missing energy", energy_balance(record).residual, below=5e-3, by="conservation of energy")


def test_nets_of_bars_move_along_the_closed_form(agree, holds, tmp_path):
    """They agree to 0.5 deg: springs drive the pleats against bars 3e7 and bends 1e3 times as stiff.

    The hub is narrow: its ends lie 0.9 mm from the vein that their facets turn about, and a crease that is not soft
    beside the bars pulls them through it.
    """
    drive = {"kind": "rest-angle", "angle": 2.6, "rise": 0.14}
    values = {
        "facet.youngs_modulus": 3e9,
        "facet.bend_stiffness": 2.0,
        "crease.stiffness": 2e-3,
        "crease.damping": 1e-5,
        "drive": [drive | {"name": of, "of": f"role:{of}"} for of in PLEATS],
        "protocol.timestep": 2e-5,
        "protocol.stages": [stage("pleats", limit=0.2) | {"drive": list(PLEATS)}],
    }
    (record,) = simulate([compile_model(of_its_file(FAN, tmp_path, values))])
    assert_on_the_path(agree, FAN, *fold_angles(record), 0.5)
    holds("missing energy", energy_balance(record).residual, below=5e-3, by="conservation of energy")


def test_nets_of_bars_rest_on_the_closed_form(agree, tmp_path):
    """Statics agree to 0.05 deg: springs drive the pleats, with bars 1e6 times as stiff as the creases."""
    values = {
        "facet.youngs_modulus": 5e9,
        "facet.bend_stiffness": 10.0,
        "crease.stiffness": 1e-2,
        "crease.group": [{"of": "role:ring", "stiffness": 1e-4}],
        "protocol.stages": [stage()],
    }
    design = of_its_file(FAN, tmp_path, values)
    built = structure_of(design)
    net, angles = net_of(built), []
    pattern = earwig_pattern(FAN)
    edges = np.array([int(hinge.name.removeprefix("crease")) for hinge in built.hinges if hinge.role != "facet bend"])
    shape = start_shape(built, net)
    for goal in np.deg2rad((15, 35, 55, 75, 95, 110, 130, 150)):
        rests = np.zeros(len(built.hinges))
        pleats = np.isin(np.array(pattern.edges_role)[edges], PLEATS)
        rests[: len(edges)] = np.where(pleats, goal * np.sign(pattern.edges_fold_angle[edges]), 0.0)
        law = replace(net.creases.law, rest_angle=rests)
        rest = minimum(replace(net, creases=replace(net.creases, law=law)), shape, longest_step=5e-3)
        assert rest.stable
        shape = rest.shape
        angles.append(shape.angles[~bends(built)])
    assert_on_the_path(agree, FAN, np.array(angles), edges, 0.05)

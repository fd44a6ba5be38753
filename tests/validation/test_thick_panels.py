"""Thick panels fold flat along the fold angles of the sheet without thickness.

Bennett linkages: Bennett 1903; thick vertices of four creases: Chen, Peng and You 2015, doi 10.1126/science.aab2870.
Trimmed panels: Tachi 2011, Rigid-foldable thick origami. Half-angle tangents: Huffman 1976; Tachi 2009.
"""

import math
from itertools import combinations

import numpy as np
import pytest

from forficula import quasi_static_path
from forficula.analysis.contact_overlap import contact_overlap
from forficula.analysis.crossing_facets import facets_that_cross
from forficula.analysis.package import flat_package
from forficula.design import with_values
from forficula.dynamics import compile_model, simulate
from forficula.statics.tree.pose import pose, tree_of
from forficula.structure import built_hinges, mass_of, structure_of
from tests.plate_sheets import miura as square_miura
from tests.plate_sheets import plates, pleats, vertex

THICK = 0.001
CREASE = 'stiffness = "1e-3 N m/rad/m"\nrest_angle = "75 deg"\ndamping = "0 N m s/rad/m"'


def facet(method):
    """Rigid facets of 1 mm, which the helper `plates` writes with a thickness of its own."""
    return f'kind = "rigid"\nthickness_method = "{method}"'


def miura(columns, rows, fold):
    return square_miura(columns, fold).replace(f"rows = {columns}", f"rows = {rows}")


def thick(pattern, method, *, crease=CREASE, **more):
    design = plates(pattern, crease=crease, facet=facet(method), **more)
    return with_values(design, {"facet.thickness": THICK})


def straight_angles(zigzag):
    """Straight creases of a Miura sheet of 60 deg: tan(straight / 2) = cos(60 deg) tan(zigzag / 2)."""
    return 2 * np.arctan2(math.cos(math.radians(60)) * np.sin(zigzag / 2), np.cos(zigzag / 2))


def around_the_vertex(structure):
    """Positions and directions of the axes of the four creases at the vertex, in their order around it."""
    origins, axes = built_hinges(structure)
    edges = [hinge.edge for hinge in structure.hinges]
    order = np.argsort(edges)
    return origins[order], axes[order]


@pytest.mark.parametrize("sectors", [(60, 60, 120, 120), (50, 95, 130, 85), (70, 80, 110, 100)])
def test_the_axes_of_shifted_hinges_form_a_bennett_linkage(agree, sectors):
    structure = structure_of(thick(vertex(sectors, "VMMM", fold="25 deg"), "hinge-shift"))
    origins, axes = around_the_vertex(structure)
    lengths, twists, feet = [], [], []
    for first in range(4):
        second = (first + 1) % 4
        normal = np.cross(axes[first], axes[second])
        between = origins[second] - origins[first]
        lengths.append(abs(between @ normal) / np.linalg.norm(normal))
        twists.append(math.asin(min(1.0, float(np.linalg.norm(normal)))))
        # position along the first axis of the common normal with the next one, and along the next one
        shares = np.linalg.solve(np.column_stack([axes[first], -axes[second], normal]), between)
        feet += [
            (first, origins[first] + shares[0] * axes[first]),
            (second, origins[second] + shares[1] * axes[second]),
        ]
    close = {"abs": 1e-9 * THICK}
    agree("distances of opposite pairs of axes", lengths[:2], lengths[2:], by="Bennett 1903", unit="m", **close)
    ratios = np.array(lengths) / np.sin(twists)
    agree("distances divided by sines of twists", ratios, ratios[0], by="Bennett 1903", unit="m", **close)
    for axis in range(4):
        places = [place for number, place in feet if number == axis]
        agree("feet of both common normals on an axis", places[0], places[1], by="Bennett 1903", unit="m", **close)


@pytest.mark.parametrize("method", ["offset", "hinge-shift"])
def test_a_thick_miura_vertex_moves_like_the_sheet_without_thickness(agree, method):
    (record,) = simulate(
        [compile_model(thick(miura(2, 2, "40 deg"), method, stages=[{"name": "a", "limit": "0.1 s"}], step="0.1 ms"))]
    )
    angles = record.series["hinge_angle"]
    roles = np.array([hinge.role for hinge in record.structure.hinges])
    assert np.ptp(angles, axis=0).max() > math.radians(20)
    known = straight_angles(angles[:, [int(np.argmax(roles == "zigzag"))]])
    close = {"unit": "rad", "abs": 1e-6, "by": "tan half angles"}
    agree("fold angles of the straight creases in a run", angles[:, roles == "straight"], known, **close)
    gap = float(record.series["closure_gap"].max())
    agree("gap of the loop, divided by the size", gap / record.structure.span, 0.0, by="closed loop", abs=1e-6)


@pytest.fixture(scope="module")
def split_run():
    """A run of a split vertex with contact, which torques on the zigzag creases close."""
    drive = '[[drive]]\nname = "fold"\nkind = "torque"\nof = "role:zigzag"\nvalue = "1 N cm"\n'
    stages = [{"name": "fold", "drive": "fold", "until": "time", "limit": "0.09 s"}]
    crease = CREASE.replace('damping = "0', 'damping = "1e-2')
    design = thick(miura(2, 2, "40 deg"), "split", crease=crease, more=drive, stages=stages, step="50 us")
    (record,) = simulate([compile_model(with_values(design, {"protocol.contact": True}))])
    return record


def test_both_folds_of_a_split_fold_share_the_angle_of_the_sheet_without_thickness(agree, split_run):
    angles, hinges = split_run.series["hinge_angle"], split_run.structure.hinges
    zigzag = [number for number, hinge in enumerate(hinges) if hinge.role == "zigzag"]
    straight = [number for number, hinge in enumerate(hinges) if hinge.role == "straight"]
    assert len(zigzag) == 2
    assert len(straight) == 4
    assert math.degrees(angles[-1, zigzag].min()) > 175
    # until the panels meet, because stops and contacts yield
    free = angles[angles[:, zigzag[0]] < math.radians(175)]
    half = straight_angles(free[:, zigzag[:1]]) / 2
    close = {"unit": "rad", "abs": 2e-5, "by": "tan half angles"}
    agree("fold angles of split straight creases in a run", free[:, straight], half, **close)


def test_split_panels_close_with_contact_without_overlap(holds, split_run):
    overlap = contact_overlap(split_run)
    holds("largest overlap in a run, divided by the thickness", overlap.largest, below=0.1)
    touched = float(split_run.series["contact_overlap"][-1])
    holds("overlap in steps, which shows that panels touch", touched, above=0.0)
    assert not facets_that_cross(split_run)


@pytest.mark.parametrize("method", ["hinge-shift", "split"])
def test_a_slow_torque_folds_a_thick_vertex_like_the_sheet_without_thickness(agree, method):
    drive = '[[drive]]\nname = "fold"\nkind = "torque"\nof = "role:zigzag"\nvalue = "0.1 N cm"\n'
    stages = [{"name": "fold", "drive": "fold", "until": "zigzag > 150 deg", "limit": "1 s"}]
    crease = CREASE.replace("75 deg", "40 deg")
    path = quasi_static_path(thick(miura(2, 2, "40 deg"), method, crease=crease, more=drive, stages=stages))
    roles = np.array([hinge.role for hinge in path.structure.hinges])
    zigzag = path.angles[:, [int(np.argmax(roles == "zigzag"))]]
    assert zigzag.max() > math.radians(140)
    known = straight_angles(zigzag) / (2 if method == "split" else 1)
    # the pins that close the loop are a million times as stiff as the creases and yield by this angle
    close = {"unit": "rad", "abs": 2e-4 if method == "split" else 1e-4, "by": "tan half angles"}
    agree("fold angles of the straight creases in statics", path.angles[:, roles == "straight"], known, **close)


@pytest.mark.parametrize("method", ["offset", "hinge-shift", "split"])
def test_folded_stacks_are_as_high_as_their_layers(agree, method):
    for columns, rows in [(2, 2), (2, 3), *([(4, 2)] if method != "split" else [])]:
        package = flat_package(structure_of(thick(miura(columns, rows, "0 deg"), method)))
        height = columns * rows * THICK
        agree("height of the stack of a Miura sheet", package.height, height, by="number of panels", unit="m", rel=1e-9)


@pytest.mark.parametrize("limit", [90, 150])
def test_trimmed_panels_meet_at_their_largest_fold_angle(agree, limit):
    crease = f'{CREASE}\nfold_limit = "{limit} deg"'.replace("75 deg", "30 deg")
    design = thick(miura(2, 2, "20 deg"), "tapered", crease=crease)
    structure = structure_of(design)
    points = np.array([point.place for point in structure.points])
    angles = []
    for plate in structure.plates:
        middle = points[list(plate.points)]
        normal = np.cross(middle[1] - middle[0], middle[2] - middle[0])
        normal /= np.linalg.norm(normal)
        corners = points[list(plate.solids[0])] - middle[0]
        for tail, head in zip(middle, np.roll(middle, -1, axis=0), strict=True):
            inwards = np.cross(normal, head - tail)
            inwards /= np.linalg.norm(inwards)
            for side in (1, -1):
                on_face = np.abs(side * corners @ normal - THICK / 2) < 1e-9
                width = float(((corners[on_face] + middle[0] - tail) @ inwards).min())
                if width > 1e-9:
                    angles.append(math.pi - 2 * math.atan(THICK / (2 * width)))
    assert len(angles) == 8
    agree("largest fold angle of trimmed panels", np.degrees(angles), limit, by="Tachi 2011", unit="deg", abs=1e-6)


def test_the_mass_of_panels_with_brackets_is_that_of_their_volumes(agree):
    structure = structure_of(thick(miura(2, 2, "0 deg"), "hinge-shift"))
    mass = sum(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    # a rhombus of 2 cm each, and two brackets of 0.15 of a crease, as wide and as high as the panel is thick
    area, brackets = 4 * 0.02**2 * math.sin(math.radians(60)), 2 * 0.15 * 0.02 * THICK**2
    agree("mass", mass, 1200.0 * (area * THICK + brackets), by="volume", unit="kg", rel=1e-9)


def test_split_pleats_form_stacks_as_high_as_their_layers(agree):
    # a letter, an accordion, and a sheet that is rolled up
    for panels, letters in [(3, "VV"), (4, "VMV"), (4, "VVV")]:
        package = flat_package(structure_of(thick(pleats(panels, letters), "split")))
        agree("height of the stack", package.height, panels * THICK, by="number of panels", unit="m", rel=1e-9)


def test_the_mass_of_split_panels_is_that_of_panels_and_strips(agree):
    structure = structure_of(thick(miura(2, 2, "0 deg"), "split"))
    mass = sum(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    # four rhombi; two strips of 2 t; one of them loses a wedge where the straight line closes to 60 deg
    panels = 4 * 0.02**2 * math.sin(math.radians(60)) * THICK
    strips = 2 * 0.02 * 2 * THICK**2 - THICK**3 / math.tan(math.radians(60))
    agree("mass", mass, 1200.0 * (panels + strips), by="volume", unit="kg", rel=1e-9)


@pytest.mark.parametrize(("method", "limit"), [("hinge-shift", 180), ("split", 180), ("tapered", 150)])
def test_layers_of_a_thickness_around_the_cores_of_panels_stay_apart_while_they_fold(holds, method, limit):
    crease = f'{CREASE}\nfold_limit = "{limit} deg"'.replace("75 deg", "30 deg")
    structure = structure_of(thick(miura(2, 2, "0 deg"), method, crease=crease))
    tangents = np.linspace(0, 1, 12) * math.tan(min(math.radians(limit), math.pi - 1e-9) / 2)
    shares = [1.0 if hinge.role == "zigzag" else 0.5 for hinge in structure.hinges]
    parts = structure.appearance.pattern.edges_share[[hinge.edge for hinge in structure.hinges]]
    at = pose(tree_of(structure), 2 * np.arctan(tangents[:, None] * shares) * parts)
    cores = [[structure.points[point] for point in plate.core] for plate in structure.plates]
    least = []
    for one, other in combinations(cores, 2):
        sides = []
        for core in (one, other):
            corners = np.array([at.origins[:, point.body] + at.frames[:, point.body] @ point.place for point in core])
            shifts = np.linspace(0, 1, 9)[:, None, None, None]
            sides.append(((1 - shifts) * corners + shifts * np.roll(corners, -1, axis=0)).reshape(-1, len(tangents), 3))
        apart = np.linalg.norm(sides[0][:, None] - sides[1][None], axis=-1)
        least.append(apart.min(axis=(0, 1)))
    holds("distance of the sides of cores, divided by the thickness", np.array(least) / THICK, above=1 - 1e-9)


def test_the_mass_of_offset_panels_counts_brackets_and_cut_outs(agree):
    structure = structure_of(thick(miura(2, 2, "0 deg"), "offset"))
    mass = sum(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    # two panels are a thickness above the axes, with a bracket at each of their two creases; the brackets of the crease
    # between them pass through the two panels below
    area, bracket = 4 * 0.02**2 * math.sin(math.radians(60)), 0.15 * 0.02 * THICK**2
    agree("mass", mass, 1200.0 * (area * THICK + (4 - 2) * bracket), by="volume", unit="kg", rel=1e-9)

"""Random flat-foldable sheets fold along the closed form and rest at its energy minimum.

A vertex of four creases folds as a spherical four-bar linkage (Huffman 1976; `vertex_closure`). Consider a sheet of
quadrilaterals with straight creases along its columns and zigzag creases on every line between two rows, which cross
the straight creases at one angle g per line. It is flat-foldable at every vertex (Kawasaki 1989): a Miura-ori with
different columns, rows and angles. All straight creases fold by the same magnitude s, and the zigzag creases of a line
by z with tan(s / 2) = |cos g| tan(z / 2) (Huffman 1976; Tachi 2009, J. IASS 50, 173-179). With rigid facets the energy
of the creases is a function of one angle, and the sheet rests at its minimum.
"""

from dataclasses import replace
from functools import partial

import numpy as np
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from forficula.design import with_values
from forficula.dynamics import compile_model, simulate, stable_timestep
from forficula.pattern import degree4_closure, folded_coordinates, kawasaki_residuals, vertex_pattern, vertex_walk
from forficula.pattern.facet_sheet import sheet_of_facets
from forficula.statics.net import minimum
from forficula.statics.net.net_of import net_of, start_shape
from tests.sheets import fold_angles, sheet_design, stage, stored_energy

GENERATE = (Phase.explicit, Phase.generate)  # shrinking a run takes minutes
STIFFNESS = 0.02  # of creases per length, N m/rad/m
# facets bend 1e3 times as stiffly; damping is about critical for facets of 2 cm
STIFF = {
    "facet.bend_stiffness": 20.0,
    "crease.stiffness": STIFFNESS,
    "crease.rest_angle": "as built",
    "crease.damping": 2e-4,
    "protocol.sample_interval": 2e-3,
}


def rest_of(record):
    """Static rest of the sheet of a record, starting as built, with the rest angles at the end of the record."""
    built = record.structure
    net = net_of(built)
    senses = np.array([hinge.sense for hinge in built.hinges])
    law = replace(net.creases.law, rest_angle=senses * record.series["hinge_rest_angle"][-1])
    net = replace(net, creases=replace(net.creases, law=law))
    return minimum(net, start_shape(built, net), longest_step=2e-3)


def driven(sheets, of, limit, stiff):
    """Records of sheets folded by the springs of some creases, simulated side by side.

    Args:
        sheets: patterns, each with how much further on these springs rest within a third of the time.
        of: creases.
        limit: of the time, s.
        stiff: EA of the bars by the stiffness of the creases, about.
    """
    stages = {"protocol.stages": [stage("fold", limit=limit)], "facet.youngs_modulus": 1.7e4 * stiff}
    designs = []
    for pattern, fold in sheets:
        drive = {"name": "fold", "kind": "rest-angle", "of": of, "angle": fold, "rise": limit / 3}
        designs.append(sheet_design(pattern, STIFF | stages | {"drive": [drive]}))
    timestep = min(map(stable_timestep, designs))
    return simulate([compile_model(with_values(design, {"protocol.timestep": timestep})) for design in designs])


def assert_rests_as(agree, record, pattern, folded, fold):
    """Check statics and dynamics at the energy minimum of a closed form of fold angles (edge,) by one angle."""
    angles, edges = fold_angles(record)
    ends = pattern.vertices_coords[pattern.edges_vertices[edges]]
    springs = STIFFNESS * np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    senses = np.array([hinge.sense for hinge in record.structure.hinges[: len(edges)]])
    goals = senses * record.series["hinge_rest_angle"][-1, : len(edges)]

    def energy(angle):
        return springs @ (folded(angle)[edges] - goals) ** 2 / 2

    least = minimize_scalar(energy, bounds=(0.01, abs(fold)), method="bounded", options={"xatol": 1e-10})
    rest = rest_of(record)
    assert rest.stable
    by = "least of the closed form"
    agree("energy at rest by statics", 1e6 * rest.energy, 1e6 * least.fun, unit="µJ", by=by, rel=1e-3)
    stored = stored_energy(record)[-1]
    agree("energy at rest by dynamics", 1e6 * stored, 1e6 * rest.energy, unit="µJ", by="statics", rel=1e-3)
    known = np.rad2deg(folded(least.x)[edges])
    by_statics = np.rad2deg(rest.shape.angles[: len(edges)])
    agree("fold angles at rest by statics", by_statics, known, unit="deg", by=by, abs=0.1)
    agree("fold angles at rest by dynamics", np.rad2deg(angles[-1]), known, unit="deg", by=by, abs=0.5)


@settings(max_examples=1, phases=GENERATE)
@given(st.lists(st.tuples(st.floats(45, 80), st.floats(95, 130), st.floats(0.8, 2.5)), min_size=3, max_size=3))
def test_flat_foldable_vertices_fold_along_the_closed_form_and_rest_on_it(agree, drawn):
    corners = [np.deg2rad((first, second, 180 - first, 180 - second)) for first, second, _ in drawn]
    patterns = [vertex_pattern(sectors.tolist(), 0.02, "VVVM", 0.2) for sectors in corners]
    folds = [fold for *_, fold in drawn]
    records = driven(zip(patterns, folds, strict=True), "crease 0", 0.12, 1e6)
    for sectors, pattern, fold, record in zip(corners, patterns, folds, records, strict=True):
        angles, edges = fold_angles(record)
        assert edges.tolist() == [0, 1, 2, 3]
        assert np.ptp(angles[:, 0]) > 0.1
        ways = degree4_closure(sectors, angles[:, 0]).swapaxes(1, 2)
        # of the two folding modes, the one in which it was built
        way = int(np.argmin(np.abs(ways[:, 0] - angles[0]).max(axis=1)))
        ours, theirs = np.rad2deg(angles), np.rad2deg(ways[way])
        agree("fold angles along the path", ours, theirs, unit="deg", by="Huffman 1976", abs=0.05)
        around, _ = vertex_walk(np.broadcast_to(sectors, angles.shape), angles)
        agree("rotation around a vertex", around, np.eye(3), by="identity", abs=np.deg2rad(0.05))
        assert_rests_as(agree, record, pattern, partial(vertex_angles, sectors, way, len(pattern.edges_vertices)), fold)


def vertex_angles(sectors, way, edges, angle):
    """Fold angles by edge, creases first."""
    return np.concatenate((degree4_closure(sectors, angle)[way], np.zeros(edges - 4)))


def quadrilaterals(widths, heights, angles):
    """A flat sheet of columns of given widths and rows of given heights, with zigzag lines at given angles."""
    across = np.concatenate(([0.0], np.cumsum(widths)))
    up = np.concatenate(([0.0], np.cumsum(heights)))
    # height of a zigzag at every column
    swing = np.concatenate(([0.0], np.cumsum(np.asarray(widths) * (-1) ** np.arange(len(widths)))))
    line = len(across)
    coords = np.array(
        [
            (x, y + s / np.tan(g), 0.0)
            for y, g in zip(up, angles, strict=True)
            for x, s in zip(across, swing, strict=True)
        ]
    )
    faces, creases = [], {}
    for j in range(len(up)):
        for i in range(line):
            at = j * line + i
            if i + 1 < line:
                creases[frozenset((at, at + 1))] = ("M" if j % 2 else "V", "zigzag")
            if j + 1 < len(up):
                creases[frozenset((at, at + line))] = ("V" if (i + j) % 2 else "M", "straight")
            if i + 1 < line and j + 1 < len(up):
                faces.append((at, at + 1, at + line + 1, at + line))
    return sheet_of_facets(coords, faces, creases, "columns, rows and angles that differ")


SHEETS = st.tuples(
    st.lists(st.floats(0.015, 0.03), min_size=2, max_size=2),
    st.lists(st.floats(0.02, 0.03), min_size=3, max_size=3),
    st.lists(st.floats(50, 75), min_size=4, max_size=4),
    st.floats(0.8, 1.8),
)


@settings(max_examples=1, phases=GENERATE)
@given(st.lists(SHEETS, min_size=2, max_size=2))
def test_sheets_of_different_quadrilaterals_fold_along_the_closed_form_and_rest_on_it(agree, holds, drawn):
    patterns = [quadrilaterals(widths, heights, np.deg2rad(acute)) for widths, heights, acute, _ in drawn]
    for pattern in patterns:
        residual = max(map(abs, kawasaki_residuals(pattern)))
        holds("residual of Kawasaki's condition", residual, below=1e-9, unit="rad", by="Kawasaki 1989")
    folds = [fold for *_, fold in drawn]
    records = driven(zip(patterns, folds, strict=True), "role:zigzag", 0.2, 3e4)
    for (_, _, acute, fold), pattern, record in zip(drawn, patterns, records, strict=True):
        folded = partial(sheet_angles, pattern, np.deg2rad(acute))
        folded_coordinates(pattern, folded(1.0))  # rejects angles at which the sheet would tear
        assert_rests_as(agree, record, pattern, folded, fold)


def sheet_angles(flat, lines, angle):
    """Fold angles by edge for straight creases folded by an angle."""
    line = flat.edges_vertices[:, 0] // 3  # vertices in each
    zigzag = np.array(flat.edges_role) == "zigzag"
    half = np.where(zigzag, np.tan(angle / 2) / np.cos(lines[line]), np.tan(angle / 2))
    return np.sign(np.nan_to_num(flat.edges_fold_angle)) * 2 * np.arctan(half)

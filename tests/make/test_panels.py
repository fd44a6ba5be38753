"""Thick panels as printed parts, and the check that they do not overlap while they fold."""

import math
from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.crossing_facets import crossing_facets
from forficula.design import load_design, with_values
from forficula.make.checks.panel_checks import panel_checks
from forficula.make.solid.panels import panel_fold
from forficula.make.solid.poses import tree_poses
from forficula.make.solid.solids import Hull, Joined
from forficula.show.make.parts_figure import draw_parts
from forficula.show.page.data.parts_data import parts_data
from forficula.show.structure.shape import shape_of
from forficula.structure import built_points, mass_of
from tests.plate_sheets import plates, pleats

THICK = 0.004


@pytest.fixture(scope="module")
def parts():
    small = {"pattern.columns": 2, "measure": [], "pattern.fold": 0.0}
    return ff.make.parts(with_values(load_design("thick-miura"), small))


def test_panels_are_parts_with_the_volume_of_boards_and_brackets(parts):
    assert [part.kind for part in parts.parts] == ["panel"] * 4
    assert parts.sheet is None
    bracket = 0.15 * 0.08 * THICK**2
    board = 0.08**2 * math.sin(math.radians(60)) * THICK
    volumes = sorted(part.volume for part in parts.parts)
    assert volumes == pytest.approx([board, board, board + bracket, board + bracket], rel=1e-5)


def test_panels_can_be_printed_and_do_not_overlap_while_they_fold(parts):
    checks = ff.make.check_parts(parts)
    assert [check.name for check in checks if check.ok is not True] == []
    assert "overlap of panels along the fold path" in [check.name for check in checks]


def test_panels_that_are_too_thick_are_reported_with_their_names(parts):
    def thicker(part):
        solids = part.solid.solids if isinstance(part.solid, Joined) else (part.solid,)
        grown = tuple(Hull(corners=solid.corners * [1, 1, 1.2]) for solid in solids)
        return replace(part, solid=Joined(solids=grown))

    (check,) = panel_checks(replace(parts, parts=tuple(map(thicker, parts.parts))))
    assert check.ok is False
    assert "panel" in check.text
    assert "mm^3 where the largest fold angle is" in check.text


def test_the_fold_path_ends_with_all_creases_closed(parts):
    fold = panel_fold(parts.design, parts.structure)
    assert np.allclose(fold[0], 0)
    assert np.allclose(fold[-1], math.pi)


def test_notches_of_printed_panels_are_those_of_the_panels_that_fold():
    design = with_values(
        load_design("thick-miura"),
        {
            "pattern.columns": 4,
            "pattern.rows": 2,
            "measure": [],
            "pattern.fold": 0.0,
            "facet.thickness_method": "offset",
        },
    )
    made = ff.make.parts(design)
    # boolean volumes of hulls minus notches, and masses of the convex pieces in a run
    mass = sum(mass_of(made.structure, body)[0] for body in range(len(made.structure.bodies)))
    assert sum(part.volume for part in made.parts) * design.facet.density == pytest.approx(mass, rel=1e-5)
    assert [len(part.shape.decompose()) for part in made.parts] == [1] * 8
    assert [check.ok for check in panel_checks(made)] == [True]


def test_flaps_that_close_one_after_another_are_checked():
    letter = plates(
        pleats(3, "VV"),
        crease='stiffness = "1e-3 N m/rad/m"\nrest_angle = "75 deg"\ndamping = "0 N m s/rad/m"',
        facet='kind = "rigid"\nthickness_method = "split"',
    )
    (check,) = panel_checks(ff.make.parts(letter))
    assert check.ok is True
    assert check.text == (
        "no two panels overlap in 13 poses from flat to folded, in which creases close one after another"
    )


def test_plates_whose_solids_overlap_are_named(parts):
    def places(angles):
        poses = tree_poses(parts.structure, angles[None], [0])
        numbers = [point.body for point in parts.structure.points]
        frames, origins = poses.frames[0], poses.origins[0]
        return np.einsum("pij,pj->pi", frames[numbers], built_points(parts.structure)) + origins[numbers]

    assert crossing_facets(parts.structure, places(parts.fold[-1])) == []
    assert crossing_facets(parts.structure, places(parts.fold[40])) == []
    assert len(crossing_facets(parts.structure, places(-parts.fold[10]))) > 1


def test_panels_are_drawn_and_described(parts):
    figure = draw_parts(parts)
    assert [axes.get_title() for axes in figure.axes[:3]] == ["flat, 0°", "half way, 90°", "folded, 180°"]
    data = parts_data(parts, None)
    assert data["text"] == "4 panels. The largest fold angle is 180°."
    assert data["fold"]["shape"] == [121, 4]
    # creases are inside the panels, and legends do not name them
    assert not any(line.kind == "crease" for line in shape_of(parts.structure).lines)

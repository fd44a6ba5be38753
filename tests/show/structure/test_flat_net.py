"""Patterns laid flat for drawings: lengths on facets are as built, and points of the sheet keep their facets."""

import numpy as np
import pytest

from forficula.design import load_design
from forficula.show import draw_pattern
from forficula.show.structure.flat_net import flat_net
from forficula.structure import built_points, structure_of
from tests.show.run.test_figures import entries, shown


@pytest.fixture(scope="module", params=["kresling-cell", "bistable-clasp", "miura-sheet"])
def structure(request):
    return structure_of(load_design(request.param))


def test_facets_of_a_folded_sheet_keep_their_sides_and_areas(structure):
    pattern = structure.appearance.pattern
    laid = flat_net(pattern).pattern
    assert np.ptp(laid.vertices_coords[:, 2]) == 0
    for built, flat in zip(pattern.faces_vertices, laid.faces_vertices, strict=True):
        before, after = (item.vertices_coords[list(face)] for item, face in ((pattern, built), (laid, flat)))
        lengths = [np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1) for points in (before, after)]
        assert lengths[1] == pytest.approx(lengths[0], rel=1e-5)
    assert laid.vertices_coords[:, :2].min(axis=0) == pytest.approx(0.0, abs=1e-12)


def test_a_point_of_the_sheet_is_drawn_at_its_distance_from_the_corners_of_its_facet(structure):
    pattern = structure.appearance.pattern
    net = flat_net(pattern)
    for built, flat in zip(pattern.faces_vertices, net.pattern.faces_vertices, strict=True):
        corners, drawn = pattern.vertices_coords[list(built)], net.pattern.vertices_coords[list(flat), :2]
        (place,) = net.places(corners.mean(axis=0)[np.newaxis])
        away = np.linalg.norm(corners - corners.mean(axis=0), axis=1)
        assert np.linalg.norm(drawn - place, axis=1) == pytest.approx(away, rel=1e-5)


def test_the_pattern_of_a_run_is_the_flat_net_and_every_entry_of_its_legend_shows_something(structure):
    figure = draw_pattern(structure)
    (axes,) = figure.axes
    assert axes.get_xlabel().endswith(", unfolded")
    assert all(shown(handle) for _, handle in entries(figure))
    joined = "seam, joined" in [words for words, _ in entries(figure)]
    # only the tower is closed
    assert joined == (len(flat_net(structure.appearance.pattern).seams) > 0) == structure.name.startswith("kresling")


def test_a_point_beside_the_sheet_is_drawn_beside_the_nearest_facet(structure):
    net = flat_net(structure.appearance.pattern)
    points = built_points(structure)
    beyond = points.mean(axis=0) + np.array([0.0, 0.0, 2 * structure.span])
    assert np.isfinite(net.places(beyond[np.newaxis])).all()


def test_a_flat_sheet_stays_where_it_is():
    pattern = structure_of(load_design("letter-fold")).appearance.pattern
    net = flat_net(pattern)
    assert net.pattern is pattern
    assert net.view == ""

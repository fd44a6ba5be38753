"""Viewpoints: figures are seen from where the pages are seen, unless another side shows more."""

import re
from pathlib import Path

import numpy as np
import pytest

from forficula.show.structure.surface import DrawnSurface
from forficula.show.structure.viewpoint import TOWARDS_EYE, _visible_faces, page_view, readable_view

CAMERA = Path(__file__).parents[3] / "web" / "src" / "camera.js"
FLAT = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)


def surface(*faces):
    empty = np.zeros((0, 2, 3))
    return DrawnSurface(
        faces=np.array(faces),
        regions=np.zeros(len(faces), dtype=np.int64),
        two_sided=True,
        bars=empty,
        radii=np.zeros(0),
        lines=empty,
        folds=np.zeros(0),
        held=np.zeros((0, 3)),
        tendons=empty,
        thickness=0.02,
        span=1.0,
    )


def upright(along):
    """Return the corners of an upright square along a level direction."""
    return np.array([[0, 0, 0], along, np.add(along, [0, 0, 1]), [0, 0, 1]], dtype=float)


@pytest.mark.skipif(not CAMERA.exists(), reason="without the scripts of the pages")
def test_figures_and_pages_have_the_same_first_view():
    numbers = re.search(r'name: "3-D".*towards: \[([^\]]*)\]', CAMERA.read_text())[1]
    assert tuple(float(number) for number in numbers.split(",")) == TOWARDS_EYE


def test_a_sheet_on_the_ground_is_seen_as_on_the_page():
    assert readable_view([surface(FLAT)]).towards == pytest.approx(page_view().towards)


def test_a_plate_that_the_page_would_show_edge_on_is_seen_from_another_side():
    usual = page_view().towards
    along = np.array([*usual[:2], 0.0]) / np.linalg.norm(usual[:2])
    # an upright plate along the direction of sight
    plate = upright(along)
    normal = np.cross(plate[1] - plate[0], plate[3] - plate[0])
    assert abs(normal @ usual) < 1e-9
    assert abs(normal @ readable_view([surface(plate)]).towards) > 0.6


def test_of_several_shapes_the_one_that_is_seen_worst_decides():
    usual = page_view().towards
    along = np.array([*usual[:2], 0.0]) / np.linalg.norm(usual[:2])
    plate = upright(along)
    view = readable_view([surface(FLAT), surface(plate), surface(FLAT)])
    assert abs(np.cross(along, [0, 0, 1]) @ view.towards) > 0.6


def test_a_structure_that_nothing_holds_is_seen_from_where_a_part_of_every_face_is_visible():
    # a small plate below a large one is visible from below only
    above, below = FLAT + np.array([0, 0, 1]), 0.5 * FLAT + np.array([0.25, 0.25, 0.9])
    roof = surface(above, below)
    free, held = readable_view([roof], free=True), readable_view([roof])
    assert free.towards[2] < 0 < held.towards[2]
    assert _visible_faces(roof.faces, free, by_face=True) > _visible_faces(roof.faces, held, by_face=True)

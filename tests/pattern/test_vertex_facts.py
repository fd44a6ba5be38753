import dataclasses
import math

import numpy as np
import pytest

from forficula.pattern import (
    CreasePattern,
    EarwigFan,
    creases_inside,
    earwig_pattern,
    fault_labels,
    miura_pattern,
    sectors_between,
    vertex_creases,
    vertex_facts,
    vertex_pattern,
)
from tests.pattern.test_crease_pattern import star


def fan():
    return earwig_pattern(
        EarwigFan(proximal_length=0.12, distal_length=0.1, hub_radius=0.015, sector_angle=math.radians(20), units=2)
    )


@pytest.mark.parametrize(
    "pattern",
    [fan(), miura_pattern(3, 3, 0.03, 0.02, 1.0), star([10, 80, 200], "MMM"), star([0, 70, 150, 290], "MFVM")],
)
def test_creases_around_a_flat_vertex_match_their_polar_angles(pattern):
    walked = vertex_creases(pattern)
    for around, (vertex, edges) in zip(walked, creases_inside(pattern), strict=True):
        assert (around.vertex, around.edges.tolist()) == (vertex, edges.tolist())
        assert around.sectors == pytest.approx(sectors_between(pattern, vertex, edges))
        assert around.total == pytest.approx(2 * math.pi)


def test_sectors_are_the_same_however_far_a_sheet_is_folded():
    flat, folded = (vertex_creases(miura_pattern(3, 3, 0.03, 0.02, 1.0, fold)) for fold in (0.0, 0.9))
    for one, other in zip(flat, folded, strict=True):
        assert one.sectors == pytest.approx(other.sectors)


def test_a_corner_that_points_inwards_is_more_than_a_half_turn():
    pattern = CreasePattern(
        vertices_coords=np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0]]),
        edges_vertices=np.array([[0, 1], [0, 2], [1, 2], [2, 3], [3, 4], [4, 5], [5, 1]]),
        edges_assignment=("M", "M", *"BBBBB"),
        edges_fold_angle=np.full(7, np.nan),
        faces_vertices=((0, 1, 2), (0, 2, 3, 4, 5, 1)),
    )
    assert np.degrees(vertex_creases(pattern)[0].sectors) == pytest.approx([45, 315])


def test_a_vertex_of_plates_that_lack_an_angle_is_not_developable():
    (facts,) = vertex_facts(vertex_pattern([math.radians(87.5)] * 4, 0.1))
    assert math.degrees(facts.total) == pytest.approx(350)
    assert not facts.developable
    assert (facts.creases, facts.freedoms, facts.check, facts.folds) == (4, 1, None, None)
    assert fault_labels(facts) == ()


@pytest.mark.parametrize(
    ("directions", "letters", "words"),
    [
        ([0, 45, 165, 300], "VMMM", ()),
        ([0, 46, 165, 300], "VMMM", ("1° missing",)),
        ([0, 45, 165, 300], "MVVM", ("|M − V| = 0",)),
        ([0, 45, 165, 300], "MMMV", ("trapped sector",)),
        ([0, 120, 240], "MMV", ("3 creases: odd",)),
        ([0, 120, 240], "MFF", ("a single crease",)),
        ([0, 46, 165, 300], "UUUU", ("1° missing",)),
    ],
)
def test_the_failed_conditions_of_a_vertex_have_short_labels(directions, letters, words):
    (facts,) = vertex_facts(star(directions, letters))
    assert fault_labels(facts) == words


def test_moving_the_missing_angle_from_one_sector_to_another_mends_the_vertex():
    (facts,) = vertex_facts(star([0, 49.3, 165, 300], "VMMM"))
    assert math.degrees(facts.missing) == pytest.approx(4.3)
    (mended,) = vertex_facts(star([0, 49.3 - 4.3, 165, 300], "VMMM"))
    assert mended.missing == pytest.approx(0, abs=1e-12)


def test_turning_a_flat_sheet_over_its_faces_is_not_flat_folding():
    pattern = star([0, 90, 180, 270], "MMMV")
    over = dataclasses.replace(pattern, vertices_coords=pattern.vertices_coords * [-1, 1, 1])
    assert vertex_facts(over)[0].check is None

"""Strips of panels, trees of facets, and the report about flat folding."""

import math

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import (
    CreasePattern,
    central_facet,
    earwig_pattern,
    facet_tree,
    flat_folding_faults,
    flat_folding_text,
    folded_coordinates,
    miura_pattern,
    pleat_pattern,
    vertex_checks,
)
from forficula.pattern.families.earwig import EarwigFan


def star(directions_deg, letters):
    """Creases from one interior vertex to a rim of radius 10 cm."""
    count = len(directions_deg)
    angles = np.radians(directions_deg)
    rim = 0.1 * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(count)])
    return CreasePattern(
        vertices_coords=np.concatenate([np.zeros((1, 3)), rim]),
        edges_vertices=np.array(
            [(0, i + 1) for i in range(count)] + [(i + 1, (i + 1) % count + 1) for i in range(count)]
        ),
        edges_assignment=tuple(letters) + ("B",) * count,
        edges_fold_angle=np.full(2 * count, np.nan),
        faces_vertices=tuple((0, i + 1, (i + 1) % count + 1) for i in range(count)),
    )


def test_a_letter_fold_lands_on_itself():
    """Both outer panels of a letter in three equal parts end on the middle one, at the z of the sheet."""
    strip = pleat_pattern([0.1, 0.1, 0.1], 0.2, "VV")
    folded = folded_coordinates(strip, strip.edges_fold_angle, fixed_face=1)
    assert np.ptp(folded[:, 0]) == pytest.approx(0.1, abs=1e-15)
    assert np.abs(folded[:, 2]).max() < 1e-15


def test_pleats_half_folded_are_stairs():
    strip = pleat_pattern([0.1] * 4, 0.05, "MVM")
    folded = folded_coordinates(strip, strip.edges_fold_angle / 2)
    # down at a mountain, on at the next valley: stairs
    assert folded[:5, 0] == pytest.approx([0, 0.1, 0.1, 0.2, 0.2], abs=1e-15)
    assert folded[:5, 2] == pytest.approx([0, 0, -0.1, -0.1, -0.2], abs=1e-15)


def test_crease_k_of_a_strip_is_edge_k_between_facets_k_and_k_plus_1():
    strip = pleat_pattern([0.1, 0.2, 0.3], 0.2, "MV")
    assert strip.edges_role.count("crease") == 2
    assert strip.edges_role[:2] == ("crease", "crease")
    assert [(link.facet, link.parent, link.edge) for link in facet_tree(strip)] == [
        (0, None, None),
        (1, 0, 0),
        (2, 1, 1),
    ]
    assert strip.vertices_coords[:4, 0] == pytest.approx([0, 0.1, 0.3, 0.6])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0.1], 0.1, ""), "pattern.panels: need 2 or more, got 1"),
        (([0.1, 0.0], 0.1, "V"), "pattern.panel_lengths.1: need > 0 and finite, got 0 cm"),
        (([0.1, 0.1], math.inf, "V"), "pattern.width: need > 0 and finite, got inf cm"),
        (([0.1, 0.1], 0.1, "VM"), 'pattern.assignment: need "M" or "V" for each of the 1 creases, got "VM"'),
        (([0.1, 0.1], 0.1, "F"), 'pattern.assignment: need "M" or "V" for each of the 1 creases, got "F"'),
        (([1.0, 1e-13], 0.1, "V"), "pattern.panel_lengths: need panels of more than 1e-12 of the whole strip"),
    ],
)
def test_a_strip_that_cannot_be_drawn_is_refused(arguments, message):
    with pytest.raises(InputError) as caught:
        pleat_pattern(*arguments)
    assert str(caught.value).startswith(message)


def cross(**letters):
    """A square facet with one more on each side: number 0 in the middle, then right, top, left, bottom."""
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    arms = [[(2, 0), (2, 1)], [(1, 2), (0, 2)], [(-1, 1), (-1, 0)], [(0, -1), (1, -1)]]
    coords = np.array([*square, *(point for arm in arms for point in arm)], dtype=float)
    faces, edges = [(0, 1, 2, 3)], []
    for side in range(4):
        near, far, one, other = (side + 1) % 4, (side + 2) % 4, 4 + 2 * side, 5 + 2 * side
        faces.append((near, one, other, far))
        edges += [(near, far), (near, one), (one, other), (other, far)]
    assignment = [letter for side in range(4) for letter in (letters.get(f"side{side}", "V"), "B", "B", "B")]
    return CreasePattern(
        vertices_coords=np.column_stack([coords, np.zeros(len(coords))]),
        edges_vertices=np.array(edges),
        edges_assignment=tuple(assignment),
        edges_fold_angle=np.full(len(edges), np.nan),
        faces_vertices=tuple(faces),
    )


def test_facets_are_listed_depth_first_from_any_of_them():
    assert [link.facet for link in facet_tree(cross())] == [0, 1, 2, 3, 4]
    links = facet_tree(cross(), root=3)
    assert [(link.facet, link.parent) for link in links] == [(3, None), (0, 3), (1, 0), (2, 0), (4, 0)]
    # the parent is on the left of its side
    assert [(link.tail, link.head) for link in links[1:3]] == [(0, 3), (1, 2)]


def test_creases_around_a_vertex_close_a_loop_at_the_one_that_the_tree_leaves_out():
    links = facet_tree(star([0, 90, 180, 270], "MMMV"))
    joined = {frozenset((link.facet, link.parent)) for link in links if link.parent is not None}
    assert joined == {frozenset(pair) for pair in [(0, 1), (1, 2), (2, 3), (3, 0)]}
    assert len([link for link in links if not link.closes]) == 4
    # two away from the first facet, it is connected to one neighbour and closes a loop with the other
    assert [link.closes for link in links if 2 in (link.facet, link.parent)] in ([False, True], [True, False])


def test_every_facet_is_reached_across_the_fewest_creases_from_the_root():
    sheet = miura_pattern(5, 5, 0.01, 0.01, math.radians(60))
    middle = central_facet(sheet)
    links = facet_tree(sheet, middle)
    depth = {middle: 0}
    for link in links:
        if not link.closes and link.parent is not None:
            depth[link.facet] = depth[link.parent] + 1
    assert max(depth.values()) == 4
    assert len(links) == len({link.edge for link in links}) == 1 + 2 * 5 * 4


def test_flat_edges_can_close_a_loop():
    assert len(facet_tree(star([0, 90, 180, 270], "FFFF"))) == 4
    with pytest.raises(InputError, match="edge 3 lies between facets 3 and 2, which flat edges join to one plate"):
        facet_tree(star([0, 90, 180, 270], "FFFV"))


def test_two_facets_of_one_piece_cannot_both_be_held():
    links = facet_tree(cross(), 0, apart=[0])
    assert [link.facet for link in links if link.parent is None] == [0, 1]
    with pytest.raises(InputError, match="facet 2 is connected to another facet that is held"):
        facet_tree(cross(), [0, 2], apart=[0])


def test_facets_without_a_connection_are_refused():
    with pytest.raises(InputError, match="facet 1 is not connected to facet 0"):
        facet_tree(cross(side0="C"))


def test_a_border_between_two_facets_is_refused():
    with pytest.raises(InputError, match="edge 0 lies between facets 0 and 1: need"):
        facet_tree(cross(side0="B"))


def test_a_missing_facet_cannot_be_held():
    with pytest.raises(InputError, match="need a facet from 0 to 4, got 5"):
        facet_tree(cross(), root=5)


def test_a_fan_is_reported_to_fold_flat():
    fan = EarwigFan(proximal_length=0.12, distal_length=0.1, hub_radius=0.015, sector_angle=math.radians(20), units=2)
    sentence = " ".join(flat_folding_text(earwig_pattern(fan)))
    for condition in ("Kawasaki", "Maekawa", "Big-little-big"):
        assert f"{condition} holds" in sentence
    assert "Every vertex folds flat by itself" in sentence
    assert flat_folding_faults(earwig_pattern(fan)) == []


def test_the_report_of_a_strip_states_that_creases_fold_independently():
    sentence = flat_folding_text(pleat_pattern([0.1, 0.1, 0.1], 0.2, "VV"))
    assert sentence == ["No interior vertex: every crease folds independently."]


def test_the_report_of_a_sheet_without_creases_states_that():
    one = CreasePattern(
        vertices_coords=np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]),
        edges_vertices=np.array([[0, 1], [1, 2], [2, 0]]),
        edges_assignment=("B",) * 3,
        edges_fold_angle=np.full(3, np.nan),
        faces_vertices=((0, 1, 2),),
    )
    assert flat_folding_text(one)[-1] == "No crease to fold."


@pytest.mark.parametrize(
    ("directions", "letters", "sentence"),
    [
        ([0, 46, 165, 300], "MMMV", "Kawasaki fails at vertex 0: the alternating sum of sectors is up to 2 deg"),
        ([0, 120, 240], "MMM", "an odd number of creases never folds flat, vertex 0 has 3 creases"),
        ([0, 45, 165, 300], "MMVV", "mountains and valleys must differ by 2, at vertex 0 they differ by 0"),
        ([0, 45, 165, 300], "MMMV", "Big-little-big fails at vertex 0"),
    ],
)
def test_the_report_names_the_conditions_that_a_vertex_fails(directions, letters, sentence):
    pattern = star(directions, letters)
    assert any(sentence in fault for fault in flat_folding_faults(pattern))
    assert flat_folding_text(pattern)[-1] == "It does not fold flat."


def test_only_sectors_are_checked_where_creases_are_unassigned():
    pattern = star([0, 45, 165, 300], "UUUU")
    assert flat_folding_faults(pattern) == []
    assert "Maekawa is not checked at vertex 0" in " ".join(flat_folding_text(pattern))


def test_coordinates_of_a_file_with_seven_digits_pass():
    pattern = star([0, 45, 165, 300], "VMMM")
    rounded = CreasePattern(
        vertices_coords=np.round(pattern.vertices_coords, 8),
        edges_vertices=pattern.edges_vertices,
        edges_assignment=pattern.edges_assignment,
        edges_fold_angle=pattern.edges_fold_angle,
        faces_vertices=pattern.faces_vertices,
    )
    assert abs(vertex_checks(rounded)[0].kawasaki) > 1e-9
    assert flat_folding_faults(rounded) == []


def test_a_solid_shape_is_not_judged():
    pattern = star([0, 90, 180, 270], "MMMV")
    raised = pattern.vertices_coords.copy()
    raised[0, 2] = 0.05
    solid = CreasePattern(
        vertices_coords=raised,
        edges_vertices=pattern.edges_vertices,
        edges_assignment=pattern.edges_assignment,
        edges_fold_angle=pattern.edges_fold_angle,
        faces_vertices=pattern.faces_vertices,
    )
    assert "not flat" in flat_folding_text(solid)[-1]
    assert flat_folding_faults(solid) == []

import math

import pytest
from rich.console import Console

from forficula.pattern import kresling_pattern, miura_pattern, pattern_facts, pleat_pattern
from forficula.show.structure.pattern_table import pattern_table
from tests.pattern.test_crease_pattern import star


def shown(pattern, remarks=()):
    console = Console(width=110)
    with console.capture() as capture:
        console.print(pattern_table(pattern_facts(pattern), remarks))
    return " ".join(capture.get().split())


def miura(fold=0.0):
    return miura_pattern(4, 4, 0.02, 0.02, math.radians(60), fold)


def test_a_flat_sheet_has_more_first_order_motions_than_finite_ones():
    text = shown(miura())
    assert "Miura-ori, 4 columns, 4 rows: 25 vertices, 16 facets, 6.928 cm by 9 cm" in text
    assert "rigid facets, as given 6 9" in text
    assert "rigid facets, creases folded by 41 to 73 deg 1 4" in text
    assert "facets that bend along a diagonal, as given 22 9" in text
    assert "more first-order motions than finite ones" in text
    assert "9 of 4 creases; 360 deg around each" in text


def test_a_folded_sheet_says_nothing_of_folding_flat():
    text = shown(miura(0.5))
    assert "rigid facets, as given 1 4" in text
    assert "flat folding is not checked" in text
    assert "creases folded by" not in text


def test_a_closed_tower_cannot_move_unless_edges_stretch():
    text = shown(kresling_pattern(6, 2, 0.05, 0.04, math.radians(30), end_plates=True))
    assert "12 of 4 creases and 6 of 6 creases; 300 to 360 deg around them" in text
    assert "cannot move from this shape unless edges stretch" in text


def test_vertices_that_do_not_fold_flat_are_listed_with_what_they_lack():
    text = shown(star([0, 46, 165, 300], "MMMV"))
    assert "vertex that does not fold flat creases reason 0 4 1° missing; trapped sector" in text
    assert "even the first-order motion does not exist" in text
    assert "At vertex 0 rigid facets cannot leave the flat state in the assigned sense" in text


def test_a_strip_is_a_tree_and_remarks_on_its_file_stand_at_the_end():
    text = shown(pleat_pattern([0.1, 0.1, 0.1], 0.2, "VV"), ["lines split where they cross, 3 times"])
    assert "facets as a tree yes" in text
    assert text.endswith("lines split where they cross, 3 times.")


@pytest.mark.parametrize("letters", ["UUUU", "FFFF"])
def test_creases_without_an_assignment_have_no_sentence_about_their_sense(letters):
    assert "sense" not in shown(star([0, 45, 165, 300], letters))

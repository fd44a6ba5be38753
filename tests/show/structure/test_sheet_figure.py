import dataclasses
import math

import numpy as np
import pytest

from forficula.pattern import interior_vertices, miura_pattern, pattern_facts, pleat_pattern
from forficula.show.structure.sheet_figure import draw_sheet
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from tests.pattern.test_crease_pattern import star
from tests.show.legible import check_words, words


def sheet(size, fold=0.0):
    return miura_pattern(size, size, 0.02, 0.02, math.radians(60), fold)


def shaken(size):
    """A sheet with every third interior vertex displaced."""
    draw, pattern = np.random.default_rng(0), sheet(size)
    coords, moved = pattern.vertices_coords.copy(), interior_vertices(pattern)[::3]
    coords[moved, :2] += 1e-3 * draw.normal(size=(len(moved), 2))
    return dataclasses.replace(pattern, vertices_coords=coords)


SHEETS = {
    "Miura": sheet(4),
    "folded": sheet(4, 0.6),
    "shaken": shaken(4),
    "shaken and dense": shaken(12),
    "strip": pleat_pattern([0.1] * 12, 0.05, "VMVMVMVMVMV"),
    "odd": star([0, 120, 240], "MMM"),
    "trapped": star([0, 46, 165, 300], "MMMV"),
    "even": star([0, 60, 120, 180, 240, 300], "MVMVMV"),
}


def drawn(pattern, width=PAGE_WIDTH):
    return draw_sheet(pattern, pattern_facts(pattern), width)


def labels(figure):
    return [text.get_text() for text, _ in words(figure)]


# page-wide figures have space for all words unless they are low or have the most words: see below
@pytest.mark.parametrize(
    ("name", "width"),
    [*((name, COLUMN_WIDTH) for name in SHEETS), ("strip", PAGE_WIDTH)],
)
def test_the_words_of_a_sheet_can_be_read(name, width):
    check_words(drawn(SHEETS[name], width), width)


@pytest.mark.parametrize(
    ("name", "said"), [("odd", "3 creases: odd"), ("trapped", "1° missing\ntrapped sector"), ("even", "|M − V| = 0")]
)
def test_a_vertex_that_does_not_fold_flat_says_what_it_lacks(name, said):
    shown = labels(drawn(SHEETS[name]))
    assert said in shown
    assert "does not fold flat (1)" in shown


def test_a_sheet_that_folds_flat_has_no_marks():
    figure = drawn(SHEETS["Miura"])
    assert not any("does not" in label or "missing" in label for label in labels(figure))
    assert "Every interior vertex folds flat" in figure.get_label()


def test_a_dense_sheet_labels_few_vertices_and_the_worst_of_them():
    pattern = SHEETS["shaken and dense"]
    missing = [text for text in check_words(drawn(pattern), PAGE_WIDTH) if "missing" in text]
    assert 3 <= len(missing) <= 8
    worst = max(item.missing for item in pattern_facts(pattern).inside)
    assert f"{math.degrees(worst):.2g}° missing" in missing


def test_a_folded_sheet_is_drawn_unfolded():
    assert "x (cm), unfolded" in labels(drawn(SHEETS["folded"]))


def test_a_sheet_that_cannot_be_laid_flat_is_said_to_be_seen_from_above():
    flat = SHEETS["folded"]
    bent = flat.vertices_coords + np.array([0, 0, 0.002]) * (np.arange(len(flat.vertices_coords)) % 3)[:, np.newaxis]
    assert "x (cm), seen from above" in labels(drawn(dataclasses.replace(flat, vertices_coords=bent)))

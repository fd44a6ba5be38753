"""Sheets with split folds in FOLD files and in designs that are read from them."""

import dataclasses
import json
import math

import numpy as np
import pytest

from forficula import InputError
from forficula.design import load_design, with_values
from forficula.design.sheets.crease_values import creases_by_edge
from forficula.design.sheets.crease_values import stops as stops_of
from forficula.pattern import pleat_pattern, read_fold, write_fold
from forficula.pattern.facts.flat_fold import flat_fold, flat_fold_text
from forficula.pattern.thick.split_sheet import split_sheet

# rolled up: the last two of three folds of 180 deg are split
SPLIT = split_sheet(pleat_pattern([0.06, 0.05, 0.04, 0.03], 0.1, "VVV"), 0.002).pattern


def test_a_split_sheet_that_is_read_again_has_the_same_folds_and_folding_ratio(tmp_path):
    """Without its folds, both edges of a split fold would close by 180 deg, and the outline would be wider."""
    write_fold(SPLIT, tmp_path / "split.fold")
    again = read_fold(tmp_path / "split.fold")
    np.testing.assert_array_equal(again.edges_fold, SPLIT.edges_fold)
    np.testing.assert_array_equal(again.edges_fold_angle, SPLIT.edges_fold_angle)
    fold = flat_fold(again)
    assert fold.area / fold.outline_area == pytest.approx(fold.area / (0.1 * 0.06))


def test_without_numbers_of_folds_the_facts_report_creases_that_fold_beyond_their_targets():
    (text,) = flat_fold_text(dataclasses.replace(SPLIT, edges_fold=np.arange(len(SPLIT.edges_fold))))
    assert text.startswith(
        "Folded flat, beyond the target angles of 4 creases, and without thickness, it has an outline of"
    )
    assert "target" not in flat_fold_text(SPLIT)[0]


def test_a_design_from_the_file_halves_the_stops_of_split_folds_and_refuses_a_second_split(tmp_path):
    write_fold(SPLIT, tmp_path / "split.fold")
    design = load_design(str(tmp_path / "split.fold"))
    torque = {"name": "fold", "kind": "torque", "of": "creases", "value": 0.1}
    design = with_values(design, {"facet.kind": "rigid", "drive": [torque]})
    np.testing.assert_array_equal(design.sheet.edges_share, SPLIT.edges_share)
    assert flat_fold(design.sheet).outline_area == pytest.approx(0.1 * 0.06)
    stops = {edge: stops_of(design, edge, crease)[1] for edge, crease in creases_by_edge(design).items()}
    assert stops == {edge: pytest.approx(math.pi * SPLIT.edges_share[edge]) for edge in stops}
    for method in ("split", "hinge-shift"):
        with pytest.raises(
            InputError, match=r'facet\.thickness_method: need "none" for a pattern that has split folds'
        ):
            with_values(design, {"facet.thickness_method": method})


@pytest.mark.parametrize(
    ("edge", "number", "message"),
    [
        (0, 99, r"forficula:edges_fold\[0\]: need a whole number from 0 to \d+, got 99"),
        (0, 1.5, r"forficula:edges_fold\[0\]: need a whole number from 0 to \d+, got 1\.5"),
        (3, 0, r"edges_fold\[3\]: need two mountains or valleys as one fold, got letters VB"),
    ],
)
def test_wrong_numbers_of_folds_are_refused(tmp_path, edge, number, message):
    path = tmp_path / "split.fold"
    write_fold(SPLIT, path)
    document = json.loads(path.read_text("utf-8"))
    document["forficula:edges_fold"][edge] = number
    path.write_text(json.dumps(document), "utf-8")
    with pytest.raises(InputError, match=message):
        read_fold(path)

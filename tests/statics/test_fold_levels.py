"""Energies of independent hinges, and where the energies of single hinges do not add up."""

from __future__ import annotations

import json

import numpy as np
import pytest

import forficula as ff
from forficula.show.landscape.levels_figure import draw_levels
from forficula.statics import landscape_summary
from forficula.statics.tree.partial_folds import fold_levels
from forficula.structure import structure_of

LOOSE = {"crease.stiffness": "0 N m/rad/m"}


def levels_of(name, values=None):
    return fold_levels(structure_of(ff.load_design(name, values or {})))


def test_springs_in_the_hinges_leave_no_levels():
    landscape = ff.landscape(ff.load_design("letter-fold"), points=11)
    assert landscape.levels is None
    assert landscape_summary(landscape)["levels_J"] is None
    json.dumps(landscape_summary(landscape), allow_nan=False)
    assert not [text for text in draw_levels(landscape).axes[0].texts if "J" in text.get_text()]


def test_of_loose_hinges_the_tendons_add_up():
    landscape = ff.landscape(ff.load_design("letter-fold", LOOSE), points=11)
    by_count = [[state.energy for state in landscape.partial_folds if len(state.folded) == count] for count in range(3)]
    assert [np.mean(energies) for energies in by_count] == pytest.approx(landscape.levels, abs=1e-9)
    assert landscape.levels[1] == pytest.approx(landscape.levels[0] / 2)


def test_a_tendon_across_two_hinges_leaves_no_levels():
    ends = {"tendon.left.from": "facet 0 at 0.5, 0.5", "tendon.left.to": "facet 2 at 0.5, 0.5"}
    assert levels_of("letter-fold", LOOSE | ends) is None


def test_a_hinge_without_a_tendon_counts_as_one_that_stores_nothing():
    every, some = levels_of("binder2025"), levels_of("binder2025", {"tendon": [{"vein": 0}, {"vein": 2}]})
    assert len(some) == len(every) == 4
    assert some == pytest.approx([every[1], every[2], every[2], every[3]], rel=1e-9)


def test_where_nothing_holds_plates_they_stay_all_the_same():
    """Slack tendons and no springs: a neutral state, whatever sign rounding gives its stiffness."""
    landscape = ff.landscape(ff.load_design("letter-fold", LOOSE), points=11)
    assert [state.stable for state in landscape.partial_folds] == [True] * 4
    assert [(rest.name, rest.stable) for rest in landscape.rests] == [
        ("flat", True),
        ("closed", True),
        ("opened", True),
    ]

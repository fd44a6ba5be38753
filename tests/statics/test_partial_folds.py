"""Wings with some hinges folded."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from forficula.design import load_design
from forficula.statics.tree import partial_folds as module
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.hinge import tendon_hinges
from forficula.statics.tree.quasi_static import start_state
from forficula.structure import structure_of
from tests.statics.hinge_numbers import top_barrier


def partial_folds(design):
    structures = ensemble_of([design])
    return module.partial_folds(structures, start_state(structures).position)


def single_hinge_barriers(design):
    structures = ensemble_of([design])
    return module.single_hinge_barriers(structures, start_state(structures).position)


def test_every_combination_of_three_hinges_is_tried(reference):
    tried = [state.folded for state in partial_folds(reference)]
    assert tried == [combination for count in range(4) for combination in itertools.combinations(range(3), count)]


def test_with_a_soft_membrane_hinges_stay_where_they_are(reference):
    """1 MPa does not pull a hinge back over its barrier: eight stable states, lower the more hinges are folded."""
    states = partial_folds(reference)
    assert all(state.stable for state in states)
    flat, *_, folded = states
    assert np.degrees(flat.angles) == pytest.approx([3, 3, 3])
    assert folded.energy < 1e-4 * flat.energy
    by_count = [np.mean([state.energy for state in states if len(state.folded) == count]) for count in range(4)]
    assert by_count == sorted(by_count, reverse=True)


def test_straight_hinges_that_no_overbend_holds_are_not_stable():
    flat = partial_folds(load_design("binder2025", {"hinge.overbend": "0 deg", "protocol.initial_overbend": "0 deg"}))[
        0
    ]
    assert not flat.stable


def test_of_many_veins_neighbours_from_the_first_on_are_tried():
    states = partial_folds(load_design("binder2025", {"pattern.units": 3, "pattern.sector_angle": "15 deg"}))
    assert [state.folded for state in states] == [tuple(range(count)) for count in range(8)]


def test_a_membrane_that_the_overbend_stretches_takes_from_the_barrier(reference):
    """The barrier of one hinge is its tendon's, less the energy that a stiffer membrane releases up to straight."""
    alone = top_barrier(tendon_hinges(structure_of(reference))[1])
    climbs = [
        single_hinge_barriers(load_design("binder2025", {"membrane.youngs_modulus": modulus}))[1]
        for modulus in ("0.01 MPa", "1 MPa", "30 MPa", "100 MPa")
    ]
    assert climbs[0] == pytest.approx(alone, rel=1e-3)
    assert climbs == sorted(climbs, reverse=True)

"""Miura sheets as nets of bars have the known number of mechanisms and fold along the closed form.

The number of mechanisms is that of the rigidity matrix of Schenk and Guest (2011, Origami 5, 291-303) for sheets of
m x n facets kept flat: m + n - 2 for a flat sheet, one for a folded sheet. The closed form of the dimensions is that of
Schenk and Guest 2013, doi 10.1073/pnas.1217998110.
"""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.statics.net.energy import built_shape
from forficula.statics.net.minimum import minimum
from forficula.statics.net.rigidity import rigidity
from forficula.statics.net.supports import rigid_motions
from tests.statics.net.nets import mechanisms, miura, sheet


@pytest.mark.parametrize(("size", "fold", "expected"), [(4, 0.0, 6), (4, 0.6, 1), (8, 0.0, 14), (8, 0.6, 1)])
def test_a_flat_sheet_has_many_mechanisms_and_a_folded_one_has_one(agree, size, fold, expected):
    net, diagonals = sheet(*miura(size, size, fold=fold))
    result = rigidity(net, built_shape(net), diagonals)
    what = f"mechanisms of {size} x {size} facets, {'folded' if fold else 'flat'}"
    agree(what, result.degrees_of_freedom, expected, by="Schenk and Guest 2011")
    assert result.rigid_motions == 6
    # Calladine's (1978) count: columns less rows
    rows = len(net.springs.points) + np.count_nonzero(diagonals)
    assert result.degrees_of_freedom + 6 - result.self_stresses == 3 * len(net.nodes) - rows
    assert len(mechanisms(net, diagonals)) == expected


def test_the_single_mechanism_is_the_folding_of_the_sheet(agree):
    net, diagonals = sheet(*miura(4, 4, fold=0.6))
    mechanism = mechanisms(net, diagonals)[0].ravel()
    folding = (miura(4, 4, fold=0.6 + 1e-5)[0] - miura(4, 4, fold=0.6 - 1e-5)[0]).ravel()
    # except for a rigid motion
    whole = rigid_motions(net.nodes).reshape(folding.size, -1)
    folding -= whole @ (whole.T @ folding)
    share = abs(folding @ mechanism) / np.linalg.norm(folding)
    agree("cosine between mechanism and folding", share, 1, by="the closed form", rel=1e-8)


@settings(deadline=None, max_examples=6)
@given(st.floats(0.3, 1.2), st.floats(0.9, 1.3), st.floats(0.5, 2.0))
def test_one_driven_crease_folds_the_whole_sheet_along_the_closed_form(agree, fold, acute, ratio):
    start, facets = miura(4, 4, fold=0.5, acute=acute, other=ratio)
    end = miura(4, 4, fold=fold, acute=acute, other=ratio)[0]
    net, diagonals = sheet(start, facets, axial=1e6)
    goal = built_shape(sheet(end, facets)[0]).angles
    driven = np.flatnonzero(~diagonals)[0]
    stiffness = np.where(diagonals, 1e2, 0.0)
    stiffness[driven] = 1.0
    law = replace(net.creases.law, stiffness=stiffness, rest_angle=np.where(diagonals, 0.0, goal))
    rest = minimum(replace(net, creases=replace(net.creases, law=law)), built_shape(net))
    assert rest.stable
    ours, theirs = np.rad2deg(rest.shape.angles), np.rad2deg(goal)
    agree("fold angles", ours, theirs, unit="deg", by="Schenk and Guest 2013", abs=1e-3)
    span = np.linalg.norm(rest.shape.positions[0] - rest.shape.positions[-1])
    known = np.linalg.norm(end[0] - end[-1])
    agree("distance from corner to corner", span, known, unit="m", by="Schenk and Guest 2013", rel=1e-6)

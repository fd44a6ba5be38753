"""The branch on which a sheet leaves its flat state, and the reported cause of that choice."""

import pytest

import forficula as ff
from forficula.analysis.branch import branch_taken, branch_text
from forficula.design import load_design, with_values
from forficula.errors import InputError

STAGE = {"name": "fold", "until": "time", "hold": 0.0, "time_limit": 0.02}


def flat(**values):
    """Return a flat Miura sheet of four facets without supports, run for an instant."""
    changes = {
        "pattern.columns": 2,
        "pattern.rows": 2,
        "pattern.fold": 0.0,
        "facet.youngs_modulus": 2e7,
        "support": [],
        "measure": [],
        "protocol.timestep": 2e-5,
        "protocol.stages": [STAGE | {"drive": "none"}],
    }
    return with_values(load_design("miura-sheet"), changes | values)


def test_a_drive_to_the_assignment_folds_every_crease_as_assigned():
    branch = branch_taken(
        ff.run(flat(**{"protocol.stages": [STAGE | {"drive": "fold", "time_limit": 0.1}]}), confirm=False)
    )
    assert (branch.as_assigned, branch.against) == (4, 0)
    assert branch.decided_by == ('the rest angles of drive "fold"',)


def test_the_branch_of_an_undriven_flat_sheet_is_decided_by_rounding():
    branch = branch_taken(ff.run(flat(), confirm=False))
    assert (branch.flat, branch.decided_by) == (4, ("rounding alone",))
    assert "rounding alone: set imperfection.size and imperfection.seed" in branch_text(branch)


def test_a_seed_chooses_an_imperfection_and_the_same_one_chooses_the_same():
    builds = [
        [
            hinge.start
            for hinge in ff.run(flat(**{"imperfection": {"size": 1e-4, "seed": seed}}), confirm=False).structure.hinges
        ]
        for seed in (1, 1, 2)
    ]
    assert builds[0] == builds[1] != builds[2]
    record = ff.run(flat(**{"imperfection": {"size": 1e-4, "seed": 2}}), confirm=False)
    assert branch_taken(record).decided_by == ("an imperfection of 0.1 mm, seed 2",)


def test_a_sheet_that_is_built_folded_has_no_branch():
    assert branch_taken(ff.run(flat(**{"pattern.fold": 0.5}), confirm=False)) is None
    # whatever the deviation of the built shape from the drawing
    shifted = {"pattern.fold": 0.5, "imperfection.size": 1e-4}
    assert branch_taken(ff.run(flat(**shifted), confirm=False)) is None


def test_rigid_facets_have_no_imperfection():
    with pytest.raises(InputError, match=r"imperfection\.size: is for"):
        flat(**{"facet.kind": "rigid", "imperfection": {"size": 1e-4, "seed": 0}})

"""What is said beside an energy balance."""

from dataclasses import replace

from forficula.show.run.outcome_rows import balance_remark


def test_energies_that_branches_which_let_go_have_in_the_books_only_are_explained(reference_outcome):
    balance = replace(reference_outcome.energy_balance, branches=0.1, branch_damping=13.2, letting_go=-12.9)
    told = balance_remark(balance)
    assert "of the 13.2 J that branches take, 12.9 J are such, which nobody paid" in told
    assert told.endswith("Together they are 0.3 J.")


def test_of_a_balance_without_much_of_them_nothing_is_said(reference_outcome):
    balance = reference_outcome.energy_balance
    assert not balance_remark(balance)
    assert not balance_remark(replace(balance, branches=0.1, branch_damping=0.2, letting_go=-0.2))

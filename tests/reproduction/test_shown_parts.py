"""The vein that represents all: the paper's where a design has it, otherwise one that every wing has."""

import pytest

from forficula.design import design_from_text, design_text, load_design, with_values
from forficula.design.files.provenance import PAPERS
from forficula.errors import InputError
from forficula.reproduction import named_reproduction, shown_hinge, shown_tendon
from forficula.study.convergence.convergence import converge
from forficula.study.convergence.refinement import TIMESTEP


def test_a_design_that_names_the_paper_shows_what_its_figures_show(reference):
    paper = named_reproduction("binder2025")
    assert (shown_tendon(reference), shown_hinge(reference)) == (paper.tendon, paper.hinge) == (1, 2)
    wide = with_values(reference, {"pattern.units": 2})
    assert (shown_tendon(wide), shown_hinge(wide)) == (1, 2)


def test_what_a_design_reproduces_is_inherited_and_kept_but_no_value_of_its_own(reference, tmp_path):
    (tmp_path / "mine.toml").write_text('based_on = "binder2025"\n')
    mine = load_design(tmp_path / "mine.toml")
    assert mine.reproduces == "binder2025"
    assert design_from_text(design_text(mine)) == mine
    free = reference.model_copy(update={"reproduces": None})
    assert free.hash == reference.hash
    assert "reproduces" not in design_text(free)
    assert (shown_tendon(free), shown_hinge(free)) == (1, None)


def test_a_design_that_names_an_unknown_paper_is_rejected_when_it_is_read(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('based_on = "binder2025"\nreproduces = "nonsense"\n')
    with pytest.raises(InputError, match=r'mine\.toml: reproduces: need one of binder2025, got "nonsense"$'):
        load_design(path)


def test_every_paper_that_a_design_may_name_has_a_reproduction():
    assert [named_reproduction(name).name for name in PAPERS] == list(PAPERS)


def test_a_convergence_study_shows_the_hinge_that_is_asked_for_or_the_last(reference):
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "10 ms"},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "20 ms"},
    ]
    wide = with_values(reference, {"pattern.units": 2, "protocol.stages": stages})
    shown = {hinge: converge(wide, TIMESTEP, [2e-4, 4e-4], hinge=hinge) for hinge in (None, 2, 4, 9)}
    assert {hinge: study.hinge for hinge, study in shown.items()} == {None: 4, 2: 2, 4: 4, 9: 4}
    assert (shown[None].angles[0] == shown[4].angles[0]).all()
    assert (shown[2].angles[0] != shown[4].angles[0]).any()


def test_a_vein_without_a_tendon_is_not_shown_as_the_example(tmp_path):
    (tmp_path / "own.toml").write_text('based_on = "binder2025"\n[[tendon]]\nvein = 0\n[[tendon]]\nvein = 2\n')
    assert shown_tendon(load_design(tmp_path / "own.toml")) == 0
    assert shown_tendon(load_design("letter-fold")) == 0

"""A run is its record with what follows from it: whatever accepts a record accepts a run."""

import copy
import pickle

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.run import Run
from forficula.dynamics import as_record
from tests.letters import QUICK


@pytest.fixture(scope="module")
def run(letter_run):
    return Run(letter_run)


def test_a_run_has_all_that_its_record_has(run, letter_run):
    assert run.record is letter_run
    assert run.design == letter_run.design
    assert run.structure is letter_run.structure
    assert run.time is letter_run.time
    assert run.stages == letter_run.stages
    assert run.series is letter_run.series
    assert np.array_equal(run.measured("mouth"), letter_run.measured("mouth"))
    assert {"series", "stages", "outcome", "figure", "to_dataframe"} <= set(dir(run))
    with pytest.raises(AttributeError, match="nothing"):
        run.nothing  # noqa: B018
    for other in (copy.copy(run), copy.deepcopy(run), pickle.loads(pickle.dumps(run))):
        assert np.array_equal(other.time, run.time)


def test_an_outcome_is_computed_once_and_named_by_the_run(run):
    assert run.outcome is run.outcome
    assert run.outcome.status == ff.measure(run).status == ff.measure(run.record).status
    assert repr(run) == "<Run of letter-fold: closed and opened>"


def test_functions_that_accept_a_record_accept_a_run(run, tmp_path):
    assert as_record(run) is run.record
    assert ff.figure(run, "angles").axes
    ff.film(run, tmp_path / "short.gif", size=(160, 160), fps=1, slower=2)
    ff.compare([run, run.record], tmp_path / "both.html")
    assert "2: letter-fold" in (tmp_path / "both.html").read_text("utf-8")
    with pytest.raises(ff.InputError, match="need 2 to 12 runs, got 1"):
        ff.compare([run], tmp_path / "one.html")
    parts = ff.make.parts("letter-fold", "sheet")
    assert all(check.ok for check in ff.make.check_parts(parts, run))


@pytest.mark.usefixtures("no_column_figures")
def test_a_run_draws_saves_and_shows_itself(run, tmp_path):
    assert run.figure("energy", width="page").get_size_inches()[0] == pytest.approx(7.1)
    run.page(tmp_path / "run.html", engine=False)
    assert "letter-fold" in (tmp_path / "run.html").read_text("utf-8")
    run.save(tmp_path / "there")
    loaded = ff.load_run(tmp_path / "there")
    assert isinstance(loaded, Run)
    assert loaded.data.identical(run.data)
    with pytest.raises(ff.InputError, match='did you mean "angles"'):
        run.figure("angels")
    with pytest.raises(ff.InputError, match=r"^folder: need a path, got 3"):
        run.save(3)
    with pytest.raises(ff.InputError, match=r"^path: need a path, got None"):
        run.page(None)


def test_tables_of_a_run_are_not_empty_and_have_a_row_for_each_time(run):
    table = run.to_dataframe()
    assert table.index.name == "time"
    assert len(table) == len(run.time)
    hinge = run.structure.hinges[0].name
    assert np.array_equal(table[f"hinge_angle[{hinge}]"], run.series["hinge_angle"][:, 0])
    point = run.structure.points[0].name
    assert np.array_equal(table[f"point_position[{point} z]"], run.series["point_position"][:, 0, 2])
    assert table.attrs["units"]["hinge_angle"] == "rad"
    # the structure has no springs
    assert "spring_force" not in run.data
    assert len(run.data.to_dataframe())
    assert 0 in run.record.dataset.sizes.values()


def test_an_outcome_is_a_row_of_plain_values(run):
    row = run.outcome.to_dict()
    closed = run.outcome.states["closed"]
    assert (row["design"], row["verdict"], row["closed"]) == ("letter-fold", "reached", True)
    assert row["close_time_s"] == run.outcome.transitions["close"].time
    assert row["closed_tendon_energy_J"] == pytest.approx(closed.tendon_energy.sum())
    assert row["closed_mouth_m"] == closed.readings["mouth"].mean[0]
    assert row["closed_creases_rad"] == closed.readings["creases"].mean.tolist()
    series = run.outcome.to_series()
    assert series.name == "letter-fold"
    assert series["close_work_J"] == row["close_work_J"]


def test_a_state_that_was_not_reached_has_no_numbers():
    never = {"protocol.stages.1.time_limit": "10 ms"}
    row = ff.run(ff.load_design("letter-fold", QUICK | never), confirm=False).outcome.to_dict()
    assert row["close_succeeded"] is False
    assert row["close_time_s"] is None


def test_other_results_are_tables_too(surveyed):
    landscape = surveyed("reference")
    table = landscape.to_dataframe()
    assert table.index.tolist() == [state.name for state in landscape.states]
    assert landscape.barrier("flat", "folded") > 0
    design = ff.load_design("letter-fold", QUICK)
    converged = ff.converge(design, timesteps="0.5 0.25 ms").to_dataframe()
    assert {"verdict", "close_time_s"} <= set(converged)
    changed = ff.assumptions(design, only=["timestep"]).to_dataframe()
    assert {"effect", "close_time_s", "close_work_J"} <= set(changed)
    study = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    assert study.estimate()[:2] == (2, 2)
    assert study.run().to_dataframe()["status"].tolist() == ["closed and opened"] * 2

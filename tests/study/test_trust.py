"""Studies with wings whose timestep is too long: tables, files and maps contain no numbers of these."""

import csv
import io
import json

import numpy as np
import pytest
from matplotlib.collections import QuadMesh

from forficula.show.folder.study_folder import study_drawings
from forficula.show.page.data.study_data import study_data
from forficula.show.study.maps import draw_first_times, draw_work_maps, missing_reasons
from forficula.study import load_study, run_study, table_csv
from tests.show.study.test_maps import legend, panels

# below 2 MPa the wing folds; 20 MPa is too stiff for 0.2 ms, and 60 MPa diverges
FACTORS = '"membrane.youngs_modulus" = ["1 MPa", "2 MPa", "20 MPa", "60 MPa"]\n"tendon.rest_length" = ["7 cm", "9 cm"]'
# the residual limit of the short protocol
COARSE = (
    'protocol.timestep = "0.4 ms"\nstops.time_constant = "2 ms"\n'
    "protocol.least_hold = 0.0\nprotocol.residual_limit = 0.02"
)
SEARCH = '[search]\nfold_torques = ["20 N cm", "50 N cm"]\nunfold_torques = ["100 N cm"]'
NUMBERS = ("fold_time", "unfold_time", "fold_work", "unfold_work", "flat_energy", "folded_energy", "opened_energy")
SILENT = ["untrusted", "diverged"]


def written(folder, write_study_file, head="", tail=""):
    path = write_study_file(folder / "stiff.toml", FACTORS, head, tail)
    path.write_text(path.read_text("utf-8").replace(COARSE, 'protocol.timestep = "0.2 ms"'), "utf-8")
    study = load_study(path)
    return study, run_study(study, folder / "out"), folder / "out"


@pytest.fixture(scope="module")
def runs(tmp_path_factory, write_study_file):
    return written(tmp_path_factory.mktemp("runs"), write_study_file)


@pytest.fixture(scope="module")
def searched(tmp_path_factory, write_study_file):
    return written(tmp_path_factory.mktemp("searched"), write_study_file, 'ask = "least-torques"', SEARCH)


@pytest.fixture(params=["runs", "searched"])
def either(request):
    return request.getfixturevalue(request.param)


def test_unreliable_points_say_so_and_have_no_number(either):
    _, table, _ = either
    silent = np.isin(table["verdict"].values, SILENT)
    assert silent[2:].all()
    assert not silent[:2].any()
    for name in (*NUMBERS, *(name for name in ("least_fold_torque", "least_unfold_torque") if name in table)):
        assert np.isnan(table[name].values[silent]).all(), name
    assert np.isfinite(table["fold_work"].values[:2]).all()
    assert set(table["outcome"].values[silent]) <= {"unreliable", "diverged"}
    residual = table["residual"].values
    assert (residual[table["verdict"].values == "untrusted"] > 0.005).all()
    assert (residual[~silent] <= 0.005).all()


def test_every_row_of_the_journal_has_a_status_a_verdict_and_a_residual(either):
    study, _, folder = either
    rows = [json.loads(line) for line in (folder / "journal.jsonl").read_text("utf-8").splitlines()]
    rows = [row for row in rows if "key" in row]
    assert len(rows) >= len(study.points)
    for row in rows:
        assert row["status"]
        assert (row["verdict"] in SILENT) == (row["folded"] is None)
        # for an undecided run, only the state on which the two runs disagree is unknown
        assert (row["verdict"] in (*SILENT, "undecided")) == (None in (row["folded"], row["opened"]))
        if row["verdict"] in SILENT:
            assert {row[name] for name in row if name.endswith(("_J", "_time_s", "angle_deg"))} == {None}
        assert (row["residual"] is None) == (row["verdict"] == "diverged")
    assert {row["verdict"] for row in rows} > set(SILENT)


def test_csv_has_verdicts_and_residuals_and_empty_cells(either):
    study, table, _ = either
    rows = list(csv.DictReader(io.StringIO(table_csv(study, table))))
    assert [row["verdict"] for row in rows] == table["verdict"].values.ravel().tolist()
    assert [row["status"] for row in rows] == table["status"].values.ravel().tolist()
    for row, residual in zip(rows, table["residual"].values.ravel(), strict=True):
        assert float(row["residual"] or "nan") == pytest.approx(residual, rel=0, nan_ok=True)
        if row["verdict"] in SILENT:
            assert {row[name] for name in row if name.endswith(("_J", "_s", "_N_m"))} == {""}
            assert row["status"].startswith(("unreliable: the energy balance misses", "diverged at t = "))


def test_maps_hatch_unreliable_points_and_scale_to_the_others(either):
    _, table, _ = either
    silent = {"unreliable", "diverged"} & set(table["outcome"].values.ravel())
    for drawing in study_drawings(table).values():
        assert silent <= set(legend(drawing(7.0)))
    figure = draw_work_maps(table)
    known = table["fold_work"].values[:2]
    (mesh,) = [item for item in panels(figure)["work of folding"].collections if isinstance(item, QuadMesh)]
    unit = 1e3 if known.max() < 1 else 1.0  # mJ or J
    assert (mesh.norm.vmin, mesh.norm.vmax) == pytest.approx((unit * known.min(), unit * known.max()))


def test_page_has_reasons_and_no_numbers_for_unreliable_points(either):
    study, table, _ = either
    data = study_data(study, table)
    words = [entry["word"] for entry in data["words"]]
    for quantity in data["quantities"]:
        if quantity["values"] is not None:
            for value, reason in list(zip(quantity["values"], quantity["reasons"], strict=True))[4:]:
                assert value is None
                assert words[reason] in ("unreliable", "diverged")


def test_each_torque_of_a_search_has_its_outcome(searched):
    _, table, _ = searched
    outcome = table["fold_outcome_by_torque"].values
    assert (np.isfinite(table["fold_time_by_torque"].values) == (outcome == "folded")).all()
    assert np.isin(outcome[2:], ["unreliable", "diverged"]).all()
    assert {"unreliable", "diverged"} & set(legend(draw_first_times(table)))
    for name in ("least_fold_torque", "least_unfold_torque", "fold_time", "opened_energy"):
        assert np.isin(missing_reasons(table, name).values[2:], ["unreliable", "diverged"]).all()


def test_automatic_timesteps_make_the_same_wings_reliable(tmp_path, write_study_file):
    path = write_study_file(tmp_path / "auto.toml", '"membrane.youngs_modulus" = ["20 MPa"]')
    path.write_text(path.read_text("utf-8").replace(COARSE, 'protocol.timestep = "auto"'), "utf-8")
    table = run_study(load_study(path), tmp_path / "out")
    assert table["verdict"].values[0] not in SILENT
    assert np.isfinite(table["fold_time"].values[0])
    assert table["residual"].values[0] <= 0.005

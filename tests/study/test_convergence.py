import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ellipk, ellipkinc

from forficula.analysis import Verdict
from forficula.cli import main
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model
from forficula.errors import InputError
from forficula.study.convergence.convergence import compare_models, converge
from forficula.study.convergence.observed_order import fit_order
from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, read_values
from tests.dynamics.protocols import on_protocol

STAGE = {"hold": 0.0}
SETTLE = STAGE | {"name": "settle", "drive": "none", "until": "time", "time_limit": 0.1}
FOLD = STAGE | {"name": "fold", "drive": "fold", "until": "folded", "time_limit": 0.2}


@pytest.fixture(scope="module")
def short(reference):
    """The reference design, folded after a short settling, and released."""
    return with_values(reference, {"protocol.stages": [SETTLE, FOLD]})


def hinges(one_hinge, steps, settle, duration=0.2):
    """Wings of one hinge that moves freely through the stages of a folding, one for each timestep."""
    wings = []
    for step in steps:
        wing = one_hinge(timestep=step, duration=duration).wing
        stages = [SETTLE | {"time_limit": settle}, FOLD | {"time_limit": duration}]
        design = with_values(wing.design, {"protocol.stages": stages})
        wings.append(on_protocol(wing, design))
    return wings


@settings(max_examples=60, deadline=None)
@given(
    st.floats(0.7, 4.0),
    st.floats(-0.3, 0.3).filter(lambda share: abs(share) > 1e-3),
    st.lists(st.integers(1, 100), min_size=3, max_size=7, unique=True).filter(lambda h: max(h) > 2 * min(h)),
)
def test_a_planted_order_and_limit_are_found_whatever_the_timesteps(order, share, tenths):
    limit, steps = 0.06, np.array(tenths) * 1e-5
    fit = fit_order(steps, limit * (1 + share * (steps / steps.max()) ** order))
    assert fit.observed
    # the search ends within 1e-6; such a flat misfit is known to the root of rounding, about 1e-8 of the change
    assert fit.order == pytest.approx(order, abs=1e-2)
    assert fit.limit == pytest.approx(limit, rel=1e-3)
    assert fit.time(steps) == pytest.approx(limit * (1 + share * (steps / steps.max()) ** order), rel=1e-6)


def test_with_a_constant_ratio_the_order_is_that_of_the_textbook():
    # Roache 1994, J. Fluids Eng. 116, 405: p = log((T3 - T2) / (T2 - T1)) / log(ratio); here log(4 / 1.3) / log 2
    fit = fit_order(np.array([0.4, 0.2, 0.1]), np.array([10.0, 6.0, 4.7]))
    assert fit.order == pytest.approx(math.log(4 / 1.3) / math.log(2), abs=1e-4)


def test_scattered_times_give_no_order_and_a_reason():
    steps = np.array([0.5, 0.4, 0.3, 0.2, 0.1])
    fit = fit_order(steps, 60 - 4 * steps + np.array([0.5, -0.6, 0.5, -0.5, 0.4]))
    assert (fit.observed, fit.order) == (False, 1.0)
    assert "scatters" in fit.reason
    assert fit.scatter > 0.4


@pytest.mark.parametrize(
    ("times", "reason"),
    [([5.0, 5.0, 5.0], "does not change"), ([5.0, 4.0], "three timesteps"), ([4.0, 5.0, 4.0], "scat")],
)
def test_times_without_an_order_have_a_reason(times, reason):
    fit = fit_order(np.array([0.4, 0.2, 0.1])[: len(times)], np.array(times))
    assert not fit.observed
    assert reason in fit.reason


def test_one_hinge_converges_with_order_one_to_its_closed_form(one_hinge):
    # from rest at phi0 to phi in t* (K(m) - F(asin(cos(phi/2) / cos(phi0/2)), m)), as a pendulum
    # (docs/model/theory.md, section "Snap of a hinge")
    steps, settle = [4e-4, 2e-4, 1e-4, 5e-5], 4e-3
    hinge = one_hinge()
    first, last = hinge.start / 2, math.radians(150) / 2
    m = math.cos(first) ** 2
    exact = hinge.time_scale * (ellipk(m) - ellipkinc(math.asin(math.cos(last) / math.cos(first)), m)) - settle
    result = compare_models(hinges(one_hinge, steps, settle), TIMESTEP, steps, 1e-4)
    assert result.orders["fold"].observed
    # the term in h^2 is about a tenth of that in h at the longest timestep
    assert result.orders["fold"].order == pytest.approx(1, abs=0.1)
    assert result.orders["fold"].limit == pytest.approx(exact, rel=1e-3)
    assert result.fine
    assert result.verdict.startswith("0.1 ms is short enough: the fold time differs by ")


def test_a_timestep_that_is_too_long_is_reported_with_one_that_suffices(one_hinge):
    # at 0.4 ms the hinge moves further than 10 deg into its stop
    steps = [2e-4, 1e-4, 5e-5, 2.5e-5]
    result = compare_models(hinges(one_hinge, steps, 4e-3), TIMESTEP, steps, 2e-4, tolerance=5e-3)
    assert result.fine is False
    advised = float(result.verdict.split("; ")[1].split(" ms")[0]) * 1e-3
    law = result.orders["fold"]
    assert abs(law.time(np.array(advised)) / law.limit - 1) <= 5e-3 < abs(law.time(np.array(2e-4)) / law.limit - 1)


def test_the_fold_time_is_that_of_the_angle_between_two_steps(short):
    result = converge(with_values(short, {"stops.time_constant": 2e-3}), TIMESTEP, [4e-4, 2e-4])
    assert result.design_value == 2e-4
    for step, time in zip(result.values, result.transition_times["fold"], strict=True):
        steps = time / step
        assert abs(steps - round(steps)) > 1e-3  # not a multiple of the step
    assert abs(result.transition_times["fold"][0] / result.transition_times["fold"][1] - 1) < 0.2
    assert result.orders["fold"] is not None
    assert not result.orders["fold"].observed
    assert result.orders["unfold"] is None


def test_the_own_value_is_run_and_timesteps_go_from_coarse_to_fine(short):
    result = converge(short, TIMESTEP, [3e-4, 4e-4])
    assert result.values.tolist() == [4e-4, 3e-4, 2e-4]
    assert result.design == short


def test_progress_counts_the_runs_whatever_meshes_they_have(short):
    seen = []
    converge(short, MESH, [1, 2], progress=lambda *report: seen.append(report))
    assert seen == [(number, 2, {"verdict": Verdict.REACHED, "outcome": "folded"}) for number in (1, 2)]


def test_a_device_that_this_computer_lacks_is_refused_in_one_line(monkeypatch, short):
    monkeypatch.setattr("forficula.dynamics.gpu.device.find_spec", lambda _: object())
    monkeypatch.setattr("forficula.dynamics.gpu.device._has_driver", lambda: False)
    with pytest.raises(InputError, match=r'^protocol.device: need "cpu" on this computer.*, got "gpu"$'):
        converge(with_values(short, {"protocol.device": "gpu"}), TIMESTEP, [1e-4, 2e-4])


def test_a_timestep_that_diverges_is_too_long(short):
    result = converge(with_values(short, {"protocol.timestep": 5e-3}), TIMESTEP, [5e-3, 2e-4])
    assert result.fine is False
    assert result.verdict.startswith("5 ms is too long: the run diverged at t = ")
    assert result.verdict.endswith("; the run at 0.2 ms does not diverge.")


def test_a_diverging_coarse_timestep_does_not_affect_the_own_one(short):
    result = converge(short, TIMESTEP, [5e-3, 2e-4, 1e-4])
    assert result.fine is not None
    assert 'the outcome changes with the timestep: "folded" at 0.2 ms, "diverged at ' in result.verdict
    assert np.isnan(result.transition_times["fold"]).tolist() == [True, False, False]


def test_an_outcome_that_changes_with_a_shorter_timestep_is_never_fine(one_hinge):
    # one wing has no time to fold, as if the timestep had prevented folding
    late = hinges(one_hinge, [2e-4], 4e-3)
    early = hinges(one_hinge, [1e-4], 4e-3, duration=0.005)
    result = compare_models([*late, *early], TIMESTEP, [2e-4, 1e-4], 2e-4)
    assert result.fine is False
    assert "the outcome changes with the timestep" in result.verdict


def test_a_timestep_is_borderline_if_its_bounds_enclose_the_tolerance(short):
    steps = [4e-4, 3e-4, 2e-4, 1e-4]
    least, most = converge(short, TIMESTEP, steps), converge(short, TIMESTEP, steps, tolerance=1e-6)
    between = converge(short, TIMESTEP, steps, tolerance=_middle(least))
    assert (most.fine, between.fine) == (False, None)
    assert between.verdict.startswith("0.2 ms is borderline: ")


def _middle(convergence):
    """The middle between the bounds of the difference from the limit, if no order is observed."""
    times, fit = convergence.transition_times["fold"], convergence.orders["fold"]
    assert not fit.observed
    far, near = abs(times[2] - fit.limit), abs(times[2] - times[3])
    return (min(far, near) + max(far, near, fit.scatter)) / 2 / fit.limit


def test_a_wing_that_does_not_fold_cannot_be_judged(reference):
    design = with_values(reference, {"protocol.stages": [SETTLE]})
    result = converge(design, TIMESTEP, [4e-4, 2e-4])
    assert result.fine is None
    assert "cannot be judged" in result.verdict
    assert np.isnan(result.transition_times["fold"]).all()


def test_moduli_and_meshes_report_the_change_of_the_fold_time(short):
    for key, values, name in ((YOUNGS_MODULUS, [2e6, 1e6], "2 MPa"), (MESH, [1, 2], "5 rows")):
        result = converge(short, key, values)
        move = 100 * (result.transition_times["fold"][1] / result.transition_times["fold"][0] - 1)
        assert f"by {move:+.2g} % at {name}" in result.verdict
        assert result.fine is None


def test_a_mesh_n_times_finer_keeps_the_rows_and_divides_the_gaps(reference):
    design = with_values(reference, {"membrane.proximal_rows": [0.2, 0.6], "membrane.distal_rows": [0.5]})
    only_settled = with_values(design, {"protocol.stages": [SETTLE | {"time_limit": 0.001}]})
    result = converge(only_settled, MESH, [2, 3])
    # gaps: two before the ring fold, two behind it
    assert result.rows == (5, 9, 13)
    # each row has two nodes on each of two panels
    assert len(compile_model(design).mesh.built) == 4 * 5


@pytest.mark.parametrize(
    ("key", "text", "values"),
    [
        (TIMESTEP, "0.5 0.4 0.1 ms", [5e-4, 4e-4, 1e-4]),
        (TIMESTEP, "0.5 ms, 0.4 ms", [5e-4, 4e-4]),
        (TIMESTEP, "0.1, 0.4 ms", [1e-4, 4e-4]),
        (TIMESTEP, "  1e-1ms 200us ", [1e-4, 2e-4]),
        (YOUNGS_MODULUS, "0.5 1 2 4 MPa", [5e5, 1e6, 2e6, 4e6]),
        (MESH, "1 2 3", [1, 2, 3]),
    ],
)
def test_numbers_without_a_unit_have_that_of_the_next_number(key, text, values):
    assert read_values(key, text) == pytest.approx(values, rel=1e-15)


@pytest.mark.parametrize(
    ("option", "text", "rule"),
    [
        ("--timesteps", "", "need at least two values"),
        ("--timesteps", "0.2 ms", "need at least two values"),
        ("--timesteps", "0.2 -0.1 ms", "need values > 0"),
        ("--timesteps", "0.2 0 ms", "need values > 0"),
        ("--timesteps", "0.2 0.1", "the unit is missing"),
        ("--timesteps", "0.2 ms 0.1", "the unit is missing"),
        ("--timesteps", "0.2 0.1 mm", "not a unit of the right kind"),
        ("--timesteps", "0,2 0,1 ms", "need numbers with spaces between"),
        ("--timesteps", "0.2 ms; 0.1 ms", "is not a unit"),
        ("--timesteps", "nan 0.1 ms", "need numbers with spaces between"),
        ("--timesteps", "0.2 0.2 ms", "need values that differ"),
        ("--timesteps", "0.2 ms 200 us", "need values that differ"),
        ("--moduli", "1 2 ms", "not a unit of the right kind"),
        ("--meshes", "1 2.5", "need whole numbers"),
        ("--meshes", "1 2 mm", "need whole numbers"),
        ("--meshes", "0 1", "need values > 0"),
        ("--meshes", "1 1000", "need whole numbers from 1 to 50"),
    ],
)
def test_an_invalid_list_exits_with_1_and_one_line(tmp_path, monkeypatch, capsys, option, text, rule):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as caught:
        main(["converge", "binder2025", option, text])
    output = capsys.readouterr()
    assert caught.value.code == 1
    assert output.err.startswith(f"forficula: {option}: ")
    assert rule in output.err
    assert (output.out, output.err.count("\n"), list(tmp_path.iterdir())) == ("", 1, [])


@pytest.mark.parametrize("options", [[], ["--meshes", "1 2", "--moduli", "1 2 MPa"]])
def test_only_one_setting_is_varied_at_a_time(capsys, options):
    with pytest.raises(SystemExit) as caught:
        main(["converge", "binder2025", *options])
    assert caught.value.code == 1
    assert "need one of --timesteps, --moduli, --meshes" in capsys.readouterr().err


def test_another_key_is_refused(reference):
    with pytest.raises(InputError, match=r"key: need protocol\.timestep"):
        converge(reference, "tendon.stiffness", [1.0, 2.0])


@pytest.mark.usefixtures("undrawn")
def test_the_command_leaves_a_table_its_numbers_two_figures_and_a_page(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    main(["converge", "binder2025", "--timesteps", "0.2 0.1 ms"])
    printed = capsys.readouterr().out
    folder = tmp_path / "out" / "binder2025-converge"
    assert printed.splitlines()[-1] == "written to out/binder2025-converge; open out/binder2025-converge/report.html"
    assert {file.name for file in folder.iterdir()} == {
        "convergence.json",
        "convergence.csv",
        "convergence.nc",
        "figures",
        "angles.png",
        "times.png",
        "report.html",
    }
    content = json.loads((folder / "convergence.json").read_text("utf-8"))
    assert content["design_hash"] == load_design("binder2025").hash
    assert [run["timestep_s"] for run in content["runs"]] == [2e-4, 1e-4]
    heading, *lines = (folder / "convergence.csv").read_text("utf-8").splitlines()
    assert heading == "timestep_s,membrane_rows,status,fold_time_s,unfold_time_s"
    assert [float(line.split(",")[3]) for line in lines] == [run["fold_time_s"] for run in content["runs"]]


def test_a_folder_that_cannot_be_written_is_refused_before_anything_runs(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    with pytest.raises(SystemExit) as caught:
        main(["converge", "binder2025", "--timesteps", "0.2 0.1 ms", "--out", str(tmp_path / "file" / "there")])
    assert caught.value.code == 1
    assert capsys.readouterr().err.startswith("forficula: --out: need a folder")

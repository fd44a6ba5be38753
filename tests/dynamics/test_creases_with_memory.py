"""Runs and statics of a strip whose crease is nonlinear, relaxes or wears out, against closed forms."""

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.outcome import measure
from forficula.analysis.storage import storage_texts
from forficula.analysis.strength import worn_crease
from forficula.design import design_from_text, load_design, with_values
from forficula.dynamics import energy_balance, simulate
from forficula.dynamics.engine.model import compile_model
from forficula.dynamics.engine.portable_model import why_not_portable
from forficula.errors import InputError
from forficula.show.run.strength_rows import strength_rows
from forficula.statics import quasi_static_path, start_drag
from forficula.structure import structure_of
from tests.dynamics.test_yielding_creases import VERTEX
from tests.memory_strips import (
    BRANCHES,
    DAMAGE,
    FACETS,
    MOMENT,
    NONLINEAR,
    STIFFNESS,
    STRIP,
    WIDTH,
    YIELD,
    changed,
    record,
    strip,
)

MIURA = """
name = "vertex"
source = "a test"
[pattern]
kind = "miura-ori"
columns = 2
rows = 2
long_side = "2 cm"
short_side = "2 cm"
acute_angle = "60 deg"
fold = "20 deg"
[facet]
kind = "rigid"
thickness = "0.3 mm"
[crease]
stiffness = "1 N m/rad/m"
rest_angle = "flat"
damping = "2e-3 N m s/rad/m"
[[support]]
of = "facet 0"
[[drive]]
name = "fold"
kind = "torque"
of = "creases"
value = "0.2 N m"
rise = "0.1 s"
[[protocol.stages]]
name = "fold"
drive = "fold"
until = "time"
time_limit = "0.15 s"
[[protocol.stages]]
name = "release"
drive = "none"
until = "time"
time_limit = "60 ms"
[protocol]
timestep = "0.1 ms"
"""


def folded(run):
    return np.searchsorted(run.time, 0.1) - 1


@pytest.mark.parametrize("facets", FACETS)
def test_a_fold_wears_a_crease_as_the_damage_law_says(facets):
    run = record(facets, wears=True)
    angle, left = run.series["hinge_angle"][:, 0], run.series["hinge_remaining"][:, 0]
    wear = np.cumsum(np.abs(np.diff(angle, prepend=0.0)))
    assert left == pytest.approx(1 - 0.5 * (1 - np.exp(-wear / np.deg2rad(90))), abs=1e-3)
    # at rest under the moment: M = left K angle
    assert angle[folded(run)] == pytest.approx(MOMENT / (left[folded(run)] * STIFFNESS), rel=2e-3)
    assert worn_crease(run).remaining == left[-1]
    assert strength_rows(run)[-1][0] == f"moment left after wear: {100 * left[-1]:.3g} %"
    balance = energy_balance(run)
    assert balance.crease_damage > 0.02 * balance.work
    assert balance.residual < 2e-3


@pytest.mark.parametrize("facets", FACETS)
def test_a_nonlinear_crease_rests_where_its_moment_is_that_of_the_drive(facets):
    run = record(facets, bends=True)
    angle = run.series["hinge_angle"][folded(run), 0]
    assert WIDTH * (angle + 0.1 * angle**2 + 0.3 * angle**3) == pytest.approx(MOMENT, rel=1e-3)
    energy = WIDTH * (angle**2 / 2 + 0.1 * angle**3 / 3 + 0.3 * angle**4 / 4)
    assert run.series["hinge_energy"][folded(run), 0] == pytest.approx(energy, rel=1e-6)
    assert energy_balance(run).residual < 1e-3


def test_a_crease_with_all_of_these_keeps_its_energy_balance():
    run = record("plates", relaxes=True, wears=True, bends=True, yields=True)
    balance = energy_balance(run)
    assert min(balance.crease_yielding, balance.crease_branches, balance.crease_damage) > 0.02 * balance.work
    assert balance.residual < 3e-3


def test_the_work_of_a_rest_angle_that_moves_at_once_closes_the_energy_balance():
    """The release moves it back in one step, by which creases yield."""
    rests = STRIP.replace('kind = "torque"', 'kind = "rest-angle"').replace(
        f'value = "{MOMENT} N m"', 'value = "50 deg"'
    )
    short = {"protocol.stages.0.time_limit": "20 ms", "protocol.stages.1.time_limit": "10 ms"}
    laws = FACETS["nodes"] | NONLINEAR | YIELD | BRANCHES | DAMAGE | short
    balance = energy_balance(simulate([compile_model(with_values(design_from_text(rests), laws))])[0])
    assert balance.crease_yielding > 0.1 * balance.work
    assert balance.residual < 5e-3


def test_joints_of_a_closed_loop_that_remember_keep_its_energy_balance():
    """Also while they hit their stops."""
    run = simulate([compile_model(with_values(design_from_text(MIURA), YIELD | BRANCHES | DAMAGE))])[0]
    balance = energy_balance(run)
    assert balance.stops > 0.02 * balance.work
    assert min(balance.crease_yielding, balance.crease_branches, balance.crease_damage) > 0.01 * balance.work
    assert balance.residual < 3e-3


def test_a_wait_relaxes_creases():
    """After 2 s under the moment the branch has relaxed: the crease is released with the branch turned backwards."""
    design = changed("plates", laws=BRANCHES, long={"protocol.stages.0.until": "rest", "protocol.stages.0.wait": "2 s"})
    design = with_values(design, {"protocol.stages.0.time_limit": "1 s"})
    run = simulate([compile_model(design)])[0]
    balance = energy_balance(run)
    released = np.searchsorted(run.time, run.time[-1] - 0.06) - 1
    angle = run.series["hinge_angle"][:, 0]
    assert run.series["waited"][-1] > 1
    assert angle[released] == pytest.approx(MOMENT / STIFFNESS, rel=1e-3)
    (text,) = storage_texts(run, measure(run))
    assert text.startswith('After 2 s in the stage "fold" its creases have relaxed: their Maxwell branches dissipated')
    assert balance.residual < 2e-3


@pytest.mark.parametrize("facets", FACETS)
def test_statics_has_nonlinear_moments_and_relaxed_branches(facets):
    path = quasi_static_path(changed(facets, bent=NONLINEAR, relaxed=BRANCHES))
    moment, angle = path.strength, path.angles[:, 0]
    closed = WIDTH * (angle + 0.1 * angle**2 + 0.3 * angle**3)
    assert path.moments[:, 0] == pytest.approx(moment, abs=1e-7)
    assert closed == pytest.approx(moment, abs=1e-7)
    assert path.stored == pytest.approx(WIDTH * (angle**2 / 2 + 0.1 * angle**3 / 3 + 0.3 * angle**4 / 4), abs=1e-9)


@pytest.mark.parametrize("facets", FACETS)
def test_a_crease_that_yields_and_is_nonlinear_has_the_sum_of_both_moments(facets):
    path = quasi_static_path(changed(facets, bent=NONLINEAR, yields=YIELD))
    angle = path.angles[:, 0]
    plastic = 0.4 * angle + 0.6 * np.minimum(angle, 0.3)
    closed = WIDTH * (plastic + 0.1 * angle**2 + 0.3 * angle**3)
    assert closed == pytest.approx(path.strength, abs=1e-7)
    assert path.moments[:, 0] == pytest.approx(path.strength, abs=1e-7)


@pytest.mark.parametrize("facets", FACETS)
def test_a_quasi_static_path_folds_as_far_as_a_run_in_which_a_crease_wears_out(facets):
    path, run = quasi_static_path(changed(facets, worn=DAMAGE)), record(facets, wears=True)
    folded = np.searchsorted(run.time, 0.1) - 1
    assert path.angles[-1, 0] == pytest.approx(run.series["hinge_angle"][folded, 0], rel=3e-3)
    assert path.remaining[-1, 0] == pytest.approx(run.series["hinge_remaining"][folded, 0], rel=3e-3)
    assert path.to_dataframe()["crease_damage_J"].to_numpy() == pytest.approx(path.losses["crease damage"])


@pytest.mark.parametrize("facets", FACETS)
def test_a_dragged_panel_wears_its_crease_in_both_senses(facets):
    design = changed(facets, worn=DAMAGE)
    drag = start_drag(design, int(np.argmax(quasi_static_path(design).positions[0][:, 0])))
    corner, near, angles = drag.start.positions[next(iter(drag.places))], drag.start, [0.0]
    for angle in (0.3, 0.1):
        target = np.array([0.04 + 0.04 * np.cos(angle), corner[1], 0.04 * np.sin(angle)])
        near = drag.to(target, near).point
        angles.append(near.angles[0])
    assert max(angles) > 0.15
    assert near.memory[1, 0] == pytest.approx(np.abs(np.diff(angles)).sum(), abs=1e-6)


def test_the_work_on_a_loop_of_rigid_facets_that_wears_out_is_stored_or_dissipated():
    path = quasi_static_path(with_values(design_from_text(VERTEX), DAMAGE))
    turned = path.angles[:, [hinge.assignment == "V" for hinge in path.structure.hinges]].sum(axis=1)
    lost = sum(energies[-1] for energies in path.losses.values())
    assert path.losses["crease damage"][-1] > 0.05 * lost
    assert np.trapezoid(path.strength, turned) == pytest.approx(path.stored[-1] - path.stored[0] + lost, rel=1e-3)


def test_statics_refuses_results_without_a_history_of_creases_that_wear_out():
    with pytest.raises(
        InputError, match=r"no energy landscape, because crease 0 wears out.*; runs and quasi-static paths"
    ):
        ff.landscape(changed("plates", worn=DAMAGE))
    drive = {"drive.0.kind": "rest-angle", "drive.0.value": "20 deg"}
    with pytest.raises(InputError, match="which changes rest angles, because crease 0 wears out"):
        quasi_static_path(changed("nodes", worn=DAMAGE, drive=drive))


def test_pages_refuse_creases_that_remember_and_paths_state_that_branches_are_relaxed():
    design = changed("plates", laws=BRANCHES)
    assert "remember" in why_not_portable(compile_model(design))
    (remark,) = quasi_static_path(design).remarks
    assert remark.startswith("the path is infinitely slow, so the Maxwell branches of crease 0 are relaxed")


def test_a_group_switches_off_what_all_creases_have():
    off = {"of": "creases", "yield_moment": "none", "branches": "none", "damage": "none"}
    design = changed("plates", laws=YIELD | BRANCHES | DAMAGE, group={"crease.group": [off]})
    hinge = structure_of(design).hinges[0]
    assert (hinge.yield_angle, hinge.hardening, hinge.branches, hinge.damage) == (np.inf, 0.0, (), None)
    assert with_values(strip(), design.as_tables()) == design
    crease = changed("plates", laws=BRANCHES | DAMAGE, off={"crease.branches": "none", "crease.damage": "none"}).crease
    assert (crease.branches, crease.damage) == ((), None)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"crease.cubic_stiffness": "-1 N m/rad^3/m"}, "crease.cubic_stiffness: need a spring that turns crease 0"),
        (
            {"crease.damage": {"loss": 0.5, "turn": "90 deg", "of": "set"}},
            'crease.damage.of: need "turns" for a crease that does not fold permanently',
        ),
        ({"crease.damage": {"loss": 1.5, "turn": "90 deg"}}, "crease.damage.loss: need <= 1, got 1.5"),
        (
            {"crease.branches": [{"stiffness": "0 N m/rad/m", "time": "1 s"}]},
            "crease.branches.0.stiffness: need > 0, got 0 N m/rad/m",
        ),
    ],
)
def test_values_without_a_meaning_are_refused(values, message):
    with pytest.raises(InputError, match=message):
        with_values(strip(), values)


def test_messages_of_a_part_name_the_part_before_every_key():
    with pytest.raises(InputError, match=r"outer\.crease\.hardening: needs outer\.crease\.yield_moment, from which on"):
        with_values(load_design("two-clasps"), {"outer.crease.hardening": "0.1 N m/rad/m"})

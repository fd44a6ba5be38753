"""Sheets whose creases take a set: spring-back and losses against closed forms, in runs and in quasi-static paths.

A crease of stiffness K, yield moment M0 and hardening H, folded slowly by the moment M > M0, turns by
M0 / K + (M - M0) / H, and its set is p = (M - M0) / H. Released, it rests at (1 - H / K) p, because the spring of
stiffness H beside the one that yields pulls it back.
"""

from functools import cache

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.strength import permanent_fold
from forficula.design import design_from_text, load_design, with_values
from forficula.dynamics import energy_balance, simulate
from forficula.dynamics.engine.model import compile_model
from forficula.errors import InputError
from forficula.goals.outcome_quantity import quantity_of
from forficula.goals.static_values import static_values
from forficula.show.run.strength_rows import strength_rows
from forficula.statics import quasi_static_path, start_drag
from forficula.statics.slow_margin import least_slow_torques
from forficula.structure import crease_law
from forficula.study.landscape_and_run import landscape_and_run
from forficula.study.tables.static_map import map_study

WIDTH = 0.02
STIFFNESS, HARDENING, YIELD = 1.0 * WIDTH, 0.4 * WIDTH, 0.5 * WIDTH
MOMENT = YIELD + 0.9 * HARDENING
SET = 0.9
DRIVE = {"kind": "torque", "of": "creases"}
NUMBERS = {
    "crease.stiffness": "1 N m/rad/m",
    "crease.yield_moment": "0.5 N m/m",
    "crease.hardening": "0.4 N m/rad/m",
    "crease.damping": "5e-3 N m s/rad/m",
    "crease.rest_angle": "flat",
    "crease.back_limit": "170 deg",
}
# the bars of nodes are softer than by default, which allows longer timesteps
FACETS = {"nodes": {"kind": "bars", "youngs_modulus": "1e8 Pa"}, "plates": {"kind": "rigid", "thickness": "0.3 mm"}}
FACET = """[facet]
kind = "bars"
"""
STEP = {"nodes": "0.04 ms", "plates": "0.1 ms"}
TEXT = """
name = "strip"
source = "a test"
[pattern]
kind = "pleats"
panels = 2
panel_lengths = ["4 cm", "4 cm"]
width = "2 cm"
assignment = "V"
[[support]]
of = "facet 0"
[[drive]]
name = "fold"
kind = "torque"
of = "creases"
value = "{moment} N m"
rise = "0.1 s"
[[drive]]
name = "back"
kind = "torque"
of = "creases"
value = "-{moment} N m"
rise = "0.1 s"
[[protocol.stages]]
name = "fold"
drive = "fold"
until = "time"
time_limit = "0.2 s"
[[protocol.stages]]
name = "{second}"
drive = "{drive}"
until = "time"
time_limit = "{time}"
"""


@cache
def strip(facets, second="release", drive="none", time="0.1 s"):
    text = TEXT.format(moment=MOMENT, second=second, drive=drive, time=time)
    tables = design_from_text(text + FACET)
    return with_values(tables, NUMBERS | {f"facet.{key}": value for key, value in FACETS[facets].items()})


@cache
def record(facets, **values):
    design = strip(facets, **values)
    return simulate([compile_model(with_values(design, {"protocol.timestep": STEP[facets]}))])[0]


@pytest.mark.parametrize("facets", FACETS)
def test_a_folded_strip_springs_back_as_far_as_its_elastic_part(facets):
    run = record(facets)
    angle, sets = run.series["hinge_angle"][:, 0], run.series["hinge_set"][:, 0]
    folded = np.searchsorted(run.time, 0.2) - 1
    assert angle[folded] == pytest.approx(YIELD / STIFFNESS + SET, rel=2e-3)
    assert sets[[folded, -1]] == pytest.approx([SET, SET], rel=2e-3)
    assert permanent_fold(run).angle == sets[-1]
    text, *_, crease, time = strength_rows(run)[-1]
    assert text.startswith("permanent fold: 51.")
    assert (crease, time) == ("crease0", "the end")
    assert angle[-1] == pytest.approx((1 - HARDENING / STIFFNESS) * SET, rel=2e-3)


@pytest.mark.parametrize("facets", FACETS)
def test_the_work_of_yielding_closes_the_energy_balance(facets):
    run = record(facets)
    balance = energy_balance(run)
    lost = (STIFFNESS - HARDENING) * YIELD / STIFFNESS * SET
    assert balance.crease_yielding == pytest.approx(lost, rel=2e-3)
    assert balance.residual < 1e-3
    both = STIFFNESS - HARDENING
    stored = (
        both / 2 * (run.series["hinge_angle"][-1, 0] - SET) ** 2 + HARDENING / 2 * run.series["hinge_angle"][-1, 0] ** 2
    )
    assert run.series["hinge_energy"][-1, 0] == pytest.approx(stored, rel=5e-3)


def test_a_cycle_of_the_moment_dissipates_the_area_of_its_loop():
    run = record("plates", second="unfold", drive="back", time="0.25 s")
    # from +M to -M the set changes by 2 p: the moment at which it yields backwards is M - 2 M0
    sets = run.series["hinge_set"][:, 0]
    assert sets[-1] == pytest.approx(-SET, rel=5e-3)
    lost = (STIFFNESS - HARDENING) * YIELD / STIFFNESS * 3 * SET
    assert energy_balance(run).crease_yielding == pytest.approx(lost, rel=5e-3)


@pytest.mark.parametrize("facets", FACETS)
def test_the_quasi_static_path_has_the_moment_of_the_closed_form(facets):
    path = quasi_static_path(strip(facets))
    moment, angle, sets = path.strength, path.angles[:, 0], path.sets[:, 0]
    beyond = np.maximum(moment - YIELD, 0.0) / HARDENING
    assert path.reached
    assert angle == pytest.approx(np.minimum(moment, YIELD) / STIFFNESS + beyond, abs=1e-6)
    assert sets == pytest.approx(beyond, abs=1e-6)
    assert path.moments[:, 0] == pytest.approx(moment, abs=1e-9)
    lost = (STIFFNESS - HARDENING) * YIELD / STIFFNESS * sets[-1]
    assert np.trapezoid(moment, angle) == pytest.approx(path.stored[-1] + lost, rel=1e-3)


def test_a_structure_whose_rest_depends_on_its_past_has_no_landscape():
    with pytest.raises(InputError, match="strip: has no energy landscape, because crease 0 folds permanently"):
        ff.landscape(strip("nodes"))


@cache
def slow_strip(second, drive):
    stages = 'until = "time"\nmotion = "quasi-static"'
    text = TEXT.replace('until = "time"', stages).format(moment=MOMENT, second=second, drive=drive, time="0.2 s")
    return with_values(
        design_from_text(text + FACET), NUMBERS | {f"facet.{key}": v for key, v in FACETS["plates"].items()}
    )


def test_quasi_static_stages_fold_a_strip_of_rigid_facets_as_far_as_the_closed_form():
    run = ff.run(with_values(slow_strip("unfold", "back"), {"protocol.timestep": STEP["plates"]})).record
    balance = energy_balance(run)
    assert run.series["hinge_set"][-1, 0] == pytest.approx(-SET, abs=1e-6)
    assert run.series["hinge_angle"][-1, 0] == pytest.approx(-YIELD / STIFFNESS - SET, abs=1e-6)
    assert balance.crease_yielding == pytest.approx((STIFFNESS - HARDENING) * YIELD / STIFFNESS * 3 * SET, rel=1e-6)
    assert balance.residual < 1e-6


VERTEX = """
name = "vertex"
source = "a test"
[pattern]
kind = "vertex"
sectors = ["60 deg", "90 deg", "120 deg", "90 deg"]
lengths = ["4 cm"]
fold = "30 deg"
assignment = "MVVV"
[facet]
kind = "rigid"
thickness = "0.3 mm"
[crease]
stiffness = "1 N m/rad/m"
yield_moment = "0.5 N m/m"
hardening = "0.4 N m/rad/m"
damping = "5e-3 N m s/rad/m"
[[drive]]
name = "fold"
kind = "torque"
of = "valleys"
value = "0.04 N m"
rise = "0.5 s"
[[protocol.stages]]
name = "fold"
drive = "fold"
until = "time"
time_limit = "0.7 s"
"""


def test_creases_that_close_a_loop_of_rigid_facets_fold_as_far_in_statics_as_in_a_slow_run():
    design = design_from_text(VERTEX)
    path, run = quasi_static_path(design), ff.run(design).record
    assert path.angles[-1] == pytest.approx(run.series["hinge_angle"][-1], rel=5e-3)
    assert path.sets[-1] == pytest.approx(run.series["hinge_set"][-1], rel=5e-3)
    # the work of the torques on the valleys is stored or dissipated
    law = crease_law(path.structure, np.arange(4))
    lost = law.yield_loss(np.diff(path.sets, axis=0)).sum()
    turned = path.angles[:, [hinge.assignment == "V" for hinge in path.structure.hinges]].sum(axis=1)
    work = np.trapezoid(path.strength, turned)
    assert work == pytest.approx(path.stored[-1] - path.stored[0] + lost, rel=1e-3)


def test_the_second_transition_of_a_path_starts_with_the_permanent_fold_of_the_first_one():
    stages = [
        {"name": "close", "drive": "fold", "until": "crease > 60 deg", "time_limit": "1 s"},
        {"name": "release closed", "drive": "none", "until": "rest", "time_limit": "1 s", "state": "closed"},
        {"name": "open", "drive": "back", "until": "crease < -10 deg", "time_limit": "1 s"},
        {"name": "release open", "drive": "none", "until": "rest", "time_limit": "1 s", "state": "opened"},
    ]
    path = quasi_static_path(with_values(strip("plates"), {"protocol.stages": stages}), "open")
    folded = np.deg2rad(60) - YIELD / STIFFNESS
    # the least torque that reaches the first goal is known to 1 %
    assert path.sets[0, 0] == pytest.approx(folded, rel=0.05)
    assert path.angles[0, 0] == pytest.approx((1 - HARDENING / STIFFNESS) * path.sets[0, 0], abs=1e-6)
    moment = HARDENING * path.angles[-1, 0] + (STIFFNESS - HARDENING) * (path.angles[-1, 0] - path.sets[-1, 0])
    assert path.strength[-1] == pytest.approx(moment, abs=1e-9)


@pytest.mark.parametrize("facets", FACETS)
def test_a_dragged_panel_springs_back_along_the_elastic_slope(facets):
    path = quasi_static_path(strip(facets))
    tip = int(np.argmax(path.positions[0][:, 0]))
    drag = start_drag(strip(facets), tip)
    near, angles, sets = None, [], []
    for angle in (0.9, 0.8):
        target = np.array([0.04 + 0.04 * np.cos(angle), path.positions[0][tip, 1], 0.04 * np.sin(angle)])
        dragged = drag.to(target, near)
        near = dragged.point
        angles.append(near.angles[0])
        sets.append(near.sets[0])
        moment = HARDENING * angles[-1] + (STIFFNESS - HARDENING) * (angles[-1] - sets[-1])
        if facets == "plates":
            assert np.linalg.norm(dragged.force) * 0.04 == pytest.approx(abs(moment), rel=1e-3)
    assert sets[0] == pytest.approx(angles[0] - YIELD / STIFFNESS, abs=1e-9)
    assert sets[1] == pytest.approx(sets[0], abs=1e-12)


@pytest.mark.parametrize("call", [ff.quasi_static_path, lambda design: start_drag(design, 0)])
def test_driven_rest_angles_and_permanent_folds_are_not_combined_in_statics(call):
    text = TEXT.replace('kind = "torque"', 'kind = "rest-angle"').replace('"{moment} N m"', '"60 deg"')
    text = (
        text.replace('value = "-60 deg"', 'value = "-60 deg"')
        .replace('"-{moment} N m"', '"-60 deg"')
        .replace("value", "angle")
    )
    design = design_from_text(text.format(second="release", drive="none", time="0.1 s") + FACET)
    with pytest.raises(InputError, match='under "fold", which changes rest angles, because crease 0 folds permanently'):
        call(with_values(design, NUMBERS))


def folding_letter():
    return with_values(load_design("letter-fold"), {"crease.yield_moment": 0.005})


STATICS = {
    "map": lambda design: map_study(design, {"crease.stiffness": ["1 N m/rad/m", "2 N m/rad/m"]}),
    "least slow drives": lambda design: static_values(design, ["slow"]),
    "least slow torques": lambda design: least_slow_torques([design]),
    "quantities of statics": lambda _: quantity_of(folding_letter(), "slow_close"),
    "energy landscape": lambda design: landscape_and_run(design, simulation=True),
}


@pytest.mark.parametrize("result", STATICS)
def test_statics_that_ignore_permanent_folds_are_refused(result):
    with pytest.raises(InputError, match=f": has no {result}.*, because crease 0 folds permanently"):
        STATICS[result](strip("plates"))


def test_a_factor_that_lets_creases_fold_permanently_has_no_static_map():
    design = with_values(strip("plates"), {"crease.yield_moment": None, "crease.hardening": None})
    with pytest.raises(InputError, match="strip: has no map of slowly growing torques, because crease 0 folds perm"):
        map_study(design, {"crease.yield_moment": ["0.1 N m/m", "0.2 N m/m"]})


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"crease.hardening": "1 N m/rad/m"}, "crease.hardening: need < crease.stiffness"),
        ({"crease.yield_moment": "0 N m/m"}, "crease.yield_moment: need > 0"),
        ({"crease.stiffness": "0 N m/rad/m"}, "crease.yield_moment: needs a stiffness"),
    ],
)
def test_a_yield_without_a_meaning_is_refused(values, message):
    with pytest.raises(InputError, match=message):
        with_values(strip("nodes"), values)


def test_a_hardening_without_a_yield_moment_is_refused():
    elastic = {key: value for key, value in NUMBERS.items() if key != "crease.yield_moment"}
    design = design_from_text(TEXT.format(moment=MOMENT, second="release", drive="none", time="1 s") + FACET)
    with pytest.raises(InputError, match=r"crease\.hardening: needs crease\.yield_moment"):
        with_values(design, elastic)

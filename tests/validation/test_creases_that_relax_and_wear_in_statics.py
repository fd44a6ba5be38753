"""Wear and Maxwell branches of creases in quasi-static paths and stages, against closed forms and slow runs."""

from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

from forficula.dynamics import energy_balance
from forficula.dynamics.engine.model import compile_model
from forficula.dynamics.stepping.simulate import simulate_each
from forficula.statics import quasi_static_path, rest_path
from forficula.statics.survey import stage_rest_path
from tests.memory_strips import (
    BRANCH,
    BRANCHES,
    DAMAGE,
    FACETS,
    MOMENT,
    STIFFNESS,
    TIME,
    WIDTH,
    YIELD,
    changed,
)

LOSS, TURN = 0.5, np.pi / 2
SLIGHT = {"crease.damage": {"loss": 0.2, "turn": "90 deg"}}
HARDENING, YIELD_ANGLE = 0.4 * WIDTH, 0.3
RAMP, HOLD = 0.3, 0.1
PUSH = 0.0075


def left(wear, loss=LOSS):
    return 1 - loss * (1 - np.exp(-wear / TURN))


def slow_record(design):
    return dict(simulate_each([compile_model(design)], 1, solver=stage_rest_path))[0]


def staged(facets, laws, *stages, **values):
    """Return a strip with stages of the drive and of none: name, drive, duration in s, and whether quasi-static."""
    tables = [
        {"name": name, "drive": drive, "until": "time", "time_limit": f"{time} s"}
        | ({"motion": "quasi-static"} if slow else {})
        for name, drive, time, slow in stages
    ]
    return changed(facets, laws=laws, stages={"protocol.stages": tables} | values)


@pytest.mark.parametrize("facets", FACETS)
def test_a_path_has_the_moment_and_the_loss_of_a_crease_that_wears_out(facets, agree):
    """From rest the wear is the angle: M = s(a) K a, and the loss is the integral of -s'(w) K w^2 / 2."""
    path = quasi_static_path(changed(facets, laws=DAMAGE))
    angle, strength = path.angles[:, 0], path.strength
    over = ("fold angle (rad)", angle)
    closed = left(angle) * STIFFNESS * angle
    agree("moment", strength, closed, by="damage law", unit="N m", abs=1e-6 * MOMENT, over=over)
    agree("moment of the spring", path.moments[:, 0], strength, by="drive", unit="N m", abs=1e-6 * MOMENT, over=over)
    end = angle[-1] / TURN
    lost = STIFFNESS / 2 * LOSS * TURN**2 * (2 - np.exp(-end) * (end**2 + 2 * end + 2))
    agree("energy lost by wear", path.losses["crease damage"][-1], lost, by="integral", unit="J", rel=1e-6)
    assert path.remaining[-1, 0] == pytest.approx(left(angle[-1]), rel=1e-12)
    assert set(path.losses) == {"crease damage"}


@pytest.mark.parametrize(("facets", "error"), [("nodes", 1e-6), ("plates", 1e-2)])
def test_a_crease_that_wears_out_fast_snaps_at_the_largest_moment(facets, error, agree):
    """M = K a exp(-a / T) is largest at a = T, where it is K T / e. Least torques of trees are known to 1 %."""
    worn_after = np.radians(30)
    fast = {"crease.damage": {"loss": 1.0, "turn": "30 deg"}, "crease.fold_limit": "100 deg"}
    path = quasi_static_path(changed(facets, laws=fast))
    snap = path.marks[0]
    assert (snap.kind, path.reached) == ("snap", True)
    largest = STIFFNESS * worn_after / np.e
    agree("moment at the snap", snap.strength, largest, by="largest moment", unit="N m", rel=error)
    # the work of the drive is stored, dissipated by wear, or released by the snap
    work = np.trapezoid(path.strength, path.angles[:, 0])
    spent = path.stored[-1] + path.losses["crease damage"][-1] + snap.released
    agree("work of the drive", work, spent, by="energies and losses", unit="J", rel=5e-3)


def test_cycles_of_the_moment_wear_a_bilinear_crease_as_in_the_closed_form(agree, monkeypatch):
    """On each branch M = s(w) (H a +- (K - H) a_y) once the crease yields, and w grows by the turn."""
    # fewer digits of the work
    monkeypatch.setattr(rest_path, "_DEPTH", -1)
    drives = [
        {"name": name, "kind": "torque", "of": "creases", "value": f"{moment} N m"}
        for name, moment in (("fold", PUSH), ("back", -PUSH))
    ]
    turns = [("fold", "fold"), ("unfold", "back"), ("fold again", "fold")]
    run = slow_record(staged("plates", SLIGHT | YIELD, *((*turn, 1, True) for turn in turns), drive=drives))
    angle, wear, closed, plastic_fold, lost = 0.0, 0.0, [], 0.0, np.zeros(2)
    for sense in (1, -1, 1):

        def short(turned, angle=angle, wear=wear, sense=sense):
            plastic = HARDENING * (angle + sense * turned) + sense * (STIFFNESS - HARDENING) * YIELD_ANGLE
            return left(wear + turned, 0.2) * plastic - sense * PUSH

        turned = brentq(short, YIELD_ANGLE * (2 if wear else 1), 5.0)
        path = angle + sense * np.linspace(0, turned, 20001)
        sets = path - np.clip(path - plastic_fold, -YIELD_ANGLE, YIELD_ANGLE)
        shares = left(wear + np.abs(path - angle), 0.2)
        stored = HARDENING / 2 * path**2 + (STIFFNESS - HARDENING) / 2 * (path - sets) ** 2
        yielding = (STIFFNESS - HARDENING) * YIELD_ANGLE * np.abs(np.diff(sets))
        lost += [np.sum((shares[1:] + shares[:-1]) / 2 * yielding), -np.trapezoid(stored, shares)]
        angle, wear, plastic_fold = path[-1], wear + turned, sets[-1]
        closed.append(angle)
    ends = np.searchsorted(run.time, [stage.end for stage in run.stages]) - 1
    ours = run.series["hinge_angle"][[*ends[:-1], -1], 0]
    agree("angle at the ends of half cycles", ours, np.array(closed), by="closed form", unit="rad", abs=1e-6)
    assert run.series["hinge_remaining"][-1, 0] == pytest.approx(left(wear, 0.2), rel=1e-6)
    balance = energy_balance(run)
    dissipated = np.array([balance.crease_yielding, balance.crease_damage])
    agree("energies lost by yielding and wear", dissipated, lost, by="integrals", unit="J", rel=1e-4)
    assert balance.residual < 1e-5


def ramped(time):
    """Return the angle of a standard linear solid under a moment that grows evenly in `RAMP`, at a time, rad."""
    slow = TIME * (STIFFNESS + BRANCH) / STIFFNESS
    return MOMENT / RAMP / STIFFNESS * (time - BRANCH * TIME / STIFFNESS * (1 - np.exp(-time / slow)))


@cache
def ramp(facets):
    laws = BRANCHES | {"crease.damping": "5e-4 N m s/rad/m"}
    held = [("hold", "fold", HOLD, False)] if facets == "plates" else []
    others = {"drive.0.rise": "1 ms", "protocol.window": "20 ms"}
    return slow_record(staged(facets, laws, ("fold", "fold", RAMP, True), *held, **others))


@pytest.mark.parametrize("facets", FACETS)
def test_a_stage_turns_a_crease_with_a_branch_as_the_standard_linear_solid(facets, agree):
    run = ramp(facets)
    first = np.searchsorted(run.time, run.stages[0].end - RAMP, side="right")
    rows = slice(first, np.searchsorted(run.time, run.stages[0].end) - 1)
    time = run.time[rows] - run.time[first - 1]
    angle = run.series["hinge_angle"][rows, 0]
    over = ("time (s)", time)
    agree("fold angle under a ramp", angle, ramped(time), by="standard linear solid", unit="rad", abs=5e-4, over=over)
    # the times of rows are rounded to timesteps, except at the end
    end = run.series["hinge_angle"][rows.stop, 0]
    agree("fold angle at the end", end, ramped(RAMP), by="standard linear solid", unit="rad", abs=1e-6)


def test_a_crease_continues_to_creep_in_the_motion_after_a_stage(agree):
    run = ramp("plates")
    slow = TIME * (STIFFNESS + BRANCH) / STIFFNESS
    rest = MOMENT / STIFFNESS
    crept = rest - (rest - ramped(RAMP)) * np.exp(-HOLD / slow)
    agree("fold angle after the hold", run.series["hinge_angle"][-1, 0], crept, by="creep", unit="rad", rel=1e-3)
    balance = energy_balance(run)
    assert balance.crease_branches > 0.05 * balance.work
    assert balance.residual < 2e-3

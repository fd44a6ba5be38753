"""A waiting stage ages the held state as simulating the whole time would.

A hinge that its tendon holds against a weight is a standard linear solid under a load: quasi-statically its angle obeys
an ordinary differential equation, which is integrated here (Dormand and Prince 1980). A tendon that only just holds its
bar releases it when k + k1 exp(-t / tau) has fallen to the stiffness that the weight requires.
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import forficula as ff
from forficula.analysis.storage import storage_texts, storages
from forficula.analysis.summary import summary
from forficula.design import with_values
from forficula.dynamics import energy_balance, load_record, save_record, simulate
from forficula.dynamics.stepping import waiting as module
from forficula.errors import InputError

REST, AREA, ARM, GRAVITY = 0.06, 12.5e-6, 0.055, 981.0
SPRING, BRANCH, TIME = 1e6, 6e5, 4000.0
LAW = {"linear_modulus": SPRING, "branches": [{"modulus": BRANCH, "time": TIME}]}
TAUT = math.radians(40)


def stage(name, until="rest", limit=3.0, wait=None, drive="none"):
    waits = {} if wait is None else {"wait": wait}
    return {"name": name, "drive": drive, "until": until, "hold": 0.05, "time_limit": limit, **waits}


def held(one_hinge, *stages, **values):
    """Return the record of a bar."""
    return simulate([built(one_hinge, *stages, **values)])[0]


def built(one_hinge, *stages, start=TAUT, gravity=-GRAVITY, law=LAW, **values):
    """Return a damped bar, folded by 90 deg: its weight pulls it upright, its tendon further; rows every 10 ms."""
    return one_hinge(
        REST,
        timestep=5e-4,
        start=start,
        values={
            "stops.time_constant": 2e-3,
            "tendon.rest_length": REST,
            "tendon.area": AREA,
            "tendon.law": law,
            "hinge.damping": 3e-3,
            "protocol.gravity": gravity,
            "protocol.sample_interval": 0.01,
            "protocol.rest_speed": math.radians(0.1),
            "protocol.window": 0.05,
            "protocol.stages": [stage("settle"), *stages],
            **values,
        },
    ).wing


def clock(record):
    return record.time + record.series["waited"]


def angles(record):
    return -record.series["hinge_angle"][:, 0]


def creeping(record):
    """Return the angle over time from the second stage on, by the quasi-static equation under the weight."""
    vein, reach = record.design.vein, record.design.pattern.distal_length
    moment = vein.density * math.pi * vein.diameter**2 / 4 * reach * GRAVITY * reach / 2
    spring, branch = SPRING * AREA / REST, BRANCH * AREA / REST
    first = int(np.searchsorted(record.time, record.stages[1].start))

    def length(angle):
        return 2 * ARM * np.cos(angle / 2)

    def pull(angle):
        """Return the branch's stiffness with which the tendon's lever holds the weight."""
        return -moment * np.cos(angle) / (ARM * np.sin(angle / 2)) - spring * (length(angle) - REST)

    def rate(_, angle, step=1e-6):
        slope = (pull(angle + step) - pull(angle - step)) / (2 * step)
        return -pull(angle) / TIME / (slope + branch * ARM * np.sin(angle / 2))

    span = clock(record)[[first, -1]]
    return solve_ivp(rate, span, angles(record)[[first]], rtol=1e-10, atol=1e-12).y[0]


@pytest.mark.parametrize("share", [0.1, 1.0, 5.0])
def test_under_a_load_it_creeps_as_the_quasi_static_equation_says(one_hinge, share):
    record = held(one_hinge, stage("store", wait=share * TIME))
    expected = creeping(record)
    crept = expected[-1] - expected[0]
    assert abs(crept) > math.radians(0.5)
    assert angles(record)[-1] == pytest.approx(expected[-1], abs=3e-3 * abs(crept))
    end = record.stages[1]
    first = int(np.searchsorted(record.time, end.start))
    change = {name: float((sery[-1] - sery[first]).sum()) for name, sery in record.series.items()}
    stored = sum(change[f"{name}_energy"] for name in ("tendon", "branch", "gravitational", "kinetic"))
    done = sum(change[f"{name}_work"] for name in ("hinge_damping", "elastic_damping", "branch_damping", "stop"))
    assert stored == pytest.approx(done, abs=1e-3 * abs(done))
    # it ends within the steps to rest
    assert end.waited + end.end - end.start == pytest.approx(share * TIME, rel=1e-3)
    assert 5 < len(storages(record)[0].clock) < 60


def test_a_smaller_allowed_error_of_leaps_gives_a_smaller_error(one_hinge, monkeypatch):
    off = []
    for allowed in (1e-2, 1e-5):
        monkeypatch.setattr(module.Waits.__init__, "__defaults__", (allowed,))
        record = held(one_hinge, stage("store", wait=2 * TIME))
        off.append(abs(angles(record)[-1] - creeping(record)[-1]))
    assert off[1] < off[0] / 4


def test_a_short_wait_equals_stepping_through_it(one_hinge):
    fast = LAW | {"branches": [{"modulus": BRANCH, "time": 10.0}]}
    rest = {"protocol.rest_speed": math.radians(100)}
    waits = held(one_hinge, stage("store", wait=10.0), law=fast, **rest)
    end = waits.stages[1]
    steps = held(one_hinge, stage("store", until="time", limit=end.end - end.start + end.waited), law=fast, **rest)
    assert end.waited > 5.0, "most of it is not stepped"
    for name in ("tendon_pull", "tendon_energy", "hinge_angle"):
        assert waits.series[name][-1] == pytest.approx(steps.series[name][-1], rel=1e-3)
    assert waits.series["branch_damping_work"][-1] == pytest.approx(steps.series["branch_damping_work"][-1], rel=0.03)


def test_two_consecutive_waits_equal_one_long_wait(one_hinge):
    twice = held(one_hinge, stage("store", wait=0.5 * TIME), stage("store on", wait=1.5 * TIME))
    once = held(one_hinge, stage("store", wait=2 * TIME))
    crept = angles(once)[-1] - angles(once)[int(np.searchsorted(once.time, once.stages[1].start))]
    assert angles(twice)[-1] == pytest.approx(angles(once)[-1], abs=3e-3 * abs(crept))
    assert [end.waited > 0 for end in twice.stages] == [False, True, True]


def test_without_branches_a_month_changes_nothing(one_hinge):
    plain = {"linear_modulus": SPRING}
    record = held(one_hinge, stage("store", wait=30 * 86400.0), law=plain)
    first = int(np.searchsorted(record.time, record.stages[1].start))
    assert record.stages[1].waited == pytest.approx(30 * 86400.0)
    assert angles(record)[-1] == pytest.approx(angles(record)[first], abs=math.radians(0.01))
    assert record.series["tendon_energy"][-1] == pytest.approx(record.series["tendon_energy"][first], rel=1e-3)
    assert "no other part creeps" in storage_texts(record, ff.measure(record))[0]


def test_a_bar_that_its_tendon_holds_open_falls_when_that_has_relaxed(one_hinge, reference):
    """In the overbend a taut tendon presses the bar against its stop, and the weight pulls it off."""
    # opened by a drive, its branch is not relaxed; the fold stage only precedes the unfold stage
    stages = [
        stage("fold", until="time", limit=0.01, drive="fold"),
        stage("open", until="opened", drive="unfold"),
        stage("store", wait=20 * TIME),
    ]
    torques = {"protocol.fold_torque": 0.0, "protocol.unfold_torque": 0.5}
    stop, vein, reach = reference.hinge.overbend, reference.vein, reference.pattern.distal_length
    lever, stretch = ARM * math.sin(stop / 2), 2 * ARM * math.cos(stop / 2) - REST
    rested, needed = SPRING * AREA / REST * stretch, 11.0  # N
    by_weight = vein.density * math.pi * vein.diameter**2 / 4 * reach * reach / 2 * math.cos(stop)
    record = held(one_hinge, *stages, start=math.radians(60), gravity=-needed * lever / by_weight, **torques)
    store = storages(record)[0]
    branch = float(store.pulls[0, 0]) - rested
    assert rested < needed < rested + branch
    falls = TIME * math.log(branch / (needed - rested))
    fallen = store.clock[np.argmax(store.pulls[:, 0] < 0.9 * rested)]
    # within the last leap of time, at most twice as long as the one before
    assert falls <= fallen <= 2.2 * falls
    assert energy_balance(record).residual < 5e-3


def test_a_bar_that_creeps_faster_than_the_rest_speed_does_not_wait_and_is_reported(one_hinge):
    fast = LAW | {"branches": [{"modulus": BRANCH, "time": 20.0}]}
    record = held(one_hinge, stage("store", limit=0.5, wait=3600.0), stage("after", until="time"), law=fast)
    assert len(record.stages) == 2, "nothing comes after it"
    outcome = ff.measure(record)
    assert outcome.verdict == "moving"
    assert outcome.status == (
        'did not come to rest within 0.5 s (time_limit) in the stage "store", which waits 1 h at rest'
    )
    assert storages(record) == ()


def test_a_wait_is_read_in_days_and_hours_and_written_again(reference, tmp_path):
    for text, seconds in (("30 d", 2592000.0), ("12 h", 43200.0), ("90 min", 5400.0), ("2 s", 2.0)):
        design = with_values(reference, {"protocol.stages.2.wait": text})
        assert design.protocol.stages[2].wait == seconds
        ff.save_design(design, tmp_path / "design.toml")
        assert ff.load_design(tmp_path / "design.toml").hash == design.hash


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"protocol.stages.2.wait": "-1 d"}, "stages.2.wait: need >= 0, got -1 d"),
        (
            {"protocol.stages.2.wait": "30 m"},
            '"m" is not a unit of the right kind; write it such as "30 d", got "30 m"',
        ),
        (
            {"protocol.stages.1.wait": "1 d"},
            'stages.1.wait: need until = "rest", because a wait begins at rest, got until = "folded"',
        ),
        ({"protocol.stages.0.wait": "1 d"}, 'got until = "time"'),
    ],
)
def test_a_wait_that_cannot_be_is_refused(reference, values, message):
    with pytest.raises(InputError) as caught:
        with_values(reference, values)
    assert message in str(caught.value)


def test_designs_without_a_wait_keep_their_hashes(reference):
    assert with_values(reference, {"protocol.stages.2.wait": "30 d"}).hash != reference.hash
    assert "wait" not in str(reference.as_tables())


def fading(time):
    """Return the share of a branch's force that remains after a month."""
    return math.exp(-30 * 86400 / time)


def test_a_month_folded_and_a_month_open_are_reported(stored_run, tmp_path):
    outcome = ff.measure(stored_run)
    assert outcome.status == "folded and opened"
    folded, opened = storages(stored_run)
    assert (folded.state, opened.state) == ("folded", "opened")
    assert folded.slack
    assert folded.weakened is None
    # a tendon that is pulled fast has the force of all branches; the slowest branch relaxes in a month
    law = stored_run.design.tendon.law
    fresh, left = (sum(b.modulus * part(b.time) for b in law.branches) for part in (lambda _: 1, fading))
    most = 1 - (law.linear_modulus + left) / (law.linear_modulus + fresh)
    # less: its branches had a month to recover at most
    assert 0.75 * most < opened.weakened < most
    first, second = storage_texts(stored_run, outcome)
    assert first.startswith("After 30 d folded the holding force is unchanged, because its tendons are slack")
    assert first.endswith("Then it opened again.")
    assert second.startswith("After 30 d opened its tendons pull ")
    assert energy_balance(stored_run).residual < 5e-3
    output = summary(stored_run, outcome, {})
    assert [item["wait_s"] for item in output["storage"]["waits"]] == [2592000.0, 2592000.0]
    assert output["stages"]["store folded"]["waited_s"] > 2591990
    save_record(stored_run, tmp_path / "record.nc")
    again = load_record(tmp_path / "record.nc")
    assert again.stages == stored_run.stages
    assert np.array_equal(again.series["waited"], stored_run.series["waited"])


def test_bars_with_different_waits_give_the_same_bits_side_by_side(one_hinge):
    waits = [3.0 * TIME, 0.1 * TIME, 0.0]
    models = [built(one_hinge, stage("store", wait=wait)) for wait in waits]
    for record, model, wait in zip(simulate(models, threads=2), models, waits, strict=True):
        (alone,) = simulate([model])
        assert alone.stages == record.stages
        assert (record.stages[1].waited > 0) == (wait > 0)
        assert set(alone.series) == set(record.series)
        for name, values in alone.series.items():
            assert values.tobytes() == record.series[name].tobytes(), name


def test_a_wing_of_the_same_materials_at_another_size_waits_as_long():
    stored = ff.load_design("binder2025-stored")
    assert ff.scale_design(stored, 0.5, natural=True).protocol.stages[2].wait == stored.protocol.stages[2].wait
    # waits scale together with relaxation times
    assert ff.scale_design(stored, 0.5).protocol.stages[2].wait == pytest.approx(stored.protocol.stages[2].wait / 2)

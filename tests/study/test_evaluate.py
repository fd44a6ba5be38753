"""Torques that are tried one after another until one opens give the same rows as all of them at once."""

import json
import math
import subprocess
import sys

import mujoco
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.analysis.margin import transition_margins
from forficula.design import with_values
from forficula.dynamics import compile_model
from forficula.errors import InputError
from forficula.structure import structure_of
from forficula.study.running.evaluate import evaluate, outcome_row, row_key
from forficula.study.running.runs import trial_chains


def test_torques_above_the_least_that_opens_do_not_run_and_the_others_keep_their_bits():
    torques = ("40 N cm", "60 N cm", "80 N cm")
    settings = {
        "tendon.rest_length": "7 cm",
        "protocol.fold_torque": "500 N cm",
        "protocol.timestep": "0.2 ms",
    }
    base = with_values(ff.load_design("binder2025"), settings)
    designs = [with_values(base, {"protocol.unfold_torque": torque}) for torque in torques]
    every = {row["key"]: row for row in evaluate(designs)}
    tried = list(evaluate(designs, until_last=True))
    assert [bool(row["opened"]) for row in tried] == [False, True]
    assert all(row == every[row["key"]] for row in tried)
    assert len(every) == 3
    # a bracket begins with the largest torque: its verdict would be repeated at half the timestep, but decides nothing
    keys = [row_key(design) for design in designs]
    assert every[keys[2]]["confirmed"]
    bracket = {row["key"]: row for row in evaluate([designs[2], *designs[:2]], until_last=True)}
    assert bracket == {key: every[key] for key in keys[:2]}


@pytest.mark.parametrize(("torques", "surplus"), [((0.8, 0.4, 0.6), [0]), ((0.8, 0.6, 0.4), []), ((0.4, 0.6, 0.8), [])])
def test_falling_torques_all_count_although_a_smaller_one_succeeds(torques, surplus):
    designs = [with_values(SHORT, {"protocol.unfold_torque": torque}) for torque in torques]
    assert trial_chains(designs, structure_of(SHORT)).surplus(2, reached=True) == surplus


def test_tendons_with_and_without_branches_and_yield_are_evaluated_side_by_side():
    law = {"linear_modulus": 4.8e6}
    branched = law | {"branches": [{"modulus": 1e6, "time": 0.002}]}
    laws = [law, branched, branched | {"linear_viscosity": 50.0}, law | {"yield_strain": 0.1}]
    settle = {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.02}
    fold = {"name": "fold", "drive": "fold", "until": "folded", "hold": 0.0, "time_limit": 0.1}
    values = {"protocol.stages": [settle, fold], "tendon.area": 18.75e-6}
    designs = [with_values(ff.load_design("binder2025"), values | {"tendon.law": law}) for law in laws]
    rows = {row["key"]: row for row in evaluate(designs)}
    for design in designs:
        record = ff.run(design, confirm=False)
        margins = {f"{name}_margin": margin for name, margin in transition_margins(record, ff.measure(record)).items()}
        short = not ff.measure(record).holds["folded"]
        alone = (
            {"key": row_key(design), "timestep_s": 2e-4, "confirmed": None, "short_of_goal": short}
            | outcome_row(ff.measure(record))
            | margins
        )
        # sparse records do not have the energy of membranes
        for row in (rows[row_key(design)], alone):
            for state in ("flat", "folded", "opened"):
                row.pop(f"{state}_stored_energy_J", None)
        assert rows[row_key(design)] == alone


STAGE = {"until": "time", "hold": 0.0, "time_limit": 0.005}
SHORT = with_values(
    ff.load_design("binder2025"),
    {
        "protocol.stages": [
            STAGE | {"name": "settle", "drive": "none"},
            STAGE | {"name": "fold", "drive": "fold", "until": "folded"},
            STAGE | {"name": "unfold", "drive": "unfold", "until": "opened"},
        ]
    },
)
KEYS = (
    *("pattern.proximal_length", "pattern.distal_length", "pattern.hub_radius", "vein.diameter", "vein.density"),
    *("membrane.youngs_modulus", "membrane.thickness", "membrane.damping", "membrane.margin", "hinge.damping"),
    *("hinge.armature", "tendon.stiffness", "tendon.rest_length", "tendon.damping", "tendon.proximal_attachment"),
    *("protocol.sample_interval", "protocol.fold_torque", "protocol.unfold_torque", "protocol.rest_speed"),
    *("protocol.window", "protocol.gravity", "protocol.stages.1.hold"),
)


@settings(max_examples=60)
@given(st.dictionaries(st.sampled_from(KEYS), st.floats(-300, 300).map(lambda power: 10.0**power), max_size=2))
@example({"pattern.distal_length": 378.25949135728735})  # blows up in its first step
@example({"membrane.thickness": 1e228, "vein.density": 1e-76})  # its energies overflow
@example({"protocol.unfold_torque": 1e300})
@example({"protocol.window": 1e308})
@example({"membrane.youngs_modulus": 1e300, "vein.density": 1e-300})
@example(
    {"pattern.proximal_length": 1.0, "membrane.margin": 1e-17}
)  # a margin narrower than the resolution of a coordinate
def test_every_allowed_number_gives_one_row_of_plain_numbers(values):
    try:
        design = with_values(SHORT, values)
    except InputError:
        assume(False)
    (row,) = evaluate([design])
    assert row["key"] == row_key(design)
    assert row["status"]
    assert json.loads(json.dumps(row, allow_nan=False)) == row


def test_an_enormous_torque_gives_a_row_and_does_not_affect_others():
    designs = [SHORT, with_values(SHORT, {"protocol.fold_torque": 1e308})]
    small = [with_values(design, {"vein.density": 1e-3}) for design in designs]
    rows = {row["key"]: row for row in evaluate(small)}
    assert rows[row_key(small[0])]["status"] != ""
    assert "protocol.fold_torque: need a finite number" in rows[row_key(small[1])]["status"]


EVALUATION = "forficula.study.running.runs"


def test_the_first_wings_run_before_the_last_are_built(monkeypatch):
    built = []
    monkeypatch.setattr(f"{EVALUATION}._FIRST_SECONDS", 0.0)
    monkeypatch.setattr(f"{EVALUATION}.compile_model", lambda design: built.append(design) or compile_model(design))
    designs = [with_values(SHORT, {"tendon.stiffness": 1000.0 + number}) for number in range(5)]
    rows = evaluate(designs)
    next(rows)
    assert len(built) == 1
    assert len(list(rows)) == 4
    assert len(built) == 5


def test_a_batch_beyond_memory_runs_in_halves_and_a_single_wing_beyond_memory_is_a_row(monkeypatch):
    heavy = with_values(SHORT, {"tendon.stiffness": 1003.0})
    designs = [*(with_values(SHORT, {"tendon.stiffness": 1000.0 + number}) for number in range(3)), heavy]
    whole = {row["key"]: row for row in evaluate(designs)}
    stepping = sys.modules["forficula.dynamics.stepping.simulate"]
    stepper = stepping.Stepper

    class Full:
        def __init__(self, wings, *_):
            if len(wings) > 1 or wings[0].design == heavy:
                raise mujoco.FatalError("Could not allocate memory")
            self.inner = stepper(wings, *_)

        def __getattr__(self, name):
            return getattr(self.inner, name)

    monkeypatch.setattr(stepping, "Stepper", Full)
    rows = {row["key"]: row for row in evaluate(designs)}
    assert rows.keys() == whole.keys()
    assert {key: row for key, row in rows.items() if key != row_key(heavy)} == {
        key: row for key, row in whole.items() if key != row_key(heavy)
    }
    assert rows[row_key(heavy)]["status"] == (
        "cannot be built: binder2025: no memory left to simulate: Could not allocate memory"
    )


# 100 units with this many bytes more than the program itself needs
LIMITED = """
import resource, sys
import scipy.optimize, xarray
import forficula as ff
from forficula.analysis.margin import transition_margins
from forficula.dynamics import compile_model, simulate
stage = {"name": "s", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "1 ms"}
design = ff.load_design("binder2025", {"pattern.units": 100, "pattern.sector_angle": "1.7 deg", "vein.diameter":
    "0.01 mm", "guard.stretch": 2.0,
    "membrane.margin": "0.01 mm", "protocol.timestep": "0.1 ms", "protocol.stages": [stage]})
# threads and libraries that a simulation starts have their memory before the limit
simulate([compile_model(ff.load_design("binder2025", {"protocol.stages": [stage]}))], threads=1)
used = next(int(line.split()[1]) for line in open("/proc/self/status") if line.startswith("VmSize"))
for left in sys.argv[1:]:
    resource.setrlimit(resource.RLIMIT_AS, (1024 * used + int(left), resource.RLIM_INFINITY))
    try:
        simulate([compile_model(design)], threads=1)
    except ff.InputError as error:
        print(error)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="a limit on memory that holds is Linux's")
def test_a_wing_beyond_memory_is_one_line():
    left = {12_000_000: "MuJoCo cannot build it: ", 120_000_000: "no memory left to simulate: "}
    done = subprocess.run([sys.executable, "-c", LIMITED, *map(str, left)], capture_output=True, text=True, check=False)
    assert done.stderr == ""
    for line, message in zip(done.stdout.splitlines(), left.values(), strict=True):
        assert line.startswith(f"binder2025: {message}")


def test_more_units_than_anyone_simulates_are_refused():
    closed = {
        "guard.stretch": 10.0,
        "pattern.sector_angle": math.radians(0.3),
        "vein.diameter": 1e-6,
        "membrane.margin": 1e-6,
    }
    message = r"need at most 2002 bodies to simulate it \(two for every vein, pattern.units = 501\), got 2006$"
    with pytest.raises(InputError, match=message):
        compile_model(with_values(SHORT, {"pattern.units": 501, "protocol.sample_interval": 1.0} | closed))

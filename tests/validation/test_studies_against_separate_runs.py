"""Studies give the same numbers as separate runs, to the last bit.

They are compared with `forficula.run` and `forficula.measure`, one wing at a time. IEEE 754 arithmetic in a fixed order
does not depend on other computations.
"""

import math
import struct
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.analysis.confirmation import HALF_STEP
from forficula.design import with_values
from forficula.study import load_study, run_study
from forficula.study.running.second_runs import half_step, with_checks


def bits(value):
    return struct.pack("<d", math.nan if value is None else value)


def by_hand(design, *, confirmed):
    """Results of separate runs of a design: one, and one at half the timestep if the study found that it decides."""
    record = ff.run(design, confirm=False).record
    outcome = ff.measure(
        with_checks(record, {HALF_STEP: ff.run(half_step(design), confirm=False).record} if confirmed else {})
    )
    fold, unfold = outcome.transitions["fold"], outcome.transitions["unfold"]
    numbers = {
        "fold_time": fold and fold.time,
        "unfold_time": unfold and unfold.time,
        "fold_work": fold and fold.work,
        "unfold_work": unfold and unfold.work,
    } | {f"{name}_energy": state and float(np.sum(state.tendon_energy)) for name, state in outcome.states.items()}
    if outcome.verdict is ff.Verdict.UNDECIDED:
        numbers = {}  # a table has some of them, those on which both timesteps agree; here the verdict is compared
    elif not outcome.verdict.conclusive:
        numbers = dict.fromkeys(numbers)
    # a table does not contain a third value
    return numbers, (outcome.status, outcome.verdict, bool(outcome.holds["folded"]), bool(outcome.holds["opened"]))


def assert_study_is_separate_runs(agree, path, out, **options):
    study = load_study(path)
    table = run_study(study, out, **options)
    (factor,) = study.factors
    ours, theirs = [], []
    for number, value in enumerate(factor.values):
        row = table.isel({factor.dimension: number})
        confirmed = ff.Verdict(row["verdict"].item()) is ff.Verdict.UNDECIDED
        numbers, verdict = by_hand(with_values(study.base, {factor.key: value}), confirmed=confirmed)
        assert tuple(row[name].item() for name in ("status", "verdict", "folded", "opened")) == verdict
        for name, expected in numbers.items():
            assert bits(row[name].item()) == bits(expected), (name, value)
            if expected is not None and name.endswith("time"):
                ours.append(row[name].item())
                theirs.append(expected)
    if ours:
        agree("times of a study", ours, theirs, unit="s", by="separate runs, to the last bit")


@pytest.mark.parametrize(
    "factor",
    [
        '"pattern.hub_radius" = ["1.2 cm", "1.5 cm", "1.9 cm"]',
        '"pattern.sector_angle" = ["17 deg", "20 deg", "24 deg"]',
        '"pattern.units" = "1..3 step 1"',
        '"pattern.tangent" = ["left", "right"]',
        '"vein.density" = ["1 g/cm^3", "1.4 g/cm^3"]',
        '"membrane.distal_rows" = [[], [0.5]]',
        '"membrane.youngs_modulus" = ["0.5 MPa", "2 MPa"]',
        '"tendon.stiffness" = ["0 N/cm", "10 N/cm", "23.45 N/cm", "60 N/cm"]',
        '"protocol.fold_torque" = ["0 N cm", "10 N cm", "50 N cm", "500 N cm"]',
        '"protocol.unfold_torque" = "10..100 N cm step 30"',
        '"protocol.timestep" = ["0.4 ms", "0.3 ms", "8 ms"]',
        '"protocol.window" = ["10 ms", "50 ms"]',
        '"protocol.contact" = [false, true]',
        '"protocol.gravity" = ["0 m/s^2", "9.81 m/s^2"]',
    ],
)
def test_a_study_over_one_factor_equals_separate_runs(agree, tmp_path, study_file, factor):
    assert_study_is_separate_runs(agree, study_file(factor), tmp_path / "out")


@settings(max_examples=5, deadline=None)
@given(
    st.sampled_from(
        [("tendon.rest_length", 0, 0.1), ("pattern.hub_radius", 0.01, 0.02), ("hinge.damping", 1e-4, 1e-2)]
    ),
    # equal shares in different notation
    st.lists(st.integers(0, 1000).map(lambda thousandths: thousandths / 1000), min_size=1, max_size=3, unique=True),
    st.integers(1, 2),
    st.integers(1, 3),
)
def test_a_study_equals_separate_runs_for_any_values_threads_and_batch_size(
    agree, write_study_file, factor, shares, threads, batch
):
    key, low, high = factor
    unit = {"tendon.rest_length": "m", "pattern.hub_radius": "m", "hinge.damping": "N m s/rad"}[key]
    values = ", ".join(f'"{low + share * (high - low)!r} {unit}"' for share in shares)
    with tempfile.TemporaryDirectory() as folder:
        path = write_study_file(Path(folder) / "small.toml", f'"{key}" = [{values}]')
        assert_study_is_separate_runs(agree, path, Path(folder) / "out", threads=threads, batch=batch)

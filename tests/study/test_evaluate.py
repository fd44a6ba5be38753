"""Torques that are tried one after another until one opens leave the same rows as all of them at once."""

import forficula as ff
from forficula.design import with_values
from forficula.study.evaluate import evaluate, outcome_row, row_key


def test_torques_above_the_least_that_opens_do_not_run_and_the_others_keep_their_bits():
    torques = ("40 N cm", "60 N cm", "80 N cm")
    settings = {
        "tendon.rest_length": "7 cm",
        "protocol.fold_torque": "500 N cm",
        "protocol.timestep": "0.4 ms",
    }
    base = with_values(ff.load_design("binder2025"), settings)
    designs = [with_values(base, {"protocol.unfold_torque": torque}) for torque in torques]
    every = {row["key"]: row for row in evaluate(designs)}
    tried = list(evaluate(designs, until_opened=True))
    assert [bool(row["opened"]) for row in tried] == [False, True]
    assert all(row == every[row["key"]] for row in tried)
    assert len(every) == 3


def test_tendons_with_and_without_branches_and_yield_are_evaluated_side_by_side():
    law = {"linear_modulus": 4.8e6}
    branched = law | {"branches": [{"modulus": 1e6, "time": 0.002}]}
    laws = [law, branched, branched | {"linear_viscosity": 50.0}, law | {"yield_strain": 0.1}]
    designs = [
        with_values(ff.load_design("binder2025"), {"tendon.area": 18.75e-6, "tendon.law": each}) for each in laws
    ]
    rows = {row["key"]: row for row in evaluate(designs)}
    for design in designs:
        assert rows[row_key(design)] == {"key": row_key(design)} | outcome_row(ff.measure(ff.run(design)))

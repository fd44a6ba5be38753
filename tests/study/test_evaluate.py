"""Torques that are tried one after another until one opens leave the same rows as all of them at once."""

import forficula as ff
from forficula.design import with_values
from forficula.study.evaluate import evaluate


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

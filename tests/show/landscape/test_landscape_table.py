import pytest
from rich.console import Console

from forficula.design import load_design
from forficula.show.landscape.landscape_table import landscape_table
from forficula.study.runs import run


def printed(landscape, record=None):
    console = Console(width=110)
    with console.capture() as capture:
        console.print(landscape_table(landscape, record))
    return capture.get()


def line(text, start):
    return next(each for each in text.splitlines() if each.startswith(start))


def test_the_prediction_stands_beside_the_simulation(surveyed, reference_run):
    text = printed(surveyed("reference"), reference_run)
    # ideal, of the wing, simulated; the wing is slower than its hinge alone
    times = [float(word) for word in line(text, "from 1.0° past straight to 150.0°").split()[-6::2]]
    assert 30 < times[0] < times[1] < times[2] < 80
    # while it must stay folded, it folds on
    assert "folds to 179" in line(text, "from 1.0° past straight to 180.0°")
    assert "The simulated wing: folded and opened." in text
    assert "sampled every 1 ms" in text


def test_without_a_simulation_only_the_prediction_is_there(surveyed):
    assert "simulated" not in printed(surveyed("reference"))


def test_what_cannot_give_way_is_rigid(surveyed):
    cells = line(printed(surveyed("reference")), "flat (along").split()
    assert cells[-1] == "rigid"


@pytest.mark.parametrize("name", ["without hub", "without overbend", "slack", "without stiffness", "small"])
def test_every_landscape_reads_as_sentences_and_numbers(surveyed, name):
    text = printed(surveyed(name))
    assert "None" not in text
    assert "nan" not in text.split()
    assert text.rstrip().endswith((".", "rad/s", "none"))


def test_a_force_that_is_rounding_reads_zero(surveyed):
    cells = line(printed(surveyed("without hub")), "that fold").split()
    assert " ".join(cells).startswith("that fold, on every proximal turn axis 0 N cm")


def test_a_simulation_that_diverged_or_stuck_is_told_with_what_to_try(surveyed):
    wild = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    text = printed(surveyed("reference"), wild)
    assert "The simulated wing: diverged at t = " in text
    assert "shorter timestep" in text
    stiff = run(load_design("binder2025", {"tendon.rest_length": "0 cm", "tendon.stiffness": "60 N/cm"}))
    assert "The simulated wing: did not fold. Raise protocol.fold_torque" in printed(surveyed("reference"), stiff)

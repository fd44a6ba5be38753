import pytest
from rich.console import Console

from forficula.calls import landscape as energy_landscape
from forficula.design import load_design
from forficula.show.folder.landscape_folder import landscape_kinds
from forficula.show.landscape.landscape_table import landscape_table
from forficula.statics import landscape_summary
from forficula.study.running.runs import run


def printed(landscape, record=None):
    console = Console(width=110)
    with console.capture() as capture:
        console.print(landscape_table(landscape, record))
    return capture.get()


def line(text, start):
    return next(splitline for splitline in text.splitlines() if splitline.startswith(start))


def test_prediction_and_simulation_are_side_by_side(surveyed, reference_run):
    text = printed(surveyed("reference"), reference_run)
    # ideal, wing, simulated; the simulated wing is slower than its hinge alone
    times = [float(word) for word in line(text, "from 1.0° past straight to 150.0°").split()[-6::2]]
    assert 30 < times[0] < times[1] < times[2] < 80
    # stops yield, so it passes 180 deg
    assert len(line(text, "from 1.0° past straight to 180.0°").split()) > 6
    assert "The simulated wing: folded and opened." in text
    assert "sampled every 1 ms" in text


def test_without_a_simulation_there_is_only_the_prediction(surveyed):
    assert "simulated" not in printed(surveyed("reference"))


def test_infinite_stiffness_is_called_rigid(surveyed):
    cells = line(printed(surveyed("reference")), "flat (along").split()
    assert cells[-1] == "rigid"


NAMES = (
    "without hub",
    "without overbend",
    "slack",
    "without stiffness",
    "small",
    "off the bars",
    "beyond the stop",
    "own tendons",
    "plates",
    "soft plates",
)


@pytest.mark.parametrize("name", NAMES)
def test_every_landscape_reads_as_sentences_and_numbers(surveyed, name):
    text = printed(surveyed(name))
    assert "None" not in text
    assert "nan" not in text.split()
    assert text.rstrip().endswith((".", "rad/s", "none"))


def test_a_force_within_rounding_errors_is_displayed_as_zero(surveyed):
    cells = line(printed(surveyed("without hub")), "that fold").split()
    assert " ".join(cells).startswith("that fold, on every proximal turn axis 0 N cm")


def test_a_diverged_or_stuck_simulation_is_reported_with_advice(surveyed):
    wild = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    text = printed(surveyed("reference"), wild)
    assert "The simulated wing: diverged at t = " in text
    assert "shorter timestep" in text
    stiff = run(load_design("binder2025", {"tendon.rest_length": "0 cm", "tendon.stiffness": "60 N/cm"}))
    assert "The simulated wing: did not fold. No slowly growing torque up to 500 N cm" in printed(
        surveyed("reference"), stiff
    )


def test_a_barrier_away_from_straight_is_listed_with_its_angle(surveyed):
    text = printed(surveyed("off the bars"))
    # 10 N/cm, 9 cm, a stop at 3 deg, both attachments 2 mm off: 4.30 mJ at -4.2 deg, 6.8 N cm
    # (docs/model/theory.md, section "Tendon off the hinge axis")
    assert line(text, "ideal hinge, overbend to −4.2°").split()[-2:] == ["4.295", "mJ"]
    assert line(text, "ideal hinge               on its stop").split()[-3:] == ["6.829", "N", "cm"]
    assert "growth rate at its top" in text
    assert "from 1.0° past its top to 150.0°" in text


def test_a_vein_without_a_tendon_is_skipped(surveyed):
    text = printed(surveyed("own tendons"))
    assert "first hinge of the wing" in text
    assert "second hinge" not in text
    # remarks about one tendon name it
    assert "Vein 2: the tendon is slack from" in text


def test_no_barrier_leads_from_a_state_in_which_the_wing_does_not_rest(surveyed):
    text = printed(surveyed("folds by itself"))
    assert text.startswith("binder2025: monostable (partly folded); 1 of 8 combinations ")
    for barrier in ("flat until its weakest hinge folds alone", "flat to folded, all hinges together"):
        assert line(text, f"wing, {barrier}").split()[-1] == "none"
    assert landscape_summary(surveyed("folds by itself"))["wing"]["single_hinge_barriers_J"] is None


def test_plates_are_listed_with_their_equilibria_and_torques(surveyed, letter_run):
    text = printed(surveyed("plates"), letter_run)
    assert text.startswith(
        "letter-fold: bistable (flat, closed); barrier 53.17 µJ from flat to closed, 61.13 mJ back; a hinge"
    )
    assert "4 of 4 combinations of folded hinges are stable" in " ".join(text.split())
    assert "fold angle −3.0°" in line(text, "structure, flat")
    assert "105.6°" in line(text, "structure, closed")
    assert line(text, "crease 0 (left) of the structure, −3.0° to straight").split()[-2:] == ["53.17", "µJ"]
    assert line(text, "that make it get closed, on the creases").split()[-2:] == ["N", "cm"]
    # a hinge with a spring has no closed form, so only the run has a time
    assert "ideal hinge" not in text
    assert line(text, "from 1.0° past straight to 90.0°").split()[-1] == "s"
    assert "The simulated structure: closed and opened." in text
    for word in ("wing", "vein", "membrane", "pleats", "overbend"):
        assert word not in text


def test_a_single_hinge_is_listed_once_without_levels():
    landscape = energy_landscape("binder2025-joint")
    assert landscape_kinds(landscape) == ("tendon", "rests")
    text = printed(landscape)
    assert "binder2025-joint: bistable (flat, folded); barrier 7.025 mJ from flat to folded, 0.4871 J back; " in text
    assert line(text, "hinge of the joint, overbend to").split()[-2:] == ["7.025", "mJ"]
    assert "easiest hinge" not in text

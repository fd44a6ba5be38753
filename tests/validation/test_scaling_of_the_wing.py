"""A wing scaled in size, at fixed modulus and density, has the same motion in scaled time.

Dimensional analysis for a factor s: lengths are proportional to s, stiffness to E A / L ~ s, torque, energy and mass to
s^3, inertia to s^5 and time to s; speeds are constant (Ilton et al. 2018, arXiv 1711.04920, measured that speed).
"""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.design import scale_design, with_values
from tests.places import places

# exponent of the size per key, by hand, at fixed Pa and kg/m3; other keys are ratios, angles or counts
POWERS = {
    "pattern.proximal_length": 1,
    "pattern.distal_length": 1,
    "pattern.hub_radius": 1,
    "vein.diameter": 1,
    "vein.density": 0,
    "membrane.youngs_modulus": 0,
    "membrane.thickness": 1,
    "membrane.damping": 1,  # time
    "membrane.margin": 1,
    "hinge.damping": 4,  # torque / angular speed
    "hinge.armature": 5,
    "tendon.stiffness": 1,  # N/m = Pa m
    "tendon.rest_length": 1,
    "tendon.damping": 2,  # stiffness times time
    "tendon.proximal_attachment": 1,
    "tendon.distal_attachment": 1,
    "protocol.timestep": 1,
    "stops.time_constant": 1,
    "protocol.sample_interval": 1,
    "protocol.fold_torque": 3,
    "protocol.unfold_torque": 3,
    "protocol.rest_speed": -1,  # angular
    "protocol.window": 1,
    "protocol.gravity": -1,  # speed / time
}


def value(design, key):
    section, name = key.split(".")
    return getattr(getattr(design, section), name)


def scaled_by_hand(design, size):
    stages = [
        {**stage.model_dump(), "hold": stage.hold * size, "time_limit": stage.time_limit * size}
        for stage in design.protocol.stages
    ]
    values = {key: float(value(design, key)) * size**power for key, power in POWERS.items()}
    return with_values(design, {**values, "protocol.stages": stages})


def assert_moves_alike(agree, holds, small, large, size):
    assert small.data.sizes["time"] == large.data.sizes["time"]
    # rounding of the times
    ours, theirs = small.data["time"].values / size, large.data["time"].values
    agree("times divided by the size", ours, theirs, unit="s", by="the reference", rel=1e-12)
    # rounding, 1e-16, amplified by snaps, in which neighbouring motions diverge; largest difference seen: 1e-8
    ours, theirs = small.series["hinge_angle"], large.series["hinge_angle"]
    agree("angles of hinges", ours, theirs, unit="rad", by="the reference", abs=1e-6)
    for name in ("tendon_energy", "membrane_energy", "kinetic_energy", "motor_work"):
        series = large.data[name].values
        ours, theirs = small.data[name].values / size**3, series
        apart = np.abs(ours - theirs).max() / np.abs(series).max()
        holds("difference of energies divided by size³ and the largest", apart, below=1e-6, by="the reference")


@pytest.fixture(scope="module")
def earwig(reference):
    """A wing of the size of an earwig's: 10 mm from hub to tip."""
    return ff.run(scaled_by_hand(reference, 0.01 / 0.22), confirm=False)


def test_a_wing_of_a_tenth_of_the_size_has_the_same_scaled_motion(agree, holds, reference, reference_run):
    small = ff.run(scaled_by_hand(reference, 0.1), confirm=False)
    assert ff.measure(small).status == ff.measure(reference_run).status == "folded and opened"
    assert_moves_alike(agree, holds, small, reference_run, 0.1)


@pytest.mark.parametrize("size", [1 / 3, 0.7, 3.0])
def test_a_wing_whose_size_is_not_a_power_of_ten_has_the_same_scaled_motion(
    agree, holds, reference, reference_run, size
):
    # its lengths have other values in the model's units, so no constant may be in these units
    assert_moves_alike(agree, holds, ff.run(scaled_by_hand(reference, size), confirm=False), reference_run, size)


def test_an_earwig_sized_wing_has_the_same_scaled_motion(agree, holds, earwig, reference_run):
    assert_moves_alike(agree, holds, earwig, reference_run, 0.01 / 0.22)


def test_an_earwig_sized_wing_folds_with_microjoules_to_millijoules(holds, earwig):
    outcome = ff.measure(earwig)
    assert outcome.holds["folded"]
    assert outcome.holds["opened"]
    stored = 1e6 * outcome.states["flat"].tendon_energy.sum()
    holds("energy of the flat wing's tendons", stored, above=1, below=1e3, unit="µJ", by="size³")
    fold, unfold = (1e6 * outcome.transitions[name].work for name in ("fold", "unfold"))
    holds("works of folding and opening", [fold, unfold], above=1, below=1e4, unit="µJ")
    assert fold < unfold


@pytest.mark.parametrize("size", [0.1, 1 / 3, 0.01 / 0.22, 7.0])
def test_scale_design_multiplies_every_value_according_to_dimensional_analysis(reference, size):
    # gravity is 0 in the reference, which would hide its exponent
    reference = with_values(reference, {"protocol.gravity": 9.81})
    by_hand, scaled = scaled_by_hand(reference, size), scale_design(reference, size)
    for section, fields in by_hand.model_dump(exclude={"name", "source", "reproduces", "shows"}).items():
        # both omit a section that the design does not have
        for name, expected in (fields or {}).items():
            got = scaled.model_dump()[section][name]
            if name == "stages":
                times = [[(stage["hold"], stage["time_limit"]) for stage in stages] for stages in (got, expected)]
                # rounding, as everywhere below
                assert np.array(times[0]) == pytest.approx(np.array(times[1]), rel=1e-13)
            elif isinstance(expected, float):
                assert got == pytest.approx(expected, rel=1e-13), f"{section}.{name}"
            else:
                assert got == expected, f"{section}.{name}"


def test_the_speed_of_the_tips_does_not_depend_on_size(earwig, reference_run, agree):
    def fastest(record):
        ways = np.linalg.norm(np.diff(places(record, "tip"), axis=0), axis=-1)
        return ways.max() / record.design.protocol.sample_interval

    large = fastest(reference_run)
    agree(
        "largest speed of the tips of a wing of 1 cm", fastest(earwig), large, unit="m/s", by="one of 22 cm", rel=1e-6
    )
    assert math.log10(fastest(reference_run)) == pytest.approx(1, abs=1)  # m/s


def test_a_wing_with_contact_has_the_same_scaled_motion_at_any_size(agree, reference):
    touching = with_values(reference, {"protocol.contact": True, "contact.time_constant": "0.4 ms"})
    small = scale_design(touching, 0.5)  # other powers of ten in the model's units
    records = [ff.run(design, confirm=False) for design in (touching, small)]
    angles = [record.angles("ring") for record in records]
    fold = records[0].stages[1].end
    rows = int(np.sum(records[0].time <= fold))
    # every contact amplifies differences by rounding
    ours, theirs = angles[1][:rows], angles[0][:rows]
    agree("angles of a wing of half the size with contact", ours, theirs, unit="rad", by="full size", abs=1e-5)

"""The wing has mirror symmetry without gravity, and repeated runs give the same numbers.

Symmetry: without gravity the flat wing is its own image in its plane, which reverses the senses of all folds.
Repeatability: IEEE 754 arithmetic in a fixed order.
"""

import dataclasses

import numpy as np
import pytest

import forficula as ff
from forficula.design import with_values
from forficula.dynamics import compile_model, simulate
from forficula.pattern import earwig_pattern, ring_directions
from forficula.structure.fans.veins import structure_of_veins, veins_on
from tests.structures import compiled


def assert_same_bits(record, other):
    assert record.stages == other.stages
    assert set(record.data) == set(other.data)
    for name in record.data:
        assert record.data[name].values.tobytes() == other.data[name].values.tobytes(), name


def mirrored(design):
    """The wing with all senses reversed: its image in its own plane."""

    def image(design, _):
        veins = veins_on(earwig_pattern(design.fan), ring_directions(design.fan))
        return structure_of_veins(design, [dataclasses.replace(vein, sense=-vein.sense) for vein in veins])

    return compiled(design, image)


@pytest.fixture(scope="module")
def others(reference):
    """Wings of the same topology with other motions."""
    values = [{"tendon.rest_length": 0.07}, {"tendon.stiffness": 6000.0, "tendon.rest_length": 0.0}]
    return [with_values(reference, value) for value in values]


def test_the_mirror_image_of_the_wing_has_the_mirrored_motion(agree, reference, reference_run):
    image = simulate([mirrored(reference)])[0]
    assert image.data.sizes == reference_run.data.sizes
    signs = {"ring": 1, "turn": 1, "sweep": 1, "lift": -1}  # angles in the hinges' own senses
    for role, sign in signs.items():
        # rounding, 1e-16, amplified by the snaps; largest difference seen: 3e-13
        ours, theirs = image.angles(role), sign * reference_run.angles(role)
        agree("angles of hinges", ours, theirs, unit="rad", by="the image in its plane", abs=1e-9)
    places = image.series["point_position"] * [1, 1, -1]
    known = reference_run.series["point_position"]
    agree("positions of points", places, known, unit="m", by="the image in its plane", abs=1e-9)


def test_gravity_breaks_the_mirror_symmetry(holds, reference):
    heavy = with_values(reference, {"protocol.gravity": 9.81})
    up, down = (simulate([wing])[0].angles("ring") for wing in (compile_model(heavy), mirrored(heavy)))
    rows = min(len(up), len(down))
    apart = np.degrees(np.abs(up[:rows] - down[:rows]).max())
    holds("difference of angles from those of the image, with gravity", apart, above=1, unit="deg")


def test_the_opposite_turning_sense_of_the_veins_is_another_mechanism(holds, reference, reference_outcome):
    """The sense in which the veins turn matters (docs/model/theory.md, section Fan pattern)."""
    left = ff.measure(ff.run(with_values(reference, {"pattern.tangent": "left"}), confirm=False))
    assert reference_outcome.holds["folded"]
    angles = [item.states["folded"].readings["distal_angle"].mean for item in (left, reference_outcome)]
    apart = np.degrees(np.abs(angles[0] - angles[1]).max())
    holds("difference of folded angles from those with the opposite turning sense", apart, above=5, unit="deg")


def test_a_repeated_run_gives_the_same_bits(reference, reference_run):
    assert_same_bits(ff.run(reference, confirm=False), reference_run)


@pytest.mark.parametrize("threads", [1, 2])
def test_a_run_gives_the_same_bits_with_any_number_of_threads_and_with_other_wings(
    reference, reference_run, others, threads
):
    wings = [compile_model(design) for design in (others[0], reference, others[1])]
    together = simulate(wings, threads=threads)
    assert_same_bits(together[1], reference_run)
    assert_same_bits(together[0], ff.run(others[0], confirm=False))
    assert_same_bits(together[2], ff.run(others[1], confirm=False))


def test_a_diverging_wing_does_not_affect_wings_simulated_with_it(reference, reference_run):
    diverging = with_values(reference, {"protocol.timestep": 5e-3})
    records = simulate([compile_model(design) for design in (diverging, reference)])
    assert records[0].diverged_at is not None
    assert_same_bits(records[1], reference_run)


def test_a_saved_design_gives_the_same_bits(reference, tmp_path):
    # numbers that a text of a few digits cannot represent
    design = with_values(reference, {"tendon.rest_length": 0.1 / 3, "pattern.hub_radius": 0.01 * 2**0.5})
    ff.save_design(design, tmp_path / "design.toml")
    again = ff.load_design(tmp_path / "design.toml")
    assert again == design
    assert again.hash == design.hash
    assert_same_bits(ff.run(again, confirm=False), ff.run(design, confirm=False))


def test_the_sample_interval_of_the_record_changes_nothing(reference, reference_run):
    seldom = ff.run(with_values(reference, {"protocol.sample_interval": 0.01}), confirm=False)
    assert seldom.stages == reference_run.stages
    for name in seldom.data:
        assert seldom.data[name].values[-1].tobytes() == reference_run.data[name].values[-1].tobytes(), name

import math

import pytest

from forficula.analysis.sizing import size_tendons
from forficula.design import load_design
from forficula.errors import InputError
from forficula.material.law.law_file import load_law
from forficula.material.law.material_law import MaterialLaw, with_linear_modulus

STIFFNESSES = [1000.0 * number for number in range(1, 7)]  # N/m


def test_the_papers_tpu_needs_its_12_5_to_75_square_millimetres(reference):
    # Binder et al. 2025: 10 to 60 N/cm with a printed resting length of 6 cm
    at_specimen, at_design = size_tendons(reference, load_law("tpu-82a"), STIFFNESSES)
    assert at_specimen.length == 0.06
    areas = [size.area * 1e6 for size in at_specimen.sizes]
    assert areas == pytest.approx([12.5, 25, 37.5, 50, 62.5, 75])
    # A = k L / E
    assert [size.area * 1e6 for size in at_design.sizes] == pytest.approx([area * 9 / 6 for area in areas])


def test_a_round_tendon_has_the_area(reference):
    for size in size_tendons(reference, load_law("tpu-82a"), STIFFNESSES)[0].sizes:
        assert math.pi * size.diameter**2 / 4 == pytest.approx(size.area)


def test_a_given_length_comes_first_and_says_when_the_flat_wing_stretches_it_too_far(reference):
    short, long = size_tendons(reference, load_law("tpu-82a"), [1000.0], length=0.03)
    assert short.beyond
    assert not long.beyond
    # the bars turn by 2 asin(r / R) at the ring fold, so the open tendon is about 11 cm
    # (docs/model/theory.md, section Values from the paper)
    assert short.flat_strain == pytest.approx(0.11 / 0.03 - 1, rel=0.02)


def test_the_mean_stiffness_of_a_nonlinear_tendon_reaches_the_linear_ones_force(reference):
    law = MaterialLaw(name="soft", moduli=(4e6, -5e6, 3e6), residual_strain=0.1)
    (sizes,) = size_tendons(reference, law, [1000.0])
    strain = sizes.flat_strain - 0.1
    stress = 4e6 * strain - 5e6 * strain**2 + 3e6 * strain**3
    assert sizes.sizes[0].mean_area * stress == pytest.approx(1000.0 * strain * sizes.length)


def test_a_tendon_that_the_flat_wing_leaves_slack_has_no_mean_stiffness(reference):
    (slack, _) = size_tendons(reference, load_law("tpu-82a"), [1000.0], length=0.15)
    assert slack.flat_strain < 0
    assert slack.sizes[0].mean_area is None


def test_a_material_known_as_a_range_needs_a_choice(reference):
    with pytest.raises(InputError, match=r"modulus\.linear: known only as a range, 0\.4 to 1\.5 MPa"):
        size_tendons(reference, load_law("resilin"), [1000.0])
    (sizes,) = size_tendons(reference, with_linear_modulus(load_law("resilin"), 1e6), [1000.0])
    assert sizes.sizes[0].area == pytest.approx(1000 * 0.09 / 1e6)
    assert sizes.beyond is None


def test_without_any_length_there_is_no_strain():
    design = load_design("binder2025", {"tendon.rest_length": "0 cm"})
    with pytest.raises(InputError, match=r"length: is missing: the design's tendon\.rest_length is 0"):
        size_tendons(design, load_law("tpu-95a"), [1000.0])
    assert len(size_tendons(design, load_law("tpu-82a"), [1000.0])) == 1


@pytest.mark.parametrize("length", [1e-302, 1e298])
def test_an_extreme_length_is_rejected(reference, length):
    with pytest.raises(InputError, match=r"^length: need >= 1e-09 mm and <= 1e\+15 mm, got "):
        size_tendons(reference, load_law("tpu-82a"), [1000.0], length=length)


def test_without_tendons_there_is_nothing_to_size():
    with pytest.raises(InputError, match=r"^letter-fold has no tendon$"):
        size_tendons(load_design("letter-fold", {"tendon": []}), load_law("tpu-82a"), [1000.0])


def test_each_resting_length_is_stretched_by_the_tendons_that_have_it():
    vein = {"vein": 1, "proximal_attachment": "2.5 cm", "distal_attachment": "2.5 cm", "rest_length": "4 cm"}
    design = load_design("binder2025", {"tendon": [{"vein": 0}, vein, {"vein": 2}]})
    strains = {tendon.length: tendon.flat_strain for tendon in size_tendons(design, load_law("tpu-82a"), [1000.0])}
    assert strains[0.04] == pytest.approx(0.240, abs=5e-4)
    # a rest length of 9 cm gives 11 cm or slightly less; none has the specimens' 6 cm, so the longest counts
    assert strains[0.09] == pytest.approx(0.11 / 0.09 - 1, rel=0.1)
    assert strains[0.06] == pytest.approx(0.11 / 0.06 - 1, rel=0.02)
    (provided, *_) = size_tendons(design, load_law("tpu-82a"), [1000.0], length=0.04)
    assert provided.flat_strain == pytest.approx(strains[0.04])

"""A joint of two bars: allowed values in its design, and the quantities that follow from them."""

import re
from importlib import resources

import pytest

from forficula.design import design_from_text, design_text, load_design, write_new_design
from forficula.errors import InputError
from forficula.structure import structure_of

JOINT = "binder2025-joint"


def test_every_value_of_the_printed_joint_has_a_source():
    text = (resources.files("forficula.design") / "references" / f"{JOINT}.toml").read_text("utf-8")
    values = [line for line in text.splitlines() if re.search(r'= "?-?\d', line) and "time_limit" not in line]
    unmarked = [line for line in values if not re.search(r"\[(paper|derived|chosen)\]", line)]
    # keys without a mark are empty
    assert [line.partition("  #")[0] for line in unmarked] == ['armature = "0 kg m^2"', 'hold = "0 s"']


def test_its_tendon_has_the_stiffness_that_the_paper_measured():
    tendon = structure_of(load_design(JOINT)).tendons[0]
    # 4 N/cm; the joint as built stretches the tendon within the measured range
    assert tendon.law.elastic.linear == pytest.approx(400.0, rel=1e-12)
    assert tendon.law.rest_length == 0.06
    assert tendon.material.largest_strain == 1.0


def test_a_joint_reads_back_to_the_bit():
    design = load_design(JOINT)
    again = design_from_text(design_text(design))
    assert (again, again.hash) == (design, design.hash)


def test_a_spring_in_place_of_its_law_leaves_the_tendon_its_mass():
    design = load_design(JOINT, {"tendon.stiffness": "5 N/cm"})
    assert (design.tendon.law, design.tendon.stiffness) == (None, 500.0)
    assert design.tendon.mass == load_design(JOINT).tendon.mass > 0
    assert load_design(JOINT, {"tendon.law": "none"}).tendon.stiffness == pytest.approx(400.0)


def test_a_new_file_names_the_material_of_its_tendon(tmp_path):
    write_new_design(tmp_path / "new.toml", "joint")
    text = (tmp_path / "new.toml").read_text("utf-8")
    assert re.search(r'^law = "tpu-82a" +# material or law file', text, re.MULTILINE)
    assert "[[tendon]]" not in text
    assert load_design(tmp_path / "new.toml").hash == load_design(JOINT).hash


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"pattern.proximal_sector": "200 deg"}, "pattern.proximal_sector: need <= 179 deg, got 200 deg"),
        (
            {"pattern.proximal_sector": "30 deg", "pattern.distal_sector": "40 deg"},
            f"{JOINT}: pattern.distal_sector: need > 90 deg and < 270 deg together with pattern.proximal_sector, or the"
            " bars lie beside one another in the flat sheet, got 70 deg",
        ),
        ({"pattern.sense": "valey"}, 'pattern.sense: need "mountain" or "valley", got "valey"'),
        (
            {"pattern.width": "0 cm"},
            f"{JOINT}: pattern.width: need >= 1e-10 cm and <= 1e+14 cm, got 0 cm",
        ),
        (
            {"pattern.kind": "earwig-fan"},
            "pattern.kind: designs of kind earwig-fan have other sections than those of kind joint; begin with"
            ' based_on = "binder2025"',
        ),
        ({"vein.diameter": "2 m"}, f"{JOINT}: vein.diameter: need < 100 mm, the length of the shorter bar, got 2000"),
        (
            {"tendon.distal_attachment": "11 cm"},
            f"{JOINT}: tendon.distal_attachment: lies beyond the bar: need <= pattern.distal_length, 10 cm, got 11 cm",
        ),
        ({"tendon.stifness": "4 N/cm"}, 'tendon.stifness: unknown key, got "4 N/cm"; did you mean tendon.stiffness?'),
        ({"tendon.0.stiffness": "4 N/cm"}, 'tendon.0: unknown key, got {stiffness = "4 N/cm"}; allowed here:'),
        ({"tendon": "tpu-82a"}, 'tendon: need a table under [tendon], got "tpu-82a"'),
        ({"hinge.turn_limit": "90 deg"}, 'hinge.turn_limit: unknown key, got "90 deg"; did you mean hinge.fold_limit?'),
        (
            {"protocol.initial_overbend": "5 deg"},
            f"{JOINT}: protocol.initial_overbend: need >= -180 deg (-hinge.fold_limit) and <= 3 deg (hinge.overbend),",
        ),
        (
            {"protocol.stages.push.until": "turn < -3 deg"},
            f'{JOINT}: protocol.stages.push.until: need a bound on "ring" or "distal_angle", got "turn"',
        ),
        (
            {"protocol.stages.push.until": "ring < -200 deg"},
            f"{JOINT}: protocol.stages.push.until: a stop keeps ring from reaching it: need a value >= -180 deg,",
        ),
        (
            {"protocol.stages.push.drive": ["fold", "unfold"]},
            f"{JOINT}: protocol.stages.push.drive: need one drive, because a joint is not folded and unfolded in one",
        ),
        ({"protocol.contact": True}, f"{JOINT}: protocol.contact: need false, because only the stops of its hinge"),
    ],
)
def test_what_no_joint_can_have_is_refused_by_its_key(settings, message):
    with pytest.raises(InputError) as caught:
        load_design(JOINT, settings)
    assert str(caught.value).startswith(message)


def test_a_medium_has_no_effect_and_there_is_a_warning():
    (sentence,) = load_design(JOINT, {"medium.density": "1.2 kg/m^3"}).idle
    assert sentence.startswith("medium.density and medium.viscosity have no effect, because a joint has no panels")
    assert load_design(JOINT).idle == ()

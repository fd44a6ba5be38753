"""A material in a design: reading it by name or file, storing it, and the values that follow from it."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import (
    design_from_text,
    design_text,
    in_units,
    key_quantity,
    key_value,
    load_design,
    save_design,
    scale_design,
    tendon_law,
    with_values,
    write_new_design,
)
from forficula.design.files.keys import known_keys
from forficula.errors import InputError
from forficula.material.law.law_file import load_law

BASED = 'based_on = "binder2025"\n'
AREA = {"tendon.area": "12.5 mm^2"}
TPU = AREA | {"tendon.law": "tpu-82a"}
LAW_FILE = """
name = "mine"
yield_strain = "40 %"
residual_strain = "5 %"
largest_strain = "60 %"
lowest_strain_rate = "0.003 1/s"
highest_strain_rate = "0.1 1/s"
[modulus]
linear = "6 MPa"
quadratic = "-3 MPa"
cubic = "1 MPa"
[viscosity]
linear = "0.2 MPa s"
cubic = "1 kPa s^3"
[[branches]]
modulus = "1.5 MPa"
time = "0.12 s"
[[branches]]
modulus = "1 MPa"
time = "3 s"
[softening]
r = 1.5
m = "300 kJ/m^3"
beta = 0.1
"""


@pytest.fixture
def law_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "law.toml").write_text(LAW_FILE)
    return "law.toml"


def load(**values):
    return load_design("binder2025", {key.replace("__", "."): value for key, value in values.items()})


def refusal(settings):
    with pytest.raises(InputError) as caught:
        load_design("binder2025", settings)
    message = str(caught.value)
    assert len(message.splitlines()) == 1
    return message


def test_the_papers_tpu_has_the_papers_stiffness():
    # Binder et al. 2025: 6 cm long and 12.5 to 75 mm2 give 10 to 60 N/cm
    for area, stiffness in (("12.5 mm^2", 1000.0), ("75 mm^2", 6000.0)):
        law = tendon_law(load_design("binder2025", TPU | {"tendon.area": area, "tendon.rest_length": "6 cm"}).tendon)
        assert law.stiffness[0] == pytest.approx(stiffness, rel=1e-12)
        # the paper gives no damping, so there is none
        assert law.damping is None


def test_a_law_file_is_taken_into_the_design(law_file):
    design = load_design("binder2025", AREA | {"tendon.law": law_file})
    law, material = design.tendon.law, load_law(law_file)
    assert law.material.moduli == material.moduli == (6e6, -3e6, 1e6)
    strains = ("yield_strain", "residual_strain", "largest_strain", "lowest_strain_rate", "highest_strain_rate")
    for name in ("viscosity", "branches", *strains, "softening", "name"):
        assert getattr(law.material, name) == getattr(material, name), name


def test_a_design_with_a_law_is_saved_whole_and_read_back_to_the_same_bits(tmp_path, law_file):
    design = load_design("binder2025", AREA | {"tendon.law": law_file})
    save_design(design, tmp_path / "saved.toml")
    (tmp_path / law_file).unlink()
    again = load_design(tmp_path / "saved.toml")
    assert repr(again.tendon) == repr(design.tendon)
    assert again.hash == design.hash
    assert repr(design_from_text(design_text(design))) == repr(design)


FINITE = st.floats(1e-3, 1e3)


@settings(deadline=None)
@given(
    st.tuples(FINITE, FINITE, FINITE),
    st.none() | FINITE,
    st.lists(st.tuples(FINITE, FINITE), max_size=3),
    FINITE,
    FINITE,
)
def test_any_law_survives_the_file_to_the_bit(moduli, viscosity, branches, area, strain):
    values = {
        "linear_modulus": 1e6 * moduli[0],
        "quadratic_modulus": 1e6 * moduli[1],
        "cubic_modulus": 1e6 * moduli[2],
        "branches": [{"modulus": 1e6 * modulus, "time": time} for modulus, time in branches],
        "yield_strain": strain,
    }
    if viscosity is not None:
        values["linear_viscosity"] = 1e3 * viscosity
    design = with_values(load_design("binder2025"), {"tendon.law": values, "tendon.area": 1e-6 * area})
    again = design_from_text(design_text(design))
    assert repr(again) == repr(design)
    assert again.hash == design.hash


def test_paths_start_from_the_file_or_from_the_working_folder(tmp_path, monkeypatch):
    (tmp_path / "wings").mkdir()
    (tmp_path / "wings" / "law.toml").write_text(LAW_FILE)
    (tmp_path / "wings" / "wing.toml").write_text(f'{BASED}[tendon]\nlaw = "law.toml"\narea = "12.5 mm^2"')
    monkeypatch.chdir(tmp_path)
    by_file = load_design("wings/wing.toml")
    by_setting = load_design("binder2025", AREA | {"tendon.law": "wings/law.toml"})
    assert by_file.tendon == by_setting.tendon
    assert by_file.hash == by_setting.hash


def test_a_named_law_replaces_the_one_before_it_and_values_change_it(tmp_path, law_file):
    base = f'{BASED}[tendon]\nlaw = "{law_file}"\narea = "12.5 mm^2"'
    (tmp_path / "base.toml").write_text(base)
    (tmp_path / "wing.toml").write_text('based_on = "base.toml"\n[tendon]\nlaw = "tpu-82a"')
    law = load_design("wing.toml").tendon.law
    assert (law.name, law.branches, law.yield_strain) == ("tpu-82a", (), None)
    (tmp_path / "wing.toml").write_text('based_on = "base.toml"\n[tendon.law]\nlinear_modulus = "7 MPa"')
    law = load_design("wing.toml").tendon.law
    assert (law.name, law.linear_modulus, law.quadratic_modulus, len(law.branches)) == ("mine", 7e6, -3e6, 2)


def test_values_of_a_law_count_whatever_the_order_of_the_settings():
    first = {"tendon.law.linear_modulus": "2 MPa"} | TPU
    last = TPU | {"tendon.law.linear_modulus": "2 MPa"}
    assert load_design("binder2025", first) == load_design("binder2025", last)
    assert load_design("binder2025", last).tendon.law.linear_modulus == 2e6


def test_a_material_with_a_range_of_values_needs_a_choice(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    resilin = AREA | {"tendon.law": "resilin"}
    assert refusal(resilin).startswith(
        "tendon.law.linear_modulus: of resilin only a range is known, 0.4 to 1.5 MPa; choose a value in it, as in "
    )
    chosen = load_design("binder2025", resilin | {"tendon.law.linear_modulus": "1 MPa"})
    assert chosen.tendon.law.linear_modulus == 1e6
    (tmp_path / "wing.toml").write_text(
        f'{BASED}[tendon]\nlaw = {{based_on = "resilin", linear_modulus = "1 MPa"}}\narea = "12.5 mm^2"'
    )
    assert load_design("wing.toml").tendon == chosen.tendon
    assert "need a value in 0.4 to 1.5 MPa, got 3 MPa" in refusal(resilin | {"tendon.law.linear_modulus": "3 MPa"})


def test_a_material_may_be_written_by_hand():
    law = tendon_law(load(tendon__area="10 mm^2", tendon__law={"linear_modulus": "1 MPa"}).tendon)
    assert law.stiffness[0] == pytest.approx(1e6 * 10e-6 / 0.09, rel=1e-12)
    assert with_values(load_design("binder2025"), {"tendon.area": 1e-5, "tendon.law": load_law("tpu-95a")}).tendon.law


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (
            {"tendon.law": "tpu-82a"},
            'binder2025: tendon.area: is missing; tendon.law gives force per area, so give one such as "12.5 mm^2"',
        ),
        (
            AREA,
            "tendon.area: needs tendon.law, which gives force per area; also give a law, or tendon.stiffness instead",
        ),
        (
            TPU | {"tendon.rest_length": "0 cm"},
            "tendon.rest_length: need > 0 with tendon.law, because strain is extension per resting length, got 0 cm",
        ),
        (
            TPU | {"tendon.stiffness": "20 N/cm"},
            "tendon.stiffness: follows from tendon.law, 6.667 N/cm; set tendon.area or tendon.law.linear_modulus"
            " instead, got 20 N/cm",
        ),
        (
            TPU | {"tendon.damping": "0.1 N s/m"},
            "tendon.damping: follows from tendon.law, 0 N s/m; set tendon.area or tendon.law.linear_viscosity instead,"
            " got 0.1 N s/m",
        ),
        (
            AREA | {"tendon.law": "tpu-82"},
            'tendon.law: "tpu-82" is neither a named material nor a .toml file; did you mean tpu-82a?',
        ),
        (AREA | {"tendon.law": "none.toml"}, "tendon.law: none.toml: no such file"),
        (
            AREA | {"tendon.law": "petg"},
            "tendon.law: petg: no tendon can be made of it: it is a material for stiff printed bars, and its sources"
            " give no law for stretching",
        ),
        (
            {"tendon.law": 3},
            "tendon.law: need the name of a material, the path of a law file, or a table under [tendon.law], got 3",
        ),
        (
            {"tendon.law": {}},
            "binder2025: tendon.law.linear_modulus: is missing; give it, or name a material as in"
            ' tendon.law = "tpu-82a"',
        ),
        (
            TPU | {"tendon.law.linear_modolus": "1 MPa"},
            'tendon.law.linear_modolus: unknown key, got "1 MPa"; did you mean tendon.law.linear_modulus?',
        ),
        (
            TPU | {"tendon.law.linear_modulus": "1 N"},
            'tendon.law.linear_modulus: "N" is not a unit of the right kind; write it such as "4.8 MPa", got "1 N"',
        ),
        (TPU | {"tendon.law.yield_strain": "0 %"}, "tendon.law.yield_strain: need > 0, got 0 %"),
        (
            TPU | {"tendon.law.viscosity.linear": "1 MPa s"},
            'tendon.law.viscosity: unknown key, got {linear = "1 MPa s"}; did you mean tendon.law.linear_viscosity or'
            " tendon.law.quadratic_viscosity or tendon.law.cubic_viscosity?",
        ),
        (
            TPU | {"tendon.law": "none"},
            "tendon.area: needs tendon.law, which gives force per area; also give a law, or tendon.stiffness instead",
        ),
        (
            TPU | {"tendon.law.quadratic_modulus": "-1 MPa"},
            "tendon.law.quadratic_modulus: need >= 0 or > -2 sqrt(linear_modulus cubic_modulus), or the"
            " tendon would push at some strain, got -1 MPa",
        ),
        (
            TPU | {"tendon.law.branches": [{"modulus": "1 MPa"}]},
            "tendon.law.branches.0.time: is missing; needed here: modulus, time",
        ),
        (
            TPU | {"tendon.law.branches": ["soft"]},
            'tendon.law.branches.0: need a table under [[tendon.law.branches]], got "soft"',
        ),
        *(
            (
                {"tendon.law": written},
                f'tendon.law: need a material, a law file, or "none" for no law, got "{written}"; did you mean "none"?',
            )
            for written in ("None", "NONE")
        ),
        (TPU | {"tendon.law.branches.0.time": "1 s"}, 'tendon.law.branches.0.time: has no entries, got "0"'),
        (TPU | {"tendon.area": "-5 mm^2"}, "tendon.area: need > 0, got -5 mm^2"),
    ],
)
def test_settings_that_a_law_does_not_allow_are_refused_with_the_reason(settings, message):
    assert refusal(settings) == message


def test_a_law_that_cannot_be_read_is_an_error_of_the_file_that_names_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "law.toml").write_text('[modulus]\nlinear = "3 N"')
    (tmp_path / "wing.toml").write_text(f'{BASED}[tendon]\nlaw = "law.toml"')
    with pytest.raises(InputError, match=r"^wing\.toml: tendon\.law: law\.toml: modulus\.linear: "):
        load_design("wing.toml")


def test_stiffness_and_law_in_one_file_must_agree(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = f'{BASED}[tendon]\nlaw = "tpu-82a"\narea = "12.5 mm^2"\nrest_length = "6 cm"\nstiffness = "%s"'
    (tmp_path / "wing.toml").write_text(text % "10 N/cm")
    design = load_design("wing.toml")
    # only the law is stored and written
    assert (design.tendon.stiffness, design.tendon.damping) == (None, None)
    assert "stiffness =" not in design_text(design)
    assert tendon_law(design.tendon).stiffness[0] == pytest.approx(1000)
    (tmp_path / "wing.toml").write_text(text % "11 N/cm")
    with pytest.raises(InputError, match=r"^wing\.toml: tendon\.stiffness: follows from tendon\.law, 10 N/cm; "):
        load_design("wing.toml")


@pytest.mark.parametrize("settings", [{"tendon.law": "none"}, {"tendon": {"law": "none"}}])
def test_removing_a_law_leaves_its_spring_at_small_extension(tmp_path, monkeypatch, law_file, settings):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wing.toml").write_text(f'{BASED}[tendon]\nlaw = "{law_file}"\narea = "12.5 mm^2"')
    tendon = load_design("wing.toml", settings).tendon
    assert (tendon.law, tendon.area) == (None, None)
    assert tendon.stiffness == pytest.approx(6e6 * 12.5e-6 / 0.09, rel=1e-12)
    assert with_values(load_design("wing.toml"), settings).tendon == tendon
    (tmp_path / "plain.toml").write_text('based_on = "wing.toml"\n[tendon]\nlaw = "none"')
    assert load_design("plain.toml").tendon == tendon
    stiffer = settings | {"tendon.stiffness": "20 N/cm"}
    assert load_design("wing.toml", stiffer).tendon.stiffness == 2000


def test_a_design_without_a_law_has_no_law_to_remove():
    plain = load_design("binder2025")
    assert load_design("binder2025", {"tendon.law": "none"}) == plain
    assert with_values(plain, {"tendon.law": "none"}) == plain


def test_setting_a_stiffness_removes_the_law_and_setting_a_law_the_stiffness(law_file):
    for with_law in (load_design("binder2025", AREA | {"tendon.law": law_file}), load_design("binder2025", TPU)):
        law = tendon_law(with_law.tendon)
        tendon = with_values(with_law, {"tendon.stiffness": 500.0}).tendon
        assert (tendon.law, tendon.area, tendon.stiffness) == (None, None, 500.0)
        # the damping is unchanged at small extension
        assert tendon.damping == (0.0 if law.damping is None else law.damping[0])
        again = with_values(
            with_values(with_law, {"tendon.stiffness": 500.0}), {"tendon.law": "tpu-82a", "tendon.area": 1e-5}
        )
        assert (again.tendon.stiffness, again.tendon.damping) == (None, None)


def test_a_file_can_remove_the_law_of_its_base(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "law.toml").write_text(f'{BASED}[tendon]\nlaw = "tpu-82a"\narea = "12.5 mm^2"')
    (tmp_path / "spring.toml").write_text('based_on = "law.toml"\n[tendon]\nstiffness = "7 N/cm"')
    assert load_design("law.toml").tendon.stiffness is None
    assert load_design("spring.toml").tendon.law is None
    assert load_design("spring.toml").tendon.stiffness == 700.0


def test_writing_values_that_follow_from_the_law_gives_the_same_design():
    design = load_design("binder2025", TPU)
    was = design_text(design).replace("[tendon]", '[tendon]\nstiffness = "666.6666666666666 N/m"\ndamping = "0 N s/m"')
    assert design_from_text(was) == design
    # and so is a design without the keys that it did not have
    lines = [
        line for line in was.splitlines() if not line.startswith(("proximal_offset", "distal_offset", "proximal_as"))
    ]
    assert design_from_text("\n".join(lines)).hash == design.hash


def test_a_law_has_its_measured_range_after_a_value_inside_it_changes(law_file):
    law = load_design("binder2025", AREA | {"tendon.law": law_file, "tendon.law.branches.1.time": "4 s"}).tendon.law
    assert [branch.time for branch in law.branches] == [0.12, 4.0]
    assert law.name == "mine"
    resilin = AREA | {"tendon.law": "resilin", "tendon.law.softening": {"r": 2.0, "m": "1 kJ/m^3"}}
    assert refusal(resilin).startswith("tendon.law.linear_modulus: of resilin only a range is known")


def test_the_key_of_a_law_file_is_answered_with_the_designs():
    for key, near in (("modulus.linear", "linear_modulus"), ("drift.stiffness", "stiffness_drift")):
        with pytest.raises(InputError, match=rf"did you mean tendon\.law\.{near}\?$"):
            key_quantity(f"tendon.law.{key}")


def test_a_factor_of_a_study_may_be_a_value_of_the_law():
    base = load_design("binder2025", TPU)
    for key, value, stiffness in (
        ("tendon.area", 25e-6, 4.8e6 * 25e-6 / 0.09),
        ("tendon.rest_length", 0.06, 4.8e6 * 12.5e-6 / 0.06),
        ("tendon.law.linear_modulus", 1e6, 1e6 * 12.5e-6 / 0.09),
    ):
        assert key_quantity(key) is not None
        assert tendon_law(with_values(base, {key: value}).tendon).stiffness[0] == pytest.approx(stiffness, rel=1e-12)


def test_keys_of_optional_sections_are_found():
    assert {"tendon.area", "tendon.law.linear_modulus", "tendon.law.branches.0.time", "tendon.law.softening.m"} <= set(
        known_keys()
    )
    assert key_quantity("tendon.law.branches.2.time").unit.si == "s"
    assert key_quantity("tendon.law.softening.r") is None
    assert key_quantity("tendon.law") is None
    with pytest.raises(InputError, match=r"tendon\.law\.softening: holds several values; name one of them: "):
        key_quantity("tendon.law.softening")
    with pytest.raises(InputError, match=r"did you mean tendon\.law\.linear_modulus\?"):
        key_quantity("tendon.law.linear_modul")
    plain = load_design("binder2025")
    assert key_value(plain, "tendon.area") is None
    with pytest.raises(InputError, match=r"tendon\.law\.linear_modulus: binder2025 has no tendon\.law"):
        key_value(plain, "tendon.law.linear_modulus")


def test_the_name_of_a_material_changes_no_hash_and_its_numbers_do():
    base = load_design("binder2025", TPU)
    assert with_values(base, {"tendon.law.name": "other"}).hash == base.hash
    bits = math.nextafter(base.tendon.law.linear_modulus, 0.0)
    assert with_values(base, {"tendon.law.linear_modulus": bits}).hash != base.hash


def test_the_law_of_a_tendon_is_the_same_in_any_units(law_file):
    design = load_design("binder2025", AREA | {"tendon.law": law_file})
    si, other = tendon_law(design.tendon), tendon_law(in_units(design, length=0.01, mass=1e-3, time=1e-3).tendon)
    force = 1e-3 * 0.01 / 1e-3**2
    # by hand: E A / L = 6 MPa 12.5 mm2 / 9 cm, set by 5 %, yield at 40 % of 9 cm
    assert si.stiffness[0] == pytest.approx(6e6 * 12.5e-6 / 0.09, rel=1e-12)
    assert si.rest_length == pytest.approx(0.0945, rel=1e-12)
    assert si.yield_extension == pytest.approx(0.036, rel=1e-12)
    assert other.rest_length * 0.01 == pytest.approx(si.rest_length, rel=1e-12)
    for power in (1, 2, 3):
        spring, damper = other.stiffness[power - 1], other.damping[power - 1]
        assert spring * force / 0.01**power == pytest.approx(si.stiffness[power - 1], rel=1e-12)
        assert damper * force / (0.01 / 1e-3) ** power == pytest.approx(si.damping[power - 1], rel=1e-12)
    for ours, theirs in zip(other.branches, si.branches, strict=True):
        assert ours.stiffness * force / 0.01 == pytest.approx(theirs.stiffness, rel=1e-12)
        assert ours.time * 1e-3 == pytest.approx(theirs.time, rel=1e-12)


def test_a_design_without_a_law_has_a_linear_one():
    law = tendon_law(load_design("binder2025").tendon)
    assert (law.rest_length, law.stiffness, law.damping) == (0.09, (1000.0, 0.0, 0.0), (0.1, 0.0, 0.0))
    assert (law.branches, law.yield_extension) == ((), None)


def test_a_scaled_design_keeps_modulus_and_strains_and_scales_times(law_file):
    design = load_design("binder2025", AREA | {"tendon.law": law_file})
    law, scaled = design.tendon.law, scale_design(design, 0.1).tendon.law
    assert scaled.linear_modulus == pytest.approx(law.linear_modulus, rel=1e-12)
    assert scaled.cubic_viscosity == pytest.approx(law.cubic_viscosity * 0.1**3, rel=1e-12)
    assert [branch.time for branch in scaled.branches] == pytest.approx([0.012, 0.3], rel=1e-12)
    assert (scaled.yield_strain, scaled.residual_strain) == (law.yield_strain, law.residual_strain)
    assert scaled.softening.m == pytest.approx(law.softening.m, rel=1e-12)


def test_a_new_design_file_shows_how_a_law_is_named(tmp_path):
    write_new_design(tmp_path / "wing.toml")
    text = (tmp_path / "wing.toml").read_text()
    text = text.replace("# area = ", "area = ").replace('# law = "', 'law = "')
    text = text.replace('stiffness = "10 N/cm"', "").replace('damping = "0.1 N s/m"', "")
    (tmp_path / "wing.toml").write_text(text)
    assert load_design(tmp_path / "wing.toml").tendon.law.name == "tpu-82a"

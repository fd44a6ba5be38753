"""Tendons that are the same for all veins, or set for every vein."""

import math

import pytest

from forficula.design import (
    design_from_text,
    design_text,
    in_units,
    key_quantity,
    key_value,
    load_design,
    put,
    save_design,
    scale_design,
    with_values,
    write_new_design,
)
from forficula.errors import InputError

REFERENCE = load_design("binder2025")
BASED = 'based_on = "binder2025"\n'
TWO = '[[tendon]]\nvein = 2\nstiffness = "20 N/cm"\n[[tendon]]\nvein = 0\nrest_length = "8 cm"\n'


@pytest.fixture
def wing(tmp_path, monkeypatch):
    """Load text as the file wing.toml."""
    monkeypatch.chdir(tmp_path)

    def load(text, settings=None):
        (tmp_path / "wing.toml").write_text(text)
        return load_design("wing.toml", settings)

    return load


def of(design, name="stiffness"):
    """Return a value of the tendons by vein; None where there is no tendon."""
    return [None if tendon is None else getattr(tendon, name) for tendon in design.tendons]


def test_one_table_applies_to_every_vein():
    assert of(REFERENCE) == [1000.0] * 3
    assert REFERENCE.tendons[1] is REFERENCE.tendon


def test_entries_inherit_missing_values_from_the_table_that_they_are_based_on(wing):
    design = wing(BASED + TWO)
    assert of(design) == [1000.0, None, 2000.0]
    assert of(design, "rest_length") == [0.08, None, 0.09]


def test_entries_based_on_entries_inherit_from_the_entry_of_their_vein(wing, tmp_path):
    (tmp_path / "base.toml").write_text(BASED + TWO)
    design = wing('based_on = "base.toml"\n[[tendon]]\nvein = 2\nrest_length = "7 cm"')
    assert (of(design), of(design, "rest_length")) == ([None, None, 2000.0], [None, None, 0.07])
    shared = wing('based_on = "base.toml"\n[tendon]\nrest_length = "7 cm"')
    assert (of(shared), of(shared, "rest_length")) == ([1000.0, None, 2000.0], [0.07, None, 0.07])


def test_a_fan_may_have_no_tendon_at_all(wing):
    assert of(wing(f"{BASED}tendon = []")) == [None] * 3
    with pytest.raises(InputError, match=r"^tendon\.stiffness: wing has no tendon$"):
        key_value(wing(f"{BASED}tendon = []"), "tendon.stiffness")


def test_a_key_of_all_sets_all_and_a_number_the_tendon_of_that_vein(wing):
    assert of(load_design("binder2025", {"tendon.1.stiffness": "20 N/cm"})) == [1000.0, 2000.0, 1000.0]
    assert of(wing(BASED + TWO, {"tendon.2.stiffness": "5 N/cm"})) == [1000.0, None, 500.0]
    both = {"tendon.2.stiffness": "5 N/cm", "tendon.stiffness": "6 N/cm"}
    for settings in (both, dict(reversed(both.items()))):
        assert of(load_design("binder2025", settings)) == [600.0, 600.0, 500.0]
        assert of(wing(BASED + TWO, settings)) == [600.0, None, 500.0]
    assert of(with_values(REFERENCE, {"tendon.0.stiffness": 1.0})) == [1.0, 1000.0, 1000.0]
    assert of(with_values(wing(BASED + TWO), {"tendon.stiffness": 1.0})) == [1.0, None, 1.0]
    assert of(load_design("binder2025", {"pattern.units": 2, "tendon.4.stiffness": "1 N/cm"})) == [1000.0] * 4 + [100.0]


def test_a_law_may_be_that_of_one_tendon():
    settings = {"tendon.1.law": "tpu-82a", "tendon.1.area": "12.5 mm^2", "tendon.1.law.linear_modulus": "3 MPa"}
    design = load_design("binder2025", settings)
    assert of(design) == [1000.0, None, 1000.0]
    assert design.tendons[1].law.linear_modulus == 3e6
    assert of(with_values(design, {"tendon.1.stiffness": 70.0})) == [1000.0, 70.0, 1000.0]
    assert of(with_values(design, {"tendon.law": "none"}))[0] == 1000.0
    assert of(with_values(design, {"tendon.law": "none"}))[1] == pytest.approx(3e6 * 12.5e-6 / 0.09, rel=1e-12)


def test_the_path_of_a_law_starts_from_the_file_that_names_it(wing, tmp_path):
    (tmp_path / "laws").mkdir()
    (tmp_path / "laws" / "law.toml").write_text('[modulus]\nlinear = "2 MPa"')
    entry = '[[tendon]]\nvein = 1\nlaw = {}\narea = "10 mm^2"\n'
    (tmp_path / "laws" / "base.toml").write_text(BASED + entry.format('"law.toml"'))
    design = wing('based_on = "laws/base.toml"')
    assert design.tendons[1].law.linear_modulus == 2e6
    based = entry.format('{based_on = "law.toml", linear_modulus = "3 MPa"}')
    (tmp_path / "laws" / "base.toml").write_text(BASED + based)
    assert wing('based_on = "laws/base.toml"').tendons[1].law.linear_modulus == 3e6


@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"tendon.1.law": "tpu-82a", "tendon.1.area": "12.5 mm^2"},
        {"tendon.0.law": {"linear_modulus": "1 MPa", "branches": [{"modulus": "1 MPa", "time": "2 s"}]}}
        | {"tendon.0.area": "12.3456789 mm^2"},
        {"tendon.distal_offset": "3.1 mm", "tendon.2.proximal_aside": "-0.1 mm"},
    ],
)
def test_tendons_are_written_and_read_to_the_same_bits(tmp_path, settings):
    design = load_design("binder2025", {"tendon.2.stiffness": "12.3456789 N/cm"} | settings)
    save_design(design, tmp_path / "saved.toml")
    assert repr(design_from_text(design_text(design))) == repr(design)
    assert repr(load_design(tmp_path / "saved.toml")) == repr(design)
    assert load_design(tmp_path / "saved.toml").hash == design.hash
    assert repr(with_values(design, {})) == repr(design)


def test_veins_without_a_tendon_stay_without_when_written_and_read(wing):
    design = wing(BASED + TWO)
    assert repr(design_from_text(design_text(design))) == repr(design)
    assert of(design_from_text(design_text(wing(f"{BASED}tendon = []")))) == [None] * 3


def test_the_hash_depends_on_the_tendons_and_not_on_how_they_are_written(wing):
    design = wing(BASED + TWO)
    assert design.hash != REFERENCE.hash
    assert (
        design.hash == wing(BASED + "".join(f"[[tendon]]{item}" for item in reversed(TWO.split("[[tendon]]")[1:]))).hash
    )
    assert with_values(design, {"tendon.2.rest_length": math.nextafter(0.09, 1)}).hash != design.hash
    assert wing(f"{BASED}tendon = []").hash not in (design.hash, REFERENCE.hash)
    same = {f"tendon.{vein}.stiffness": "10 N/cm" for vein in range(3)}
    assert load_design("binder2025", same).hash == REFERENCE.hash
    for key in ("proximal_offset", "distal_offset", "proximal_aside", "distal_aside"):
        assert with_values(REFERENCE, {f"tendon.{key}": 0.001}).hash != REFERENCE.hash
        assert with_values(REFERENCE, {f"tendon.{key}": 0.0}).hash == REFERENCE.hash


def test_the_hash_of_the_reference_is_unchanged():
    # journals and stored runs depend on the hash
    assert REFERENCE.hash == "57a4c0dec71b70c0"
    with_law = load_design("binder2025", {"tendon.law": "tpu-82a", "tendon.area": "12.5 mm^2"})
    assert with_law.hash == "395b5e618f8d19f5"


def test_tendons_of_a_list_are_scaled_like_one(wing):
    settings = {"tendon.1.law": "tpu-82a", "tendon.1.area": "12.5 mm^2", "tendon.proximal_offset": "3 mm"}
    design = load_design("binder2025", settings)
    small = scale_design(design, 0.1)
    assert of(small)[0] == pytest.approx(100.0, rel=1e-12)
    assert of(small, "area")[1] == pytest.approx(12.5e-8, rel=1e-12)
    assert of(small, "proximal_offset") == pytest.approx([3e-4] * 3, rel=1e-12)
    assert of(in_units(wing(BASED + TWO), length=0.01, mass=1.0, time=1.0), "rest_length") == pytest.approx(
        [8, None, 9]
    )


def test_keys_are_of_all_tendons_or_of_one(wing):
    for key in ("tendon.stiffness", "tendon.1.stiffness", "tendon.7.stiffness"):
        assert key_quantity(key).unit.si == "N/m"
    assert key_quantity("tendon.1.law") is None
    assert key_quantity("tendon.1.law.branches.0.time").unit.si == "s"
    with pytest.raises(InputError, match=r"^tendon\.1: holds several values; name one of them: tendon\.1\.stiffness, "):
        key_quantity("tendon.1")
    with pytest.raises(InputError, match=r"^tendon\.1\.stifness: unknown key; did you mean tendon\.1\.stiffness\?$"):
        key_quantity("tendon.1.stifness")
    with pytest.raises(InputError, match=r"did you mean tendon\.1\.law\.linear_modulus\?$"):
        key_quantity("tendon.1.law.modulus.linear")
    design = wing(BASED + TWO)
    assert key_value(REFERENCE, "tendon.2.stiffness") == key_value(REFERENCE, "tendon.stiffness") == 1000.0
    assert [key_value(design, f"tendon.{vein}.stiffness") for vein in (0, 2)] == [1000.0, 2000.0]
    # the common value, and None where they differ
    assert key_value(design, "tendon.damping") == 0.1
    assert key_value(design, "tendon.stiffness") is None
    with pytest.raises(InputError, match=r"^tendon\.1\.stiffness: wing has no tendon\.1$"):
        key_value(design, "tendon.1.stiffness")
    with pytest.raises(
        InputError, match=r"^tendon\.3\.stiffness: need one of 0, 1 or 2 after tendon, such as tendon.0"
    ):
        key_value(design, "tendon.3.stiffness")


def test_values_are_put_on_all_tendons_or_on_one(wing):
    assert of(put(REFERENCE, "tendon.stiffness", 1.0)) == [1.0] * 3
    assert of(put(REFERENCE, "tendon.1.stiffness", 1.0)) == [1000.0, 1.0, 1000.0]
    assert of(put(wing(BASED + TWO), "tendon.stiffness", 1.0)) == [1.0, None, 1.0]
    assert put(REFERENCE, "protocol.stages.1.hold", 0.5).protocol.stages[1].hold == 0.5


def test_a_new_design_file_explains_how_to_set_the_tendon_of_one_vein(tmp_path):
    write_new_design(tmp_path / "wing.toml")
    text = (tmp_path / "wing.toml").read_text()
    assert "# [[tendon]] with vein = 0" in text
    assert of(load_design(tmp_path / "wing.toml"), "distal_offset") == [0.0] * 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[[tendon]]\nvein = 3", "tendon.3: there is no vein 3: need 0 to 2 with pattern.units = 1"),
        ("[[tendon]]\nvein = 1\n[[tendon]]\nvein = 1", "tendon.vein: need one [[tendon]] for each vein, got 1 twice"),
        ("[[tendon]]\nvein = -1", "tendon.vein: need the number of a vein, from 0 on, got -1"),
        ("[[tendon]]\nvein = 1e300", "tendon.vein: need the number of a vein, from 0 on, got 1e+300"),
        (f"[[tendon]]\nvein = {10**15}", f"tendon.vein: need the number of a vein, from 0 on, got {10**15}"),
        ("[[tendon]]\nvein = true", "tendon.vein: need the number of a vein, from 0 on, got true"),
        ('[[tendon]]\nvein = "all"', 'tendon.vein: need the number of a vein, from 0 on, got "all"'),
        (
            '[[tendon]]\nvein = 0\n[[tendon]]\nstiffness = "1 N/cm"',
            "tendon.vein: is missing in entry 2 of 2 under [[tendon]]; name its vein, as in vein = 0",
        ),
        ("tendon = [1]", "tendon: need tables, each under [[tendon]], got 1"),
        (
            "[tendon]\nvein = 1",
            "tendon.vein: unknown key, got 1; the key vein is for a table under [[tendon]], a tendon of one vein",
        ),
        (
            '[[tendon]]\nvein = 2\nstifness = "1 N/cm"',
            'tendon.2.stifness: unknown key, got "1 N/cm"; did you mean tendon.2.stiffness?',
        ),
        ('[[tendon]]\nvein = 2\nstiffness = "-1 N/cm"', "tendon.2.stiffness: need >= 0, got -1 N/cm"),
        (
            '[[tendon]]\nvein = 2\nlaw = "tpu-82a"',
            'tendon.2.area: is missing; tendon.law gives force per area, so give one such as "12.5 mm^2"',
        ),
        (
            '[[tendon]]\nvein = 2\narea = "1 mm^2"\nlaw = "tpu-82"',
            'tendon.2.law: "tpu-82" is neither a named material nor a .toml file; did you mean tpu-82a?',
        ),
        (
            '[[tendon]]\nvein = 1\ndistal_attachment = "13 cm"',
            "tendon.1.distal_attachment: lies beyond the bar: need <= pattern.distal_length, 10 cm, got 13 cm",
        ),
        (
            '[tendon]\nproximal_offset = "-13 cm"',
            "tendon.proximal_offset: need >= -12 cm and <= 12 cm, pattern.proximal_length, got -13 cm",
        ),
    ],
)
def test_what_tendons_do_not_allow_is_an_error_of_the_file(wing, text, message):
    with pytest.raises(InputError) as caught:
        wing(BASED + text)
    assert str(caught.value) == f"wing.toml: {message}"


def test_an_entry_without_a_required_key_is_refused(wing):
    text = "\n".join(line for line in design_text(REFERENCE).splitlines() if not line.startswith("rest_length"))
    with pytest.raises(InputError, match=r"^wing\.toml: tendon\.1\.rest_length: is missing; give it, or begin "):
        wing(text.replace("[tendon]", "[[tendon]]\nvein = 1"))


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"tendon.3.stiffness": "1 N/cm"}, 'tendon.3: need the number of a vein with a tendon, 0, 2, got "3"'),
        (
            {"tendon.1.stiffness": "1 N/cm"},
            "tendon.1: vein 1 has no tendon, those with one are 0, 2; give it a [[tendon]] first",
        ),
        ({"tendon.2": "1 N/cm"}, 'tendon.2: need a table under [tendon.2], or "none", got "1 N/cm"'),
        (
            {"tendon.2.vein": 1},
            "tendon.2.vein: unknown key, got 1; the key vein is for a table under [[tendon]]",
        ),
        ({"tendon.stiffness": "-1 N/cm"}, "tendon.0.stiffness: need >= 0, got -1 N/cm"),
        ({"tendon.2.stiffness": "-1 N/cm"}, "tendon.2.stiffness: need >= 0, got -1 N/cm"),
        ({"tendon.2.stiffness.x": "1"}, 'tendon.2.stiffness.x: unknown key, got "1"; did you mean tendon.2.stiffness?'),
        (
            {"tendon.rest_lengt.x": "1"},
            'tendon.0.rest_lengt: unknown key, got {x = "1"}; did you mean tendon.0.rest_length?',
        ),
    ],
)
def test_setting_a_missing_tendon_lists_the_existing_ones(wing, settings, message):
    with pytest.raises(InputError) as caught:
        wing(BASED + TWO, settings)
    assert str(caught.value).startswith(message)


def test_an_error_names_the_file_that_contains_the_value(wing, tmp_path):
    (tmp_path / "base.toml").write_text(f'{BASED}[tendon]\nstiffness = "10"')
    with pytest.raises(InputError, match=r"^base\.toml: tendon\.1\.stiffness: the unit is missing"):
        wing('based_on = "base.toml"\n[[tendon]]\nvein = 1')
    (tmp_path / "base.toml").write_text(f'{BASED}[[tendon]]\nvein = 1\nstiffness = "10"')
    with pytest.raises(InputError, match=r"^base\.toml: tendon\.1\.stiffness: the unit is missing"):
        wing('based_on = "base.toml"\n[tendon]\nrest_length = "8 cm"')

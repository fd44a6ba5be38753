"""Laws of creases by name or file: their values, values that override them, and sentences about their source."""

import math
import re

import pytest

import forficula as ff
from forficula.design import design_from_text, design_text, load_design, with_values
from forficula.errors import InputError
from forficula.material import load_crease_law, named_crease_laws, save_crease_law
from forficula.quantities import Unit, parse_quantity
from forficula.structure import structure_of

WIDTH = 0.02
TEXT = """
name = "strip"
source = "a test"
[pattern]
kind = "pleats"
panels = 3
panel_lengths = ["4 cm", "4 cm", "4 cm"]
width = "2 cm"
assignment = "VM"
[facet]
kind = "rigid"
[crease]
law = "paper"
[[drive]]
name = "fold"
kind = "torque"
of = "creases"
value = "1e-3 N m"
[[protocol.stages]]
name = "fold"
drive = "fold"
until = "time"
time_limit = "0.2 s"
"""
PRESSURE = Unit(display="Pa", si="Pa", example="1 Pa")
LENGTH = Unit(display="m", si="m", example="1 m")
STIFFNESS = Unit(display="N m/rad/m", si="N m/rad/m", example="1 N m/rad/m")
MOMENT = Unit(display="N m/m", si="N m/m", example="1 N m/m")


def strip(**values):
    return with_values(design_from_text(TEXT), {f"crease.{key}": value for key, value in values.items()})


def hinge(design, number=0):
    return structure_of(design).hinges[number]


def spring(design):
    crease = hinge(design)
    return crease.stiffness, crease.rest_angle, crease.yield_angle, crease.hardening, crease.damping


@pytest.mark.parametrize("name", ["paper", "pet-film", "petg-film", "pp-living-hinge"])
def test_a_named_law_follows_from_its_facts_by_the_formulas_that_it_states(name):
    law = load_crease_law(name)
    fact = {entry.what.split()[-1]: entry.value for entry in law.facts}
    modulus, stress = (parse_quantity(fact[key], PRESSURE) for key in ("E", "S"))
    thickness, nu = parse_quantity(law.thickness, LENGTH), float(fact["nu"])
    share, unit = fact["L"].split()
    length = float(share) * thickness if unit == "thicknesses" else parse_quantity(fact["L"], LENGTH)
    stiffness = modulus * thickness**3 / (12 * (1 - nu**2) * length)
    assert parse_quantity(fact["t"], LENGTH) == thickness
    assert parse_quantity(law.values["stiffness"], STIFFNESS) == pytest.approx(stiffness, rel=1e-3)
    assert parse_quantity(law.values["yield_moment"], MOMENT) == pytest.approx(stress * thickness**2 / 4, rel=1e-3)
    assert set(law.chosen) == set(law.values)


def test_a_named_law_gives_the_values_of_creases_per_length():
    crease = hinge(strip())
    assert crease.stiffness == pytest.approx(0.2358 * WIDTH)
    assert crease.yield_angle == pytest.approx(0.1609 / 0.2358)
    assert crease.hardening == pytest.approx(0.02358 * WIDTH)
    assert strip().settled().facet.thickness == pytest.approx(0.11e-3)


def test_keys_of_the_design_override_values_of_the_law():
    crease = hinge(strip(hardening="0.1 N m/rad/m"))
    assert crease.stiffness == pytest.approx(0.2358 * WIDTH)
    assert crease.hardening == pytest.approx(0.1 * WIDTH)


def test_a_law_laid_over_a_design_replaces_the_spring_that_the_design_had():
    letter = load_design("letter-fold")
    design = letter.with_values({"crease.law": "paper"})
    assert design.crease.stiffness is None
    assert design.crease.damping == letter.crease.damping
    assert load_design("letter-fold", {"crease.law": "paper"}).hash == design.hash
    kept = letter.with_values({"crease.law": "paper", "crease.stiffness": 0.5})
    assert hinge(kept).stiffness / hinge(letter).stiffness == pytest.approx(0.5 / letter.crease.stiffness)


def test_another_law_replaces_all_values_of_the_first_one():
    changed, direct = strip(law="petg-film"), design_from_text(TEXT.replace("paper", "petg-film"))
    assert spring(changed) == spring(direct)
    assert changed.hash == direct.hash != strip().hash


def test_a_group_may_have_a_law_of_its_own():
    design = strip(group=[{"of": "mountains", "law": "pp-living-hinge", "stiffness": "2 N m/rad/m"}])
    first, second = (hinge(design, number) for number in range(2))
    assert first.stiffness == pytest.approx(0.2358 * WIDTH)
    assert second.stiffness == pytest.approx(2 * WIDTH)
    assert second.yield_angle == pytest.approx(0.5338 / 2)


def test_a_group_whose_law_has_no_yield_moment_does_not_yield(tmp_path):
    law = tmp_path / "spring.toml"
    law.write_text('[crease]\nstiffness = "1 N m/rad/m"\nrest_angle = "30 deg"\n', encoding="utf-8")
    design = strip(group=[{"of": "mountains", "law": str(law)}])
    assert math.isfinite(hinge(design).yield_angle)
    assert hinge(design, 1).yield_angle == math.inf
    assert hinge(design, 1).rest_angle == pytest.approx(math.radians(30))


def test_a_written_design_names_its_law_and_does_not_need_the_file(tmp_path):
    law = tmp_path / "fold.toml"
    save_crease_law(load_crease_law("petg-film"), law)
    text = design_text(strip(law=str(law)))
    law.unlink()
    assert "[crease.law]" in text
    assert 'name = "petg-film"' in text
    assert "derived from the bending of a strip of film" in text
    assert spring(design_from_text(text)) == spring(strip(law="petg-film"))


def test_a_law_file_is_written_and_read_again(tmp_path):
    law = load_crease_law("paper")
    save_crease_law(law, tmp_path / "again.toml")
    assert load_crease_law(tmp_path / "again.toml") == law


def test_warnings_name_chosen_values_and_another_thickness():
    chosen, other = ff.check_design(strip(yield_moment=0.1, **{"law": "paper"}).with_values({"facet.thickness": 2e-4}))
    assert chosen.startswith('crease.law "paper": stiffness and hardening are chosen, not measured (creased printing')
    assert other == (
        'crease.law "paper" applies to a sheet of 0.11 mm, but facet.thickness is 0.2 mm; its values are not scaled:'
        " change facet.thickness, or give the values for this sheet, such as crease.law.stiffness"
    )


def test_designs_without_a_law_keep_their_hash():
    assert load_design("letter-fold").hash == with_values(load_design("letter-fold"), {"crease.law": "linear"}).hash


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("papr", 'crease.law: "papr" is neither a form, a named law of creases nor a .toml file; did you mean paper?'),
        ({"stifness": 1.0}, r"crease.law.stifness: unknown key, got 1.0; did you mean crease.law.stiffness\?"),
        (
            {"based_on": "paper", "hardening": 1.0},
            "crease.law.hardening: need < crease.law.stiffness, 0.2358 N m/rad/m",
        ),
        (3, "crease.law: need the form of a spring, the name of a law, the path of a law file, or a table"),
    ],
)
def test_a_law_without_a_meaning_is_refused(value, message):
    with pytest.raises(InputError, match=message):
        strip(law=value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[modulus]\nlinear = "1 MPa"', "need a law of creases with a table \\[crease\\], got a law of tendons"),
        ('[crease]\nhardening = "1 N m/rad/m"', "crease.stiffness: is missing; a law of creases needs it"),
        ('[crease]\nstiffness = "1 N m/rad/m"\n[chosen]\nyield = "x"', "chosen.yield: unknown key"),
        ('[crease]\nstiffness = "1 N/m"', r"law.toml: crease.stiffness: .*1 N/m"),
    ],
)
def test_errors_of_a_law_file_name_the_file_or_the_key(tmp_path, text, message):
    path = tmp_path / "law.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message):
        strip(law=str(path))


def test_every_named_law_has_a_source():
    assert all(named_crease_laws().values())


def test_a_law_file_with_a_key_that_only_designs_have_is_refused_with_the_file_and_the_keys_of_a_law(tmp_path):
    file = tmp_path / "worn.toml"
    file.write_text('[crease]\nstiffness = "0.2 N m/rad/m"\nfriction = "0.01 N m/m"\n', "utf-8")
    with pytest.raises(
        InputError, match=r"worn.toml: crease.friction: unknown key, .*allowed here: stiffness, rest_an"
    ):
        strip(law=str(file))


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ('yield_moment = "-1 N m/m"', "crease.yield_moment: need > 0, got -1 N m/m"),
        ('kind = "x"', 'crease.kind: need "linear" or "locking", got "x"'),
        ("rest_angle = 3", "crease.rest_angle: the unit is missing"),
    ],
)
def test_a_wrong_value_of_a_law_file_is_refused_with_the_files_of_the_design_and_of_the_law(tmp_path, values, message):
    law, design = tmp_path / "law.toml", tmp_path / "design.toml"
    law.write_text(f'[crease]\nstiffness = "0.2 N m/rad/m"\n{values}\n')
    design.write_text('based_on = "letter-fold"\n[crease]\nlaw = "law.toml"\n')
    with pytest.raises(InputError, match=re.escape(f"{design}: crease.law: {law}: {message}")):
        load_design(str(design))
    with pytest.raises(InputError, match=re.escape(f"crease.group.0.law: {law}: {message}")):
        load_design("letter-fold", {"crease.group": [{"of": "crease 0", "law": str(law)}]})


def test_an_unknown_law_of_a_design_file_is_refused_with_the_name_of_the_file(tmp_path):
    design = tmp_path / "design.toml"
    design.write_text('based_on = "letter-fold"\n[crease]\nlaw = "papr"\n')
    with pytest.raises(InputError, match=re.escape(f'{design}: crease.law: "papr" is neither') + ".* mean paper"):
        load_design(str(design))
    with pytest.raises(InputError, match=r'^crease.law: "papr" is neither'):
        load_design("letter-fold", {"crease.law": "papr"})


def test_the_path_of_a_law_is_relative_to_the_file_that_names_it(tmp_path):
    design = tmp_path / "design.toml"
    (tmp_path / "law.toml").write_text('[crease]\nstiffness = "0.7 N m/rad/m"\n')
    design.write_text(
        'based_on = "letter-fold"\n[[crease.group]]\nof = "crease 0"\nlaw = "law.toml"\n[crease]\nlaw = "law.toml"\n'
    )
    crease = load_design(str(design)).crease
    assert (crease.law.stiffness, crease.group[0].law.stiffness) == (0.7, 0.7)
    assembly = tmp_path / "assembly.toml"
    assembly.write_text('based_on = "two-clasps"\n[part.inner.crease]\nlaw = "law.toml"\n')
    assert load_design(str(assembly)).inner.crease.law.stiffness == 0.7

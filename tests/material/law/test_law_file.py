import pytest

from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_file import law_values, load_law, named_laws, save_law
from forficula.material.law.material_law import (
    Bounds,
    LawFact,
    MaterialLaw,
    MaxwellBranch,
    Unknown,
    require,
    scaled,
    with_linear_modulus,
)
from forficula.material.law.softening import OgdenRoxburgh

EVERYTHING = MaterialLaw(
    name="all of it",
    source="a test",
    moduli=(4.8123456789012345e6, -1 / 3, 0.1),
    viscosity=(1e5 / 3, 0.1 + 0.2, 1e-7),
    branches=(MaxwellBranch(modulus=1e6 / 7, time=0.12), MaxwellBranch(modulus=2e6, time=1 / 3)),
    yield_strain=0.1 + 0.2,
    residual_strain=1 / 3,
    softening=OgdenRoxburgh(r=1.7, m=1e5 / 3, beta=0.1),
    largest_strain=1.0,
    lowest_strain_rate=1 / 360,
    highest_strain_rate=0.1 + 0.2,
    stiffness_drift=Drift(
        kind="plateau", rate=-1 / 3, interval=(-0.4, -0.1 - 0.2), cycles=1 / 7, relative=True, seen=(2, 5)
    ),
    residual_strain_drift=Drift(kind="none", rate=0.0, interval=(0.0, 0.0), cycles=0.0, relative=False, seen=(2, 5)),
    ranges=(Bounds(key="modulus.cubic", low=0.1, high=1 / 3),),
    intervals=(Bounds(key="branches.1.time", low=0.3, high=0.4), Bounds(key="softening.r", low=1.6, high=1.8)),
    unknown=(Unknown(key="softening", why="nobody asked"),),
    facts=(LawFact(what="strength", value="30 MPa", source="a data sheet"),),
)


def test_a_file_gives_back_the_same_law_to_the_bit(tmp_path):
    for law in (EVERYTHING, MaterialLaw(name="nothing"), *map(load_law, named_laws())):
        save_law(law, tmp_path / "tendon_law.toml")
        assert load_law(tmp_path / "tendon_law.toml") == law


def test_a_file_is_read_as_it_is_written_by_hand(tmp_path):
    path = tmp_path / "rubber.toml"
    path.write_text(
        'largest_strain = "100 %"\n[modulus]\nlinear = "4.8 MPa"\n[[branches]]\nmodulus = "1 MPa"\ntime = "120 ms"\n'
        '[interval]\nmodulus.linear = ["4.7 MPa", "4.9 MPa"]\n'
    )
    law = load_law(path)
    assert law == MaterialLaw(
        name="rubber",
        moduli=(4.8e6, 0, 0),
        branches=(MaxwellBranch(modulus=1e6, time=0.12),),
        largest_strain=1.0,
        intervals=(Bounds(key="modulus.linear", low=4.7e6, high=4.9e6),),
    )
    assert law_values(law)["branches.0.time"] == 0.12


def test_an_old_file_does_not_say_over_which_rates_it_was_measured(tmp_path):
    path = tmp_path / "old.toml"
    path.write_text('largest_strain = "100 %"\n[modulus]\nlinear = "4.8 MPa"\n')
    law = load_law(path)
    assert (law.lowest_strain_rate, law.highest_strain_rate) == (None, None)


def test_the_library_has_a_source_for_each():
    assert set(named_laws()) == {"resilin", "tpu-82a", "tpu-95a", "petg", "steel"}
    assert all(named_laws().values())


def test_the_paper_s_tpu_is_its_secant_modulus():
    # Binder et al. 2025, section 3.3: 4 N/cm at 5 mm^2 and 6 cm
    law = load_law("tpu-82a")
    assert scaled(law, length=0.06, area=5e-6).stiffness[0] == pytest.approx(400)
    assert law.largest_strain == 1.0
    # 10 mm/min by 60 mm
    assert law.lowest_strain_rate == law.highest_strain_rate == pytest.approx(0.01 / 60 / 0.06, rel=1e-3)
    with pytest.raises(InputError, match="tpu-82a: viscosity: is unknown: the paper shows hysteresis at a single"):
        require(law, "viscosity")


def test_resilin_is_a_range():
    law = load_law("resilin")
    with pytest.raises(InputError, match=r"resilin: modulus.linear: known only as a range, 0.4 to 1.5 MPa; choose"):
        scaled(law, length=0.06, area=5e-6)
    assert scaled(with_linear_modulus(law, 1.5e6), length=0.06, area=4e-6).stiffness[0] == pytest.approx(100)
    with pytest.raises(InputError, match=r"resilin: branches: is unknown: relaxation times of 1.7 s and 16 s"):
        require(law, "branches")


def test_petg_is_refused_as_a_tendon():
    with pytest.raises(InputError, match="petg: no tendon can be made of it"):
        scaled(load_law("petg"), length=0.06, area=5e-6)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[modulus]\nlinaer = "1 MPa"', 'modulus.linaer: unknown key, got "1 MPa"; did you mean modulus.linear?'),
        ('[drift.stiffness]\nkind = "none"', "drift.stiffness.seen: is missing; needed here: kind, seen"),
        ('[drift.stiffness]\nkind = "logarithm"\nseen = [1, 5]', "drift.stiffness.rate: is missing"),
        (
            '[drift.stiffness]\nkind = "linear"\nrate = 1\ninterval = [0, 1]\nseen = [1, 5]',
            "drift.stiffness.kind: need one",
        ),
        ('[drift.stiffness]\nkind = "none"\nseen = [1.5, 5]', "drift.stiffness.seen: need whole numbers, got"),
        (
            '[drift.stiffness]\nkind = "none"\nseen = 5',
            r"drift.stiffness.seen: need two numbers such as \[2, 5\], got 5",
        ),
        (
            '[drift.modulus]\nkind = "none"\nseen = [1, 5]',
            'drift.modulus: unknown key, got {kind = "none", seen = \\[1, 5\\]}; allowed here: stiffness',
        ),
        ('[moduls]\nlinear = "1 MPa"', 'moduls: unknown key, got {linear = "1 MPa"}; did you mean modulus?'),
        ("[modulus]\nlinear = 4.8", 'modulus.linear: the unit is missing; write it as text such as "4.8 MPa", got 4.8'),
        ('[modulus]\nlinear = "4.8 N"', "modulus.linear: .*not a unit of the right kind"),
        ('[modulus]\nlinear = "-1 MPa"', "modulus.linear: need a finite number >= 0, got -1e"),
        ('[modulus]\nquadratic = "1 MPa"', "modulus.linear: is missing; needed here: linear"),
        ("modulus = 1", r"modulus: need a table under \[modulus\], got 1"),
        ('[[branches]]\nmodulus = "1 MPa"', "branches.0.time: is missing; needed here: modulus, time"),
        ('[[branches]]\nmodulus = "1 MPa"\ntime = "0 s"', "branches.0.time: need a finite number > 0, got 0 s"),
        ('[branches]\nmodulus = "1 MPa"', r"branches: need a list of tables, each under \[\[branches\]\]"),
        ('largest_strain = "1 mm"', "largest_strain: .*not a unit of the right kind"),
        (
            'lowest_strain_rate = "2 1/s"\nhighest_strain_rate = "1 1/s"',
            "lowest_strain_rate: need <= highest_strain_rate, 1 1/s, got 2 1/s",
        ),
        ('highest_strain_rate = "1 mm/s"', "highest_strain_rate: .*not a unit of the right kind"),
        ('highest_strain_rate = "0 1/s"', "highest_strain_rate: need a finite rate > 0, got 0"),
        ('lowest_rate = "1 1/s"', 'lowest_rate: unknown key, got "1 1/s"; did you mean lowest_strain_rate'),
        ('[softening]\nr = 0.5\nm = "1 kJ/m^3"', "softening.r: need a finite number >= 1, got 0.5"),
        ('[softening]\nr = "2"\nm = "1 kJ/m^3"', 'softening.r: need a number without quotes, got "2"'),
        (
            '[interval]\n"modulus.liner" = ["1 MPa", "2 MPa"]',
            "modulus.liner: unknown key; did you mean modulus.linear?",
        ),
        ('[interval]\n"modulus.linear" = "1 MPa"', "interval.modulus.linear: need two values such as"),
        ('[range]\n"modulus.linear" = ["2 MPa", "1 MPa"]', "range.modulus.linear: need the lower value first"),
        ("[unknown]\nviscosity = 1", "unknown.viscosity: need text in quotes, got 1"),
        ('[[facts]]\nwhat = "strength"', "facts.0.value: is missing; needed here: what, value, source"),
        ("name = 3", "name: need text in quotes, got 3"),
        ("name = ", "not TOML"),
    ],
)
def test_a_wrong_file_names_file_key_value_and_rule(tmp_path, text, message):
    path = tmp_path / "tendon_law.toml"
    path.write_text(text)
    with pytest.raises(InputError, match=rf"tendon_law.toml: {message}"):
        load_law(path)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("resiln", '"resiln" is neither a named material nor a .toml file; did you mean resilin?'),
        ("brass", "the named materials are petg, resilin, steel, tpu-82a, tpu-95a"),
        ("absent.toml", "absent.toml: no such file"),
    ],
)
def test_an_unknown_material_is_refused_with_the_nearest_name(name, message):
    with pytest.raises(InputError, match=message):
        load_law(name)

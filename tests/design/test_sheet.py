"""Designs of plates: reading and writing files, refusals, and sheets from FOLD files."""

import math
import tomllib

import numpy as np
import pytest

from forficula.design import (
    SheetDesign,
    design_from_text,
    design_pattern,
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
from forficula.design.families.pleats import PleatsDesign
from forficula.design.files.keys import known_keys
from forficula.design.sheets.sheet_creases import creases_of
from forficula.design.sheets.sheet_places import place_on
from forficula.design.stops import StopSection
from forficula.errors import InputError
from forficula.pattern import earwig_pattern, pleat_pattern, write_fold

LETTER = load_design("letter-fold")
KINDS = '"earwig-fan", "joint", "miura-ori", "waterbomb", "yoshimura", "kresling", "pleats", "vertex" or "fold-file"'
BASED = 'based_on = "letter-fold"\n'


@pytest.fixture
def refusal(tmp_path, monkeypatch):
    """Load text as the file letter.toml and return the error, one line."""
    monkeypatch.chdir(tmp_path)

    def load(text):
        (tmp_path / "letter.toml").write_text(BASED + text, "utf-8")
        with pytest.raises(InputError) as caught:
            load_design("letter.toml")
        message = str(caught.value)
        assert len(message.splitlines()) == 1
        return message.removeprefix("letter.toml: ")

    return load


def test_a_design_that_is_written_reads_the_same_to_the_bit():
    odd = with_values(
        LETTER,
        {
            "crease.stiffness": 1 / 3,
            "pattern.panel_lengths": [0.1 / 3, 0.07],
            "crease.group": [{"of": "crease 1", "start": 0.1 / 3}],
            "drive.close.value": math.pi / 100,
            "tendon.left.rest_length": 0.01 / 7,
        },
    )
    again = design_from_text(design_text(odd))
    assert again == odd
    assert again.hash == odd.hash != LETTER.hash
    assert again.crease.group[0].start == 0.1 / 3
    assert isinstance(again, SheetDesign)


def test_every_number_converts_to_other_units_and_back():
    present = in_units(LETTER, length=1e-2, mass=1e-3, time=1e-2)
    assert present.pattern.panel_lengths == pytest.approx((9.9,))
    assert present.drive[0].value == pytest.approx(3e-2 / (1e-3 * (1e-2 / 1e-2) ** 2))
    # N m/rad/m
    assert present.crease.stiffness == pytest.approx(2e-2 / (1e-3 * 1e-2 / 1e-2**2))
    assert present.crease.start == LETTER.crease.start
    back = in_units(present, length=1e2, mass=1e3, time=1e2)
    assert back.pattern.panel_lengths == pytest.approx(LETTER.pattern.panel_lengths, rel=1e-15)
    assert np.ptp(design_pattern(present).vertices_coords[:, 0]) == pytest.approx(29.7)


def test_a_scaled_strip_is_stiff_as_its_cube():
    """The torque per angle of a crease, stiffness per length times length, scales with the cube of the size."""
    large = scale_design(LETTER, 2.0)
    width, other = LETTER.pattern.width, large.pattern.width
    assert other == pytest.approx(2 * width)
    assert large.crease.stiffness * other == pytest.approx(8 * LETTER.crease.stiffness * width)
    assert large.drive[1].value == pytest.approx(8 * LETTER.drive[1].value)


def test_entries_of_lists_are_addressed_by_number_or_name():
    changed = with_values(LETTER, {"drive.open.value": -1.0, "tendon.1.stiffness": "7 N/cm"})
    assert [drive.value for drive in changed.drive] == [0.03, -1.0]
    assert key_value(changed, "tendon.right.stiffness") == key_value(changed, "tendon.1.stiffness") == 700
    assert put(LETTER, "drive.close.value", 0.0).drive[0].value == 0.0
    assert put(LETTER, "drive.0.value", 0.0).drive[0].value == 0.0
    assert key_value(LETTER, "protocol.stages.release closed.time_limit") == 5.0


@pytest.mark.parametrize(
    ("key", "unit"),
    [
        ("drive.0.value", "N cm"),
        ("drive.pull.value", "N cm"),
        ("tendon.3.rest_length", "cm"),
        ("crease.group.0.start", "deg"),
        ("pattern.panel_lengths.0", "cm"),
        ("protocol.stages.fold.hold", "s"),
    ],
)
def test_a_key_of_plates_has_the_unit_of_its_field(key, unit):
    assert key_quantity(key, PleatsDesign).unit.display == unit


@pytest.mark.parametrize(
    ("key", "message"),
    [
        ("drive.value", 'drive.value: need the number of an entry of drive, from 0 on, got "value"'),
        ("drive.close.valeu", "drive.close.valeu: unknown key; did you mean drive.close.value?"),
        ("drive.0.valeu", "drive.0.valeu: unknown key; did you mean drive.0.value?"),
        ("tendon.stiffness", 'tendon.stiffness: need the number of an entry of tendon, from 0 on, got "stiffness"'),
        ("vein.diameter", "vein.diameter: unknown key; "),
    ],
)
def test_a_key_that_plates_have_not_is_refused(key, message):
    with pytest.raises(InputError) as caught:
        key_quantity(key, PleatsDesign)
    assert str(caught.value).startswith(message)


def test_every_key_that_a_file_has_is_known():
    tables = tomllib.loads(design_text(LETTER))
    known = set(known_keys(PleatsDesign))
    for section, values in tables.items():
        rows = values if isinstance(values, list) else [values]
        number = ".0" if isinstance(values, list) else ""
        for row in rows:
            for key in row if isinstance(row, dict) else ():
                assert f"{section}{number}.{key}" in known


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[pattern]\npanels = 1", "pattern.panels: need >= 2, got 1"),
        ("[pattern]\npanels = 2", 'tendon.1.from: need a facet from 0 to 1, got 2 on "strip of 2 panels"'),
        ('[pattern]\npanel_lengths = "9 cm"', 'pattern.panel_lengths: need a list such as ["12 cm"], got "9 cm"'),
        ('[pattern]\npanel_lengths = ["9 cm", "0 cm"]', "pattern.panel_lengths: entry 1: need > 0, got 0 cm"),
        ("[pattern]\npanel_lengths = []", "pattern.panel_lengths: need 1 to 3 lengths, one for each panel, got 0"),
        ('[pattern]\nassignment = "VMV"', "pattern.assignment: need 1 to 2 letters, one for each crease, got 3"),
        ('[pattern]\nassignment = "F"', 'pattern.assignment: need letters M (mountain) and V (valley), got "F"'),
        (
            '[pattern]\nkind = "plaets"',
            f'pattern.kind: need {KINDS}, got "plaets"; did you',
        ),
        ("[pattern]\nkind = 3", f"pattern.kind: need {KINDS}, got 3"),
        ('[creases]\nstart = "1 deg"', 'creases: unknown key, got {start = "1 deg"}; did you mean crease?'),
        (
            '[crease]\nstifness = "1 N m/rad/m"',
            'crease.stifness: unknown key, got "1 N m/rad/m"; did you mean crease.stiffness?',
        ),
        ('[crease]\nstart = "9 deg"\nfold_limit = "5 deg"', "crease.start: need >= -3 deg (-crease.back_limit) and"),
        ('[[crease.group]]\nof = "mountains"', 'crease.group.0.of: need "creases", "valleys", "crease" or one such as'),
        ('[[crease.group]]\nof = "crease 5"', 'crease.group.0.of: need "crease 0" or "crease 1", got "crease 5"'),
        (
            '[[crease.group]]\nof = "valleys"\n[[crease.group]]\nof = "crease 1"\nstart = "176 deg"',
            "crease.group.1.start: need >= -3 deg (-crease.back_limit) and <= 175 deg (crease.fold_limit) at crease 1,"
            " got 176 deg",
        ),
        (
            '[crease]\nstart = "9 deg"\n[[crease.group]]\nof = "crease 1"\nfold_limit = "5 deg"',
            "crease.start: need >= -3 deg (-crease.back_limit) and <= 5 deg (crease.group.0.fold_limit) at crease 1",
        ),
        (
            '[[crease.group]]\nof = "crease 0"\ndamage = "off"',
            'crease.group.0.damage: need a table under [crease.group.damage] or "none", got "off"',
        ),
        (
            '[[crease.group]]\nof = "crease 0"\ndamage = {loss = 30, turn = "36000 deg"}',
            "crease.group.0.damage.loss: need <= 1, got 30",
        ),
        (
            '[[crease.group]]\nof = "crease 0"\ndamage = {turn = "36000 deg"}',
            "crease.group.0.damage.loss: is missing; needed here: loss, turn",
        ),
        (
            '[[crease.group]]\nof = "crease 0"\nbranches = "off"',
            'crease.group.0.branches: need a list of tables, each under [[crease.group.branches]], got "off"',
        ),
        ('[crease]\nbranches = ["1 s"]', 'crease.branches.0: need a table under [[crease.branches]], got "1 s"'),
        (
            '[[crease.group]]\nfriction = "1 N m/m"',
            'crease.group.0.of: is missing; give it, such as of = "crease 0"',
        ),
        (
            '[[support]]\nof = "facet 0"\nkind = "hinged"',
            'support.0.kind: unknown key, got "hinged"; allowed here: of, axes',
        ),
        ("contact = true", "contact: need a table under [contact], got true; did you mean protocol.contact?"),
        ('[[support]]\nof = "facet 3"', "support.0.of: need a facet from 0 to 2, got 3"),
        ('[[support]]\nof = "corner 3"', 'support.0.of: need a vertex such as "vertex 4", got "corner 3"'),
        ('[support]\nof = "facet 0"', "support: need a list of tables, each under [[support]], got "),
        ('[[drive]]\nname = "close"', "drive.0.kind: is missing; needed here: name, kind, of"),
        (
            '[[drive]]\nname = "close"\nkind = "torc"',
            'drive.0.kind: need "torque", "force", "displacement" or "rest-angle", got "torc"',
        ),
        (
            '[[drive]]\nname = "close"\nkind = "torque"\nof = "creases"',
            "drive.0.value: is missing; needed here: name, kind, of, value",
        ),
        ("drive = [1]", "drive.0: need a table under [[drive]], got 1"),
        (
            '[[drive]]\nname = "none"\nkind = "torque"\nof = "creases"\nvalue = "1 N m"',
            'drive.0.name: need a name that has no other meaning, got "none"',
        ),
        (
            '[[drive]]\nname = "a.b"\nkind = "torque"\nof = "creases"\nvalue = "1 N m"',
            "drive.0.name: need a name of letters, digits, spaces, - and _ that begins with a letter",
        ),
        (
            '[[drive]]\nname = "push"\nkind = "torque"\nof = "creases"\nvalue = "1 N m"',
            'protocol.stages.1.drive: need "none" or "push", got "close"',
        ),
        (
            '[[measure]]\nname = "valleys"\nkind = "fold-angle"\nof = "creases"',
            'measure.0.name: need a name that has no other meaning, got "valleys"',
        ),
        (
            '[[measure]]\nname = "crease"\nkind = "fold-angle"\nof = "creases"',
            'measure.0.name: need a name that is not used yet, got "crease" again',
        ),
        (
            '[[measure]]\nname = "energy"\nkind = "fold-angle"\nof = "creases"',
            'measure.0.name: need a name that is not a column of tables, got "energy"',
        ),
        (
            '[[measure]]\nname = "a"\nkind = "distance"\nfrom = "vertex 0"',
            'measure.0: kind = "distance" needs from and to, and nothing else; got from',
        ),
        (
            '[[measure]]\nname = "a"\nkind = "distance"\nfrom = "vertex 0"\nto = "edge 3 at 2"',
            "measure.0.to: need a share of edge 3 from 0 to 1, got 2",
        ),
        ("[crease.damage]\nloss = 0.3", "crease.damage.turn: is missing; give it, or leave out crease.damage"),
        ('[protocol]\ntimestep = "1 h"', "protocol.timestep: need >= "),
    ],
)
def test_what_cannot_be_is_refused_with_its_key_and_its_rule(refusal, text, message):
    assert refusal(text).startswith(message)


AFTER_TENDON = "need one of 0 (left) or 1 (right) after tendon"


@pytest.mark.parametrize(
    ("key", "message"),
    [
        ("tendon.stiffness", f"{AFTER_TENDON}, such as tendon.left.stiffness"),
        ("tendon.5.stiffness", f"{AFTER_TENDON}, such as tendon.left.stiffness"),
        ("tendon.law", f'{AFTER_TENDON}, got "law"'),
        ("drive.clos.value", "need one of 0 (close) or 1 (open) after drive; did you mean drive.close.value?"),
        ("drive.close.valeu", 'unknown key, got "1"; did you mean drive.close.value?'),
        ("drive.close.value", 'the unit is missing; write it such as "50 N cm", got "1"'),
        ("support.1.of", "need 0 after support, such as support.0.of"),
    ],
)
def test_an_unknown_setting_of_plates_is_refused_with_its_full_key(key, message):
    with pytest.raises(InputError) as caught:
        load_design("letter-fold", {key: "1"})
    assert str(caught.value) == f"{key}: {message}"


def test_drives_that_cancel_on_every_crease_are_refused():
    both = {"protocol.stages.1.drive": ["close", "open"]}
    with pytest.raises(InputError) as caught:
        load_design("letter-fold", both)
    assert str(caught.value) == (
        "letter-fold: protocol.stages.1.drive: need drives that do not cancel on every crease, got"
        ' ["close", "open"], 3 N cm and -3 N cm'
    )
    for other in ({"drive.open.value": "-2 N cm"}, {"drive.open.of": "crease 1"}, {"drive.open.rise": "1 s"}):
        assert load_design("letter-fold", both | other).protocol.stages[1].drive == ("close", "open")


def stage(until, more="", name="a"):
    head = f'[[protocol.stages]]\nname = "{name}"\ndrive = "close"\nhold = "0 s"\ntime_limit = "1 s"\n'
    return f'{head}until = "{until}"\n{more}\n'


@pytest.mark.parametrize(
    ("until", "message"),
    [
        ("closed", 'need "time", "rest", "target" or a bound such as "creases < -150 deg", got "closed"'),
        ("crese > 90 deg", 'need a bound on "creases", "crease" or "mouth", got "crese"; did you mean "crease"?'),
        ("creases > 3 cm", '"cm" is not a unit of the right kind; write it such as "15 deg", got "3 cm"'),
        ("mouth < 3 deg", '"deg" is not a unit of the right kind; write it such as "12 cm", got "3 deg"'),
        ("creases > 176 deg", "a stop keeps crease 0 from reaching it: need a value <= 175 deg, got 176 deg"),
        ("mouth < 0 cm", 'need a distance > 0 m, got "mouth < 0 cm"'),
        ("creases < -4 deg", "a stop keeps crease 0 from reaching it: need a value >= -3 deg, got -4 deg"),
    ],
)
def test_a_goal_that_cannot_be_is_refused(refusal, until, message):
    assert refusal(stage(until)) == f"protocol.stages.0.until: {message}"


def test_a_name_of_a_stage_or_of_a_state_is_given_once(refusal):
    sentence = "need a name that no stage and no other state has, got"
    one = stage("creases > 9 deg", 'state = "b"')
    assert refusal(one + one.replace('"a"', '"c"')) == f'protocol.stages.1.state: {sentence} "b" again'
    assert refusal(one + stage("rest")) == f'protocol.stages.1.name: {sentence} "a" again'
    assert refusal(stage("creases > 9 deg", 'state = "a"')) == f'protocol.stages.0.state: {sentence} "a" again'


@pytest.mark.parametrize("name", ["verdict", "stages", "residual"])
def test_reserved_table_keys_are_not_accepted_as_names(refusal, name):
    sentence = f'need a name that is not a column of tables, got "{name}"'
    assert refusal(stage("rest", name=name)) == f"protocol.stages.0.name: {sentence}"
    assert refusal(stage("rest", f'state = "{name}"')) == f"protocol.stages.0.state: {sentence}"


def test_a_bound_on_a_mountain_by_a_measure_is_valley_positive():
    """A mountain that folds by up to 175 deg has fold angles from -175 deg to 3 deg."""
    measure = {"name": "hills", "kind": "fold-angle", "of": "mountains"}
    ending = {"name": "a", "drive": "close", "hold": 0.0, "time_limit": 1.0}
    values = {"pattern.assignment": "M", "measure": [measure]}
    with_values(LETTER, values | {"protocol.stages": [ending | {"until": "hills < -174 deg"}]})
    with pytest.raises(InputError, match="a stop keeps crease 0 from reaching it: need a value <= 3 deg, got 90 deg"):
        with_values(LETTER, values | {"protocol.stages": [ending | {"until": "hills > 90 deg"}]})


def test_a_tendon_must_cross_something(refusal):
    tendon = (
        '[[tendon]]\nname = "t"\nfrom = "vertex 0"\nto = "facet 0 at 1, 1"\nstiffness = "1 N/cm"\nrest_length = "1 cm"'
    )
    assert refusal(tendon) == (
        "tendon.0.to: need a place on another facet than tendon.0.from, or the length never changes, got facet 0 for"
        " both"
    )


def test_a_design_of_another_kind_cannot_be_the_base(tmp_path):
    path = tmp_path / "a.toml"
    path.write_text('based_on = "binder2025"\n[pattern]\nkind = "pleats"\n')
    with pytest.raises(InputError, match=r'of kind earwig-fan; begin with based_on = "letter-fold"$'):
        load_design(path)
    with pytest.raises(
        InputError, match=r"pattern.kind: designs of kind pleats have other sections than those of kind"
    ):
        load_design("binder2025", {"pattern.kind": "pleats"})


@pytest.mark.parametrize(
    ("text", "facet", "place"),
    [
        ("vertex 5", 0, (0.1, 0.2)),
        ("vertex 5 of facet 1", 1, (0.1, 0.2)),
        ("edge 0 at 0.25", 0, (0.1, 0.05)),
        ("crease 0 at 1", 0, (0.1, 0.2)),
        ("facet 1 at centre", 1, (0.2, 0.1)),
        (" facet  1 at center ", 1, (0.2, 0.1)),
        ("facet 1 at 0.5, 1", 1, (0.2, 0.2)),
        ("facet 0 at 0,0", 0, (0, 0)),
    ],
)
def test_a_place_has_the_described_position(text, facet, place):
    result = place_on(pleat_pattern([0.1, 0.2, 0.3], 0.2, "MV"), text)
    assert result.facet == facet
    assert result.position == pytest.approx([*place, 0], abs=1e-15)


@pytest.mark.parametrize(
    "text",
    ["", "vertex", "vertex 99", "vertex -1", "facet 1", "facet 9 at centre", "vertex 0 of facet 2", "edge 0 at 1.1"],
)
def test_an_invalid_place_is_refused(text):
    with pytest.raises(InputError):
        place_on(pleat_pattern([0.1, 0.2, 0.3], 0.2, "MV"), text)


def test_groups_of_creases():
    strip = pleat_pattern([0.1] * 4, 0.2, "MVM")
    assert [creases_of(strip, name) for name in ("creases", "mountains", "valleys", "crease", "crease 1")] == [
        (0, 1, 2),
        (0, 2),
        (1,),
        (0, 1, 2),
        (1,),
    ]


def test_a_sheet_of_a_file_is_stored_with_its_content(tmp_path):
    sheet = pleat_pattern([0.1 / 3, 0.05, 0.07], 0.2, "MV")
    write_fold(sheet, tmp_path / "strip.fold")
    path = tmp_path / "design.toml"
    path.write_text(
        f'{BASED}tendon = []\nmeasure = []\nsupport = []\n[pattern]\nkind = "fold-file"\npath = "strip.fold"\n'
    )
    design = load_design(path)
    (tmp_path / "strip.fold").unlink()
    again = design_from_text(design_text(design))
    assert again == design
    for one in (design, again):
        kept = design_pattern(one)
        assert kept.vertices_coords.tobytes() == sheet.vertices_coords.tobytes()
        assert kept.edges_vertices.tolist() == sheet.edges_vertices.tolist()
        assert (kept.edges_assignment, kept.edges_role, kept.faces_vertices) == (
            sheet.edges_assignment,
            sheet.edges_role,
            sheet.faces_vertices,
        )
    assert design.pattern.title == "strip of 3 panels"
    assert design.pattern.path is None


def test_a_sheet_of_a_file_is_named_by_a_setting(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_fold(pleat_pattern([0.1, 0.1, 0.1, 0.1], 0.2, "MVM"), "strip.fold")
    values = {"pattern.kind": "fold-file", "pattern.path": "strip.fold"}
    assert len(design_pattern(load_design("letter-fold", values)).faces_vertices) == 4
    assert len(design_pattern(with_values(LETTER, values)).faces_vertices) == 4


def test_facets_around_a_loop_that_do_not_meet_at_the_start_are_refused(tmp_path):
    """All creases of letter-fold start at -1 deg, which closes around no vertex of a fan."""
    fan = load_design("binder2025").fan
    write_fold(earwig_pattern(fan), tmp_path / "fan.fold")
    path = tmp_path / "a.toml"
    path.write_text(f'{BASED}[pattern]\nkind = "fold-file"\npath = "fan.fold"\n')
    with pytest.raises(InputError, match=r"crease\.start: need angles at which the facets meet: "):
        load_design(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            'path = "no.fold"',
            "pattern.path: {folder}/no.fold: no such file",
        ),
        ('file = "sheet.fold"', 'pattern.file: unknown key, got "sheet.fold"; did you mean pattern.path?'),
        ("", 'pattern.path: is missing; name a FOLD file, as in path = "sheet.fold"'),
        ('vertices_x = ["1 cm"]', "pattern.vertices_y: need 1 entries, as pattern.vertices_x has, got 0"),
        (
            'vertices_x = ["1 cm"]\nvertices_y = ["1 cm"]\nedges = [[0, 0]]\nassignment = "B"',
            "pattern: edges_vertices[0]: need two vertices apart, got 0 and 0 at one place",
        ),
    ],
)
def test_an_invalid_sheet_is_refused(tmp_path, text, message):
    path = tmp_path / "a.toml"
    path.write_text(f'{BASED}[pattern]\nkind = "fold-file"\n{text}\n')
    with pytest.raises(InputError) as caught:
        load_design(path)
    assert str(caught.value) == f"{path}: {message.format(folder=tmp_path)}"


def test_a_new_file_describes_every_key_and_gives_the_same_design(tmp_path):
    path = tmp_path / "letter.toml"
    write_new_design(path, "pleats")
    assert load_design(path).hash == LETTER.hash
    # also with the comment signs of all tables removed
    lines, inside = [], False
    for line in path.read_text().splitlines():
        inside = line.startswith("# [[") or (inside and line.startswith("# "))
        # creases open all or none
        lines.append(line.removeprefix("# ") if inside and not line.startswith("# extension") else line)
    path.write_text("\n".join(lines))
    assert "\n[[tendon]]" in path.read_text()
    design = load_design(path)
    (group,) = design.crease.group
    # with the angles of letter-fold, so that every goal lies within its stops
    angles = ("rest_angle", "fold_limit", "back_limit", "start")
    assert [getattr(group, key) for key in angles] == [getattr(LETTER.crease, key) for key in angles]
    assert put(put(design, "crease.group", ()), "crease.branches", ()).hash == LETTER.hash


def test_a_new_file_for_a_fold_file_has_no_values_of_a_particular_sheet(tmp_path):
    path = tmp_path / "new.toml"
    write_new_design(path, "fold-file")
    with pytest.raises(InputError, match=r"pattern\.path: .*sheet\.fold: no such file"):
        load_design(path)
    write_fold(pleat_pattern([0.1, 0.1], 0.2, "M"), tmp_path / "sheet.fold")
    design = load_design(path)
    assert (design.tendon, design.support, design.measure) == ((), (), ())
    base = load_design("miura-sheet")
    assert (design.facet, design.crease, design.drive) == (base.facet, base.crease, base.drive)


@pytest.mark.parametrize(
    ("start", "end", "why"),
    [
        ("facet 0 at 0.5, 0.5", "facet 1 at 0.5, 0.5", "no crease lies between them"),
        ("facet 1 at 0.5, 0.5", "vertex 2 of facet 2", "it lies on the axis of every crease between them"),
        ("edge 1 at 0.3", "facet 2 at 0.5, 0.5", "it lies on the axis of every crease between them"),
    ],
)
def test_a_tendon_that_nothing_stretches_is_refused(tmp_path, start, end, why):
    """Facets 0 and 1 are one plate, because the edge between them is flat; a point on an axis does not move."""
    path = tmp_path / "strip.fold"
    write_fold(pleat_pattern([0.1, 0.1, 0.1], 0.2, "VV"), path)
    path.write_text(path.read_text().replace('"V"', '"F"', 1).replace("180.0", "0.0", 1))
    sheet = {"pattern.kind": "fold-file", "pattern.path": str(path), "measure": [], "support": []}
    tendon = {"name": "a", "from": start, "to": end, "stiffness": "1 N/cm", "rest_length": "1 cm"}
    with pytest.raises(InputError) as caught:
        load_design("letter-fold", sheet | {"tendon": [tendon]})
    assert str(caught.value).endswith(
        "tendon.0.to: need a place that moves relative to tendon.0.from, or the length never changes, got"
        f' "{end}": {why}'
    )


def test_a_tendon_from_one_axis_to_the_next_is_refused():
    tendon = {"name": "a", "from": "vertex 1 of facet 0", "to": "vertex 2 of facet 2", "rest_length": "1 cm"}
    with pytest.raises(InputError, match="it lies on the axis of every crease between them"):
        load_design("letter-fold", {"tendon": [tendon | {"stiffness": "1 N/cm"}]})
    # from the axis of one crease across the other one
    tendon |= {"to": "facet 2 at 0.5, 0.5", "stiffness": "1 N/cm"}
    assert load_design("letter-fold", {"tendon": [tendon]}).tendon[0].name == "a"


TENDON = {"name": "t", "from": "vertex 0", "to": "vertex 8", "stiffness": "1 N/cm", "rest_length": "1 cm"}
WIDTH = {"name": "width", "kind": "distance", "from": "vertex 0", "to": "vertex 8"}
STAGE = {"name": "rest", "drive": "none", "until": "time", "time_limit": "1 s"}
MIURA = {
    "pattern.columns": 2,
    "pattern.rows": 2,
    "support": [{"of": "facet 0"}],
    "drive": [],
    "protocol.stages": [STAGE],
}


@pytest.mark.parametrize(
    ("values", "why"),
    [
        ({"support": [{"of": f"facet {n}"} for n in range(4)]}, "support: need a vertex that can move, got all 9 held"),
        (
            {"support": [{"of": f"vertex {n}"} for n in range(9)]},
            "support: need a vertex that can move, got all 9 held",
        ),
        ({"tendon": [TENDON | {"to": "edge 4 at 0"}]}, 'tendon.0.to: need another place than tendon.0.from, got "edge'),
        ({"tendon": [TENDON | {"to": "vertex 0"}]}, 'tendon.0.to: need another place than tendon.0.from, got "vertex'),
        ({"measure": [WIDTH | {"to": "vertex 0"}]}, "measure.0.to: need another place than measure.0.from, got"),
        (
            {"crease.group": [{"name": "crease 0", "of": "crease 1"}]},
            "crease.group.0.name: need a name that has no oth",
        ),
        ({"crease.group": [{"name": "a and b", "of": "crease 1"}]}, "crease.group.0.name: need a name that has no oth"),
    ],
)
def test_a_sheet_of_nodes_with_contradictory_values_is_refused(values, why):
    whole = MIURA | {"tendon": [TENDON], "measure": [WIDTH]}
    assert load_design("miura-sheet", whole)
    with pytest.raises(InputError) as caught:
        load_design("miura-sheet", whole | values)
    assert str(caught.value).removeprefix("miura-sheet: ").startswith(why)


def test_a_sheet_whose_vertices_are_all_held_along_some_axes_can_move():
    assert load_design(
        "miura-sheet", MIURA | {"measure": [], "support": [{"of": f"vertex {n}", "axes": "xy"} for n in range(9)]}
    )


@pytest.mark.parametrize(("key", "value", "got"), [("time_constant", "3 ms", "3 ms"), ("damping_ratio", 0.5, "0.5")])
def test_stops_of_bodies_are_refused_where_facets_bend_and_their_creases_have_springs(key, value, got):
    sentence = f"stops.{key}: is for stops of rigid bodies; where facets bend, .* crease.stop_stiffness; got {got}$"
    with pytest.raises(InputError, match=sentence):
        load_design("miura-sheet", {f"stops.{key}": value})
    assert getattr(load_design("letter-fold", {f"stops.{key}": value}).stops, key) != getattr(StopSection(), key)


def test_the_stops_of_a_scaled_sheet_with_bending_facets_are_unchanged(tmp_path):
    small = scale_design("miura-sheet", 0.5)
    save_design(small, tmp_path / "small.toml")
    assert load_design(tmp_path / "small.toml").stops == load_design("miura-sheet").stops
    assert scale_design("letter-fold", 0.5).stops.time_constant == 0.5 * StopSection().time_constant


def test_a_key_that_another_kind_of_drive_has_is_absent():
    letter = load_design("letter-fold")
    assert key_value(letter, "drive.close.value") > 0
    for key in ("angle", "force", "distance", "direction", "to"):
        assert key_value(letter, f"drive.close.{key}") is None

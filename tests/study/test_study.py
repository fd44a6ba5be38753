import pytest

import forficula as ff
from forficula.design import key_value, tendon_law, with_values
from forficula.errors import InputError
from forficula.study import named_studies, run_study
from forficula.study.files.study_file import load_study, study_of
from forficula.study.search import search_designs
from forficula.study.study_designs import point_design

DRAWN = '"tendon.stiffness" = {distribution = "uniform", low = "10 N/cm", high = "20 N/cm"}'
LISTED = '"tendon.rest_length" = ["5 cm", "7 cm"]'


def test_the_papers_search_has_sixty_tendons_with_six_fold_torques_and_ten_unfold_torques_each():
    assert "binder2025-search" in named_studies()
    study = ff.load_study("binder2025-search")
    assert "10.3390/biomimetics11010009" in study.source
    assert (len(study.points), study.sampled) == (60, False)
    first, last = (point_design(study.base, study.points[index]).tendon for index in (0, -1))
    assert (first.stiffness, first.rest_length) == (1000.0, 0.0)
    assert (last.stiffness, last.rest_length) == (6000.0, 0.09)
    designs = search_designs(study.base, study.search, {})
    folding = [design.protocol for design in designs.values()]
    assert [protocol.fold_torque for protocol in folding] == pytest.approx([0.5, 0.4, 0.3, 0.2, 0.1, 0.0])
    assert {protocol.stages[-1].drive for protocol in folding} == {"fold"}
    # a wing that folds is released, and opened from the wing folded with 500 N cm
    known = {key: {"verdict": "reached", "folded": True} for key in designs}
    wanted = [design.protocol for design in search_designs(study.base, study.search, known).values()]
    release, *opening = wanted[len(folding) :]
    assert release.fold_torque == 0.0
    assert {protocol.fold_torque for protocol in opening} == {5.0}
    # the largest torque first, and then halving
    assert [protocol.unfold_torque for protocol in opening[:4]] == pytest.approx([1.0, 0.5, 0.3, 0.8])
    assert sorted(protocol.unfold_torque for protocol in opening) == pytest.approx([0.1 * n for n in range(1, 11)])


def test_the_last_factor_varies_fastest(study_file):
    study = load_study(study_file('"tendon.stiffness" = "10..20 N/cm step 10"\n"pattern.units" = "1..3 step 1"'))
    assert [tuple(point.values()) for point in study.points] == [
        (stiffness, units) for stiffness in ("10 N/cm", "20 N/cm") for units in (1, 2, 3)
    ]


def test_settings_are_part_of_the_design_that_is_varied(study_file):
    study = load_study(study_file(LISTED))
    assert study.base.protocol.timestep == 4e-4
    assert study.base.protocol.stages[1].time_limit == 0.1
    assert study.name == "small"


def test_a_design_by_path_is_looked_for_beside_the_study(tmp_path, monkeypatch):
    folder = tmp_path / "there"
    folder.mkdir()
    (folder / "wing.toml").write_text('based_on = "binder2025"\n[tendon]\nstiffness = "33 N/cm"\n')
    (folder / "study.toml").write_text(f'design = "wing.toml"\n[factors]\n{LISTED}\n')
    monkeypatch.chdir(tmp_path)
    assert load_study("there/study.toml").base.tendon.stiffness == 3300.0


@pytest.mark.parametrize("law", ['"soft.toml"', '{based_on = "soft.toml", linear_modulus = "3 MPa"}'])
def test_a_law_by_path_is_looked_for_beside_the_study(tmp_path, monkeypatch, law):
    (tmp_path / "studies").mkdir()
    (tmp_path / "studies" / "soft.toml").write_text('[modulus]\nlinear = "2 MPa"')
    (tmp_path / "studies" / "laws.toml").write_text(
        f'design = "binder2025"\n[settings.tendon]\nlaw = {law}\narea = "12.5 mm^2"\n'
        '[factors]\n"tendon.law" = ["none", "soft.toml", "tpu-82a"]'
    )
    monkeypatch.chdir(tmp_path)
    study = load_study("studies/laws.toml")
    modulus = 3e6 if "based_on" in law else 2e6
    assert study.base.tendon.law.linear_modulus == modulus
    tendons = [point_design(study.base, point).tendon for point in study.points]
    by_area = [tendon_law(tendon).stiffness[0] * 0.09 / 12.5e-6 for tendon in tendons]
    assert by_area == pytest.approx([modulus, 2e6, 4.8e6], rel=1e-12)
    assert [tendon.law is None for tendon in tendons] == [True, False, False]


def test_a_key_may_be_written_in_tables(tmp_path):
    path = tmp_path / "study.toml"
    path.write_text('design = "binder2025"\n[settings.protocol]\ntimestep = "0.4 ms"\n[factors.pattern]\nunits = [1]\n')
    study = load_study(path)
    assert study.base.protocol.timestep == 4e-4
    assert [factor.key for factor in study.factors] == ["pattern.units"]


def test_a_factor_in_a_stage_is_that_of_a_run_with_the_same_value(tmp_path, study_file):
    study = load_study(study_file('"protocol.stages.1.time_limit" = ["20 ms", "100 ms"]'))
    table = run_study(study, tmp_path / "out")
    assert table["protocol_stages_1_time_limit"].values.tolist() == [0.02, 0.1]
    for number, limit in enumerate(("20 ms", "100 ms")):
        alone = ff.measure(ff.run(with_values(study.base, {"protocol.stages.1.time_limit": limit}), confirm=False))
        assert table["status"].values[number] == alone.status
        assert table["fold_work"].values[number] == alone.transitions["fold"].work
    assert len(set(table["status"].values)) == 2


def test_an_entry_of_a_list_of_shares_is_drawn_as_any_number(study_file):
    rows = '"membrane.proximal_rows.0" = {distribution = "uniform", low = 0.2, high = 0.4}'
    study = load_study(study_file(rows, tail="[sampling]\ncount = 3"))
    shares = [point_design(study.base, point).membrane.proximal_rows[0] for point in study.points]
    assert all(0.2 <= share <= 0.4 for share in shares)


@pytest.mark.parametrize(
    ("stage", "meant"),
    [("5", r", such as protocol\.stages\.settle\.hold"), ("flod", r"; did you mean .*\.fold\.hold\?")],
)
def test_a_stage_that_the_design_does_not_have_is_refused_with_those_it_has(study_file, stage, meant):
    words = rf"protocol\.stages\.{stage}\.hold: need one of 0 \(settle\), 1 \(fold\), .* after protocol\.stages{meant}"
    with pytest.raises(InputError, match=words):
        load_study(study_file(f'"protocol.stages.{stage}.hold" = ["1 ms"]'))


def test_the_value_of_a_drive_has_the_unit_of_its_strength():
    study = study_of({"design": "force-clasp", "factors": {"drive.pull.value": ["1 N", "1.5 N"]}})
    assert [factor.key for factor in study.factors] == ["drive.pull.force"]
    assert key_value(point_design(study.base, study.points[1]), "drive.pull.force") == pytest.approx(1.5)
    with pytest.raises(InputError, match=r'factors\.drive\.pull\.force: "N cm" is not a unit of the right kind'):
        study_of({"design": "force-clasp", "factors": {"drive.pull.value": ["1 N cm"]}})


def test_a_stage_may_be_named_by_its_name(study_file):
    named, numbered = (load_study(study_file(f'"protocol.stages.{stage}.hold" = ["1 ms"]')) for stage in ("fold", "1"))
    designs = [point_design(study.base, study.points[0]) for study in (named, numbered)]
    assert designs[0] == designs[1]
    assert designs[0].protocol.stages[1].hold == 1e-3


@pytest.mark.parametrize("method", ["random", "sobol"])
def test_sampled_studies_have_the_requested_points_and_depend_only_on_the_seed(study_file, method):
    tail = f'[sampling]\nmethod = "{method}"\ncount = 5\nseed = 3'
    study, again = (load_study(study_file(DRAWN, tail=tail)) for _ in range(2))
    assert study.sampled
    assert len(study.points) == 5
    assert study.points == again.points
    assert all(1000 <= point_design(study.base, point).tendon.stiffness <= 2000 for point in study.points)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = ?", "not TOML: "),
        ("a = " + "[" * 20_000, "not TOML for a study: nested too deeply"),
        (f"[factors]\n{LISTED}", "design: is missing; give the name or path of a design"),
        (f"design = 3\n[factors]\n{LISTED}", 'design: need the name or path of a design, such as "binder2025", got 3'),
        (f'design = "bindr2025"\n[factors]\n{LISTED}', 'design: "bindr2025" is neither a named design nor'),
        (f'design = "none.toml"\n[factors]\n{LISTED}', ""),
        ('design = "binder2025"', "factors: need a table with at least one"),
        ('design = "binder2025"\nfactors = 3', "factors: need a table, got 3"),
        (
            f'design = "binder2025"\nfactor = 3\n[factors]\n{LISTED}',
            "factor: unknown key, got 3; did you mean factors?",
        ),
        (f'design = "binder2025"\nzzz = 3\n[factors]\n{LISTED}', "zzz: unknown key, got 3; allowed here: name"),
        (f'design = "binder2025"\nsettings = 3\n[factors]\n{LISTED}', "settings: need a table, got 3"),
        (
            f'design = "binder2025"\n[factors]\n{LISTED}\n[settings]\ntendon.stifness = "1 N/m"',
            "settings.tendon.stifness: unkno",
        ),
        (f'design = "binder2025"\nname = "a/b"\n[factors]\n{LISTED}', "name: need a name that a folder can have"),
        (f'design = "binder2025"\nname = ""\n[factors]\n{LISTED}', "name: need a name that a folder can have"),
        (f'design = "binder2025"\nname = ".."\n[factors]\n{LISTED}', "name: need a name that a folder can have"),
        (f'design = "binder2025"\nname = "a\\u001b[2J"\n[factors]\n{LISTED}', "name: need a name that a folder can"),
        (f'design = "binder2025"\nname = "a\\nb"\n[factors]\n{LISTED}', "name: need a name that a folder can"),
        (f"x = 1{'0' * 5000}\n[factors]\n{LISTED}", "not TOML: a whole number has too many digits"),
        (f"design = 'a'\ndesign = 'b'\n[factors]\n{LISTED}", "not TOML: Cannot overwrite a value (at line 2, "),
        (
            'design = "binder2025"\n[factors]\n"tendon.rest_length" = ["1 cm"]\ntendon.rest_length = ["2 cm"]',
            "factors.tendon.rest_length: is given twice",
        ),
        (
            'design = "binder2025"\nsettings.tendon.rest_length = "1 cm"\n'
            f'settings."tendon.rest_length" = "2 cm"\n[factors]\n{LISTED}',
            "settings.tendon.rest_length: is given twice",
        ),
        (f'design = "binder2025"\nname = 3\n[factors]\n{LISTED}', "name: need a name that a folder can have"),
        (
            f'design = "binder2025"\nask = "best"\n[factors]\n{LISTED}',
            'ask: need "run", "least-torques" or "least-v',
        ),
        (f'design = "binder2025"\n[factors]\n{LISTED}\n{DRAWN}', "factors: need either all of them as distributions"),
        (f'design = "binder2025"\n[factors]\n{LISTED}\n[sampling]\ncount = 3', "sampling: needs factors that are dist"),
        (
            f'design = "binder2025"\n[factors]\n{LISTED}\n[search]\nrefinements = 1',
            'search: needs ask = "least-torques" or "least-value"',
        ),
        (
            'design = "binder2025"\n[factors]\n"tendon.rest_length" = "0..1 m step 1e-4"\n'
            '"pattern.hub_radius" = "0..1 m step 1e-4"',
            "factors: need at most 1000000 points, got 100020001",
        ),
        (
            f'design = "binder2025"\n[settings]\n"tendon.rest_length" = "4 cm"\n[factors]\n{LISTED}',
            "factors.tendon.rest_length: is under [settings], too; need it in one of them",
        ),
        (
            'design = "letter-fold"\n[settings]\ntendon.0.stiffness = "0.4 N/cm"\n[factors]\n'
            'tendon.left.stiffness = ["0.5 N/cm"]',
            "factors.tendon.left.stiffness: is under [settings], too, as tendon.0.stiffness; need it in one of them",
        ),
    ],
)
def test_an_invalid_study_is_rejected_with_its_file_and_the_error(tmp_path, monkeypatch, text, message):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "study.toml").write_text(text)
    with pytest.raises(InputError) as caught:
        load_study("study.toml")
    assert str(caught.value).startswith(f"study.toml: {message}")
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize(
    ("sampling", "message"),
    [
        ("", "sampling.count: is missing; give it (whole number, >= 1, <= 1000000)"),
        ("[sampling]\ncount = 0", "sampling.count: need a whole number >= 1 and <= 1000000, got 0"),
        ("[sampling]\ncount = true", "sampling.count: need a whole number >= 1 and <= 1000000, got true"),
        ("[sampling]\ncount = 2.5", "sampling.count: need a whole number >= 1 and <= 1000000, got 2.5"),
        (
            "[sampling]\ncount = 1_000_000_000_000",
            "sampling.count: need a whole number >= 1 and <= 1000000, got 1000000000000",
        ),
        ("[sampling]\ncount = 3\nseed = -1", "sampling.seed: need a whole number >= 0, got -1"),
        ('[sampling]\ncount = 3\nmethod = "grid"', 'sampling.method: need "random", "sobol" or "refine"'),
        ("[sampling]\ncounts = 3", "sampling.counts: unknown key, got 3; did you mean sampling.count?"),
    ],
)
def test_sampling_needs_a_count_and_a_seed(study_file, sampling, message):
    with pytest.raises(InputError) as caught:
        load_study(study_file(DRAWN, tail=sampling))
    assert message in str(caught.value)


@pytest.mark.parametrize("numbers", ["low = nan, high = 0.4", "low = 0.1, high = inf", "low = -1e308, high = 1e308"])
def test_a_distribution_has_finite_ends(study_file, numbers):
    share = f'"membrane.proximal_rows.0" = {{distribution = "uniform", {numbers}}}'
    with pytest.raises(InputError, match=r"membrane\.proximal_rows\.0\.(low|high): need a finite "):
        load_study(study_file(share, tail="[sampling]\ncount = 3"))


def test_sampling_that_is_no_table_is_refused(study_file):
    with pytest.raises(InputError, match=r"sampling: need a table under \[sampling\], got 3"):
        load_study(study_file(DRAWN, head="sampling = 3"))


def test_whole_numbers_and_words_are_not_sampled(study_file):
    units = '"pattern.units" = {distribution = "uniform", low = 1, high = 3}'
    with pytest.raises(InputError, match=r"pattern\.units: need a list or a range"):
        load_study(study_file(units, tail="[sampling]\ncount = 3"))


@pytest.mark.parametrize(
    ("search", "message"),
    [
        ('fold_torques = "0..1000 N cm step 1"', "search.fold_torques: need at most 1000 torques, got 1001"),
        ('unfold_torques = "0..999999 N cm step 1"', "search.unfold_torques: need at most 1000 torques, got 1000000"),
        ('fold_torques = ["20 N cm", "10 N cm"]', "search.fold_torques: need rising torques >= 0"),
        ('fold_torques = ["10 N cm", "10 N cm"]', "search.fold_torques: need rising torques >= 0"),
        ('unfold_torques = "-10..10 N cm step 10"', "search.unfold_torques: need rising torques >= 0"),
        ('fold_with = "-1 N cm"', "search.fold_with: need rising torques >= 0"),
        ("fold_torques = []", "search.fold_torques: need torques such as"),
        ("fold_torques = [20]", "search.fold_torques: the unit is missing"),
        ('unfold_torques = ["20 N"]', 'search.unfold_torques: "N" is not a unit of the right kind'),
        ("refinements = -1", "search.refinements: need a whole number >= 0 and <= 20, got -1"),
        ("refinements = true", "search.refinements: need a whole number >= 0 and <= 20, got true"),
        ("torques = 1", "search.torques: unknown key, got 1; did you mean search.fold_torques?"),
    ],
)
def test_a_search_over_torques_that_do_not_rise_is_refused(study_file, search, message):
    with pytest.raises(InputError) as caught:
        load_study(study_file(LISTED, head='ask = "least-torques"', tail=f"[search]\n{search}"))
    assert message in str(caught.value)


@pytest.mark.parametrize("name", ["none.toml", "none", "", "x" * 400 + ".toml", "a\0.toml", "folder.toml"])
def test_a_missing_study_is_one_clear_error(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder.toml").mkdir()
    with pytest.raises(InputError) as caught:
        load_study(name)
    assert len(str(caught.value).splitlines()) == 1


def test_a_study_that_is_not_utf8_is_one_clear_error(tmp_path):
    (tmp_path / "study.toml").write_bytes('source = "Käfer"'.encode("latin-1"))
    with pytest.raises(InputError, match="not UTF-8 text from byte"):
        load_study(tmp_path / "study.toml")


def test_one_value_by_two_names_is_refused():
    twice = {"tendon.0.stiffness": ["0.4 N/cm"], "tendon.left.stiffness": ["0.5 N/cm", "0.6 N/cm"]}
    with pytest.raises(InputError, match=r"tendon\.left\.stiffness: is given twice, also as tendon\.0\."):
        ff.new_study("letter-fold", twice)
    with pytest.raises(InputError, match=r"tendon\.left\.stiffness: is given twice"):
        with_values(ff.load_design("letter-fold"), {key: values[0] for key, values in twice.items()})


def test_one_value_with_dots_and_in_a_table_is_refused():
    twice = {"tendon.stiffness": "1 N/cm", "tendon": {"stiffness": "2 N/cm"}}
    says = r"^tendon\.stiffness: is given twice, once with dots in its name and once in a table$"
    with pytest.raises(InputError, match=says):
        ff.load_design("binder2025", twice)
    beside = {"tendon.stiffness": "1 N/cm", "tendon": {"damping": "0.2 N s/m"}}
    assert ff.load_design("binder2025", beside).as_tables()["tendon"]["damping"] == "0.2 N s/m"

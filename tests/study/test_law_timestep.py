"""A law of tendons that needs a shorter timestep than the reference has makes the timestep automatic, everywhere."""

import pytest

import forficula as ff
from forficula.design import load_design, named_designs
from forficula.study.running.law_timestep import law_timestep, with_timestep_for_law
from forficula.study.tables.table_rows import json_rows
from forficula.workbench.requests import DesignRequest, Opened
from forficula.workbench.responses import model_response

VISCOUS = 'name = "{0}"\nsource = ""\n[modulus]\nlinear = "4.8 MPa"\n[viscosity]\nlinear = "{1} MPa s"\n'
USED = 'protocol.timestep: "auto" is used, because the viscous law of the tendons does not allow 0.1 ms'

STAGES = ("settle", "push", "snap", "unfold", "release opened")
SHORT = {f"protocol.stages.{stage}.time_limit": "2 ms" for stage in STAGES}


@pytest.fixture
def viscous(tmp_path, monkeypatch):
    """Return settings with a law that needs a timestep far below that of the joint."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "viscous.toml").write_text(VISCOUS.format("viscous", 12))
    (tmp_path / "mild.toml").write_text(VISCOUS.format("mild", 0.01))
    return {"tendon.law": "viscous.toml", "tendon.area": "5 mm^2"}


def test_a_law_that_needs_a_shorter_timestep_has_an_automatic_one(viscous):
    with pytest.warns(UserWarning, match=USED):
        assert with_timestep_for_law(load_design("binder2025-joint", viscous)).protocol.timestep == "auto"
    assert law_timestep(load_design("binder2025-joint").with_values(viscous))[0].protocol.timestep == "auto"


def test_a_timestep_that_was_set_and_one_that_the_law_allows_are_kept(viscous):
    set_to_the_same = load_design("binder2025-joint", viscous | {"protocol": {"timestep": "0.1 ms"}})
    for design in (
        set_to_the_same,
        set_to_the_same.with_values({"tendon.rest_length": "6 cm"}),
        load_design("binder2025-joint", viscous).with_values({"protocol.timestep": "0.1 ms"}),
        load_design("binder2025-joint", viscous | {"protocol.timestep": "0.2 ms"}),
        load_design("binder2025-joint", viscous | {"tendon.law": "mild.toml"}),
    ):
        assert law_timestep(design) == (design, "")


def test_named_designs_keep_their_timestep():
    for name in named_designs():
        design = load_design(name)
        assert law_timestep(design) == (design, "")


def test_python_studies_and_the_workbench_use_the_same_timestep_and_warn(viscous):
    design = load_design("binder2025-joint", viscous)
    assert ff.check_design(design) == (law_timestep(design)[1],)
    with pytest.warns(UserWarning, match=USED):
        used = ff.run(design.with_values(SHORT), confirm=False).record.design.protocol.timestep
    assert used < 1e-4
    opened = Opened(design="binder2025-joint", settings={})
    request = DesignRequest(settings=viscous)
    assert any(warning.startswith(USED) for warning in model_response(request, opened)["warnings"])


@pytest.mark.usefixtures("viscous")
def test_rows_of_a_study_say_which_timestep_was_used_where_it_is_automatic():
    factors = {"tendon.law": ["viscous.toml", "mild.toml"]}
    base = load_design("binder2025-joint", {"tendon.area": "5 mm^2", **SHORT})
    with pytest.warns(UserWarning, match=USED):
        table = ff.sweep(base, factors)
    viscous_step, mild_step = table["timestep"].values
    assert viscous_step < mild_step == 1e-4
    assert [row["timestep_s"] for row in json_rows(table.study, table)] == [viscous_step, mild_step]
    # named timesteps need no column
    assert "timestep" not in ff.sweep(base, {"tendon.rest_length": ["5 cm"]})

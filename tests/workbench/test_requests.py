"""Which files a page of a workbench may name; a design that is dropped on it may come from somebody else."""

import json

import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.material import load_law, save_law
from forficula.workbench.requests import DesignRequest, UploadedFile, opened_with, requested_design
from tests.workbench.test_server import SQUARE

SECRET = "TOP-SECRET-TOKEN-12345"
REFUSED = "the workbench reads only files that are dropped on its page, files in the folder of its design"


@pytest.fixture
def places(tmp_path, monkeypatch):
    """A folder that a workbench is opened in, and one beside it with what is nobody's business."""
    inside, outside = tmp_path / "inside", tmp_path / "outside"
    inside.mkdir()
    outside.mkdir()
    for folder in (inside, outside):
        save_law(load_law("tpu-82a"), folder / "law.toml")
        (folder / "design.toml").write_text('based_on = "binder2025-joint"\n[tendon]\nlaw = "law.toml"\n', "utf-8")
        (folder / "sheet.fold").write_text(json.dumps(SQUARE), "utf-8")
    (outside / "credentials.toml").write_text(f'token = "{SECRET}"\n', "utf-8")
    try:
        (inside / "link.toml").symlink_to(outside / "credentials.toml")
        (inside / "linked").symlink_to(outside)
    except OSError:  # not every account of Windows may make links: there they are missing files, refused likewise
        pass
    monkeypatch.chdir(inside)
    monkeypatch.setenv("HOME", str(outside))
    return inside, outside


def refusal(opened, **values):
    with pytest.raises(InputError) as error:
        requested_design(DesignRequest.model_validate(values), opened)
    return str(error.value)


def naming(key, path):
    """Every way in which a page names a file."""
    if key == "based_on":
        yield {"files": [{"name": "a.toml", "text": f"based_on = {json.dumps(path)}"}]}
        yield {
            "files": [
                {"name": "a.toml", "text": 'based_on = "b.toml"'},
                {"name": "b.toml", "text": f"based_on = {json.dumps(path)}"},
            ]
        }
        return
    if key == "pattern.path":
        yield {"settings": {key: path}}
        yield {"settings": {"pattern": f'{{kind = "fold-file", path = {json.dumps(path)}}}'}}
        text = f'based_on = "miura-sheet"\n[pattern]\nkind = "fold-file"\npath = {json.dumps(path)}'
        yield {"files": [{"name": "a.toml", "text": text}]}
        return
    yield {"settings": {key: path}}
    yield {"settings": {"tendon": f"{{law = {json.dumps(path)}}}"}}
    yield {"settings": {"tendon.law.based_on": path}}
    yield {"settings": {"tendon.law": f"{{based_on = {json.dumps(path)}, branches = []}}"}}
    yield {"settings": {"tendon.law": path, "tendon.law.softening": "{r = 1.0}"}}
    text = f'based_on = "binder2025-joint"\n[tendon]\nlaw = {json.dumps(path)}'
    yield {"files": [{"name": "a.toml", "text": text}]}


ENDINGS = {"based_on": "toml", "tendon.law": "toml", "pattern.path": "fold"}


@pytest.mark.parametrize("key", ENDINGS)
@pytest.mark.parametrize("form", ["absolute", "upwards", "back and forth"])
def test_a_page_names_no_file_outside_and_does_not_learn_whether_it_exists(places, key, form):
    inside, outside = places
    opened = opened_with("binder2025-joint", {}, None)
    ending = ENDINGS[key]
    present, missing = f"{'sheet' if ending == 'fold' else 'credentials'}.{ending}", f"no-such-file.{ending}"
    # from the folder of files that were sent, more steps up than there are lead to the root
    folder = {
        "absolute": str(outside),
        "upwards": f"{'../' * 30}{outside.as_posix().lstrip('/')}",
        "back and forth": f"{inside.as_posix()}/../outside",
    }[form]
    for at_file, at_nothing in zip(naming(key, f"{folder}/{present}"), naming(key, f"{folder}/{missing}"), strict=True):
        output, of_nothing = refusal(opened, **at_file), refusal(opened, **at_nothing)
        assert REFUSED in output
        assert SECRET not in output
        assert output.replace(present, missing) == of_nothing


@pytest.mark.parametrize("path", ["link.toml", "linked/credentials.toml", "~/credentials.toml", "linked/../x.toml"])
@pytest.mark.usefixtures("places")
def test_no_link_and_no_home_leads_outside(path):
    opened = opened_with("binder2025-joint", {}, None)
    output = refusal(opened, settings={"tendon.law": path})
    assert SECRET not in output
    assert REFUSED in output or "no such file" in output
    assert "linked" not in path or REFUSED in output


def test_no_near_name_of_another_folder_is_offered(places, monkeypatch):
    inside, outside = places
    opened = opened_with(str(inside / "design.toml"), {}, None)
    monkeypatch.chdir(outside)
    output = refusal(opened, files=[{"name": "a.toml", "text": 'based_on = "credential"'}])
    assert "credentials" not in output


def test_a_page_names_what_lies_in_the_folder_of_its_design(places):
    inside, _ = places
    law = requested_design(DesignRequest(), opened_with("design.toml", {}, None))
    opened = opened_with("binder2025-joint", {}, None)
    for path in ("law.toml", str(inside / "law.toml"), "../inside/law.toml", "tpu-82a"):
        design = requested_design(DesignRequest(settings={"tendon.law": path, "tendon.area": law_area(law)}), opened)
        assert design.tendon.law.linear_modulus == law.tendon.law.linear_modulus
    sent = UploadedFile(name="a.toml", text=f"based_on = {json.dumps(str(inside / 'design.toml'))}")
    assert requested_design(DesignRequest(files=(sent,)), opened).hash == law.hash


def law_area(design):
    return f"{design.tendon.area:.17g} m^2"


def test_a_design_is_opened_with_what_it_names_elsewhere(places):
    """Its owner chose these files on the command line, or wrote them into the design."""
    inside, outside = places
    (inside / "far.toml").write_text('based_on = "../outside/design.toml"', "utf-8")
    opened = opened_with("far.toml", {}, None)
    assert requested_design(DesignRequest(), opened).hash == load_design("far.toml").hash
    assert REFUSED in refusal(opened, settings={"tendon.law": str(outside / "credentials.toml")})
    opened = opened_with("binder2025-joint", {"tendon.law": "../outside/law.toml", "tendon.area": "5 mm^2"}, None)
    provided = DesignRequest(settings=dict(opened.settings))
    assert requested_design(provided, opened).tendon.law is not None


def test_files_that_are_not_named_by_a_page_are_read_as_before(places):
    _, outside = places
    opened = opened_with("binder2025-joint", {}, None)
    refusal(opened, settings={"tendon.law": str(outside / "law.toml")})
    assert load_design(outside / "design.toml").tendon.law is not None

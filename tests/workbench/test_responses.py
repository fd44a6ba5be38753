"""Responses of a workbench about a design."""

import shlex

import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.design import load_design
from forficula.options import setting_texts
from forficula.workbench.requests import DesignRequest, Opened, UploadedFile
from forficula.workbench.responses import command_of, design_response, model_response, pattern_response

LETTER = Opened(design="letter-fold")


@given(
    st.dictionaries(st.sampled_from(["name", "tendon.stiffness", "protocol.stages"]), st.text(min_size=1), max_size=3)
)
def test_a_shell_reads_the_command_as_the_values_that_were_set(settings):
    kept = {key: text for key, text in settings.items() if text.isprintable()}
    words = shlex.split(command_of(DesignRequest(settings=kept), LETTER))
    assert words[:3] == ["forficula", "run", "letter-fold"]
    assert words[3::2] == ["--set"] * len(kept)
    assert setting_texts(words[4::2]) == {key: text.strip() for key, text in kept.items()}


@pytest.mark.parametrize(
    ("opened_request", "opened", "command"),
    [
        (DesignRequest(), Opened(design="my wing.toml"), "forficula run 'my wing.toml'"),
        (DesignRequest(), Opened(design="sheet.fold", unit=0.01), 'forficula run sheet.fold --unit "0.01 m"'),
        (DesignRequest(design="binder2025"), Opened(design="sheet.fold", unit=0.01), "forficula run binder2025"),
        (DesignRequest(files=(UploadedFile(name="-rf.toml", text=""),)), LETTER, "forficula run ./-rf.toml"),
        (DesignRequest(settings={"pattern.units": "2"}), LETTER, "forficula run letter-fold --set pattern.units=2"),
        (DesignRequest(settings={"a.b": "2 cm"}), LETTER, 'forficula run letter-fold --set a.b="2 cm"'),
    ],
)
def test_the_command_names_what_is_open(opened_request, opened, command):
    assert command_of(opened_request, opened) == command


def test_the_response_describes_the_design_and_its_sections():
    output = design_response(DesignRequest(), LETTER)
    assert output["hash"] == load_design("letter-fold").hash
    assert set(output["sections"]) == {key["key"].partition(".")[0] for key in output["keys"] if "." in key["key"]}
    assert all(output["sections"].values())


def test_a_structure_that_the_engine_in_pages_cannot_simulate_is_refused_with_the_reason():
    output = model_response(DesignRequest(design="bistable-miura"), LETTER)
    assert output["live"] == {"refused": "its creases are not joints, which engines before MuJoCo 4.0 do not support"}


def test_a_pattern_with_a_vertex_that_does_not_fold_flat_says_so():
    text = """{"file_spec": 1.2, "frame_unit": "cm", "vertices_coords": [[0, 0], [4, 0], [1.37, 3.76], [-4, 0],
        [1, -3]],
        "edges_vertices": [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [2, 3], [3, 4], [4, 1]],
        "edges_assignment": ["V", "M", "M", "M", "B", "B", "B", "B"]}"""
    requested = DesignRequest(files=(UploadedFile(name="odd.fold", text=text),))
    assert "1 of 1 interior vertices do not fold flat" in pattern_response(requested, LETTER)["said"]
    assert "do not fold flat" not in pattern_response(DesignRequest(), LETTER)["said"]

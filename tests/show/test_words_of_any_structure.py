"""Sentences name structures and transitions by their own words: no other structure is a wing that opens."""

from __future__ import annotations

from dataclasses import replace

import pytest
import xarray

import forficula as ff
from forficula.errors import InputError
from forficula.show.folder.static_map_folder import print_static_map
from forficula.show.landscape.landscape_figure import draw_fold_path
from forficula.show.page.parts.design_rows import design_rows
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.progress import run_progress
from forficula.show.study.maps_text import maps_text
from forficula.statics.tree.ensemble import ensemble_of
from forficula.structure import structure_of
from forficula.study.convergence.convergence import converge
from forficula.study.convergence.refinement import MESH, YOUNGS_MODULUS
from forficula.study.tables.outcome_kinds import whole_of


@pytest.fixture(scope="module")
def called(surveyed):
    """A landscape of a fan that is called a flower, and closes."""
    landscape = surveyed("reference")
    structure = landscape.structure
    words = ("closing", "blooming")
    return replace(
        landscape,
        structure=replace(
            structure,
            appearance=replace(structure.appearance, whole="flower", bar="petal"),
            transitions=tuple(
                replace(transition, wording=replace(transition.wording, doing=word))
                for transition, word in zip(structure.transitions, words, strict=True)
            ),
        ),
    )


def test_torques_along_the_fold_are_named_after_transitions(called):
    texts = [text.get_text() for axes in draw_fold_path(called).axes for text in axes.texts]
    assert any(text.startswith("closing requires") and text.endswith("on every petal") for text in texts)
    assert any(text.startswith("blooming requires") for text in texts)
    assert not any("folding" in text or "opening" in text for text in texts)


def test_an_unknown_state_is_refused_with_the_structure_s_noun(called):
    with pytest.raises(InputError, match="need a stable state of the flower"):
        called.barrier("flat", "nowhere")


def test_an_ensemble_s_error_uses_the_structure_s_noun():
    letters = [ff.load_design("letter-fold", {"pattern.width": width}) for width in ("20 cm", "21 cm")]
    with pytest.raises(InputError, match=r"need structures that differ in their tendons only, got another pattern"):
        ensemble_of(letters)


def test_a_study_table_stores_the_structure_s_noun():
    assert whole_of(xarray.Dataset(attrs={"whole": "flower"})) == "flower"
    assert maps_text("", ["a", "b"], [], [], whole="flower").startswith(
        "Map of the outcome of every flower over a and b"
    )


def test_a_static_map_counts_structures(capsys):
    table = xarray.Dataset({"outcome": ("a", ["closed", "stuck"])})
    print_static_map(table, "structure")
    assert "wing" not in capsys.readouterr().out


def test_the_first_structure_has_no_other_name(capsys):
    with run_progress() as progress:
        progress("settle", 0.1, 1.0)
    assert "wing" not in capsys.readouterr().err


@pytest.mark.parametrize(("key", "values"), [(YOUNGS_MODULUS, [1e5, 2e5]), (MESH, [1.0, 2.0])])
def test_a_design_without_a_membrane_has_none_to_vary(key, values):
    with pytest.raises(InputError, match=f"{key}: letter-fold has no membrane; need protocol.timestep to vary"):
        converge(ff.load_design("letter-fold"), key, values)


def test_too_many_plates_are_not_counted_by_veins():
    design = ff.load_design("letter-fold", {"pattern.panels": 1000})
    assert structure_of(design).appearance.bodies == ""
    assert structure_of(ff.load_design("binder2025")).appearance.bodies == "two for every vein"


def test_entries_of_a_list_have_the_numbers_that_they_name_or_their_place():
    fan = ff.load_design("binder2025", {"tendon": [{"vein": 0}, {"vein": 2, "stiffness": "20 N/cm"}]})
    rows = {f"{row.section}.{row.key}": row.value for row in design_rows(fan, fan)}
    assert rows["tendon.2.stiffness"] == "20 N/cm"
    assert "tendon.1.stiffness" not in rows
    letter = ff.load_design("letter-fold")
    assert {row.key for row in design_rows(letter, letter) if row.section == "tendon"} >= {"0.name", "1.name"}
    for design, headings in ((fan, ["Veins", "Guard tendons", "Hinges", "Tendons"]), (letter, ["Tendons"])):
        output = "".join(design_tables(design))
        assert all(f"{heading}: " in output for heading in headings)

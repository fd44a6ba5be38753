"""Designs made from FOLD files and drawings without a design file."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from forficula.design import design_from_text, design_text, load_design
from forficula.errors import InputError
from forficula.pattern import read_pattern, write_fold
from forficula.structure import structure_of

FILES = Path(__file__).parents[1] / "pattern" / "fold"


@pytest.mark.parametrize("name", ["diagonal-cp", "simple", "squareBase"])
def test_a_file_of_others_is_a_design(name):
    design = load_design(FILES / f"{name}.fold", unit=0.05)
    structure = structure_of(design)
    assert design.name == name
    sheet, _ = read_pattern(FILES / f"{name}.fold", 0.05)
    assert np.array_equal(design.sheet.vertices_coords, sheet.vertices_coords)
    assert len(structure.bodies) == len(sheet.vertices_coords)
    assert [(stage.drive, stage.until) for stage in design.protocol.stages] == [("fold", "target")]
    again = design_from_text(design_text(design))
    assert again.hash == design.hash
    assert np.array_equal(again.sheet.edges_fold_angle, sheet.edges_fold_angle, equal_nan=True)


def test_creases_fold_to_the_angles_of_the_file(tmp_path):
    sheet = load_design("miura-sheet").sheet
    angles = sheet.edges_fold_angle / 3
    write_fold(type(sheet)(**{**vars(sheet), "edges_fold_angle": angles}), tmp_path / "third.fold")
    structure = structure_of(load_design(tmp_path / "third.fold"))
    (motor,), (drive,) = structure.motors, structure.drives
    ends = [
        structure.hinges[hinge].start + gain * drive.strength
        for hinge, gain in zip(motor.hinges, motor.gains, strict=True)
    ]
    assert ends == pytest.approx([np.pi / 3] * 24)


def test_settings_hold_for_a_file_too():
    design = load_design(FILES / "simple.fold", {"facet.thickness": "1 mm"}, unit=0.05)
    assert design.facet.thickness == 1e-3
    assert not any(choice.key == "thickness" for choice in design.chosen)


@pytest.mark.parametrize(
    ("name", "unit", "message"),
    [
        ("none.fold", 0.05, "no such file"),
        ("miura-sheet", 0.05, "unit: a design already has units, got 0.05 m"),
    ],
)
def test_a_missing_file_or_unit_is_refused(name, unit, message):
    path = FILES / name if name.endswith(".fold") else name
    with pytest.raises(InputError, match=message):
        load_design(path, unit=unit)


def test_the_largest_dimension_of_a_file_without_a_unit_is_20_cm():
    with pytest.warns(UserWarning, match=r"simple.fold: the file states no unit .* 20 cm \[chosen\]; .* --unit"):
        design = load_design(FILES / "simple.fold")
    assert np.ptp(design.sheet.vertices_coords, axis=0).max() == pytest.approx(0.2)
    assert "[chosen] its largest dimension is 20 cm" in design.source


DESIGN = """
source = "from a test"
based_on = "letter-fold"
tendon = []
[pattern]
kind = "fold-file"
path = "diagonal-cp.fold"
"""


@pytest.fixture
def named_file(tmp_path):
    """Return the path of a design file that names a FOLD file without a unit."""
    shutil.copy(FILES / "diagonal-cp.fold", tmp_path)
    (tmp_path / "mine.toml").write_text(DESIGN)
    return tmp_path / "mine.toml"


def test_a_design_file_may_name_a_file_without_a_unit_as_the_command_line_may(named_file):
    with pytest.warns(UserWarning, match=r'cp.fold: the file states no unit .* \[chosen\]; .* pattern.unit = "1 cm"'):
        design = load_design(named_file)
    with pytest.warns(UserWarning, match="--unit"):
        alone = load_design(named_file.parent / "diagonal-cp.fold")
    assert np.array_equal(design.sheet.vertices_coords, alone.sheet.vertices_coords)
    assert design.source == "from a test; [chosen] its largest dimension is 20 cm, because it states no unit of length"


def test_the_unit_of_a_design_file_is_beside_its_path(named_file):
    named_file.write_text(DESIGN + 'unit = "5 cm"\n')
    assert np.ptp(load_design(named_file).sheet.vertices_coords) == pytest.approx(0.05)
    with pytest.raises(InputError, match=r"pattern.unit: needs pattern.path beside it"):
        load_design(named_file, {"pattern.unit": "1 cm"})

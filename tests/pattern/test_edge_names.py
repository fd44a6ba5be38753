import pytest

from forficula.pattern.files.edge_names import letter_of_name


@pytest.mark.parametrize(
    ("name", "letter"),
    [
        ("M", "M"),
        (" v ", "V"),
        ("Mountain folds", "M"),
        ("layer_valley_2", "V"),
        ("CutLine", "C"),
        ("BOUNDARY", "B"),
        ("auxiliary", "F"),
        ("J", "F"),
        ("unassigned", "U"),
        ("0", None),
        ("Layer 1", None),
        ("mountain and valley", None),
        ("", None),
        ("X", None),
    ],
)
def test_letters_and_words_of_origami_programs_are_understood(name, letter):
    assert letter_of_name(name) == letter

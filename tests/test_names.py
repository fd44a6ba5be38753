import pytest

from forficula.names import ordinal


@pytest.mark.parametrize(
    ("number", "word"), [(0, "first"), (9, "tenth"), (10, "11th"), (20, "21st"), (21, "22nd"), (112, "113th")]
)
def test_numbers_from_0_are_told_as_people_count(number, word):
    assert ordinal(number) == word

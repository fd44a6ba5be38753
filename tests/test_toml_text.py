import pytest

from forficula.errors import InputError
from forficula.toml_text import parse_toml


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("a = 1\nb = 2\na = 3\n", "(at line 3, column 6); the key a is given twice"),
        ('"x.y" = 1\n"x.y" = [\n1,\n]\n', '(at line 4, column 2); the key "x.y" is given twice'),
        ("[t]\na.b = 1\na.b = 2\n", "(at line 3, column 8); the key a.b is given twice"),
        ("[t.u]\na = 1\n[t.u]\n", "(at line 3, column 5); the table [t.u] is given twice"),
        ("[t]\na = 1\n[[t]] # one\n", "[t] and [[t]] in one file (at line 3): use one of the two"),
        ("[[t]]\na = 1\n[ t ]\n", "[t] and [[t]] in one file (at line 3): use one of the two"),
        ("[t.u]\na = 1\n[[t]]\n", "[t.u] and [[t]] in one file (at line 3): use one of the two"),
        ("t = []\na = 1\n[[t]]\n", "(at line 3, column 4); the key t is given twice"),
        ("t = 3\na = 1\n[[t]]\n", "(at line 3, column 4); the key t is given twice"),
        ("a = {b = 1, b = 2}\n", "Duplicate inline table key 'b' (at line 1, column 18)"),
    ],
)
def test_a_repeated_key_is_reported_with_its_line(text, end):
    with pytest.raises(InputError) as caught:
        parse_toml(text, "a design")
    assert str(caught.value).startswith("not TOML: ")
    assert str(caught.value).endswith(end)


def test_a_whole_number_of_thousands_of_digits_is_refused():
    with pytest.raises(InputError) as caught:
        parse_toml(f"a = 1{'0' * 5000}", "a study")
    assert str(caught.value) == "not TOML: a whole number has too many digits"

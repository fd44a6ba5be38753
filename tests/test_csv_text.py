import csv
import io

from hypothesis import given
from hypothesis import strategies as st

from forficula.csv_text import csv_text

CELLS = st.one_of(st.text(), st.floats(allow_nan=False), st.integers(), st.booleans())


@given(st.lists(CELLS, min_size=1))
def test_no_cell_is_a_formula_and_every_number_stays_one(cells):
    if cells == [""]:
        return
    (row,) = csv.reader(io.StringIO(csv_text([cells]), newline=""))
    for given_cell, written in zip(cells, row, strict=True):
        if isinstance(given_cell, str):
            assert written in (given_cell, f"'{given_cell}")
            assert not written.startswith(("=", "@", "\t", "\r"))
            assert not written.startswith(("+", "-")) or isinstance(float(written), float)
        else:
            assert written == str(given_cell)


def test_numbers_that_are_text_stay_numbers():
    assert csv_text([["-5.5e-3", "+1", "-5 deg", "=1+1", "a=1"]]) == "-5.5e-3,+1,'-5 deg,'=1+1,a=1\n"

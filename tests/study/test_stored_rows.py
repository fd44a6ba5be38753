"""Rows on disk are found by key, whatever number of them is in memory."""

import sys

import pytest

import forficula as ff
from forficula.errors import InputError
from forficula.study.running.journal import open_journal, stored_rows

DESIGN = ff.load_design("binder2025")
MODULE = sys.modules["forficula.study.running.stored_rows"]


@pytest.fixture(params=[(10_000, 65_536), (1, 2)])
def limits(request, monkeypatch):
    in_memory, added = request.param
    monkeypatch.setattr(MODULE, "_MOST_IN_MEMORY", in_memory)
    monkeypatch.setattr(MODULE, "_MOST_ADDED", added)


def row(number, status="folded"):
    # some rows are longer than a piece that is read at once
    return {"key": f"5-{number}", "status": status * (1 + 2000 * (number % 3 == 2)), "fold_time_s": number / 7}


@pytest.mark.usefixtures("limits")
def test_rows_of_files_and_appended_rows_are_read_back(tmp_path):
    with open_journal(tmp_path, DESIGN, (1, 2)) as journal:
        for number in range(5):
            journal.append(row(number))
    rows = stored_rows(tmp_path, DESIGN)
    with open_journal(tmp_path, DESIGN, (2, 2)) as journal:
        for number in range(5, 12):
            rows.add(row(number), journal.path, journal.append(row(number)))
            assert rows["5-1"] == row(1)
            assert f"5-{number}" in rows
            assert f"5-{number + 1}" not in rows
    assert rows == {f"5-{number}": row(number) for number in range(12)}
    assert len(rows) == 12
    assert dict(stored_rows(tmp_path, DESIGN)) == dict(rows)
    with pytest.raises(KeyError):
        rows["5-12"]


@pytest.mark.usefixtures("limits")
def test_the_last_of_several_rows_with_a_key_counts(tmp_path):
    for shard in (1, 2):
        with open_journal(tmp_path, DESIGN, (shard, 2)) as journal:
            for number in range(3):
                journal.append(row(number, status=f"shard {shard}"))
    rows = stored_rows(tmp_path, DESIGN)
    assert rows == {f"5-{number}": row(number, status="shard 2") for number in range(3)}
    with open_journal(tmp_path, DESIGN, (1, 2)) as journal:
        rows.add(row(1), journal.path, journal.append(row(1)))
    assert rows["5-1"] == row(1)
    assert len(rows) == 3


@pytest.mark.usefixtures("limits")
def test_a_file_that_changes_while_it_is_read_is_one_clear_error(tmp_path):
    with open_journal(tmp_path, DESIGN, (1, 1)) as journal:
        journal.append(row(0))
    rows = stored_rows(tmp_path, DESIGN)
    (tmp_path / "journal.jsonl").write_text("")
    with pytest.raises(InputError, match=r"journal\.jsonl: has changed while it was read"):
        rows["5-0"]

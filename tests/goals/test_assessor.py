"""Rows of designs are computed once and do not depend on the process that computes them."""

import json
import threading

import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.goals import assessor as assessor_module
from forficula.goals.assessor import open_assessor, value_of
from forficula.goals.outcome_quantity import quantity_of
from forficula.study.files.search_file import read_search

JOINT, LETTER = load_design("binder2025-joint"), load_design("letter-fold")
STIFFER = [JOINT.with_values({"tendon.area": f"{area} mm^2"}) for area in (4, 5, 6)]


def test_rows_are_in_the_order_of_designs_and_existing_ones_are_read(tmp_path):
    with open_assessor(tmp_path, JOINT) as assess:
        first = assess(
            STIFFER, ["hinges", "run"], points=[{"tendon.area": design.tendons[0].area} for design in STIFFER]
        )
        assert assess.done == 6
    with open_assessor(tmp_path, JOINT) as assess:
        assert assess(STIFFER[::-1], ["hinges", "run"]) == first[::-1]
        assert assess.done == 0
    held = quantity_of(JOINT, "hinge_holding_torque")
    torques = [value_of(row, held, design) for row, design in zip(first, STIFFER, strict=True)]
    assert torques == pytest.approx([torques[1] * share for share in (0.8, 1, 1.2)])
    _, *rows = [json.loads(line) for line in (tmp_path / "journal.jsonl").read_text().splitlines() if line]
    assert all(row["values"].keys() == {"tendon.area"} for row in rows)


def test_a_design_that_cannot_be_built_has_a_row_with_the_reason(tmp_path):
    with open_assessor(tmp_path, JOINT) as assess:
        (row,) = assess(["bars of no length"], ["run"])
    assert (row["verdict"], row["status"]) == ("not built", "cannot be built: bars of no length")


def test_least_torques_are_those_of_a_search(tmp_path):
    provided = {"close_torques": ["0.1 N cm", "3 N cm"], "open_torques": []}
    with open_assessor(tmp_path, LETTER) as assess:
        (row,) = assess([LETTER], ["search"], search=read_search("least-torques", provided, LETTER))
    assert value_of(row, quantity_of(LETTER, "least_close_value"), LETTER) == pytest.approx(0.03)


def test_whole_records_give_package_sizes(tmp_path):
    with open_assessor(tmp_path, LETTER) as assess:
        (row,) = assess([LETTER], ["run", "record"])
    assert 0 < value_of(row, quantity_of(LETTER, "package_area"), LETTER) < 1
    assert row["outcome"] == "closed and opened"


def test_shards_share_the_work_and_get_the_same_result(tmp_path):
    with open_assessor(tmp_path / "one", JOINT) as assess:
        alone = assess(STIFFER, ["hinges"])
    rows, done = {}, {}

    def work(number):
        with open_assessor(tmp_path / "both", JOINT, shard=(number, 2)) as assess:
            rows[number] = assess(STIFFER, ["hinges"])
            done[number] = len((tmp_path / "both" / f"journal-{number}-of-2.jsonl").read_text().split("\n")) - 2

    threads = [threading.Thread(target=work, args=(number,)) for number in (1, 2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert rows[1] == rows[2] == alone
    assert done == {1: 2, 2: 1}


def test_rows_of_a_missing_shard_are_computed_by_the_others(tmp_path, monkeypatch):
    monkeypatch.setattr(assessor_module, "_PATIENCE_SECONDS", 0.2)
    monkeypatch.setattr(assessor_module, "_LOOK_SECONDS", 0.05)
    with open_assessor(tmp_path, JOINT, shard=(2, 2)) as assess:
        assert len(assess(STIFFER, ["hinges"])) == 3


@pytest.mark.parametrize(("shard", "threads"), [((0, 1), 0), ((3, 2), 0), ((1, 1), -1)])
def test_an_invalid_shard_is_rejected(tmp_path, shard, threads):
    with pytest.raises(InputError), open_assessor(tmp_path, JOINT, shard=shard, threads=threads):
        pass

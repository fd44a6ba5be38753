"""Comparison of a design with its made parts, and the changes that prevent folding."""

import json

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from forficula.design import load_design
from forficula.errors import InputError
from forficula.make.make_parts import make_parts
from forficula.serial import json_text
from forficula.show.make.made_figure import draw_made
from forficula.show.make.made_table import made_lines
from forficula.study.made_comparison import made_comparison


@pytest.fixture(scope="module")
def compared():
    # folds as designed; with pegs on the bars, 3 mm away from the hinges, its barrier is ten times as high
    values = {"tendon.rest_length": "5 cm", "make.anchors": "on the bars"}
    return made_comparison(make_parts(load_design("binder2025").with_values(values), "joint"), simulate=True)


def test_offsets_make_the_barrier_higher(compared):
    (pair, *_) = compared.hinges
    assert pair.name == "fold0"
    assert pair.made.barrier > 5 * pair.designed.barrier
    assert pair.made.holding_torque > 2 * pair.designed.holding_torque


def test_offsets_are_reported_as_the_cause_of_a_lost_state(compared):
    assert compared.as_designed.holds("folded")
    assert compared.as_made.holds("folded") is False
    (blame, *_) = compared.blame
    assert (blame.state, blame.alone, blame.mends) == ("folded", ("offsets",), ("offsets",))
    assert blame.text == (
        'the design reaches "folded" as designed, but not as made: the offsets as made would alone prevent this, and it'
        " is reached again with the offsets as designed."
    )


def test_every_change_is_tried_alone_and_undone(compared):
    groups = compared.groups
    assert set(groups) == {"offsets", "stiffness", "masses"}
    tried = {trial.groups for trial in compared.trials}
    assert tried == {(), groups, *((group,) for group in groups), *(
        tuple(item for item in groups if item != group) for group in groups
    )}  # fmt: skip


def test_comparison_is_printed_drawn_and_saved(compared):
    output = "\n".join(made_lines(compared))
    assert "tendon.proximal_offset: 0 cm as designed, 0.3 cm as made" in output
    assert compared.blame[0].text in output
    written = json.loads(json_text(compared))
    assert written["hinges"][0]["made"]["barrier_J"] == compared.hinges[0].made.barrier
    assert {item["name"] for item in written["unkept"]} >= {"mass", "barrier of two straps", "play of the hinges"}
    figure = draw_made(compared)
    energy, _, barriers, *_ = figure.axes
    # the barriers are enlarged in a panel of their own, over no data
    FigureCanvasAgg(figure).draw()
    assert barriers.get_ylabel().startswith("energy above the stop (")
    assert not any(barriers.get_window_extent().overlaps(axes.get_window_extent()) for axes in figure.axes[:2])
    assert not any(axes.child_axes for axes in figure.axes)
    labels = [line.get_label() for line in energy.lines]
    assert any(label.startswith("as made: barrier") for label in labels)
    with pytest.raises(InputError, match='hinge: need "fold0", "fold1" or "fold2", got "fold9"'):
        draw_made(compared, hinge="fold9")


def test_nothing_is_run_without_simulation():
    compared = made_comparison(make_parts("binder2025-joint"))
    assert (compared.trials, compared.blame) == ((), ())
    assert compared.as_made is None
    assert compared.made.name == "binder2025-joint-as-made"

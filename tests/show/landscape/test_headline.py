"""The first line of a landscape."""

from forficula.design import load_design
from forficula.show.landscape.headline import headline
from forficula.statics import energy_landscape


def test_states_that_a_free_hinge_connects_count_as_one():
    free = load_design("two-clasps", {"joint.mount.kind": "hinge"})
    text = headline(energy_landscape(free))
    assert text.startswith("two-clasps: monostable (closed); it moves without force from closed to ")
    assert "barrier 0 J" not in text

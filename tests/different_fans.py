"""Random fans whose veins differ, for properties that hold for every fan."""

import math

from hypothesis import assume
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import EarwigFan


@st.composite
def different_fans(draw):
    units, spread = draw(st.integers(1, 4)), draw(st.floats(0, 0.12))

    def shares(count):
        return tuple(draw(st.lists(st.floats(1 - spread, 1 + spread), min_size=count, max_size=count)))

    length = draw(st.floats(0.001, 1))
    try:
        return EarwigFan(
            proximal_length=length,
            distal_length=length * draw(st.floats(0.2, 1.2)),
            hub_radius=length * draw(st.floats(0.1, 0.6)),
            sector_angle=math.radians(draw(st.floats(10, 40))),
            units=units,
            tangent=draw(st.sampled_from(["left", "right"])),
            proximal_shares=shares(2 * units + 1),
            distal_shares=shares(2 * units + 1),
            sector_shares=shares(2 * units),
        )
    except InputError:
        # veins that differ too much for one fan
        assume(False)

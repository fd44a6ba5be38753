import pytest

from forficula.design import load_design
from forficula.make.make_parts import make_parts

# a wing whose joints can be made: pegs on the bars that do not collide in the folded state
MADE = {
    "make.anchors": "on the bars",
    "tendon.proximal_attachment": "5.85 cm",
    "tendon.distal_attachment": "5.15 cm",
}


@pytest.fixture(scope="session")
def made_joint():
    return make_parts(load_design("binder2025").with_values(MADE), "joint")


@pytest.fixture(scope="session")
def made_section():
    return make_parts(load_design("binder2025").with_values(MADE), "section")


@pytest.fixture(scope="session")
def joint_of():
    def make(**values):
        return make_parts(load_design("binder2025").with_values(MADE | values), "joint")

    return make

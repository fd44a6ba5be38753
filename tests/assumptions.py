"""A flap on an overdamped hinge, whose times are known in closed form, and assumptions of it that nothing has run."""

from dataclasses import replace

import forficula as ff
from forficula.analysis import Verdict
from forficula.study.assumptions.assumptions import AssumptionRun, Assumptions, Effect, TransitionName

# two panels, the first of them held; nothing but damping resists the torque
FLAP = {
    "name": "flap",
    "pattern.panels": 2,
    "crease.stiffness": 0.0,
    "crease.damping": 0.3,  # N m s/rad/m, of a crease of 21 cm
    "crease.start": 0.0,
    "tendon": [],
    "support": [{"of": "facet 0"}],
    "drive": [{"name": "close", "kind": "torque", "of": "creases", "value": "30 N cm"}],
    "measure": [],
    "protocol.stages": [
        {"name": "close", "drive": "close", "until": "creases > 60 deg", "state": "closed", "time_limit": "1 s"}
    ],
}


def flap(values=None):
    """The flap with some values replaced."""
    return ff.load_design("letter-fold").with_values(FLAP).with_values(values or {})


_OWN = AssumptionRun(
    name="as designed",
    label="as designed",
    meaning="The design itself.",
    timestep=2e-4,
    verdict=Verdict.REACHED,
    goal="close",
    word="closed",
    status="closed",
    times={"close": 0.2206},
    works={"close": 0.3929},
)
_SLOW = {"name": "slow rise", "label": "drives rise over 0.2 s", "meaning": "Drives come at once; or they rise."}
_LATE = {"verdict": Verdict.MOVING, "word": "still closing", "status": "still closing at 50 deg", "timestep": 1e-4}
ASSUMED = Assumptions(
    design=flap(),
    transitions=(TransitionName(name="close", time="time to close", noun="closing"),),
    own=_OWN,
    runs=(
        replace(_OWN, **_SLOW, times={"close": 0.3206}, effect=Effect.NUMBERS),
        replace(
            _OWN,
            name="twice hinge damping",
            label="twice the damping of hinges",
            **_LATE,
            times={"close": None},
            effect=Effect.VERDICT,
        ),
    ),
    left_out={"gravity": "the axis of the hinge is upright"},
    uncertainty={"close.time": 0.01, "close.work": 0.001},
    versions={"forficula": ff.__version__},
)

from forficula.statics.hinge import (
    PeakTorque,
    TendonHinge,
    holding_torque,
    ideal_hinge,
    peak_opening_torque,
    slack_angle,
    tendon_hinges,
    top_barrier,
)
from forficula.statics.hinge_landscape import (
    HingeLandscape,
    HingeState,
    hinge_landscape,
    hinge_remarks,
    hinge_states,
)
from forficula.statics.landscape import EnergyLandscape, Rest, StableState, barrier, energy_landscape, stable_states
from forficula.statics.landscape_summary import landscape_summary
from forficula.statics.snap import final_speed, fold_time, growth_rate, time_scale

__all__ = [
    "EnergyLandscape",
    "HingeLandscape",
    "HingeState",
    "PeakTorque",
    "Rest",
    "StableState",
    "TendonHinge",
    "barrier",
    "energy_landscape",
    "final_speed",
    "fold_time",
    "growth_rate",
    "hinge_landscape",
    "hinge_remarks",
    "hinge_states",
    "holding_torque",
    "ideal_hinge",
    "landscape_summary",
    "peak_opening_torque",
    "slack_angle",
    "stable_states",
    "tendon_hinges",
    "time_scale",
    "top_barrier",
]

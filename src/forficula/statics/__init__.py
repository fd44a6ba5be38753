from forficula.statics.fold_path import FoldPath, StableState
from forficula.statics.hinge import (
    PeakTorque,
    TendonHinge,
    folding_sense,
    holding_torque,
    ideal_hinges,
    peak_opening_torque,
    slack_angle,
    tendon_hinge,
    tendon_hinges,
    top_barrier,
)
from forficula.statics.hinge_landscape import (
    HingeLandscape,
    HingeSpring,
    HingeState,
    hinge_landscape,
    hinge_remarks,
    hinge_states,
)
from forficula.statics.landscape import EnergyLandscape, Rest, barrier, stable_states
from forficula.statics.landscape_summary import landscape_summary
from forficula.statics.partial_folds import PartialFold, folding_hinges
from forficula.statics.snap import final_speed, fold_time, growth_rate, time_scale
from forficula.statics.survey import energy_landscape

__all__ = [
    "EnergyLandscape",
    "FoldPath",
    "HingeLandscape",
    "HingeSpring",
    "HingeState",
    "PartialFold",
    "PeakTorque",
    "Rest",
    "StableState",
    "TendonHinge",
    "barrier",
    "energy_landscape",
    "final_speed",
    "fold_time",
    "folding_hinges",
    "folding_sense",
    "growth_rate",
    "hinge_landscape",
    "hinge_remarks",
    "hinge_states",
    "holding_torque",
    "ideal_hinges",
    "landscape_summary",
    "peak_opening_torque",
    "slack_angle",
    "stable_states",
    "tendon_hinge",
    "tendon_hinges",
    "time_scale",
    "top_barrier",
]

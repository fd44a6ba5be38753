from forficula.statics.drag import DraggedPoint, DraggedShape
from forficula.statics.landscape import EnergyLandscape, Rest, barrier, stable_states
from forficula.statics.landscape_summary import landscape_summary
from forficula.statics.quasi_static_path import PathMark, QuasiStaticPath, QuasiStaticPoint
from forficula.statics.survey import energy_landscape, quasi_static_path, start_drag
from forficula.statics.tree.fold_path import FoldPath, StableState
from forficula.statics.tree.hinge import (
    TendonHinge,
    folding_sense,
    ideal_hinges,
    slack_angle,
    tendon_hinge,
    tendon_hinges,
)
from forficula.statics.tree.hinge_landscape import (
    CrossedHinge,
    HingeLandscape,
    HingeSpring,
    HingeState,
    PeakTorque,
    crossed_hinges,
    hinge_landscape,
)
from forficula.statics.tree.hinge_remarks import hinge_remarks
from forficula.statics.tree.partial_folds import PartialFold, folding_hinges
from forficula.statics.tree.snap import final_speed, fold_time, time_scale

__all__ = [
    "CrossedHinge",
    "DraggedPoint",
    "DraggedShape",
    "EnergyLandscape",
    "FoldPath",
    "HingeLandscape",
    "HingeSpring",
    "HingeState",
    "PartialFold",
    "PathMark",
    "PeakTorque",
    "QuasiStaticPath",
    "QuasiStaticPoint",
    "Rest",
    "StableState",
    "TendonHinge",
    "barrier",
    "crossed_hinges",
    "energy_landscape",
    "final_speed",
    "fold_time",
    "folding_hinges",
    "folding_sense",
    "hinge_landscape",
    "hinge_remarks",
    "ideal_hinges",
    "landscape_summary",
    "quasi_static_path",
    "slack_angle",
    "stable_states",
    "start_drag",
    "tendon_hinge",
    "tendon_hinges",
    "time_scale",
]

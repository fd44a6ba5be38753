from forficula.statics.net.collapse import Collapse, collapse, holding_torque, state_after_collapse
from forficula.statics.net.energy import Expansion, built_shape, expand, shape_at
from forficula.statics.net.load import (
    Load,
    acceleration,
    crease_torques,
    held_displacements,
    no_load,
    point_forces,
    pressure,
)
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import NetRest, minimum, stationary
from forficula.statics.net.modes import Modes, natural_modes
from forficula.statics.net.net import Net, NetCreases, NetShape, Springs, Tendons, Triangles
from forficula.statics.net.net_state import Strength, strength
from forficula.statics.net.path_events import PathEvent
from forficula.statics.net.path_increment import PathPoint
from forficula.statics.net.rigidity import NetRigidity, rigidity, rigidity_matrix
from forficula.statics.net.saddle import Saddle, find_saddle
from forficula.statics.net.stable_states import StableStates, find_stable_states, same_shape
from forficula.statics.net.supports import loose_motions, supported

__all__ = [
    "Collapse",
    "Expansion",
    "Load",
    "LoadPath",
    "Modes",
    "Net",
    "NetCreases",
    "NetRest",
    "NetRigidity",
    "NetShape",
    "PathEvent",
    "PathPoint",
    "Saddle",
    "Springs",
    "StableStates",
    "Strength",
    "Tendons",
    "Triangles",
    "acceleration",
    "built_shape",
    "collapse",
    "crease_torques",
    "expand",
    "find_saddle",
    "find_stable_states",
    "held_displacements",
    "holding_torque",
    "load_path",
    "loose_motions",
    "minimum",
    "natural_modes",
    "no_load",
    "point_forces",
    "pressure",
    "rigidity",
    "rigidity_matrix",
    "same_shape",
    "shape_at",
    "state_after_collapse",
    "stationary",
    "strength",
    "supported",
]

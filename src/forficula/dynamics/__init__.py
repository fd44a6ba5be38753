from forficula.dynamics.model import WingModel, compile_wing
from forficula.dynamics.record import Record, StageEnd, load_record, save_record, versions
from forficula.dynamics.simulate import run, simulate
from forficula.dynamics.timestep import stable_timestep, timestep_warnings, with_timestep

__all__ = [
    "Record",
    "StageEnd",
    "WingModel",
    "compile_wing",
    "load_record",
    "run",
    "save_record",
    "simulate",
    "stable_timestep",
    "timestep_warnings",
    "versions",
    "with_timestep",
]

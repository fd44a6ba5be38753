from forficula.dynamics.energy_balance import EnergyBalance, energy_balance
from forficula.dynamics.model import Model, compile_model, compile_structure
from forficula.dynamics.record import Record, StageEnd, as_record, load_record, save_record, versions
from forficula.dynamics.sharing import but_last_drive
from forficula.dynamics.simulate import simulate, simulate_each
from forficula.dynamics.timestep import stable_timestep, timestep_warnings, with_timestep
from forficula.dynamics.units import design_in_model_units

__all__ = [
    "EnergyBalance",
    "Model",
    "Record",
    "StageEnd",
    "as_record",
    "but_last_drive",
    "compile_model",
    "compile_structure",
    "design_in_model_units",
    "energy_balance",
    "load_record",
    "save_record",
    "simulate",
    "simulate_each",
    "stable_timestep",
    "timestep_warnings",
    "versions",
    "with_timestep",
]

from forficula.dynamics.energies.energy_balance import EnergyBalance, energy_balance
from forficula.dynamics.engine.contact_geometry import SLIGHT_OVERLAP, resolving_time_constant
from forficula.dynamics.engine.knobs import Knob, knobs_of
from forficula.dynamics.engine.model import Model, compile_model, compile_structure
from forficula.dynamics.engine.portable_model import portable_model, why_not_portable
from forficula.dynamics.engine.trials import TrialChains, design_trial, tried_transition
from forficula.dynamics.engine.units import design_in_model_units
from forficula.dynamics.gpu.device import batch_key, check_available, check_device
from forficula.dynamics.record import AnyRun, ContactRun, NumericalCheck, Record, StageEnd
from forficula.dynamics.record_file import as_record, load_record, save_record, versions
from forficula.dynamics.stepping.simulate import simulate, simulate_each
from forficula.dynamics.stepping.stage_plan import goal_in_units
from forficula.dynamics.stepping.stepped_protocol import SteppedProtocol, stepped_protocol
from forficula.dynamics.stepping.timestep import (
    STEPS_TO_CONTACT,
    STEPS_TO_TIME_CONSTANT,
    contact_timestep,
    stable_timestep,
    timestep_warnings,
    with_timestep,
)

__all__ = [
    "SLIGHT_OVERLAP",
    "STEPS_TO_CONTACT",
    "STEPS_TO_TIME_CONSTANT",
    "AnyRun",
    "ContactRun",
    "EnergyBalance",
    "Knob",
    "Model",
    "NumericalCheck",
    "Record",
    "StageEnd",
    "SteppedProtocol",
    "TrialChains",
    "as_record",
    "batch_key",
    "check_available",
    "check_device",
    "compile_model",
    "compile_structure",
    "contact_timestep",
    "design_in_model_units",
    "design_trial",
    "energy_balance",
    "goal_in_units",
    "knobs_of",
    "load_record",
    "portable_model",
    "resolving_time_constant",
    "save_record",
    "simulate",
    "simulate_each",
    "stable_timestep",
    "stepped_protocol",
    "timestep_warnings",
    "tried_transition",
    "versions",
    "why_not_portable",
    "with_timestep",
]

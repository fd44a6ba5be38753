from forficula.analysis.outcome import EnergyBalance, Outcome, State, Transition, measure
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.summary import summary

__all__ = ["EnergyBalance", "Outcome", "State", "Transition", "measure", "run_warnings", "summary"]

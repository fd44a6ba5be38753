from forficula.analysis.outcome import EnergyBalance, Outcome, State, Transition, measure, summary

__all__ = ["EnergyBalance", "Outcome", "State", "Transition", "measure", "summary"]

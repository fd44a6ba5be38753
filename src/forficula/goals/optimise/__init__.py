from forficula.goals.optimise.optimise import SoFar, optimise_goal
from forficula.goals.optimise.optimum import Optimum

__all__ = ["Optimum", "SoFar", "optimise_goal"]

from forficula.goals.tolerance.assess_tolerance import assess_tolerance, estimate_tolerance
from forficula.goals.tolerance.question import Question
from forficula.goals.tolerance.tolerance import Tolerance

__all__ = ["Question", "Tolerance", "assess_tolerance", "estimate_tolerance"]

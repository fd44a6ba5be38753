from forficula.reproduction.comparison import Comparison, check_reproduction, compare, named_reproduction
from forficula.reproduction.reproduction import Claim, Reproduction
from forficula.reproduction.shown_parts import shown_hinge, shown_tendon

__all__ = [
    "Claim",
    "Comparison",
    "Reproduction",
    "check_reproduction",
    "compare",
    "named_reproduction",
    "shown_hinge",
    "shown_tendon",
]

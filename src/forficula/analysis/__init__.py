from forficula.analysis.outcome import Outcome, State, Transition, measure
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.summary import summary
from forficula.analysis.verdict import FOLDED, OPENED, Ending, Verdict, ending_text, ending_word

__all__ = [
    "FOLDED",
    "OPENED",
    "Ending",
    "Outcome",
    "State",
    "Transition",
    "Verdict",
    "ending_text",
    "ending_word",
    "measure",
    "run_warnings",
    "summary",
]

from forficula.analysis.outcome import Outcome, StageOutcome, measure
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.states import SPRUNG, Reading, State
from forficula.analysis.summary import summary
from forficula.analysis.transition_runs import TransitionOutcome
from forficula.analysis.verdict import FORMER_WORDS, Ending, Verdict, ending_text, ending_word, verdict_word

__all__ = [
    "FORMER_WORDS",
    "SPRUNG",
    "Ending",
    "Outcome",
    "Reading",
    "StageOutcome",
    "State",
    "TransitionOutcome",
    "Verdict",
    "ending_text",
    "ending_word",
    "measure",
    "run_warnings",
    "summary",
    "verdict_word",
]

from forficula.analysis.outcome import SPRUNG, Outcome, Reading, StageOutcome, State, TransitionOutcome, measure
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.summary import summary
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

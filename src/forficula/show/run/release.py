"""Motion on a release that does not end in a named state, as numbers: no claim is made that a state was held."""

from __future__ import annotations

import math

from forficula.analysis import Outcome, TransitionOutcome
from forficula.quantities import show_value
from forficula.structure import Structure, Transition, measure_of


def release_text(structure: Structure, transition: Transition, result: TransitionOutcome) -> str:
    """Return a clause such as "went from 116.2 deg to 15.3 deg when released (smallest of creases)"; else empty."""
    if result.sprung_back is None:
        return ""
    measure = measure_of(structure, transition.measure)
    title = transition.measure if measure is None else measure.label or measure.name
    one = measure is not None and len(measure.parts) == 1
    furthest = "largest" if transition.furthest == "largest" else "smallest"
    what = title if one or transition.kind == "distance" else f"{furthest} of {title}"
    before, after = (_reading(value, transition.kind) for value in result.sprung_back)
    return f"went from {before} to {after} when released ({what})"


def release_sentences(outcome: Outcome) -> list[str]:
    """Return a sentence for every transition that is followed by a release which ends in no named state."""
    structure = outcome.structure
    sentences = []
    for transition in structure.transitions:
        result = outcome.transitions[transition.name]
        text = "" if result is None else release_text(structure, transition, result)
        if text:
            whole = structure.appearance.whole
            sentences.append(f"The {whole} {text}. The protocol names no state there, so none is reported as held.")
    return sentences


def _reading(value: float, kind: str) -> str:
    return show_value(value, "m") if kind == "distance" else f"{math.degrees(value):.1f} deg"

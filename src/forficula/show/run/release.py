"""What a release left that ends in no state: numbers, for such a stage says nothing of whether anything is held."""

from __future__ import annotations

import math

from forficula.analysis import Outcome, TransitionOutcome
from forficula.quantities import show_value
from forficula.structure import Structure, Transition, measure_of


def release_text(structure: Structure, transition: Transition, found: TransitionOutcome) -> str:
    """A clause such as "went from 116.2 deg to 15.3 deg when released (smallest of creases)"; else empty."""
    if found.sprung_back is None:
        return ""
    measure = measure_of(structure, transition.measure)
    title = transition.measure if measure is None else measure.label or measure.name
    one = measure is not None and len(measure.parts) == 1
    furthest = "largest" if transition.furthest == "largest" else "smallest"
    what = title if one or transition.kind == "distance" else f"{furthest} of {title}"
    before, after = (_reading(value, transition.kind) for value in found.sprung_back)
    return f"went from {before} to {after} when released ({what})"


def release_sentences(outcome: Outcome) -> list[str]:
    """A sentence for every transition whose state no release ends in, though one follows."""
    structure = outcome.structure
    sentences = []
    for transition in structure.transitions:
        found = outcome.transitions[transition.name]
        text = "" if found is None else release_text(structure, transition, found)
        if text:
            whole = structure.appearance.whole
            sentences.append(f"The {whole} {text}. No state is named there, so none is claimed to have held.")
    return sentences


def _reading(value: float, kind: str) -> str:
    return show_value(value, "m") if kind == "distance" else f"{math.degrees(value):.1f} deg"

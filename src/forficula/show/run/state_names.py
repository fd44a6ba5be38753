"""Names of states, and the letters that mark them."""

from __future__ import annotations

from string import ascii_lowercase

from forficula.analysis import Outcome, State
from forficula.structure import RestState, Structure


def lettered_states(structure: Structure, outcome: Outcome) -> list[tuple[str, State]]:
    """Return the reached states with their names, each with its letter as in Binder et al. 2025.

    A missed state has a negated name, such as "not folded", and no letter.
    """
    named = []
    for name, letter in state_letters(structure).items():
        if (state := outcome.states[name]) is not None:
            held = outcome.holds.get(name, True)
            named.append((f"{letter} {outcome.state_names[name]}" if held else outcome.state_names[name], state))
    return named


def states_reached(structure: Structure, outcome: Outcome) -> dict[str, State]:
    """Return the states by their names in tables and marks: a missed state is named by its time, "after folding"."""
    return {
        table_name(state, outcome): reached
        for state in structure.states
        if (reached := outcome.states[state.name]) is not None
    }


def table_name(state: RestState, outcome: Outcome) -> str:
    """Return a state's name in tables and marks, or "after folding" and the like if the state was missed."""
    if state.name in outcome.holds:
        return state.name if outcome.holds[state.name] else state.unknown
    return outcome.state_names[state.name]


def state_letters(structure: Structure) -> dict[str, str]:
    """Return the letter of every state, by name."""
    return dict(zip((state.name for state in structure.states), _letters(len(structure.states)), strict=True))


def _letters(count: int) -> list[str]:
    """Return the letters a to z, then letters with a number."""
    return [f"{ascii_lowercase[index % 26]}{index // 26 or ''}" for index in range(count)]

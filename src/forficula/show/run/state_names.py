"""What states are called, and the letters that mark them."""

from __future__ import annotations

from string import ascii_lowercase

from forficula.analysis import Outcome, State
from forficula.structure import RestState, Structure


def lettered_states(structure: Structure, outcome: Outcome) -> list[tuple[str, State]]:
    """The states that there are and what to call each: with its letter, as Binder et al. 2025 give them.

    One that was missed is called by what it is not, such as "not folded", without a letter.
    """
    named = []
    for name, letter in state_letters(structure).items():
        if (found := outcome.states[name]) is not None:
            held = outcome.holds.get(name, True)
            named.append((f"{letter} {outcome.state_names[name]}" if held else outcome.state_names[name], found))
    return named


def states_reached(structure: Structure, outcome: Outcome) -> dict[str, State]:
    """The states that there are, by what tables and marks call them: one that was missed by when it was looked for."""
    return {
        table_name(state, outcome): found
        for state in structure.states
        if (found := outcome.states[state.name]) is not None
    }


def table_name(state: RestState, outcome: Outcome) -> str:
    """What tables and marks call a state: by its name, or by when it was looked for, such as "after folding"."""
    if state.name in outcome.holds:
        return state.name if outcome.holds[state.name] else state.unknown
    return outcome.state_names[state.name]


def state_letters(structure: Structure) -> dict[str, str]:
    """The letter of every state, by its name."""
    return dict(zip((state.name for state in structure.states), _letters(len(structure.states)), strict=True))


def _letters(count: int) -> list[str]:
    """The letters a to z, then with a number."""
    return [f"{ascii_lowercase[each % 26]}{each // 26 or ''}" for each in range(count)]

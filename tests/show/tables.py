"""Attributes of planted tables: those that a study of binder2025 writes."""

from functools import cache

from forficula.design import load_design
from forficula.structure import structure_of
from forficula.study.files.search_file import read_search
from forficula.study.tables.outcome_kinds import transitions_text


@cache
def transitions_of_reference(ask: str = "least-torques", *, opens: bool = True) -> dict[str, str]:
    """Return attributes of a table of the reference: its transitions, the state before them, and its noun.

    Args:
        ask: "least-torques", or "run" for plain runs.
        opens: whether a search asks for torques that open, too.
    """
    reference = load_design("binder2025")
    search = read_search(ask, {} if opens else {"unfold_torques": []}, reference) if ask != "run" else None
    structure = structure_of(reference)
    return {
        "transitions": transitions_text(structure, search),
        "start_state": "flat",
        "whole": structure.appearance.whole,
    }

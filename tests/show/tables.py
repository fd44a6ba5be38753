"""What tables that tests plant say of their structure: that of binder2025, as a study of it writes it."""

from functools import cache

from forficula.design import load_design
from forficula.structure import structure_of
from forficula.study.outcome_kinds import transitions_text
from forficula.study.study import read_search


@cache
def transitions_of_reference(ask: str = "least-torques") -> dict[str, str]:
    """Attributes of a table of the reference: its transitions and the state before them.

    Args:
        ask: "least-torques", or "run" for plain runs.
    """
    reference = load_design("binder2025")
    search = read_search(ask, {}, reference) if ask != "run" else None
    return {"transitions": transitions_text(structure_of(reference), search), "start_state": "flat"}

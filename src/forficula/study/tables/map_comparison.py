"""A static map beside the table of a simulated search: which structures make a transition in one, or in both."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from forficula.analysis import Ending, Verdict, ending_word
from forficula.errors import InputError
from forficula.study.tables.outcome_kinds import TableTransition, table_transitions

if TYPE_CHECKING:
    import xarray

_SAME = 1e-9  # share by which two torques of one grid may differ
BOTH, BOTH_LESS, BOTH_MORE, ONLY_SIMULATED, ONLY_STATIC, NEITHER, NOT_SIMULATED = (
    "in both, at the same torque",
    "in both, at less when simulated",
    "in both, at more when simulated",
    "in the simulation only: inertia",
    "in the statics only",
    "in neither",
    "not run",
)


def compare_maps(statics: xarray.Dataset, simulated: xarray.Dataset, name: str) -> xarray.DataArray:
    """Say for every structure where it has a least torque: in the statics, in the simulation, in both.

    Args:
        statics: from `static_map`.
        simulated: table of a search for the least torques, with the same factors; other values of them are left out.
        name: of a least torque, such as "least_fold_torque".

    Returns:
        Words, over the factors of the static map.

    Raises:
        InputError: the tables have different factors, or the simulated one has no such torque.
    """
    there = simulated_values(statics, simulated, name).values
    first, *_ = table_transitions(statics)
    found = np.isfinite(there)
    tried = simulated_values(statics, simulated.assign(tried=_tried(simulated, name, first)), "tried").values == 1
    slow = np.isfinite(statics[name].values)
    words = np.full(found.shape, NEITHER, dtype=object)
    with np.errstate(invalid="ignore"):
        ratio = there / statics[name].values
        less, more = ratio < 1 - _SAME, ratio > 1 + _SAME
    for where, word in (
        (slow, ONLY_STATIC),
        (found, ONLY_SIMULATED),
        (found & slow, BOTH),
        (less, BOTH_LESS),
        (more, BOTH_MORE),
        (~tried, NOT_SIMULATED),
    ):
        words[where] = word
    return statics[name].copy(data=words)


def simulated_values(statics: xarray.Dataset, simulated: xarray.Dataset, name: str) -> xarray.DataArray:
    """A variable of a simulated table at the points of a static map, nan where it has none.

    Raises:
        InputError: as `compare_maps`.
    """
    factors = [str(factor) for factor in statics["outcome"].dims]
    theirs = [str(factor) for factor in simulated["outcome"].dims]
    if set(factors) != set(theirs) or name not in simulated:
        raise InputError(
            f"the simulated study: need a search for the least torques over {', '.join(factors)}, got a table of"
            f" {', '.join(theirs)}"
        )
    values = simulated[name].transpose(*factors)
    # the same text of a value gives the same number, so no nearest one is looked for
    return values.reindex({factor: statics[factor] for factor in factors})


def _tried(simulated: xarray.Dataset, name: str, first: TableTransition) -> xarray.DataArray:
    """1 where a simulation tells of this torque: that of the second transition is tried where some makes the first."""
    outcome = simulated["outcome"]
    if name == first.least:
        return outcome.copy(data=_tells(simulated.get(f"{first.name}_outcome", outcome)).astype(np.float64))
    tells = np.isfinite(simulated[first.least].values) & _tells(outcome)
    return outcome.copy(data=tells.astype(np.float64))


def _tells(outcomes: xarray.DataArray) -> np.ndarray:
    """Where outcomes say something of the structure."""
    silent = [ending_word(Ending(verdict=verdict)) for verdict in Verdict if not verdict.tells]
    return np.asarray(~np.isin(outcomes.values.astype(str), silent))

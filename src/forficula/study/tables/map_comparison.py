"""Comparison of a static map with the table of a simulated search: which structures succeed in one, or in both."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from forficula.analysis import FORMER_WORDS, Ending, Verdict, ending_word
from forficula.errors import InputError
from forficula.study.tables.outcome_kinds import TableTransition, table_transitions

if TYPE_CHECKING:
    import xarray

_SAME = 1e-9  # relative difference allowed between equal torques of a grid
BOTH, BOTH_LESS, BOTH_MORE, ONLY_SIMULATED, ONLY_STATIC, NEITHER, NOT_SIMULATED = (
    "in both, at the same torque",
    "in both, at a smaller torque when simulated",
    "in both, at a larger torque when simulated",
    "in the simulation only: inertia",
    "in the statics only",
    "in neither",
    "not run",
)


def compare_maps(statics: xarray.Dataset, simulated: xarray.Dataset, name: str) -> xarray.DataArray:
    """Return for every structure where it has a least torque: in statics, in the simulation, or in both.

    Args:
        statics: statics from `static_map`.
        simulated: table of a search for the least torques over the same factors. Values of factors that are not in the
            static map are ignored.
        name: name of a least torque, such as "least_fold_torque".

    Returns:
        Words, over the factors of the static map.

    Raises:
        InputError: the tables have different factors, or the simulated one has no such torque.
    """
    torques = simulated_values(statics, simulated, name).values
    first, *_ = table_transitions(statics)
    in_simulation = np.isfinite(torques)
    tried = simulated_values(statics, simulated.assign(tried=_tried(simulated, name, first)), "tried").values == 1
    in_statics = np.isfinite(statics[name].values)
    words = np.full(in_simulation.shape, NEITHER, dtype=object)
    with np.errstate(invalid="ignore"):
        ratio = torques / statics[name].values
        less, more = ratio < 1 - _SAME, ratio > 1 + _SAME
    for where, word in (
        (in_statics, ONLY_STATIC),
        (in_simulation, ONLY_SIMULATED),
        (in_simulation & in_statics, BOTH),
        (less, BOTH_LESS),
        (more, BOTH_MORE),
        (~tried, NOT_SIMULATED),
    ):
        words[where] = word
    return statics[name].copy(data=words)


def simulated_values(statics: xarray.Dataset, simulated: xarray.Dataset, name: str) -> xarray.DataArray:
    """Return a variable of a simulated table at the points of a static map, nan if missing.

    Raises:
        InputError: see `compare_maps`.
    """
    factors = [str(factor) for factor in statics["outcome"].dims]
    simulated_factors = [str(factor) for factor in simulated["outcome"].dims]
    if set(factors) != set(simulated_factors) or name not in simulated:
        raise InputError(
            f"the simulated study: need a search for the least torques over {', '.join(factors)}, got a table of"
            f" {', '.join(simulated_factors)}"
        )
    values = simulated[name].transpose(*factors)
    # equal texts give equal numbers, so no tolerance is needed
    return values.reindex({factor: statics[factor] for factor in factors})


def _tried(simulated: xarray.Dataset, name: str, first: TableTransition) -> xarray.DataArray:
    """Return 1 where a simulation determines this torque. The second transition is tried only if the first succeeds."""
    outcome = simulated["outcome"]
    if name == first.least:
        return outcome.copy(data=_conclusive(simulated.get(f"{first.name}_outcome", outcome)).astype(np.float64))
    tried = np.isfinite(simulated[first.least].values) & _conclusive(outcome)
    return outcome.copy(data=tried.astype(np.float64))


def _conclusive(outcomes: xarray.DataArray) -> np.ndarray:
    """Return where outcomes are conclusive; tables of earlier versions have former words for verdicts."""
    inconclusive = [
        *FORMER_WORDS,
        *(ending_word(Ending(verdict=verdict)) for verdict in Verdict if not verdict.conclusive),
    ]
    return np.asarray(~np.isin(outcomes.values.astype(str), inconclusive))

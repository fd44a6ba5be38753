"""Which wings of a grid fold and open under slowly growing torques: a map without any simulation."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Ending, Verdict, ending_text, ending_word
from forficula.design import Design, key_value
from forficula.errors import InputError
from forficula.statics.potential import FOLD, SHARED, Section, section
from forficula.statics.quasi_static import flat_state, folded_state, slow_transition
from forficula.study.factors import read_factor
from forficula.study.search import point_design
from forficula.study.study import Search, Study, grid_points, read_torque_search
from forficula.study.table import table_axes

if TYPE_CHECKING:
    import xarray

# some 50 ms each
_MOST_POINTS = 100_000
# more are hardly faster, and say nothing for longer
_SIDE_BY_SIDE = 256

# name: (unit, what it is)
_NUMBERS = {
    "least_fold_torque": ("N m", "least slowly growing torque that folds"),
    "least_unfold_torque": ("N m", "least slowly growing torque that opens"),
    "flat_energy": ("J", "energy of the tendons, flat"),
    "folded_energy": ("J", "energy of the tendons, folded"),
}


def map_study(design: Design, over: Mapping[str, object], search: Search | None = None) -> Study:
    """The grid of a static map.

    Args:
        design: what is varied.
        over: values by key of the design, as a study file has its factors: a range with a step, or a list.
        search: the torques to try; those of a study file that gives none, if not given.

    Raises:
        InputError: an unknown key, values that are not allowed, or a distribution.
    """
    factors = tuple(read_factor(key, values) for key, values in over.items())
    count = math.prod(len(factor.values) for factor in factors)
    if count > _MOST_POINTS:
        raise InputError(f"{', '.join(over)}: need at most {_MOST_POINTS} points of a static map, got {count}")
    for factor in factors:
        if not factor.key.startswith(("tendon.", *SHARED)):
            raise InputError(
                f"{factor.key}: changes nothing under slowly growing torques; need a key of the tendon, or of"
                f" {', '.join(SHARED)}"
            )
        if factor.distribution is not None:
            raise InputError(f'{factor.key}: need a list or a range such as "10..60 N/cm step 10", got a distribution')
    return Study(
        name=f"{design.name}-statics",
        source="",
        base=design,
        factors=factors,
        points=tuple(grid_points(factors)),
        sampled=False,
        search=search or read_torque_search({}),
    )


def static_map(study: Study, progress: Callable[[int, int], None] | None = None) -> xarray.Dataset:
    """Let the torques grow step by step on every wing of a study: the least that fold from flat and open from folded.

    Every torque of the study's search above 0 is tried, with all inertia left out. Wings that differ in their tendons
    only go side by side.

    Args:
        study: a grid with a search for the least torques.
        progress: called now and then with the wings that are done, and all of them.

    Returns:
        Dimensions are the factors; variables as in the table of a search for the least torques.

    Raises:
        InputError: the study draws its points, or searches for no torques.
    """
    import xarray

    if study.search is None or study.sampled:
        raise InputError(f'{study.name}: need a grid and ask = "least-torques" for a static map')
    results: list[dict[str, float | str]] = [{} for _ in study.points]
    groups: dict[str, list[tuple[int, Design]]] = {}
    for number, point in enumerate(study.points):
        try:
            design = point_design(study.base, point)
        except InputError as error:
            results[number] = {**_told(Ending(verdict=Verdict.NOT_BUILT, why=str(error)))}
        else:
            groups.setdefault(repr([key_value(design, key) for key in SHARED]), []).append((number, design))
    done = 0
    for group in groups.values():
        for first in range(0, len(group), _SIDE_BY_SIDE):
            part = group[first : first + _SIDE_BY_SIDE]
            rows = _rows([design for _, design in part], study.search)
            for (number, _), row in zip(part, rows, strict=True):
                results[number] = row
            done += len(part)
            if progress is not None:
                progress(done, len(study.points))
    coordinates, dimensions, shape = table_axes(study)
    variables: dict[str, Any] = {
        name: (dimensions, _column(results, name).reshape(shape), {"units": unit, "long_name": meaning})
        for name, (unit, meaning) in _NUMBERS.items()
    }
    for name in ("status", "verdict", "outcome"):
        words = np.array([result[name] for result in results], dtype=object).reshape(shape)
        variables[name] = (dimensions, words)
    return xarray.Dataset(
        variables,
        coordinates,
        {"name": study.name, "design": study.base.name, "design_hash": study.base.hash, "ask": "statics"},
    )


def _rows(designs: Sequence[Design], search: Search) -> list[dict[str, float | str]]:
    """Rows of wings that go side by side."""
    wings = section(designs)
    flat, folded = flat_state(wings), folded_state(wings)
    fold = slow_transition(wings, flat, "fold", [torque for torque in search.fold_torques if torque > 0]).torque
    unfold = slow_transition(wings, folded, "unfold", [torque for torque in search.unfold_torques if torque > 0]).torque
    return [
        {
            "least_fold_torque": float(fold[case]),
            "least_unfold_torque": float(unfold[case]),
            "flat_energy": _tendon_energy(wings, case, flat),
            "folded_energy": _tendon_energy(wings, case, folded),
            **_told(_ending(folds=fold[case], opens=unfold[case])),
        }
        for case in range(len(designs))
    ]


def _tendon_energy(wings: Section, case: int, position: np.ndarray) -> float:
    angles = position[case, FOLD::4]
    return float(sum(hinge.energy(angle) for hinge, angle in zip(wings.hinges[case], angles, strict=True)))


def _told(ending: Ending) -> dict[str, str]:
    return {"status": ending_text(ending), "verdict": ending.verdict.value, "outcome": ending_word(ending)}


def _ending(*, folds: float, opens: float) -> Ending:
    """What a wing comes to for which these torques, nan where there is none, are the least that fold and open."""
    reached = np.isfinite([folds, opens])
    goal = "unfold" if reached[0] else "fold"
    return Ending(verdict=Verdict.REACHED if reached.all() else Verdict.STUCK, goal=goal)


def _column(results: Sequence[Mapping[str, float | str]], name: str) -> np.ndarray:
    return np.array([float(result.get(name, math.nan)) for result in results])


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
    """Say for every wing where it has a least torque: in the statics, in the simulation, in both.

    Args:
        statics: from `static_map`.
        simulated: table of a search for the least torques, with the same factors; other values of them are left out.
        name: "least_fold_torque" or "least_unfold_torque".

    Returns:
        Words, over the factors of the static map.

    Raises:
        InputError: the tables have different factors, or no wing in common.
    """
    there = simulated_values(statics, simulated, name).values
    found = np.isfinite(there)
    tried = simulated_values(statics, simulated.assign(tried=_tried(simulated, name)), "tried").values == 1
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
    """A variable of a simulated table at the wings of a static map, nan where it has none.

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


def _tried(simulated: xarray.Dataset, name: str) -> xarray.DataArray:
    """1 where a simulation tells of this torque: opening is tried where some torque folds."""
    folds, outcome = simulated["least_fold_torque"], simulated["outcome"]
    if name == "least_fold_torque":
        return folds.copy(data=_tells(simulated.get("fold_outcome", outcome)).astype(np.float64))
    tells = np.isfinite(folds.values) & _tells(outcome)
    return folds.copy(data=tells.astype(np.float64))


def _tells(outcomes: xarray.DataArray) -> np.ndarray:
    """Where outcomes say something of the wing."""
    silent = [ending_word(Ending(verdict=verdict)) for verdict in Verdict if not verdict.tells]
    return np.asarray(~np.isin(outcomes.values.astype(str), silent))

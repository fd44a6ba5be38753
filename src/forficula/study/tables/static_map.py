"""Static map: structures of a grid that make their transitions under slowly growing torques, without simulation."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Ending, Verdict, ending_text, ending_word
from forficula.arrays import Array, Flags
from forficula.design import TORQUE, Design, check_keys_once, key_value
from forficula.design.section import Section
from forficula.errors import InputError
from forficula.statics.net.net_of import is_net
from forficula.statics.path_dependence import refuse_path_dependence
from forficula.statics.tree.ensemble import Ensemble, ensemble_of
from forficula.statics.tree.lines import line_energy
from forficula.statics.tree.quasi_static import at_goal, slow_transition, start_state, state_after
from forficula.structure import Structure, Transition, goal_of, static_keys, structure_of
from forficula.study.factors import read_factor
from forficula.study.files.search_file import read_search
from forficula.study.points import grid_points
from forficula.study.search_steps import Search
from forficula.study.study import Study
from forficula.study.study_designs import point_design
from forficula.study.tables.outcome_kinds import transitions_text
from forficula.study.tables.table import table_axes

if TYPE_CHECKING:
    import xarray


_RESULT = "map of slowly growing torques"
# about 50 ms each
_MOST_POINTS = 100_000
# larger batches are hardly faster, but report progress less often
_SIDE_BY_SIDE = 256


def map_study(design: Design, over: Mapping[str, object], search: Search | None = None) -> Study:
    """Return the grid of a static map as a study.

    Args:
        design: design that is varied.
        over: values by key of the design, as the factors of a study file: a range with a step, or a list.
        search: torques to try; by default those of a study file without a table `search`.

    Raises:
        InputError: an unknown key, values that are not allowed, a distribution, or a design that is no tree of joints.
    """
    structure = structure_of(design)
    if is_net(structure):
        raise InputError(
            f"{design.name}: maps of slowly growing torques need bodies on joints in a tree, got points that slide,"
            " plates in loops or plates that touch; a study (forficula study) runs them over any key"
        )
    if not structure.transitions:
        raise InputError(
            f"{design.name}: maps of slowly growing torques need a stage of the protocol with a drive, a goal and a"
            " state to which it leads, got none"
        )
    refuse_path_dependence(structure, _RESULT)
    check_keys_once(over, design)
    factors = tuple(read_factor(key, values, type(design)) for key, values in over.items())
    count = math.prod(len(factor.values) for factor in factors)
    if count > _MOST_POINTS:
        raise InputError(f"{', '.join(over)}: need at most {_MOST_POINTS} points of a static map, got {count}")
    relevant = static_keys(design)
    for factor in factors:
        if not factor.key.startswith(("tendon.", *relevant)):
            raise InputError(
                f"{factor.key}: has no effect under slowly growing torques; need a key of the tendon, or of"
                f" {', '.join(relevant)}"
            )
        if factor.distribution is not None:
            raise InputError(f'{factor.key}: need a list or a range such as "10..60 N/cm step 10", got a distribution')
    # a factor may let creases fold permanently
    refuse_path_dependence(structure_of(point_design(design, grid_points(factors)[0])), _RESULT)
    return Study(
        name=f"{design.name}-statics",
        source="",
        base=design,
        factors=factors,
        points=grid_points(factors),
        sampled=False,
        search=search or read_search("least-torques", {}, design),
    )


def static_map(study: Study, progress: Callable[[int, int], None] | None = None) -> xarray.Dataset:
    """Find the least slowly growing torques that make the transitions of a search, for every design of a study.

    Every torque of the study's search above 0 is tried, without inertia. Designs that differ only in their tendons are
    computed side by side.

    Args:
        study: a grid with a search for the least torques.
        progress: called now and then with the number of completed designs and the number of all designs.

    Returns:
        Dimensions are the factors. Variables are as in the table of a search for the least torques.

    Raises:
        InputError: the points of the study are sampled, or it does not search for torques.
    """
    from forficula.study.tables.study_table import StudyTable

    search = study.search
    if search is None or study.sampled or any(step.unit is not TORQUE for step in search.steps):
        raise InputError(f'{study.name}: need a grid and ask = "least-torques" for a static map')
    results: list[dict[str, float | str]] = [{} for _ in study.points]
    groups: dict[str, list[tuple[int, Design]]] = {}
    for number, point in enumerate(study.points):
        try:
            design = point_design(study.base, point)
        except InputError as error:
            results[number] = {**_ending_columns(Ending(verdict=Verdict.NOT_BUILT, why=str(error)))}
        else:
            groups.setdefault(repr([_exact(key_value(design, key)) for key in static_keys(design)]), []).append(
                (number, design)
            )
    done = 0
    for group in groups.values():
        for first in range(0, len(group), _SIDE_BY_SIDE):
            part = group[first : first + _SIDE_BY_SIDE]
            rows = _rows([design for _, design in part], search)
            for (number, _), row in zip(part, rows, strict=True):
                results[number] = row
            done += len(part)
            if progress is not None:
                progress(done, len(study.points))
    structure = structure_of(study.base)
    coordinates, dimensions, shape = table_axes(study)
    variables: dict[str, Any] = {
        name: (dimensions, _column(results, name).reshape(shape), {"units": unit, "long_name": meaning})
        for name, (unit, meaning) in _numbers(structure, search).items()
    }
    for name in ("status", "verdict", "outcome"):
        words = np.array([result[name] for result in results], dtype=object).reshape(shape)
        variables[name] = (dimensions, words)
    return StudyTable(
        variables,
        coordinates,
        {
            "name": study.name,
            "design": study.base.name,
            "design_hash": study.base.hash,
            "ask": "statics",
            "transitions": transitions_text(structure, search),
            "start_state": search.start_state,
            "whole": structure.appearance.whole,
        },
    )


def _numbers(structure: Structure, search: Search) -> dict[str, tuple[str, str]]:
    """Return unit and meaning of each variable, by name."""
    wordings = {transition.name: transition.wording for transition in structure.transitions}
    steps = {
        step.result_name: ("N m", f"least slowly growing torque that {wordings[step.transition].does}")
        for step in search.steps
    }
    return steps | {f"{state}_energy": ("J", f"energy of the tendons, {state}") for state in _states(search)}


def _states(search: Search) -> tuple[str, str]:
    """Return the names of the states before and after the first transition."""
    return search.start_state or "first", search.first.state


def _rows(designs: Sequence[Design], search: Search) -> list[dict[str, float | str]]:
    """Return rows of designs that are computed side by side."""
    structures = ensemble_of(designs)
    refuse_path_dependence(structures.structure, _RESULT)
    transitions = {transition.name: transition for transition in structures.structure.transitions}
    before, after = _states(search)
    position, rests = start_state(structures).position, np.ones(structures.cases, dtype=bool)
    columns = {f"{before}_energy": _tendon_energies(structures, position)}
    results: list[tuple[Transition, Flags, Flags]] = []
    for step in search.steps:
        transition, torques = transitions[step.transition], [torque for torque in step.values if torque > 0]
        slow_result = slow_transition(structures, position, transition, torques)
        torque = slow_result.torque
        columns[step.result_name] = np.where(rests, torque, np.nan)
        position = state_after(structures, transition, torque, slow_result.position).position
        rests = at_goal(structures, position, goal_of(structures.structure, transition.released))
        if step is search.first:
            columns[f"{after}_energy"] = np.where(rests, _tendon_energies(structures, position), np.nan)
        results.append((transition, np.isfinite(torque), rests))
    return [
        {
            **{name: float(values[case]) for name, values in columns.items()},
            **_ending_columns(
                _ending(
                    [(transition, bool(succeeded[case]), bool(held[case])) for transition, succeeded, held in results]
                )
            ),
        }
        for case in range(structures.cases)
    ]


def _tendon_energies(structures: Ensemble, position: Array) -> Array:
    """Return the energy of all tendons, J, (case,)."""
    stored = structures.tendons.energy(position[:, structures.crossed])
    energies = np.array([sum(energy) for energy in stored], dtype=np.float64)
    return energies if structures.lines is None else energies + line_energy(structures.lines, position)[0]


def _ending_columns(ending: Ending) -> dict[str, str]:
    return {"status": ending_text(ending), "verdict": ending.verdict.value, "outcome": ending_word(ending)}


def _ending(results: Sequence[tuple[Transition, bool, bool]]) -> Ending:
    """Return the ending: for each transition, whether some torque makes it, and whether its state is then held."""
    for transition, succeeded, held in results:
        if not succeeded:
            return Ending(verdict=Verdict.STUCK, transition=transition)
        if not held:
            return Ending(verdict=Verdict.NOT_HELD, transition=transition)
    return Ending(verdict=Verdict.REACHED, transition=results[-1][0])


def _exact(value: Any) -> Any:
    """Return a value of a design in SI with all digits, which the repr of a section does not have."""
    if isinstance(value, Section):
        return value.si_tables()
    return [_exact(item) for item in value] if isinstance(value, tuple) else value


def _column(results: Sequence[Mapping[str, float | str]], name: str) -> np.ndarray:
    return np.array([float(result.get(name, math.nan)) for result in results])

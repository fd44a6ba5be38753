"""Calls about designs: the named ones, and warnings before a run."""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from typing import Literal

from forficula.design import AnyDesign, as_design
from forficula.errors import InputError
from forficula.names import one_of


class Examples(dict[str, str]):
    """Names of examples, each with one line of explanation; printed as a table."""

    def __repr__(self) -> str:
        """One line per example."""
        wide = max(map(len, self), default=0)
        return "\n".join(f"{name:{wide}}  {text}" for name, text in self.items())

    def _repr_html_(self) -> str:
        rows = (f"<tr><td><code>{escape(name)}</code></td><td>{escape(text)}</td></tr>" for name, text in self.items())
        return f"<table>{''.join(rows)}</table>"


def examples(kind: Literal["designs", "studies", "goals", "observations", "laws"] = "designs") -> Examples:
    """List the examples that come with the package, with one line each.

    Args:
        kind: "designs", for `load_design` and everything that accepts a design; "studies", for `load_study`; "goals",
            for `optimise`; "observations", for `identify`; or "laws", for `material.load_law`.

    Raises:
        InputError: another kind.

    >>> ff.examples()["letter-fold"]
    'rigid panels that tendons across the creases hold in two states'
    """
    kinds: dict[str, Callable[[], dict[str, str]]] = {
        "designs": _designs,
        "studies": _studies,
        "goals": _goals,
        "observations": _observations,
        "laws": _laws,
    }
    if kind not in kinds:
        raise InputError(f"kind: need {one_of(kinds, kind)}")
    return Examples(kinds[kind]())


def check_design(design: AnyDesign) -> tuple[str, ...]:
    """Return warnings about a design that can be built and run all the same, one sentence each.

    The warnings concern the structure and its timestep. `forficula run` prints them before a run.

    Args:
        design: design, its name or its path.

    Raises:
        InputError: no such design, or it cannot be built.

    >>> ff.check_design("letter-fold")
    ()
    """
    from forficula.dynamics import timestep_warnings
    from forficula.structure import structure_of, structure_warnings
    from forficula.study.running.law_timestep import law_timestep

    read = as_design(design)
    run, of_law = law_timestep(read)
    return (*structure_warnings(read, structure_of(read)), *[of_law] * bool(of_law), *timestep_warnings(run))


def _designs() -> dict[str, str]:
    from forficula.design import load_design, named_designs

    return {name: load_design(name).shows or source for name, source in named_designs().items()}


def _studies() -> dict[str, str]:
    from forficula.study import load_study, named_studies

    return {name: repr(load_study(name)).strip("<>").partition(": ")[2] for name in named_studies()}


def _goals() -> dict[str, str]:
    from forficula.goals import load_goal, named_goals

    return {name: repr(load_goal(name)).strip("<>").partition(": ")[2] for name in named_goals()}


def _observations() -> dict[str, str]:
    from forficula.goals.identify import load_observations, named_observations

    return {name: load_observations(name).source for name in named_observations()}


def _laws() -> dict[str, str]:
    from forficula.material import load_law, named_laws

    return {name: load_law(name).source for name in named_laws()}

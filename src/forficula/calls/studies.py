"""Calls that make many runs of a design."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from forficula.design import AnyDesign, as_design
from forficula.errors import InputError, error_prefix
from forficula.quantities import as_written

if TYPE_CHECKING:
    from forficula.dynamics.stepping.simulate import Progress
    from forficula.study import Study
    from forficula.study.assumptions.assumptions import Assumptions
    from forficula.study.convergence.convergence import Convergence

_OPTIONS = ("timesteps", "moduli", "meshes")


def converge(
    design: AnyDesign,
    *,
    timesteps: str | Sequence[float] | None = None,
    moduli: str | Sequence[float] | None = None,
    meshes: str | Sequence[float] | None = None,
    progress: Callable[[int, int, dict[str, Any]], None] | None = None,
) -> Convergence:
    """Run a design at several timesteps, membrane moduli or meshes, as `forficula converge` does.

    Args:
        design: or its name or path.
        timesteps: as in "0.5 0.2 ms", or s; this, `moduli` or `meshes`.
        moduli: of the membrane, as in "0.5 1 2 MPa", or Pa.
        meshes: by how much its rows are closer, as in "1 2".
        progress: called with the runs done, all runs, and what the last came to.

    Raises:
        InputError: none of the three, several of them, or values that are not allowed.

    >>> set(ff.converge(design, timesteps="0.2 0.1 ms").statuses)
    {'closed and opened'}
    """
    from forficula.study.convergence.convergence import converge as converge_design
    from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, read_values

    every = zip(_OPTIONS, (TIMESTEP, YOUNGS_MODULUS, MESH), (timesteps, moduli, meshes), strict=True)
    given = [(name, key, values) for name, key, values in every if values is not None]
    if len(given) != 1:
        names = ", ".join(name for name, _, _ in given) or "none"
        raise InputError(f"converge: need one of {', '.join(_OPTIONS)}, got {names}")
    ((name, key, values),) = given
    with error_prefix(f"{name}: "):
        read = read_values(key, values) if isinstance(values, str) else values
        read = [*read] if isinstance(read, Iterable) else read
        if not isinstance(read, Sequence) or not all(isinstance(value, int | float) for value in read):
            raise InputError(f"need text with a unit, or a list of numbers, got {as_written(values)}")
        return converge_design(as_design(design), key, read, progress=progress)


def assumptions(
    design: AnyDesign, *, only: Iterable[str] | None = None, progress: Progress | None = None
) -> Assumptions:
    """Run a design with one modelling assumption changed at a time, as `forficula assumptions` does.

    Args:
        design: or its name or path.
        only: names of the assumptions to change, such as "slow rise"; all that apply if not given.
        progress: called now and then with the runs done and the stage, the time of the stage and the longest it can
            take, s.

    Returns:
        The runs, and which of them change the verdict. `to_xarray` returns the table, `save` writes the folder.

    Raises:
        InputError: no such design or assumption, or the design cannot be built.

    >>> found = ff.assumptions(design, only=["timestep"])
    >>> found.own.status, found.deciding
    ('closed and opened', ())
    """
    from forficula.study.assumptions.assumptions import run_assumptions
    from forficula.study.assumptions.modelling_assumptions import selected

    read = as_design(design)
    with error_prefix("only: "):
        chosen = selected(only)
    return run_assumptions(read, assumptions=chosen, progress=progress)


def new_study(
    design: AnyDesign,
    factors: Mapping[str, object],
    *,
    name: str = "study",
    **tables: object,
) -> Study:
    """Build a study without a file: `run_study` runs it, `estimate` says how long that takes.

    Args:
        design: that is varied, or its name or path.
        factors: by key of the design: a list of values, a range, or a distribution, as in a study file.
        name: what outputs call it.
        **tables: what else a study file may have, such as `ask="least-torques"` or `search={"refinements": 2}`; the
            command `forficula keys --study` lists them.

    Raises:
        InputError: an unknown key, or a value that is not allowed.

    >>> asked = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    >>> ff.run_study(asked, out="asked")["status"].values.tolist()
    ['closed and opened', 'closed and opened']
    """
    from forficula.study.files.study_file import study_of

    return study_of(
        {
            **tables,
            "name": name,
            "design": as_design(design),
            "factors": dict(factors) if isinstance(factors, Mapping) else factors,
        }
    )

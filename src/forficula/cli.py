"""The command line: one sub-command, one library call."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

from cyclopts import App, CycloptsError, Parameter

from forficula.errors import InputError

# What each command needs is imported in it: help and errors come at once, without MuJoCo and matplotlib.

app = App(
    name="forficula",
    help="Predict and design bistable folding structures.",
    version_flags=["--version"],
    help_format="plaintext",
    suppress_keyboard_interrupt=False,
)
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set", help='Replace a value, as in --set tendon.stiffness="20 N/cm"; may be repeated.', negative=()
    ),
]
DesignName = Annotated[str, Parameter(help="A named design, or the path of a design file (.toml).")]


@app.command
def run(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    out: Annotated[
        Path | None, Parameter(help="Folder for the results; out/<name of the design> if not given.")
    ] = None,
) -> None:
    """Fold and open a wing: energies, work, times, a verdict, and pictures."""
    from forficula.design import design_warnings, load_design

    chosen = load_design(design, _read_settings(settings))
    folder = out or Path("out") / chosen.name
    _check_folder(folder)

    from forficula.analysis import measure
    from forficula.dynamics import run as run_design
    from forficula.dynamics import timestep_warnings
    from forficula.show import print_outcome, write_run

    for warning in design_warnings(chosen) + timestep_warnings(chosen):
        print(f"warning: {warning}", file=sys.stderr)
    with _progress() as progress:
        record = run_design(chosen, progress)
    outcome = measure(record)
    write_run(record, outcome, folder)
    print_outcome(chosen.name, outcome)
    print(f"\nwritten to {folder}")


@app.command
def pattern(
    design: DesignName,
    /,
    *,
    out: Annotated[Path, Parameter(help="A .fold or .svg file.")],
    settings: Settings = None,
) -> None:
    """Write a design's crease pattern as FOLD or SVG, by the ending of the file."""
    from forficula.design import load_design
    from forficula.pattern import earwig_pattern, folded_frames, write_fold, write_svg

    fan = load_design(design, _read_settings(settings)).fan
    match out.suffix:
        case ".fold":
            write_fold(earwig_pattern(fan), out, frames=folded_frames(fan))
        case ".svg":
            write_svg(earwig_pattern(fan), out)
        case _:
            raise InputError(f"--out: need a file that ends with .fold or .svg, got {out}")
    print(f"written to {out}")


@app.command
def new(file: Annotated[Path, Parameter(help="Where to write it; must end with .toml and not exist.")], /) -> None:
    """Write a commented design file to start from."""
    from forficula.design import write_new_design

    write_new_design(file)
    print(f"written to {file}; run it with: forficula run {file}")


@app.command
def designs() -> None:
    """List the named designs, each with its source."""
    from forficula.design import named_designs

    for name, source in named_designs().items():
        print(f"{name}\n    {source}")


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line; exit with 0 where the command was carried out, and with 1 for bad input."""
    try:
        app(arguments, exit_on_error=False, print_error=False)
    except (InputError, CycloptsError) as error:
        print(f"forficula: {' '.join(str(error).split())}", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        print("forficula: stopped", file=sys.stderr)
        sys.exit(130)


def _check_folder(folder: Path) -> None:
    """Refuse a folder that cannot be made, before a run that takes a while."""
    try:
        there = next(place for place in (folder, *folder.parents, Path()) if place.exists())
    except OSError as error:
        raise InputError(f"--out: {folder}: {error.strerror}") from None
    if not there.is_dir():
        raise InputError(f"--out: need a folder, got the file {there}")


def _read_settings(settings: Sequence[str] | None) -> dict[str, object]:
    """Turn key=value texts into values by dotted key: TOML where they are TOML, text with a unit otherwise."""
    import tomllib

    values: dict[str, object] = {}
    for setting in settings or ():
        key, equals, text = setting.partition("=")
        if not equals or not key.strip():
            raise InputError(f'--set: need KEY=VALUE such as tendon.stiffness="20 N/cm", got "{setting}"')
        try:
            values[key.strip()] = tomllib.loads(f"value = {text}")["value"]
        except (ValueError, RecursionError):  # not TOML, or too long a number or too deep a list for it
            values[key.strip()] = text.strip()
    return values


@contextmanager
def _progress() -> Iterator[Callable[[str, float, float], None]]:
    """Show how far a run is: a bar on a terminal, a line a stage elsewhere."""
    from rich.console import Console
    from rich.progress import Progress

    console = Console(stderr=True, highlight=False)
    if not console.is_terminal:
        stages = [""]

        def line(stage: str, time: float, longest: float) -> None:
            if stage != stages[-1]:
                stages.append(stage)
                console.print(f"{stage}: {time:.3g} s of at most {longest:.3g} s simulated")

        yield line
        return
    with Progress(console=console, transient=True) as bar:
        task = bar.add_task("start")
        yield lambda stage, time, longest: bar.update(task, description=stage, completed=time, total=longest)

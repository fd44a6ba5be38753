"""The command line."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from cyclopts import App, CycloptsError

from forficula.commands import designs, landscapes, materials, runs, studies
from forficula.errors import InputError

app = App(
    name="forficula",
    help="Predict and design bistable folding structures.",
    version_flags=["--version"],
    help_format="plaintext",
    suppress_keyboard_interrupt=False,
)
for command in (
    runs.run,
    designs.pattern,
    landscapes.landscape,
    studies.converge,
    runs.compare,
    studies.study,
    materials.material,
    materials.size,
    runs.figure,
    runs.film,
    materials.materials,
    designs.new,
    designs.designs,
):
    app.command(command)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line, and exit with what it came to.

    0: done, and every goal met; 1: bad input; 2: done and to be trusted, but a goal missed; 3: a run diverged or is not
    to be trusted; 130: stopped.
    """
    try:
        status = app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
    except (InputError, CycloptsError) as error:
        print(f"forficula: {' '.join(str(error).split())}", file=sys.stderr)
        sys.exit(1)
    except BrokenPipeError:
        # whoever read our output has seen enough; Python would complain once more when it closes it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except KeyboardInterrupt:
        print("forficula: stopped", file=sys.stderr)
        sys.exit(130)
    if status:
        sys.exit(status)

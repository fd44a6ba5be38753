"""The command line."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from cyclopts import App, CycloptsError

from forficula.commands import designs, landscapes, materials, runs, studies
from forficula.errors import InputError
from forficula.terminal import drop_output, flush_output, plain_terminal

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
    designs.scale,
    designs.designs,
):
    app.command(command)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line, and exit with what it came to.

    0: done, and every goal met; 1: bad input; 2: done and to be trusted, but a goal missed; 3: a run diverged or is not
    to be trusted; 130: stopped.
    """
    try:
        with plain_terminal():
            try:
                status = app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
            finally:
                flush_output()
    except (InputError, CycloptsError) as error:
        print(f"forficula: {' '.join(str(error).split())}", file=sys.stderr)
        sys.exit(1)
    except BrokenPipeError:
        # whoever read our output has seen enough
        drop_output()
        sys.exit(1)
    except OSError as error:
        drop_output()
        where = error.filename or "the output cannot be written"
        print(f"forficula: {where}: {error.strerror or error}", file=sys.stderr)
        sys.exit(1)
    except MemoryError:
        print("forficula: no memory left; take fewer units, or fewer rows by a longer sample_interval", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        print("forficula: stopped", file=sys.stderr)
        sys.exit(130)
    if status:
        sys.exit(status)

"""The command line."""

from __future__ import annotations

import contextlib
import gc
import mmap
import os
import sys
from collections.abc import Callable, Sequence
from functools import wraps
from inspect import Parameter as Argument
from inspect import signature
from pathlib import Path
from time import monotonic
from typing import Annotated, Any

from cyclopts import App, CycloptsError, MissingArgumentError, Parameter, UnusedCliTokensError

from forficula.commands import citations, designs, goals, landscapes, materials, parts, runs, schemas, studies
from forficula.commands.new import new
from forficula.errors import InputError
from forficula.names import listed
from forficula.quantities import as_written
from forficula.terminal import drop_output, flush_output, plain_terminal, remark, speaking

app = App(
    name="forficula",
    help="Predict and design bistable folding structures.",
    version_flags=["--version"],
    help_format="plaintext",
    suppress_keyboard_interrupt=False,
)
# commands, and whether they have JSON for other programs
_COMMANDS: dict[Callable[..., int | None], bool] = {
    runs.run: True,
    designs.pattern: False,
    parts.make: True,
    landscapes.landscape: True,
    studies.converge: True,
    studies.assumptions: True,
    runs.compare: False,
    designs.open_design: False,
    studies.study: True,
    goals.optimise: True,
    goals.tolerance: True,
    goals.identify: True,
    materials.material: True,
    materials.size: True,
    runs.figure: False,
    runs.film: False,
    materials.materials: True,
    designs.scale: False,
    designs.designs: True,
    studies.studies: True,
    designs.keys: True,
    citations.cite: False,
    schemas.schema: False,
}
_AsJson = Annotated[
    bool, Parameter(name="--json", help="Write what came of it as JSON, and nothing else there.", negative=())
]
app.meta.suppress_keyboard_interrupt = False
# what the engine, the loader of libraries and threads say where memory ends
_OF_MEMORY = ("allocate memory", "failed to map segment", "start new thread")
# s; of what takes longer, the time is told
_LONG = 1.0
# letters of a word in an error; paths of files are shorter
_LONGEST_WORD = 300
# [chosen] what numpy and scipy map when they are loaded: 175 MiB were measured with one thread, 82 MiB more by thread
_LIBRARIES, _THREAD = 192 << 20, 88 << 20
_THREADS = "OPENBLAS_NUM_THREADS"


def _offering_json(command: Callable[..., int | None]) -> Callable[..., int | None]:
    """A command that has --json among its options, for whoever launches it: what it comes to is the same."""

    @wraps(command)
    def offered(*arguments: Any, as_json: bool = False, **options: Any) -> int | None:  # noqa: ARG001
        return command(*arguments, **options)

    own = signature(command)
    option = Argument("as_json", Argument.KEYWORD_ONLY, default=False, annotation=_AsJson)
    offered.__signature__ = own.replace(parameters=[*own.parameters.values(), option])  # type: ignore[attr-defined]
    offered.__annotations__ = {**command.__annotations__, "as_json": _AsJson}
    return offered


for each, has_data in _COMMANDS.items():
    # a function that is called as its command would hide a name that Python has
    app.command(_offering_json(each) if has_data else each, name=each.__name__.removesuffix("_design"))
app.command(new)
app.register_install_completion_command(
    name="--install-completion", add_to_startup=False, help="Let the shell complete commands and options."
)


@app.meta.default
def _launch(
    *tokens: Annotated[str, Parameter(show=False, allow_leading_hyphen=True)],
    # before a command, which alone knows whether it has it
    as_json: Annotated[_AsJson, Parameter(show=False)] = False,
    quiet: Annotated[bool, Parameter(help="Write warnings and errors only.", negative=())] = False,
) -> int | None:
    command, bound, _ = app.parse_args(tokens, exit_on_error=False, print_error=False)
    as_json = as_json or bound.arguments.get("as_json", False)
    with_data = [each.__name__ for each, has_data in _COMMANDS.items() if has_data]
    if as_json and command.__name__ not in with_data:
        raise InputError(f"--json: need {listed(with_data, 'or')}, got {as_written(' '.join(tokens[:1]))}")
    check_room_for_libraries()
    start = monotonic()
    with speaking(quiet=quiet, as_json=as_json):
        status: int | None = command(*bound.args, **bound.kwargs)
        if (passed := monotonic() - start) > _LONG:
            remark(f"took {passed:.3g} s" if passed < 100 else f"took {passed / 60:.3g} min")
    return status


def _worded(error: Exception, arguments: Sequence[str] | None) -> str:
    """Word an error, and what to do where a value begins with a hyphen, as an option does."""
    if isinstance(error, UnusedCliTokensError):
        return f"need no more arguments, got {as_written(' '.join(error.unused_tokens or ()))}"
    tokens = list(sys.argv[1:] if arguments is None else arguments)
    if isinstance(error, MissingArgumentError) and error.keyword in tokens:
        value = "".join(tokens[tokens.index(error.keyword) + 1 :][:1])
        if value.startswith("-") and not value.startswith("--"):
            return f"{error} Write a value that begins with a hyphen as {error.keyword}={as_written(value)}"
    return str(error)


def _without_long_words(text: str) -> str:
    """Write an error on one line; of a path or value of thousands of letters only the beginning and the end."""
    short = (
        word if len(word) <= _LONGEST_WORD else f"{word[: _LONGEST_WORD // 2]}...{word[-20:]}" for word in text.split()
    )
    return " ".join(short)


def _keep_matplotlib_plain() -> None:
    """Let no file and no variable of the user's change figures, nor one that cannot be read end a command."""
    if "matplotlib" in sys.modules:
        return
    os.environ |= {"MPLBACKEND": "agg", "MATPLOTLIBRC": os.devnull}
    if os.path.lexists("matplotlibrc"):
        # matplotlib looks for it in the current folder first, and only there and then
        with contextlib.chdir(Path(__file__).parent):
            import matplotlib  # noqa: F401


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line, and exit with what it came to.

    0: done, and every goal met; 1: bad input; 2: done and to be trusted, but a goal missed, or a check under --strict;
    3: a run diverged, is undecided or is not to be trusted; 130: stopped.
    """
    _keep_matplotlib_plain()
    gc.set_threshold(20_000)  # most of what a command makes stays to its end: looking for garbage took 7 % of a run
    try:
        with plain_terminal():
            try:
                status = app.meta(arguments, exit_on_error=False, print_error=False, result_action="return_value")
            finally:
                flush_output()
    except (InputError, CycloptsError) as error:
        print(f"forficula: {_without_long_words(_worded(error, arguments))}", file=sys.stderr)
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
    except KeyboardInterrupt:
        print("forficula: stopped", file=sys.stderr)
        sys.exit(130)
    except Exception as error:
        if not (isinstance(error, MemoryError) or any(words in str(error) for words in _OF_MEMORY)):
            raise
        drop_output()
        print(
            "forficula: no memory left; take fewer units, fewer rows by a longer sample_interval, or a higher limit"
            " (ulimit -v)",
            file=sys.stderr,
        )
        sys.exit(1)
    if status:
        sys.exit(status)


def check_room_for_libraries() -> None:
    """Let OpenBLAS begin with one thread where there is no room for all, and refuse to load it where that has none.

    OpenBLAS asks for its buffers again and again, without an end, where a limit (`ulimit -v`) leaves no room for them.

    Raises:
        MemoryError: no room for one thread.
    """
    if "scipy.linalg" in sys.modules or not _is_limited():
        return
    if _has_room(_LIBRARIES + (_threads() - 1) * _THREAD):
        return
    if not _has_room(_LIBRARIES):
        raise MemoryError
    os.environ[_THREADS] = "1"


def _is_limited() -> bool:
    try:
        import resource
    except ImportError:  # not on Windows
        return False
    return resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY


def _threads() -> int:
    cores = os.cpu_count() or 1
    with contextlib.suppress(ValueError):
        return min(cores, max(1, int(os.environ.get(_THREADS, ""))))
    return cores


def _has_room(size: int) -> bool:
    try:
        mmap.mmap(-1, size).close()
    except OSError:
        return False
    return True

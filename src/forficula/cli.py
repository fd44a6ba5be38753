"""The command line: its commands in groups, its exit status, and its messages for errors."""

from __future__ import annotations

import contextlib
import gc
import mmap
import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import wraps
from inspect import Parameter as Argument
from inspect import signature
from pathlib import Path
from time import monotonic
from typing import Annotated, Any

from cyclopts import App, CycloptsError, Group, MissingArgumentError, Parameter, UnusedCliTokensError

from forficula.commands import citations, designs, goals, landscapes, materials, parts, runs, schemas, studies, tracing
from forficula.commands.new import new
from forficula.errors import InputError
from forficula.names import listed
from forficula.quantities import as_written
from forficula.terminal import command_output, drop_output, flush_output, note, output_until_closed, plain_terminal

# in the order of the help, most used first
_GROUPS = (
    "Predict what a design does",
    "Explore many designs",
    "Design for a purpose",
    "Make parts",
    "Look at results and lists",
)
_PREDICT, _EXPLORE, _DESIGN, _MAKE, _LOOK = (Group(name, sort_key=place) for place, name in enumerate(_GROUPS))
app = App(
    name="forficula",
    help="Predict and design bistable folding structures.",
    version_flags=["--version"],
    default_parameter=Parameter(show_default=lambda value: value if value is not False else None),
    help_format="plaintext",
    help_epilogue="Start with: forficula run binder2025\nHelp on a command: forficula run --help",
    group_commands=Group("General", sort_key=len(_GROUPS)),
    suppress_keyboard_interrupt=False,
)


@dataclass(frozen=True, kw_only=True)
class _Command:
    """A command and its place in the help.

    Attributes:
        call: function of the command.
        group: heading under which the help lists it.
        examples: two command lines, without "forficula".
        has_json: whether --json writes its result.
    """

    call: Callable[..., int | None]
    group: Group
    examples: tuple[str, str]
    has_json: bool = False

    @property
    def name(self) -> str:
        """The name; a function that would hide a builtin of Python has an ending."""
        return self.call.__name__.removesuffix("_design")


_COMMANDS = (
    _Command(
        call=runs.run,
        group=_PREDICT,
        examples=(
            "run binder2025 --open",
            'run my-wing.toml --set protocol.stages.fold.time_limit="3 s"',
        ),
        has_json=True,
    ),
    _Command(
        call=landscapes.landscape,
        group=_PREDICT,
        examples=(
            "landscape binder2025",
            'landscape binder2025 --over tendon.rest_length="0..9 cm step 1"',
        ),
        has_json=True,
    ),
    _Command(
        call=designs.pattern, group=_PREDICT, examples=("pattern sheet.fold", "pattern binder2025 --out wing.svg")
    ),
    _Command(
        call=studies.converge,
        group=_PREDICT,
        examples=(
            'converge binder2025-joint --timesteps "0.2 0.1 0.05 ms"',
            'converge binder2025 --meshes "1 2" --out out/meshes',
        ),
        has_json=True,
    ),
    _Command(
        call=studies.assumptions,
        group=_PREDICT,
        examples=("assumptions binder2025-joint", 'assumptions binder2025 --only "slow rise" --only gravity'),
        has_json=True,
    ),
    _Command(
        call=designs.open_design,
        group=_EXPLORE,
        examples=("open binder2025", "open miura-sheet --out sheet.html"),
    ),
    _Command(
        call=studies.study,
        group=_EXPLORE,
        examples=("study my-study.toml --dry-run", "study my-study.toml --out out/map"),
        has_json=True,
    ),
    _Command(
        call=goals.tolerance,
        group=_EXPLORE,
        examples=(
            'tolerance binder2025-joint --tolerance all="5 %"',
            "tolerance --goal my-goal.toml --minutes 20",
        ),
        has_json=True,
    ),
    _Command(
        call=goals.identify,
        group=_EXPLORE,
        examples=("identify my-observations.toml --dry-run", "identify my-observations.toml"),
        has_json=True,
    ),
    _Command(
        call=goals.optimise,
        group=_DESIGN,
        examples=("optimise my-goal.toml --dry-run", "optimise my-goal.toml --out out/best"),
        has_json=True,
    ),
    _Command(
        call=designs.scale,
        group=_DESIGN,
        examples=("scale binder2025 --length 1/2 --out half.toml", "scale my-wing.toml --length 10"),
    ),
    _Command(
        call=tracing.trace,
        group=_DESIGN,
        examples=(
            'trace photograph.jpg --size "29.7 x 21 cm"',
            "trace imitated-wing",
        ),
        has_json=True,
    ),
    _Command(
        call=materials.material,
        group=_DESIGN,
        examples=(
            'material tests.csv --length "60 mm" --area "5 mm^2"',
            'material strip-1.csv strip-2.csv --width "20 mm" --out out/fold',
        ),
        has_json=True,
    ),
    _Command(
        call=materials.size,
        group=_DESIGN,
        examples=(
            'size binder2025 --material tpu-95a --stiffness "10 N/cm"',
            'size binder2025 --material petg --stiffness "10..60 N/cm step 10"',
        ),
        has_json=True,
    ),
    _Command(
        call=parts.make,
        group=_MAKE,
        examples=("make binder2025-joint", "make miura-sheet --part sheet --out out/sheet"),
        has_json=True,
    ),
    _Command(
        call=runs.figure,
        group=_LOOK,
        examples=(
            "figure out/binder2025 --kind energy --out energy.pdf",
            "figure out/binder2025 --kind folding --out folding.svg --width page",
        ),
    ),
    _Command(
        call=runs.film,
        group=_LOOK,
        examples=("film out/binder2025 --out wing.mp4", "film out/binder2025 --out wing.gif --slower 20"),
    ),
    _Command(
        call=runs.export,
        group=_LOOK,
        examples=("export out/binder2025 --to gltf", 'export out/binder2025 --to stl --at "30 ms" --out wing.stl'),
    ),
    _Command(
        call=runs.compare,
        group=_LOOK,
        examples=("compare out/soft out/stiff --out both.html", "compare out/a out/b out/c --out three.html"),
    ),
    _Command(call=designs.designs, group=_LOOK, examples=("designs", "designs --json"), has_json=True),
    _Command(call=studies.studies, group=_LOOK, examples=("studies", "studies --json"), has_json=True),
    _Command(call=materials.materials, group=_LOOK, examples=("materials", "materials --json"), has_json=True),
    _Command(call=designs.keys, group=_LOOK, examples=("keys tendon", "keys --kind miura-ori"), has_json=True),
    _Command(call=citations.cite, group=_LOOK, examples=("cite binder2025", "cite my-wing.toml --bibtex")),
    _Command(call=schemas.schema, group=_LOOK, examples=("schema summary", "schema row")),
)
_AsJson = Annotated[
    bool,
    Parameter(name="--json", help="Write only the result, as JSON, to standard output.", negative=()),
]
app.meta.suppress_keyboard_interrupt = False
# messages of the engine, the loader of libraries and threads when memory is exhausted
_OF_MEMORY = ("allocate memory", "failed to map segment", "start new thread")
_LONG = 1.0  # s; the time of a longer command is reported
# letters of a word in an error message; paths of files are shorter
_LONGEST_WORD = 300
# [chosen] memory that numpy, scipy and the engine map on import: 234 MiB measured with one thread, 82 MiB more for each
# thread
_LIBRARIES, _THREAD = 256 << 20, 88 << 20
_THREADS = "OPENBLAS_NUM_THREADS"


def _with_json(command: Callable[..., int | None]) -> Callable[..., int | None]:
    """Return a command that also has the option --json, which `_launch` reads."""

    @wraps(command)
    def call(*arguments: Any, as_json: bool = False, **options: Any) -> int | None:  # noqa: ARG001
        return command(*arguments, **options)

    before = signature(command)
    option = Argument("as_json", Argument.KEYWORD_ONLY, default=False, annotation=_AsJson)
    call.__signature__ = before.replace(parameters=[*before.parameters.values(), option])  # type: ignore[attr-defined]
    call.__annotations__ = {**command.__annotations__, "as_json": _AsJson}
    return call


def _examples(lines: Sequence[str]) -> str:
    return "Examples:\n" + "\n".join(f"  forficula {line}" for line in lines)


for place, command in enumerate(_COMMANDS):
    app.command(
        _with_json(command.call) if command.has_json else command.call,
        name=command.name,
        group=command.group,
        sort_key=place,
        help_epilogue=_examples(command.examples),
    )
new.group, new.sort_key = _DESIGN, -1
app.command(new)
app.register_install_completion_command(
    name="--install-completion", add_to_startup=False, help="Let the shell complete commands and options."
)


@app.meta.default
def _launch(
    *tokens: Annotated[str, Parameter(show=False, allow_leading_hyphen=True)],
    # accepted before the command, too; the command decides whether it has the option
    as_json: Annotated[_AsJson, Parameter(show=False)] = False,
    quiet: Annotated[bool, Parameter(help="Write warnings and errors only.", negative=())] = False,
) -> int | None:
    command, bound, _ = app.parse_args(tokens, exit_on_error=False, print_error=False)
    as_json = as_json or bound.arguments.get("as_json", False)
    with_json = [command.name for command in _COMMANDS if command.has_json]
    if as_json and command.__name__ not in with_json:
        raise InputError(f"--json: need {listed(with_json, 'or')}, got {as_written(' '.join(tokens[:1]))}")
    # the matrices of statics are small: the fold path of 100 facets takes 0.4 s of processor time with one thread, and
    # 0.9 to 1.8 s with two; processes that a command starts inherit it
    os.environ.setdefault(_THREADS, "1")
    check_room_for_libraries()
    start = monotonic()
    with command_output(quiet=quiet, as_json=as_json):
        status: int | None = command(*bound.args, **bound.kwargs)
        if (passed := monotonic() - start) > _LONG:
            note(f"took {passed:.3g} s" if passed < 100 else f"took {passed / 60:.3g} min")
    return status


def _worded(error: Exception, arguments: Sequence[str] | None) -> str:
    """Return the message of an error; explains how to write a value that begins with a hyphen."""
    if isinstance(error, UnusedCliTokensError):
        return f"need no more arguments, got {as_written(' '.join(error.unused_tokens or ()))}"
    tokens = list(sys.argv[1:] if arguments is None else arguments)
    if isinstance(error, MissingArgumentError) and error.keyword in tokens:
        value = "".join(tokens[tokens.index(error.keyword) + 1 :][:1])
        if value.startswith("-") and not value.startswith("--"):
            return f"{error} Write a value that begins with a hyphen as {error.keyword}={as_written(value)}"
    return str(error)


def _without_long_words(text: str) -> str:
    """Return an error on one line, with long paths and values shortened to their beginning and end."""
    short = (
        word if len(word) <= _LONGEST_WORD else f"{word[: _LONGEST_WORD // 2]}...{word[-20:]}" for word in text.split()
    )
    return " ".join(short)


def _keep_matplotlib_plain() -> None:
    """Ignore the user's matplotlib settings: they would change figures, and unreadable ones would end the command."""
    if "matplotlib" in sys.modules:
        return
    os.environ |= {"MPLBACKEND": "agg", "MATPLOTLIBRC": os.devnull}
    if os.path.lexists("matplotlibrc"):
        # matplotlib reads this file from the current folder on import
        with contextlib.chdir(Path(__file__).parent):
            import matplotlib  # noqa: F401


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line, and exit with its status.

    0: every goal was met; 1: bad input; 2: a goal was missed, or a check failed under --strict; 3: a run diverged, is
    undecided or is unreliable; 130: stopped by ctrl-C.
    """
    _keep_matplotlib_plain()
    gc.set_threshold(20_000)  # most objects live to the end of a command: collection took 7 % of a run
    try:
        with output_until_closed(), plain_terminal():
            try:
                status = app.meta(arguments, exit_on_error=False, print_error=False, result_action="return_value")
            finally:
                flush_output()
    except (InputError, CycloptsError) as error:
        print(f"forficula: {_without_long_words(_worded(error, arguments))}", file=sys.stderr)
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
    """Limit OpenBLAS to one thread where memory is limited, and stop where memory does not suffice for one thread.

    OpenBLAS requests its buffers in an endless loop where a limit (`ulimit -v`) leaves no room for them.

    Raises:
        MemoryError: memory does not suffice for one thread.
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

"""Options that several commands share, and functions that read their values."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, TypeVar

from cyclopts import Parameter, Token

from forficula.errors import InputError, error_prefix
from forficula.names import is_device_name, listed, one_of
from forficula.quantities import as_written
from forficula.terminal import end_with, note, set_result

if TYPE_CHECKING:
    from forficula.analysis import Verdict
    from forficula.design import Design
    from forficula.quantities import Unit

T = TypeVar("T")
# digits of ASCII only: others, such as ², are digits to Python, too
_WHOLE = re.compile(r"[0-9]{1,18}")
_NUMBER = r"((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
_RATIO = re.compile(rf"{_NUMBER}(?:\s*/\s*{_NUMBER})?")


def _whole_number(_type: object, tokens: Sequence[Token]) -> int:
    """Read a whole number; without this converter a fraction would be rounded silently."""
    (token,) = tokens
    if not re.fullmatch(rf"[+-]?{_WHOLE.pattern}", token.value):
        limit = " of at most 18 digits" if re.fullmatch("[+-]?[0-9]+", token.value) else ""
        raise InputError(f"need a whole number{limit}, got {as_written(token.value)}")
    return int(token.value)


# parameter of every option that is a whole number
WHOLE_NUMBER = Parameter(converter=_whole_number)
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set", help='Set a value, such as --set tendon.stiffness="20 N/cm"; may be repeated.', negative=()
    ),
]


def _read_out(_: object, tokens: Sequence[Token]) -> Path:
    # an empty path would be the current folder
    if not tokens[0].value:
        raise InputError("need the name of a file or a folder, got an empty text")
    path = Path(tokens[0].value)
    if device := next((part for part in path.parts if is_device_name(part)), None):
        raise InputError(
            "need a path that every system can have: Windows refuses device names such as aux and nul; got"
            f" {as_written(device)}"
        )
    return path


Out = Annotated[Path, Parameter(converter=_read_out)]
OutIfGiven = Annotated[Path | None, Parameter(converter=_read_out)]
NoEngine = Annotated[
    bool,
    Parameter(
        negative=(), help="Leave the simulator (3.5 MB) out of report.html, which then only plays recorded runs."
    ),
]
Tolerate = Annotated[
    bool,
    Parameter(help="End with status 0 instead of 3 where a run diverged or is unreliable.", negative=()),
]
OkIf = Annotated[
    list[str] | None,
    Parameter(
        name="--ok-if",
        help="End with status 0 only where this is the verdict, such as stuck; may be repeated.",
        negative=(),
    ),
]
OpenReport = Annotated[
    bool,
    Parameter(name="--open", help="Open the HTML page of the results in the browser when it is written.", negative=()),
]
DesignName = Annotated[
    str, Parameter(help="A named design, or the path of a design file (.toml), a FOLD file or a drawing (.svg, .dxf).")
]
Dask = Annotated[
    str | None, Parameter(help="Run on the Dask cluster with this scheduler, such as tcp://scheduler:8786.")
]
Device = Annotated[
    Literal["cpu", "gpu", "warp-cpu"] | None,
    Parameter(
        help="Simulate on this device: cpu (the default, in double precision), gpu (a graphics processor, in single"
        " precision), or warp-cpu (the same on the processor, for tests). It is the value of protocol.device."
    ),
]
DrawingUnit = Annotated[
    str | None, Parameter(help='Length of one unit of a FOLD file or drawing that states no unit, such as "1 cm".')
]


def exit_status(verdicts: Iterable[Verdict], *, tolerate: bool, ok_if: Sequence[str] | None = None) -> int:
    """Return the exit status of a command that ran to its end, for scripts.

    Args:
        verdicts: verdicts of the requested runs.
        tolerate: whether to accept runs that diverged, are undecided or are unreliable.
        ok_if: accepted verdicts; only `Verdict.REACHED` if none is named.

    Returns:
        0 where every verdict is accepted, 2 where one is not, 3 where a run gives no information on its structure.
    """
    uninformative, wanted = ("diverged", "untrusted", "undecided"), tuple(ok_if or ("reached",))
    counted = [verdict for verdict in verdicts if not (tolerate and verdict in uninformative)]
    if any(verdict in uninformative and verdict not in wanted for verdict in counted):
        return 3
    return 0 if all(verdict in wanted for verdict in counted) else 2


def check_verdicts(ok_if: Sequence[str] | None) -> None:
    """Refuse words that are not verdicts of a run.

    Raises:
        InputError: a word is not a verdict; the message names the nearest one.
    """
    from forficula.analysis import Verdict

    words = [verdict.value for verdict in Verdict]
    for word in ok_if or ():
        if word not in words:
            raise InputError(f"--ok-if: need {one_of(words, word)}")


def read_option(option: str, read: Callable[[], T]) -> T:
    """Read an option; error messages begin with its name.

    Raises:
        InputError: `read` raises it.
    """
    with error_prefix(f"{option}: "):
        return read()


@contextmanager
def options_named(**options: str) -> Iterator[None]:
    """Name the options of the command line in error messages, instead of the arguments of a Python function.

    Args:
        **options: option by the name of the argument, such as unit="--unit".

    Raises:
        InputError: the error of the block.
    """
    try:
        yield
    except InputError as error:
        argument = re.compile(rf"(^|: )({'|'.join(options)})(?:: |\.)")
        message = argument.sub(lambda match: f"{match[1]}{options[match[2]]}: ", str(error), count=1)
        raise InputError(message) from None


def read_quantity(option: str, text: object, unit: Unit) -> float:
    """Return the value of an option in SI.

    Raises:
        InputError: the text is not a quantity of the dimension of the unit.
    """
    from forficula.quantities import parse_quantity

    return read_option(option, lambda: parse_quantity(text, unit))


def read_size(option: str, text: str, smallest: int, largest: int) -> tuple[int, int]:
    """Read a size such as "1280x720": width and height, px.

    Raises:
        InputError: the text is not a size, or a number is out of bounds or odd, which video codecs refuse.
    """
    width, times, height = text.partition("x")
    if times and _WHOLE.fullmatch(width) and _WHOLE.fullmatch(height):
        size = int(width), int(height)
        if all(smallest <= pixels <= largest and pixels % 2 == 0 for pixels in size):
            return size
    rule = f"two even numbers from {smallest} to {largest} such as 1280x720"
    raise InputError(f'{option}: need {rule}, got "{text}"')


def read_ratio(option: str, text: str) -> float:
    """Read a ratio such as "1/10", "0.1" or "10".

    Raises:
        InputError: the text is not a ratio, or the ratio is not > 0 and finite.
    """
    match = _RATIO.fullmatch(text.strip())
    numerator, denominator = (float(match[1]), float(match[2] or 1)) if match else (0.0, 1.0)
    ratio = numerator / denominator if denominator else 0.0
    if not 0 < ratio < math.inf:
        raise InputError(f"{option}: need a number > 0 such as 1/10, 0.1 or 10, got {as_written(text)}")
    return ratio


def read_stiffnesses(option: str, text: str) -> list[float]:
    """Read stiffnesses such as "10 N/cm" or "10..60 N/cm step 10", N/m.

    Raises:
        InputError: the text is neither a value nor a range, or a value is not > 0.
    """
    from forficula.design.section import STIFFNESS
    from forficula.study.factors import range_values

    texts = range_values(option, text) if ".." in text else (text,)
    values = [read_quantity(option, value, STIFFNESS) for value in texts]
    if min(values) <= 0:
        raise InputError(f'{option}: need > 0, got "{text}"')
    return values


def read_shard(text: str) -> tuple[int, int]:
    """Read a shard such as "2/8": its number, from 1, and the number of shards.

    Raises:
        InputError: the text is not a shard.
    """
    number, slash, count = text.partition("/")
    if slash and _WHOLE.fullmatch(number) and _WHOLE.fullmatch(count) and 1 <= int(number) <= int(count):
        return int(number), int(count)
    raise InputError(f"--shard: need a number and a count such as 2/8, got {as_written(text)}")


def check_apart(option: str, is_used: bool, others: Mapping[str, bool]) -> None:
    """Refuse options that have no meaning together with another option.

    Args:
        option: name of the option.
        is_used: whether the option is used.
        others: options that have no meaning with it, and whether each is used.

    Raises:
        InputError: one of the others is used with the option.
    """
    if is_used and (conflicting := [other for other, used in others.items() if used]):
        raise InputError(f"{option}: cannot be used with {listed(conflicting)}; leave one of them out")


def check_folder(folder: Path, kind: str) -> None:
    """Refuse an unusable output folder before the work starts, and restore a folder whose command was killed.

    Args:
        folder: output folder of a command.
        kind: kind of its results, a name of `forficula.results`.

    Raises:
        InputError: the folder cannot be made or written, or contains results of another kind that would be replaced.
    """
    from forficula.files import check_writable, clear_leftovers
    from forficula.results import check_own_kind

    try:
        existing = next(path for path in (folder, *folder.parents, Path()) if path.exists())
    except OSError as error:
        raise InputError(f"--out: {folder}: {error.strerror}") from None
    if not existing.is_dir():
        raise InputError(f"--out: need a folder, got the file {existing}")
    read_option("--out", lambda: check_writable(folder))
    clear_leftovers(folder)
    read_option("--out", lambda: check_own_kind(folder, kind))


def note_replaced(folder: Path, kind: str, remaining: str = "") -> None:
    """Report on standard error which earlier results a command will replace.

    Args:
        folder: output folder.
        kind: kind of the new results, a name of `forficula.results`.
        remaining: what is kept, such as "; the rows are kept".
    """
    from forficula.results import replaced_text

    if replaced := replaced_text(folder, kind):
        note(f"{folder}: replaces {replaced}{remaining}")


def finish_folder(folder: Path, kind: str, *, show: bool = False) -> None:
    """Report where the results are, set their JSON as the result of the command, and open their page if requested.

    Args:
        folder: folder of the results.
        kind: kind of the results, a name of `forficula.results`.
        show: whether to open the page.
    """
    from forficula.results import json_file

    set_result(folder / json_file(kind))
    end_with_page(folder, show=show)


def end_with_page(folder: Path, *, show: bool = False) -> None:
    """End the output with the folder of the results and their page; open the page if requested."""
    page = folder / ("parts.html" if (folder / "bill.json").is_file() else "report.html")
    end_with(f"\nwritten to {folder}; open {page}" if page.is_file() else f"\nwritten to {folder}")
    if show and page.is_file():
        import webbrowser

        webbrowser.open(page.resolve().as_uri())


def read_unit(unit: str | None, name: str) -> float | None:
    """Return the length of one unit of a drawing, m; None without the option.

    Args:
        unit: value of the option.
        name: name or path of the design.

    Raises:
        InputError: the text is not a length > 0, or the design is not a FOLD file or a drawing.
    """
    from forficula.design.section import LENGTH
    from forficula.pattern import PATTERN_FILES

    if unit is None:
        return None
    if Path(name).suffix.lower() not in PATTERN_FILES:
        raise InputError(f"--unit: a design already has units, got {as_written(unit)}")
    length = read_quantity("--unit", unit, LENGTH)
    if not length > 0:
        raise InputError(f"--unit: need > 0, got {as_written(unit)}")
    return length


def read_design(name: str, settings: Sequence[str] | None, unit: str | None) -> Design:
    """Return the design of a name or path, with the values of `--set` and the unit of a drawing.

    Raises:
        InputError: the design does not exist, or a value is not allowed.
    """
    from forficula.design import load_design
    from forficula.pattern.files.pattern_file import PATTERN_FILES, read_pattern

    length = read_unit(unit, name)
    with nullcontext() if length is None else options_named(unit="--unit"):
        chosen = load_design(name, read_settings(settings), unit=length)
    if Path(name).suffix.lower() in PATTERN_FILES:
        from forficula.pattern.files.fold_frame import CHOSEN_UNIT

        for remark in read_pattern(name, length, choose_unit=True)[1]:
            if remark != CHOSEN_UNIT:  # a warning
                note(f"{name}: {remark}")
    return chosen


def on_device(design: Design, device: str | None) -> Design:
    """Return a design that is simulated on the device of an option; unchanged without the option.

    Raises:
        InputError: this computer does not have the device.
    """
    from forficula.design import with_values
    from forficula.dynamics import check_available

    if device is None:
        return design
    placed = with_values(design, {"protocol.device": device})
    if placed.protocol.device is not None:
        check_available(placed.protocol.device)
    return placed


def read_settings(
    settings: Sequence[str] | None, option: str = "--set", example: str = 'tendon.stiffness="20 N/cm"'
) -> dict[str, object]:
    """Read KEY=VALUE texts into values by dotted key: TOML where the value is TOML, else text with a unit.

    Raises:
        InputError: a text is not of this form, or a key is repeated.
    """
    import tomllib

    values: dict[str, object] = {}
    for key, text in setting_texts(settings, option, example).items():
        try:
            values[key] = tomllib.loads(f"value = {text}")["value"]
        except (ValueError, RecursionError):  # not TOML, or a number too long or a list too deep for the parser
            values[key] = text
    return values


def setting_texts(
    settings: Sequence[str] | None, option: str = "--set", example: str = 'tendon.stiffness="20 N/cm"'
) -> dict[str, str]:
    """Read KEY=VALUE texts into texts by dotted key.

    Raises:
        InputError: a text is not of this form, or a key is repeated.
    """
    texts: dict[str, str] = {}
    for setting in settings or ():
        if re.search("[\ud800-\udfff]", setting):
            raise InputError(f"{option}: need text in UTF-8, got {as_written(setting)}")
        key, equals, text = (part.strip() for part in setting.partition("="))
        if not equals or not key:
            raise InputError(f"{option}: need KEY=VALUE such as {example}, got {as_written(setting)}")
        if key in texts:
            raise InputError(f"{option}: {key} is given twice")
        texts[key] = text
    return texts

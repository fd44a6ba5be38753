"""What options of the command line mean."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeVar

from cyclopts import Parameter, Token

from forficula.errors import InputError, error_prefix
from forficula.names import listed, one_of
from forficula.quantities import as_written
from forficula.terminal import came_to, remark

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
    """Take a whole number as one: a fraction would otherwise be rounded without a word."""
    (token,) = tokens
    if not re.fullmatch(rf"[+-]?{_WHOLE.pattern}", token.value):
        few = " of at most 18 digits" if re.fullmatch("[+-]?[0-9]+", token.value) else ""
        raise InputError(f"need a whole number{few}, got {as_written(token.value)}")
    return int(token.value)


# of every option that takes a whole number
WHOLE_NUMBER = Parameter(converter=_whole_number)
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set", help='Replace a value, as in --set tendon.stiffness="20 N/cm"; may be repeated.', negative=()
    ),
]


def _read_out(_: object, tokens: Sequence[Token]) -> Path:
    # as a path it would be the current folder
    if not tokens[0].value:
        raise InputError("need the name of a file or a folder, got an empty text")
    return Path(tokens[0].value)


Out = Annotated[Path, Parameter(converter=_read_out)]
OutIfGiven = Annotated[Path | None, Parameter(converter=_read_out)]
NoEngine = Annotated[
    bool, Parameter(negative=(), help="Leave the simulator, 3.5 MB, out of report.html: it then only plays.")
]
Tolerate = Annotated[
    bool,
    Parameter(help="End with status 0, not 3, where a run diverged or is not to be trusted.", negative=()),
]
OkIf = Annotated[
    list[str] | None,
    Parameter(
        name="--ok-if",
        help="End with status 0 where this is the verdict, such as stuck, and no other; may be repeated.",
        negative=(),
    ),
]
DesignName = Annotated[
    str, Parameter(help="A named design, or the path of a design file (.toml), a FOLD file or a drawing (.svg, .dxf).")
]
Dask = Annotated[str | None, Parameter(help="Run on the Dask cluster with this scheduler, as in tcp://scheduler:8786.")]
DrawingUnit = Annotated[
    str | None, Parameter(help='Length of one unit of a FOLD file or a drawing that names none, as in "1 cm".')
]


def exit_status(verdicts: Iterable[Verdict], *, tolerate: bool, ok_if: Sequence[str] | None = None) -> int:
    """What a command ends with that was carried out, for scripts.

    Args:
        verdicts: of the runs that it was asked for.
        tolerate: whether what diverged, is undecided or is not to be trusted counts as done.
        ok_if: verdicts that are wanted, and no others; `Verdict.REACHED` where none are named.

    Returns:
        0 where every verdict is wanted, 2 where one is not, 3 where one run says nothing of its structure.
    """
    silent, wanted = ("diverged", "untrusted", "undecided"), tuple(ok_if or ("reached",))
    told = [verdict for verdict in verdicts if not (tolerate and verdict in silent)]
    if any(verdict in silent and verdict not in wanted for verdict in told):
        return 3
    return 0 if all(verdict in wanted for verdict in told) else 2


def check_verdicts(ok_if: Sequence[str] | None) -> None:
    """Refuse what is no verdict of a run.

    Raises:
        InputError: which is none, and which is near.
    """
    from forficula.analysis import Verdict

    words = [verdict.value for verdict in Verdict]
    for word in ok_if or ():
        if word not in words:
            raise InputError(f"--ok-if: need {one_of(words, word)}")


def read_option(option: str, read: Callable[[], T]) -> T:
    """Read an option; an error begins with it.

    Raises:
        InputError: what `read` raises.
    """
    with error_prefix(f"{option}: "):
        return read()


def read_quantity(option: str, text: object, unit: Unit) -> float:
    """The value of an option in SI.

    Raises:
        InputError: it is no quantity of that unit's kind.
    """
    from forficula.quantities import parse_quantity

    return read_option(option, lambda: parse_quantity(text, unit))


def read_size(option: str, text: str, smallest: int, largest: int) -> tuple[int, int]:
    """Turn "1280x720" into pixels across and upwards.

    Raises:
        InputError: it is no such text, or a number is odd, which films cannot have, or out of bounds.
    """
    across, times, upwards = text.partition("x")
    if times and _WHOLE.fullmatch(across) and _WHOLE.fullmatch(upwards):
        size = int(across), int(upwards)
        if all(smallest <= each <= largest and each % 2 == 0 for each in size):
            return size
    rule = f"two even numbers from {smallest} to {largest} such as 1280x720"
    raise InputError(f'{option}: need {rule}, got "{text}"')


def read_ratio(option: str, text: str) -> float:
    """Turn "1/10", "0.1" or "10" into a number.

    Raises:
        InputError: it is no such text, or not > 0 and finite.
    """
    found = _RATIO.fullmatch(text.strip())
    over, under = (float(found[1]), float(found[2] or 1)) if found else (0.0, 1.0)
    ratio = over / under if under else 0.0
    if not 0 < ratio < math.inf:
        raise InputError(f"{option}: need a number > 0 such as 1/10, 0.1 or 10, got {as_written(text)}")
    return ratio


def read_stiffnesses(option: str, text: str) -> list[float]:
    """Turn "10 N/cm" or "10..60 N/cm step 10" into N/m.

    Raises:
        InputError: it is neither, or not > 0.
    """
    from forficula.design.section import STIFFNESS
    from forficula.study.factors import range_values

    texts = range_values(option, text) if ".." in text else (text,)
    values = [read_quantity(option, each, STIFFNESS) for each in texts]
    if min(values) <= 0:
        raise InputError(f'{option}: need > 0, got "{text}"')
    return values


def read_shard(text: str) -> tuple[int, int]:
    """Turn "2/8" into (2, 8).

    Raises:
        InputError: it is no such text.
    """
    number, slash, count = text.partition("/")
    if slash and _WHOLE.fullmatch(number) and _WHOLE.fullmatch(count) and 1 <= int(number) <= int(count):
        return int(number), int(count)
    raise InputError(f"--shard: need a number and a count such as 2/8, got {as_written(text)}")


def check_apart(option: str, given: bool, others: Mapping[str, bool]) -> None:
    """Refuse options beside one that leaves them without a meaning.

    Args:
        option: the one.
        given: whether it is given.
        others: the options that mean nothing beside it, and whether each of them is given.

    Raises:
        InputError: one of them is given with it, and which.
    """
    if given and (beside := [other for other, there in others.items() if there]):
        raise InputError(f"{option}: cannot be used with {listed(beside)}; leave one of them out")


def check_folder(folder: Path, own: str) -> None:
    """Refuse a folder for results before a run that takes a while, and restore what a killed one left of it.

    Args:
        folder: where a command will write.
        own: kind of its results, of `forficula.results`.

    Raises:
        InputError: it cannot be made or written, or holds results of another kind, of which some would be replaced.
    """
    from forficula.files import check_writable, clear_leftovers
    from forficula.results import check_own_kind

    try:
        there = next(place for place in (folder, *folder.parents, Path()) if place.exists())
    except OSError as error:
        raise InputError(f"--out: {folder}: {error.strerror}") from None
    if not there.is_dir():
        raise InputError(f"--out: need a folder, got the file {there}")
    read_option("--out", lambda: check_writable(folder))
    clear_leftovers(folder)
    read_option("--out", lambda: check_own_kind(folder, own))


def tell_replaced(folder: Path, what: str, left: str = "") -> None:
    """Say on stderr which earlier results a command is about to replace, where there are any.

    Args:
        folder: where it will write.
        what: kind of these results, of `forficula.results`.
        left: what stays, such as "; the rows stay".
    """
    from forficula.results import replaced_text

    if replaced := replaced_text(folder, what):
        remark(f"{folder}: replaces {replaced} there{left}")


def tell_written(folder: Path, kind: str) -> None:
    """Say where results were written, and hand their JSON on.

    Args:
        folder: of the results.
        kind: of them, of `forficula.results`.
    """
    from forficula.results import json_file

    came_to(folder / json_file(kind))
    print(f"\nwritten to {folder}")


def read_unit(unit: str | None) -> float | None:
    """The length of one unit of a drawing, m; None where it is not given.

    Raises:
        InputError: no length.
    """
    from forficula.design.section import LENGTH

    return None if unit is None else read_quantity("--unit", unit, LENGTH)


def read_design(name: str, settings: Sequence[str] | None, unit: str | None) -> Design:
    """The design of a name or a path, with the values of `--set` and the unit of a drawing.

    Raises:
        InputError: no such design, or one of its values is none.
    """
    from forficula.design import load_design

    length = read_unit(unit)
    return load_design(name, read_settings(settings), unit=length)


def read_settings(
    settings: Sequence[str] | None, option: str = "--set", example: str = 'tendon.stiffness="20 N/cm"'
) -> dict[str, object]:
    """Turn key=value texts into values by dotted key: TOML where they are TOML, text with a unit otherwise.

    Raises:
        InputError: one is no such text.
    """
    import tomllib

    values: dict[str, object] = {}
    for key, text in setting_texts(settings, option, example).items():
        try:
            values[key] = tomllib.loads(f"value = {text}")["value"]
        except (ValueError, RecursionError):  # not TOML, or too long a number or too deep a list for it
            values[key] = text
    return values


def setting_texts(
    settings: Sequence[str] | None, option: str = "--set", example: str = 'tendon.stiffness="20 N/cm"'
) -> dict[str, str]:
    """Turn key=value texts into texts by dotted key.

    Raises:
        InputError: one is no such text, or a key is given twice.
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

"""What options of the command line mean."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from forficula.errors import InputError

if TYPE_CHECKING:
    from forficula.quantities import Unit

T = TypeVar("T")


def read_option(option: str, read: Callable[[], T]) -> T:
    """Read an option; an error begins with it.

    Raises:
        InputError: what `read` raises.
    """
    try:
        return read()
    except InputError as error:
        raise InputError(f"{option}: {error}") from None


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
    if times and across.isdecimal() and upwards.isdecimal():
        size = int(across), int(upwards)
        if all(smallest <= each <= largest and each % 2 == 0 for each in size):
            return size
    rule = f"two even numbers from {smallest} to {largest} such as 1280x720"
    raise InputError(f'{option}: need {rule}, got "{text}"')


def read_stiffnesses(option: str, text: str) -> list[float]:
    """Turn "10 N/cm" or "10..60 N/cm step 10" into N/m.

    Raises:
        InputError: it is neither, or not > 0.
    """
    from forficula.design.part import STIFFNESS
    from forficula.study.factors import range_values

    key = "tendon.stiffness"
    try:
        texts = range_values(key, text) if ".." in text else (text,)
    except InputError as error:
        raise InputError(str(error).replace(key, option, 1)) from None
    values = [read_quantity(option, each, STIFFNESS) for each in texts]
    if min(values) <= 0:
        raise InputError(f'{option}: need > 0, got "{text}"')
    return values

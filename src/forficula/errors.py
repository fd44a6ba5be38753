"""The exception for invalid input."""

from collections.abc import Iterator
from contextlib import contextmanager


class InputError(ValueError):
    """Invalid input of the user; the message is one line that names the key, the rule and the value."""


@contextmanager
def error_prefix(prefix: str) -> Iterator[None]:
    """Put a text, such as a file or a key, before the message of every `InputError` that is raised inside the block.

    Raises:
        InputError: the error of the block, with the prefix.
    """
    try:
        yield
    except InputError as error:
        raise InputError(f"{prefix}{error}") from None

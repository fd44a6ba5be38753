"""The one exception for input that cannot be used."""

from collections.abc import Iterator
from contextlib import contextmanager


class InputError(ValueError):
    """What the user gave cannot be used; the message is one line that names the key, the rule and the value."""


@contextmanager
def error_prefix(prefix: str) -> Iterator[None]:
    """Put a text before the message of whatever input is refused inside, as the file or the key that it is about.

    Raises:
        InputError: what is refused.
    """
    try:
        yield
    except InputError as error:
        raise InputError(f"{prefix}{error}") from None

"""Restrict which files a design may name while it is read for somebody else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path

from forficula.errors import InputError
from forficula.quantities import as_written


@dataclass(frozen=True)
class _Rule:
    allows: Callable[[Path], bool]
    reason: str


_rule: ContextVar[_Rule | None] = ContextVar("rule", default=None)


@contextmanager
def reading_only(allows: Callable[[Path], bool], reason: str) -> Iterator[None]:
    """Read only some files: designs, laws and sheets of other paths are refused before anything looks at them.

    The rule is a context variable, not an argument, because a law is read deep inside the validation of a design. A
    reader that forgets to pass an argument on would open every file.

    Args:
        allows: returns whether the file of a path may be read.
        reason: reason for a refusal, which follows the path in the error message.
    """
    token = _rule.set(_Rule(allows, reason))
    try:
        yield
    finally:
        _rule.reset(token)


def may_read(path: Path) -> bool:
    """Return whether the rule in force, if any, allows a file to be read."""
    rule = _rule.get()
    return rule is None or rule.allows(path)


def check_may_read(path: Path) -> None:
    """Refuse a file that the rule in force does not allow; the error is the same whether or not the file exists.

    Raises:
        InputError: the file may not be read.
    """
    rule = _rule.get()
    if rule is not None and not rule.allows(path):
        shown = str(path) if str(path).isprintable() else as_written(str(path))
        raise InputError(f"{shown}: {rule.reason}")

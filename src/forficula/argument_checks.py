"""Arguments of public functions, checked by their annotations before anything is done with them."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, wraps
from inspect import Parameter, Signature, signature
from typing import ParamSpec, TypeVar

from forficula.errors import InputError
from forficula.quantities import as_written, plain_value

P = ParamSpec("P")
R = TypeVar("R")


@dataclass(frozen=True, kw_only=True)
class _Accepted:
    """What an annotation allows.

    Attributes:
        word: one of them, as errors say it; empty for what errors need not say.
        many: several of them.
        holds: whether a value is one of them.
    """

    word: str
    many: str
    holds: Callable[[object], bool]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _is_list(value: object) -> bool:
    """A list, a tuple, an array: no text and no table, which are sequences to Python, too."""
    counted = hasattr(value, "__len__") and hasattr(value, "__getitem__") and isinstance(value, Iterable)
    return counted and not isinstance(value, str | bytes | bytearray | Mapping)


def _accepted(word: str, many: str, holds: Callable[[object], bool]) -> _Accepted:
    return _Accepted(word=word, many=many, holds=holds)


_ANYTHING = _accepted("", "", lambda _: True)
_FUNCTION = _accepted("a function", "functions", callable)
_PATH = _accepted("a path", "paths", lambda value: isinstance(value, str | os.PathLike))
_TEXT = _accepted("text", "texts", lambda value: isinstance(value, str))
_TABLE = _accepted("a table of values by key", "tables", lambda value: isinstance(value, Mapping))
# by the last part of their names; the names of ours are aliases, which exist for type checkers only
_KNOWN = {
    "None": _accepted("", "", lambda value: value is None),
    "object": _ANYTHING,
    "Any": _ANYTHING,
    "str": _TEXT,
    "Kind": _TEXT,
    "PartName": _TEXT,
    "int": _accepted("a whole number", "whole numbers", _is_whole),
    "float": _accepted("a number", "numbers", _is_number),
    "bool": _accepted("True or False", "True or False", lambda value: isinstance(value, bool)),
    "Path": _accepted("a path", "paths", lambda value: isinstance(value, os.PathLike)),
    "PathLike": _accepted("a path", "paths", lambda value: isinstance(value, os.PathLike)),
    "AnyPath": _PATH,
    "Mapping": _TABLE,
    "dict": _TABLE,
    "Callable": _FUNCTION,
    "Progress": _FUNCTION,
    "Building": _FUNCTION,
    "Evaluate": _FUNCTION,
}
# what gives a user an object of a class
_GIVEN_BY = {
    "CreasePattern": "earwig_pattern or read_fold",
    "Cycle": "find_cycles",
    "Design": "load_design",
    "EnergyLandscape": "energy_landscape",
    "Frame": "read_folded_frames",
    "Goal": "load_goal",
    "MaterialLaw": "load_law",
    "Observations": "load_observations",
    "PartSet": "make_parts",
    "Record": "run or load_record",
    "Structure": "structure_of",
    "Study": "load_study or new_study",
    "TensileTest": "read_tensile_test",
}


def checked(function: Callable[P, R], name: str) -> Callable[P, R]:
    """The function, which first refuses arguments of other types than it is annotated with.

    Numbers of numpy, 0-d arrays among them, are handed on as Python's. What a value must be beyond its type the
    function says itself.

    Args:
        function: public, of a module whose annotations are text.
        name: by which the package offers it, and by which it is pickled.
    """

    @wraps(function)
    def first_checked(*arguments: P.args, **options: P.kwargs) -> R:
        own = _signature(function)
        try:
            bound = own.bind(*arguments, **options)
        except TypeError:
            return function(*arguments, **options)  # of too many or too few Python says which
        for key, value in bound.arguments.items():
            accepted = _by_annotation(own.parameters[key].annotation)
            if own.parameters[key].kind in (Parameter.VAR_KEYWORD, Parameter.VAR_POSITIONAL):
                continue
            plain = value if accepted.holds(value) else plain_value(value)
            if not accepted.holds(plain):
                raise InputError(f"{key}: need {accepted.word}, got {_shown(value)}")
            bound.arguments[key] = plain
        return function(*bound.args, **bound.kwargs)

    first_checked.__module__, first_checked.__qualname__ = __name__.partition(".")[0], name
    return first_checked


@cache
def _signature(function: Callable[..., object]) -> Signature:
    return signature(function)


@cache
def _by_annotation(annotation: object) -> _Accepted:
    """What an annotation allows, as a module with `from __future__ import annotations` has it."""
    return _read(ast.parse(annotation, mode="eval").body) if isinstance(annotation, str) else _ANYTHING


def _read(node: ast.expr) -> _Accepted:
    match node:
        case ast.BinOp():
            return _any_of(_alternatives(node))
        case ast.Constant(value=str(text)):
            return _read(ast.parse(text, mode="eval").body)
        case ast.Constant(value=None):
            return _KNOWN["None"]
        case ast.Subscript(value=ast.Name(id="Sequence" | "Iterable" as kind), slice=inner):
            return _list_of(_read(inner), lazy=kind == "Iterable")
        case ast.Subscript(value=ast.Name(id="Literal"), slice=ast.Tuple(elts=words)):
            word = " or ".join(as_written(each.value) for each in words if isinstance(each, ast.Constant))
            return _accepted(word, word, _TEXT.holds)  # the function names the nearest one
        case ast.Subscript(value=ast.Name(id="tuple")):
            return _accepted("a list", "lists", _is_list)
        case ast.Subscript(value=kind):
            return _read(kind)
        case ast.Attribute(attr=name) | ast.Name(id=name):
            return _named(name)
    return _ANYTHING


def _named(name: str) -> _Accepted:
    if name == "AnyDesign":
        design = _named("Design")
        word = "a design, its name or the path of its file"
        return _accepted(word, "designs", lambda value: _PATH.holds(value) or design.holds(value))
    if name in _KNOWN:
        return _KNOWN[name]
    article = "an" if name[0] in "AEIOU" else "a"
    given = f" (as {_GIVEN_BY[name]} returns it)" if name in _GIVEN_BY else ""
    # by name: what a class is imported from may take a second
    return _accepted(
        f"{article} {name}{given}",
        f"objects of class {name}{given.replace(' it', ' them')}",
        lambda value: any(each.__name__ == name for each in type(value).__mro__),
    )


def _alternatives(node: ast.expr) -> list[_Accepted]:
    """What is allowed on both sides of every |."""
    if isinstance(node, ast.BinOp):
        return [*_alternatives(node.left), *_alternatives(node.right)]
    return [_read(node)]


def _any_of(every: list[_Accepted]) -> _Accepted:
    # a path may be text, and what is not given need not be named
    paths = any(each.word == _PATH.word for each in every)
    told = [each for each in every if each.word and not (each is _TEXT and paths)]
    words, many = (list(dict.fromkeys(names)) for names in zip(*((each.word, each.many) for each in told), strict=True))
    return _accepted(" or ".join(words), " or ".join(many), lambda value: any(each.holds(value) for each in every))


def _list_of(entry: _Accepted, *, lazy: bool) -> _Accepted:
    """A list; the entries of what is made while it is read are left to the function."""

    def holds(value: object) -> bool:
        if lazy and isinstance(value, Iterable) and not hasattr(value, "__len__"):
            return True
        return _is_list(value) and all(entry.holds(each) or entry.holds(plain_value(each)) for each in value)  # type: ignore[attr-defined]

    of = f" of {entry.many}" if entry.many else ""
    return _accepted(f"a list{of}", f"lists{of}", holds)


def _shown(value: object) -> str:
    """A value with its type, in a line."""
    written = as_written(value) if isinstance(value, str | bool | int | float | list | tuple | dict) else ""
    kind = type(value).__name__
    if value is None:
        return "None"
    return f"{written} ({kind})" if written else f"an object of class {kind}"

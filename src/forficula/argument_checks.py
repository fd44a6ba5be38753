"""Check of the arguments of public functions by their annotations, before the function is called."""

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
    """Values that an annotation allows.

    Attributes:
        word: name of one such value in errors; empty if errors need not name it.
        many: name of several.
        holds: returns whether a value is allowed.
    """

    word: str
    many: str
    holds: Callable[[object], bool]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _is_list(value: object) -> bool:
    """Return whether a value is a list, tuple or array: not text or a table, which are also sequences in Python."""
    counted = hasattr(value, "__len__") and hasattr(value, "__getitem__") and isinstance(value, Iterable)
    return counted and not isinstance(value, str | bytes | bytearray | Mapping)


def _accepted(word: str, many: str, holds: Callable[[object], bool]) -> _Accepted:
    return _Accepted(word=word, many=many, holds=holds)


_ANYTHING = _accepted("", "", lambda _: True)
_FUNCTION = _accepted("a function", "functions", callable)
_PATH = _accepted("a path", "paths", lambda value: isinstance(value, str | os.PathLike))
_TEXT = _accepted("text", "texts", lambda value: isinstance(value, str))
_TABLE = _accepted("a table of values by key", "tables", lambda value: isinstance(value, Mapping))
# by the last part of a name in an annotation; those of forficula are aliases, which exist for type checkers only
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
    "ProgressOption": _accepted(
        "a function, True, False or None",
        "functions",
        lambda value: value is None or isinstance(value, bool) or callable(value),
    ),
    "Building": _FUNCTION,
    "Frame": _accepted(
        "a frame, which is a title, positions and fold angles",
        "frames, each a title, positions and fold angles",
        _is_list,
    ),
    "Evaluate": _FUNCTION,
}
# function that returns an object of a class, as users call it
_GIVEN_BY = {
    "CreasePattern": "pattern.earwig_pattern or pattern.read_fold",
    "Cycle": "material.find_cycles",
    "Design": "load_design",
    "EnergyLandscape": "landscape",
    "Generator": "numpy.random.default_rng",
    "Goal": "load_goal",
    "MaterialLaw": "material.load_law",
    "Observations": "load_observations",
    "PartSet": "make.parts",
    "Record": "load_record",
    "Run": "run or load_run",
    "Structure": "structure_of",
    "Study": "load_study or new_study",
    "TensileTest": "material.read_tensile_test",
}


def checked(function: Callable[P, R], name: str, package: str = "forficula") -> Callable[P, R]:
    """Return the function with a check of its arguments: those of another type than annotated are refused.

    Numbers of numpy, including 0-d arrays, are passed on as Python's. The function itself checks everything beyond the
    type.

    Args:
        function: public function of a module whose annotations are text.
        name: public name, by which the function is pickled.
        package: package that has the name.
    """

    @wraps(function)
    def first_checked(*arguments: P.args, **options: P.kwargs) -> R:
        expected = _signature(function)
        try:
            bound = expected.bind(*arguments, **options)
        except TypeError:
            return function(*arguments, **options)  # Python reports too many or too few arguments
        for key, value in bound.arguments.items():
            accepted = _by_annotation(expected.parameters[key].annotation)
            if expected.parameters[key].kind in (Parameter.VAR_KEYWORD, Parameter.VAR_POSITIONAL):
                continue
            plain = value if accepted.holds(value) else plain_value(value)
            if not accepted.holds(plain):
                raise InputError(f"{key}: need {accepted.word}, got {_shown(value)}")
            bound.arguments[key] = plain
        return function(*bound.args, **bound.kwargs)

    first_checked.__module__, first_checked.__qualname__ = package, name
    return first_checked


@cache
def _signature(function: Callable[..., object]) -> Signature:
    return signature(function)


@cache
def _by_annotation(annotation: object) -> _Accepted:
    """Return what an annotation allows, given as text (`from __future__ import annotations`)."""
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
            word = " or ".join(as_written(word.value) for word in words if isinstance(word, ast.Constant))
            return _accepted(word, word, _TEXT.holds)  # the function itself names the nearest word
        case ast.Subscript(value=ast.Name(id="tuple")):
            return _accepted("a list", "lists", _is_list)
        case ast.Subscript(value=kind):
            return _read(kind)
        case ast.Attribute(attr=name) | ast.Name(id=name):
            return _named(name)
    return _ANYTHING


def _named(name: str) -> _Accepted:
    if name == "AnyRun":
        run, record = _named("Run"), _named("Record")
        word = "a run (as run or load_run returns it), its record, or a path"
        return _accepted(
            word, "runs or paths", lambda value: _PATH.holds(value) or run.holds(value) or record.holds(value)
        )
    if name == "AnyDesign":
        design = _named("Design")
        word = "a design, its name or the path of its file"
        return _accepted(word, "designs", lambda value: _PATH.holds(value) or design.holds(value))
    if name in _KNOWN:
        return _KNOWN[name]
    article = "an" if name[0] in "AEIOU" else "a"
    provided = f" (as {_GIVEN_BY[name]} returns it)" if name in _GIVEN_BY else ""
    # by name, because importing the class may take a second
    return _accepted(
        f"{article} {name}{provided}",
        f"objects of class {name}{provided.replace(' it', ' them')}",
        lambda value: any(item.__name__ == name for item in type(value).__mro__),
    )


def _alternatives(node: ast.expr) -> list[_Accepted]:
    """Return what is allowed on each side of every |."""
    if isinstance(node, ast.BinOp):
        return [*_alternatives(node.left), *_alternatives(node.right)]
    return [_read(node)]


def _any_of(every: list[_Accepted]) -> _Accepted:
    # a path may be text, and None need not be named
    paths = any(item.word == _PATH.word for item in every)
    named = [item for item in every if item.word and not (item is _TEXT and paths)]
    words, many = (
        list(dict.fromkeys(names)) for names in zip(*((item.word, item.many) for item in named), strict=True)
    )
    return _accepted(" or ".join(words), " or ".join(many), lambda value: any(item.holds(value) for item in every))


def _list_of(entry: _Accepted, *, lazy: bool) -> _Accepted:
    """Return what a list of entries allows; the function itself checks the entries of a generator."""

    def holds(value: object) -> bool:
        if lazy and isinstance(value, Iterable) and not hasattr(value, "__len__"):
            return True
        return _is_list(value) and all(entry.holds(item) or entry.holds(plain_value(item)) for item in value)  # type: ignore[attr-defined]

    of = f" of {entry.many}" if entry.many else ""
    return _accepted(f"a list{of}", f"lists{of}", holds)


def _shown(value: object) -> str:
    """Return a value with its type, in one line."""
    written = as_written(value) if isinstance(value, str | bool | int | float | list | tuple | dict) else ""
    kind = type(value).__name__
    if value is None:
        return "None"
    return f"{written} ({kind})" if written else f"an object of class {kind}"

"""Public names of a package: imported at first use, with arguments checked, and old names that warn."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Callable, Collection, Mapping
from importlib import import_module
from pathlib import Path
from types import FunctionType
from typing import Any, NamedTuple


class OldName(NamedTuple):
    """Deprecated name of a package.

    Attributes:
        place: module and attribute that the name still gives, as "module:attribute".
        instead: expression that replaces the name, for the warning.
    """

    place: str
    instead: str


def public_names(
    package: str,
    file: str,
    *,
    public: Collection[str] | None = None,
    old: Mapping[str, OldName] | None = None,
) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return `__getattr__`, `__dir__` and `__all__` of a package whose names are in its stub `__init__.pyi`.

    Args:
        package: name of the package.
        file: path of its `__init__.py`.
        public: names that are listed, and whose functions check their arguments; all names of the stub if not given.
            The other names of the stub are for other modules of forficula.
        old: deprecated names, which are not listed.
    """
    places = _places(package, Path(file).with_suffix(".pyi"))
    listed = sorted(places if public is None else public)

    def get(name: str) -> Any:
        if name in places:
            value = _imported(places[name])
            if name in listed:
                value = _checked(value, name, package)
            # the next use finds it without this function
            vars(import_module(package))[name] = value
            return value
        if old is not None and name in old:
            warnings.warn(
                f"{package}.{name} is deprecated, the next minor version removes it: use {old[name].instead}",
                DeprecationWarning,
                stacklevel=2,
            )
            return _checked(_imported(old[name].place), name, package)
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return get, lambda: listed, listed


def _places(package: str, stub: Path) -> dict[str, str]:
    """Return by name the module and attribute that a stub imports it from; a module has no attribute."""
    places = {}
    for node in ast.parse(stub.read_text("utf-8")).body:
        if not isinstance(node, ast.ImportFrom):
            continue
        module = f"{package}.{node.module}" if node.level and node.module else node.module or package
        for alias in node.names:
            place = f"{module}.{alias.name}:" if node.module is None else f"{module}:{alias.name}"
            places[alias.asname or alias.name] = place
    return places


def _checked(value: Any, name: str, package: str) -> Any:
    """Return a function with a check of its arguments; other values as they are."""
    if not isinstance(value, FunctionType):
        return value
    from forficula.argument_checks import checked

    return checked(value, name, package)


def _imported(place: str) -> Any:
    module, _, attribute = place.partition(":")
    return getattr(import_module(module), attribute) if attribute else import_module(module)

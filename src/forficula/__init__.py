"""Predict and design bistable folding structures.

import forficula as ff

record = ff.run("binder2025")
outcome = ff.measure(record)
"""

from importlib import metadata
from types import FunctionType

import lazy_loader

# the public names stand in __init__.pyi, once
_public, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    value = _public(name)
    if isinstance(value, FunctionType):
        from forficula.argument_checks import checked

        value = globals()[name] = checked(value, name)
    return value


__version__ = metadata.version("forficula")

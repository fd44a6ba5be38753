"""Libraries that only some results need, imported at their first use."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from forficula.errors import InputError


def optional_module(name: str, needs: str, package: str, instead: str = "") -> Any:
    """Import a library that may not be installed.

    Args:
        name: module to import.
        needs: what needs which library, such as "vtk needs meshio", for the error message.
        package: argument of pip that installs the library, such as "forficula[export]".
        instead: what else can be done, such as "or save the sheet as .csv".

    Raises:
        InputError: it is not installed; the message says how to install it.
    """
    try:
        return import_module(name)
    except ImportError:
        # square brackets mean something to shells
        quoted = f'"{package}"' if "[" in package else package
        raise InputError(f"{needs}: pip install {quoted}{f'; {instead}' if instead else ''}") from None

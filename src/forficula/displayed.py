"""What notebooks show of a result in place of its `repr`."""

from __future__ import annotations

from importlib import import_module


class Displayed:
    """Something that a notebook shows as HTML; how is up to `forficula.show.notebook`, which stands above it."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        return str(import_module("forficula.show.notebook").notebook_html(self))

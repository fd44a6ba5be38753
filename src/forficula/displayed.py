"""HTML that notebooks show in place of the `repr` of a result."""

from __future__ import annotations

from importlib import import_module


class Displayed:
    """Result that a notebook shows as HTML, which `forficula.show.notebook` writes."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        return str(import_module("forficula.show.notebook").notebook_html(self))

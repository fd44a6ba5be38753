"""Figures of the gallery that pyplot does not manage: the figure that is the last expression of a block."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from weakref import WeakSet

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

_SHOWN: WeakSet[Figure] = WeakSet()


def save_figure(_: object, block_vars: Mapping[str, Any], gallery_conf: Mapping[str, Any]) -> str:
    """Save the value of the last expression of a block if it is a figure, and return the reST that shows it."""
    shown = block_vars["example_globals"].get("___")
    # the value remains until a later block ends with an expression
    if not isinstance(shown, Figure) or shown in _SHOWN or getattr(shown, "number", None) in _drawn():
        return ""
    _SHOWN.add(shown)
    path = next(block_vars["image_path_iterator"])
    shown.savefig(path, dpi=160)
    return str(figure_rst([path], gallery_conf["src_dir"]))


def _drawn() -> list[int]:
    """Return the numbers of the figures that pyplot manages, which the gallery shows already."""
    import matplotlib.pyplot as plt

    return plt.get_fignums()

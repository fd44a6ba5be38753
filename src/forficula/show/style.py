"""How figures look: sizes for a journal's page, colours that survive grey print and colour blindness."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from matplotlib import rc_context
from matplotlib.figure import Figure

from forficula.files import replacing

PAGE_WIDTH = 7.1  # inch, two columns of a journal

# Okabe and Ito 2008, Color Universal Design: eight colours told apart by all kinds of colour vision.
BLACK, ORANGE, SKY, GREEN, BLUE, VERMILION, PURPLE = (
    "#000000",
    "#E69F00",
    "#56B4E9",
    "#009E73",
    "#0072B2",
    "#D55E00",
    "#CC79A7",
)
LINE_STYLES = ("-", "--", "-.", ":")


@contextmanager
def figure_style() -> Iterator[None]:
    """Draw with small sans-serif text and thin axes."""
    with rc_context(
        {
            "font.family": "DejaVu Sans",
            "font.size": 8,
            "axes.labelsize": 8,
            "axes.titlesize": 8,
            "legend.fontsize": 7,
            "xtick.labelsize": 7,
            "ytick.labelsize": 7,
            "axes.linewidth": 0.6,
            "lines.linewidth": 1.2,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "legend.frameon": False,
        }
    ):
        yield


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure in the format of the file's ending.

    Raises:
        InputError: it cannot be written.
    """
    with replacing(path) as temporary:
        figure.savefig(temporary, dpi=200)

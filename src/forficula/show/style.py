"""How figures look and are kept: widths of a journal, colours that survive grey print and colour blindness, a text."""

from __future__ import annotations

import io
import textwrap
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from html import escape
from pathlib import Path
from typing import Any

from matplotlib import colormaps, rc_context, rcParams, rcParamsDefault
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.colors import Colormap, LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.legend import Legend

from forficula.errors import InputError
from forficula.files import write_bytes

COLUMN_WIDTH, PAGE_WIDTH = 3.5, 7.1  # inch, one and two columns of a journal
_RESOLUTION = 200  # dots per inch
_LEAST_LETTERS = 8  # of a line of a legend
_FILLED = 0.96  # of the room of a legend: at another resolution letters are a little wider
PICTURE_RESOLUTION = 400  # of pictures among lines, dots per inch: journals ask for 300 or more
COPY_ENDINGS = (".svg", ".pdf")
ENDINGS = (".png", *COPY_ENDINGS)
# of a results' folder, where the copies for papers lie
COPIES = "figures"

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
# The colours of quantities, each of which means the same in figures, maps, films and pages (web/src/scheme.js has the
# first two): lightness rises with the value, so that grey print and every kind of colour vision keep the order.
# Of every energy, stored or put in: viridis (Smith and van der Walt 2015) without its darkest end, which dark bars
# would swallow.
ENERGY_COLOURS = LinearSegmentedColormap.from_list(
    "energy", ["#453781", "#39568c", "#2d708e", "#20908d", "#29af7f", "#73d055", "#b8de29", "#fde725"]
)
# of every other quantity that a map shows, and of many lines in their order: cividis (Nunez, Anderton and Renslow 2018)
QUANTITY_COLOURS = colormaps["cividis"]
# of strains of a sheet, from as it was built on: from pale on, so that what it hides is told from it
STRAIN_COLOURS = colormaps["YlOrRd"]
LINE_STYLES = ("-", "--", "-.", ":")

# what rcParams say of windows and not of pictures
_OF_WINDOWS = ("backend", "interactive", "timezone", "tk.", "toolbar", "webagg.")

# Draws a figure at a width in inch.
Drawing = Callable[[float], Figure]


@contextmanager
def figure_style() -> Iterator[None]:
    """Draw with small sans-serif text and thin axes, whatever a matplotlibrc says."""
    with rc_context(
        {
            **_without_matplotlibrc(),
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
            # a name that a user gave may hold a dollar sign; we write no formulas
            "text.parse_math": False,
        }
    ):
        yield


def _without_matplotlibrc() -> Any:  # of many literal names, to type checkers
    """What matplotlib's own defaults are where a file of the user, of a folder or a program has others."""
    own = (name for name in rcParamsDefault if not name.startswith(_OF_WINDOWS))
    return {name: rcParamsDefault[name] for name in own if rcParams[name] != rcParamsDefault[name]}


def colours_of(unit: str) -> Colormap:
    """The colours of a quantity by its SI unit."""
    return ENERGY_COLOURS if unit == "J" else QUANTITY_COLOURS


def is_narrow(width: float) -> bool:
    """Whether a width (inch) is that of a column rather than of a page."""
    return width < (COLUMN_WIDTH + PAGE_WIDTH) / 2


def fit_legend(
    owner: Figure | Axes, handles: Sequence[Artist], columns: int, *, room: float | None = None, **look: Any
) -> Legend:
    """Give a figure or axes a legend that is not cut: in fewer columns, and at last with its words in more lines.

    Args:
        owner: of the legend.
        handles: what it names.
        columns: at most.
        room: how wide it may be, inch; as wide as the figure if not given.
        look: where it stands and how, as matplotlib takes it.
    """
    figure = owner.get_figure(root=True)
    assert isinstance(figure, Figure)
    room = _FILLED * (figure.get_figwidth() if room is None else room)
    for count in range(max(1, min(columns, len(handles))), 0, -1):
        legend = owner.legend(handles=handles, ncols=count, **look)
        beyond = legend.get_window_extent().width - room * figure.dpi
        if beyond <= 0 or count == 1:
            break
        legend.remove()
    if beyond > 0:
        widths = [text.get_window_extent().width for text in legend.get_texts()]
        for text, width in zip(legend.get_texts(), widths, strict=True):
            words, share = text.get_text(), (max(widths) - beyond) / width
            text.set_text(textwrap.fill(words, max(_LEAST_LETTERS, int(share * len(words)))))
    return legend


def in_column(axes: Axes) -> bool:
    """Whether axes are in a figure as wide as a column, in which words have half the room."""
    figure = axes.get_figure(root=True)
    return isinstance(figure, Figure) and is_narrow(figure.get_figwidth())


def draw_bar(axes: Axes, start: Sequence[float], length: float, text: str) -> None:
    """Draw a scale bar from a place to the right, with what its length is above it; all in the units of the axes."""
    left, foot = start
    axes.plot([left, left + length], [foot, foot], color="black", lw=1.5, solid_capstyle="butt", clip_on=False)
    middle = (left + length / 2, foot)
    axes.annotate(text, middle, (0, 2), textcoords="offset points", ha="center", va="bottom")


def describe(figure: Figure, text: str) -> Figure:
    """Give a figure the text that stands for it where it is not seen; its first sentence is the title.

    Returns:
        The figure.
    """
    figure.set_label(text)
    return figure


def description(figure: Figure) -> str:
    """The text that stands for a figure, or nothing."""
    return str(figure.get_label())


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure and its text in the format of the file's ending; the same figure gives the same bytes.

    Raises:
        InputError: it cannot be written, or has another ending.
    """
    if path.suffix not in ENDINGS:
        raise InputError(f"{path}: need a file that ends with .png, .svg or .pdf")
    text = description(figure)
    content = io.BytesIO()
    told: dict[str, str | None] = {"Title": text.partition(". ")[0].removesuffix(".")}
    figure.set_dpi(_RESOLUTION if path.suffix == ".png" else PICTURE_RESOLUTION)
    # Not by figure.savefig, which draws everything twice. TrueType, because journals refuse Type 3. Outlines in SVG,
    # because few readers have the font, and with another one words run into one another. A salt and no dates, because
    # otherwise the same figure is another file each time.
    with rc_context(
        {
            **_without_matplotlibrc(),
            "pdf.fonttype": 42,
            "svg.fonttype": "path",
            "svg.hashsalt": "forficula",
            "text.parse_math": False,
        }
    ):
        match path.suffix:
            case ".png":
                told |= {"Description": text, "Software": "forficula"}
                FigureCanvasAgg(figure).print_png(content, metadata=told)  # type: ignore[no-untyped-call]
            case ".svg":
                told |= {"Description": text, "Creator": "forficula", "Date": None}
                FigureCanvasSVG(figure).print_svg(content, metadata=told)  # type: ignore[no-untyped-call]
            case _:
                told |= {"Subject": text, "Creator": "forficula", "CreationDate": None}
                FigureCanvasPdf(figure).print_pdf(content, metadata=told)  # type: ignore[no-untyped-call]
    written = content.getvalue()
    if path.suffix == ".svg":
        # what reads a page aloud takes the text from here; matplotlib has it among the metadata only
        tags = f"</title>\n <desc>{escape(text, quote=False)}</desc>".encode()
        written = written.replace(b"<svg ", b'<svg role="img" ', 1).replace(b"</title>", tags, 1)
    write_bytes(path, written)


def save_figures(
    drawings: Mapping[str, Drawing], folder: Path, copies: Collection[str] = COPY_ENDINGS
) -> dict[str, str]:
    """Write every figure as PNG at the width of a page, and as SVG and PDF at that of a column.

    Args:
        drawings: by the stem of their file.
        folder: of the results; the SVG and PDF come into its sub-folder `COPIES`.
        copies: which of `COPY_ENDINGS` are written.

    Returns:
        The text that stands for each, by the stem of its file.

    Raises:
        InputError: one cannot be written.
    """
    texts = {}
    for stem, draw in drawings.items():
        page = draw(PAGE_WIDTH)
        texts[stem] = description(page)
        save_figure(page, folder / f"{stem}.png")
        column = draw(COLUMN_WIDTH) if copies else page
        for ending in copies:
            save_figure(column, folder / COPIES / f"{stem}{ending}")
            # the second one has the places that were found for the first
            column.set_layout_engine("none")
    return texts


def figure_files(stem: str) -> tuple[str, ...]:
    """Return the files that a figure is kept in, within the folder of the results."""
    return f"{stem}.png", *copy_files(stem)


def copy_files(stem: str) -> tuple[str, ...]:
    """Return the files of a figure that is as wide as a column, within the folder of the results."""
    return tuple(f"{COPIES}/{stem}{ending}" for ending in COPY_ENDINGS)

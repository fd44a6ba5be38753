"""Style and files of figures: widths of a journal, colours for grey print and colour blindness, descriptions."""

from __future__ import annotations

import io
import textwrap
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from html import escape
from pathlib import Path
from string import ascii_uppercase
from typing import Any

import numpy as np
from matplotlib import colormaps, rc_context, rcParams, rcParamsDefault
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.colors import Colormap, LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.legend import Legend
from matplotlib.lines import Line2D
from matplotlib.textpath import TextPath
from matplotlib.transforms import Affine2D, Bbox

from forficula.errors import InputError
from forficula.files import write_bytes

COLUMN_WIDTH, PAGE_WIDTH = 3.5, 7.1  # inch, one and two columns of a journal
_RESOLUTION = 200  # dots per inch
# pt, lower right corner of a panel's letter, from the upper left corner of its axes
_LETTER = (-6.0, 3.0)
_PLACES = 9  # decimals of a position in a figure, as a share of its size
_LEAST_LETTERS = 8  # least letters per line of a legend
_FILLED = 0.96  # share of the width that a legend may fill: at another resolution letters are slightly wider
PICTURE_RESOLUTION = 400  # dots per inch, of pictures among lines: journals require 300 or more
_LAYOUT_TABLES = ("GDEF", "GPOS", "GSUB", "MATH", "kern")  # of a font, as named by OpenType
COPY_ENDINGS = (".svg", ".pdf")
ENDINGS = (".png", *COPY_ENDINGS)
# sub-folder of a folder of results that contains copies for papers
COPIES = "figures"

# Okabe and Ito 2008, Color Universal Design: eight colours that all kinds of colour vision distinguish.
BLACK, ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE = (
    "#000000",
    "#E69F00",
    "#56B4E9",
    "#009E73",
    "#F0E442",
    "#0072B2",
    "#D55E00",
    "#CC79A7",
)
# The colours of quantities, with the same meaning in figures, maps, films and pages (web/src/scheme.js has the
# first two): lightness rises with the value, so grey print and every kind of colour vision keep the order.
# For every energy: viridis (Smith and van der Walt 2015) without its darkest end, which dark bars
# would hide.
ENERGY_COLOURS = LinearSegmentedColormap.from_list(
    "energy", ["#453781", "#39568c", "#2d708e", "#20908d", "#29af7f", "#73d055", "#b8de29", "#fde725"]
)
# for every other quantity of a map, and for many lines in their order: cividis (Nunez, Anderton and Renslow 2018)
QUANTITY_COLOURS = colormaps["cividis"]
# for strains of a sheet, from the built shape on; begins with a pale colour that differs from hidden parts
STRAIN_COLOURS = colormaps["YlOrRd"]
LINE_STYLES = ("-", "--", "-.", ":")

# rcParams that concern windows and not pictures
_OF_WINDOWS = ("backend", "interactive", "timezone", "tk.", "toolbar", "webagg.")

# Draws a figure at a width in inch.
Drawing = Callable[[float], Figure]


@contextmanager
def figure_style() -> Iterator[None]:
    """Apply small sans-serif text and thin axes, independent of any matplotlibrc."""
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
            # a user's names may contain dollar signs; figures contain no formulas
            "text.parse_math": False,
        }
    ):
        yield


def _without_matplotlibrc() -> Any:  # of many literal names, to type checkers
    """Return matplotlib's own defaults for settings that a matplotlibrc or a program has changed."""
    names = (name for name in rcParamsDefault if not name.startswith(_OF_WINDOWS))
    return {name: rcParamsDefault[name] for name in names if rcParams[name] != rcParamsDefault[name]}


def colours_of(unit: str) -> Colormap:
    """Return the colours of a quantity by its SI unit."""
    return ENERGY_COLOURS if unit == "J" else QUANTITY_COLOURS


def is_narrow(width: float) -> bool:
    """Return whether a width (inch) is that of a column and not of a page."""
    return width < (COLUMN_WIDTH + PAGE_WIDTH) / 2


def fit_legend(
    owner: Figure | Axes, handles: Sequence[Artist], columns: int, *, room: float | None = None, **look: Any
) -> Legend:
    """Add a legend that fits into a figure or axes: with fewer columns, or with wrapped words if that is not enough.

    Args:
        owner: figure or axes.
        handles: entries of the legend.
        columns: largest number of columns.
        room: largest width, inch; that of the figure by default.
        look: position and style, as for matplotlib.
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


def number_handle(number: int, label: str, colour: str = BLACK) -> Line2D:
    """Return the entry of a legend for numbers in a drawing, with a number in the place of the line."""
    digits = TextPath((0, 0), str(number), size=1)
    box = digits.get_extents()
    marker = digits.transformed(Affine2D().translate(-(box.x0 + box.x1) / 2, -(box.y0 + box.y1) / 2))
    return Line2D([], [], color=colour, marker=marker, ls="none", ms=5, mew=0, label=label)


def in_column(axes: Axes) -> bool:
    """Return whether axes are in a column-wide figure, where words have half the space."""
    figure = axes.get_figure(root=True)
    return isinstance(figure, Figure) and is_narrow(figure.get_figwidth())


def letter_panels(panels: Sequence[Axes]) -> None:
    """Write bold letters A, B, C .. above the upper left corners of a figure's panels; none for a single panel.

    Capitals, because small letters name the states of a structure.

    Args:
        panels: axes in the order of reading.
    """
    if len(panels) < 2:
        return
    for letter, axes in zip(ascii_uppercase, panels, strict=False):
        axes.annotate(
            letter,
            (0, 1),
            xytext=_LETTER,
            xycoords="axes fraction",
            textcoords="offset points",
            ha="right",
            va="bottom",
            fontweight="bold",
            fontsize=9,
            annotation_clip=False,
        )


def draw_bar(axes: Axes, start: Sequence[float], length: float, text: str) -> None:
    """Draw a scale bar from a position to the right, with its length above; all in the units of the axes."""
    left, foot = start
    axes.plot([left, left + length], [foot, foot], color="black", lw=1.5, solid_capstyle="butt", clip_on=False)
    middle = (left + length / 2, foot)
    axes.annotate(text, middle, (0, 2), textcoords="offset points", ha="center", va="bottom")


def describe(figure: Figure, text: str) -> Figure:
    """Attach to a figure a text for readers who cannot see it; its first sentence is the title.

    Returns:
        The figure.
    """
    figure.set_label(text)
    return figure


def description(figure: Figure) -> str:
    """Return the description of a figure, or an empty text."""
    return str(figure.get_label())


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure and its description in the format of the file's ending; the same figure gives the same bytes.

    Raises:
        InputError: the file cannot be written, or the path has another ending.
    """
    if path.suffix not in ENDINGS:
        raise InputError(f"{path}: need a file that ends with .png, .svg or .pdf")
    text = description(figure)
    content = io.BytesIO()
    metadata: dict[str, str | None] = {"Title": text.partition(". ")[0].removesuffix(".")}
    figure.set_dpi(_RESOLUTION if path.suffix == ".png" else PICTURE_RESOLUTION)
    # Not by figure.savefig, which draws everything twice. TrueType, because journals refuse Type 3. Outlines in SVG,
    # because few readers have the font, and another font would make words overlap. A salt and no dates, because
    # otherwise the same figure would give a different file each time.
    with rc_context(
        {
            **_without_matplotlibrc(),
            "pdf.fonttype": 42,
            "svg.fonttype": "path",
            "svg.hashsalt": "forficula",
            "text.parse_math": False,
        }
    ):
        _lay_out(figure)
        match path.suffix:
            case ".png":
                metadata |= {"Description": text, "Software": "forficula"}
                FigureCanvasAgg(figure).print_png(content, metadata=metadata)  # type: ignore[no-untyped-call]
            case ".svg":
                metadata |= {"Description": text, "Creator": "forficula", "Date": None}
                FigureCanvasSVG(figure).print_svg(content, metadata=metadata)  # type: ignore[no-untyped-call]
            case _:
                # imports a library of fonts in 0.1 s, which no other format needs
                from matplotlib.backends.backend_pdf import FigureCanvasPdf

                metadata |= {"Subject": text, "Creator": "forficula", "CreationDate": None}
                with _fonts_without_layout():
                    FigureCanvasPdf(figure).print_pdf(content, metadata=metadata)  # type: ignore[no-untyped-call]
    written = content.getvalue()
    if path.suffix == ".svg":
        # screen readers take the text from the root element; matplotlib writes it only into the metadata
        tags = f"</title>\n <desc>{escape(text, quote=False)}</desc>".encode()
        written = written.replace(b"<svg ", b'<svg role="img" ', 1).replace(b"</title>", tags, 1)
    write_bytes(path, written)


@contextmanager
def _fonts_without_layout() -> Iterator[None]:
    """Embed fonts without their tables of ligatures, kerning and formulas, which took most of the time of a PDF file.

    A PDF file has the position of every glyph, so that no viewer reads these tables.
    """
    from fontTools import subset

    class Options(subset.Options):  # type: ignore[misc]
        def __init__(self, **options: object) -> None:
            super().__init__(**options)
            self.drop_tables: list[str] = [*self.drop_tables, *_LAYOUT_TABLES]

    usual, subset.Options = subset.Options, Options
    try:
        yield
    finally:
        subset.Options = usual


def _lay_out(figure: Figure) -> None:
    """Lay a figure out once, with positions that do not depend on the rounding errors of the solver.

    The order of its equations, and with it the last digits, differ from figure to figure.
    """
    layout = figure.get_layout_engine()
    if layout is None:
        return
    layout.execute(figure)
    figure.set_layout_engine("none")
    for axes in figure.axes:
        axes.set_position(Bbox(np.round(axes.get_position(original=True).get_points(), _PLACES)))


def save_figures(
    drawings: Mapping[str, Drawing], folder: Path, copies: Collection[str] = COPY_ENDINGS
) -> dict[str, str]:
    """Write every figure as PNG at the width of a page, and as SVG and PDF at the width of a column.

    Args:
        drawings: drawings by the stems of their files.
        folder: folder of the results; SVG and PDF are written to its sub-folder `COPIES`.
        copies: endings among `COPY_ENDINGS` to write.

    Returns:
        Description of each figure, by the stem of its file.

    Raises:
        InputError: a file cannot be written.
    """
    texts = {}
    for stem, draw in drawings.items():
        page = draw(PAGE_WIDTH)
        texts[stem] = description(page)
        save_figure(page, folder / f"{stem}.png")
        column = draw(COLUMN_WIDTH) if copies else page
        for ending in copies:
            save_figure(column, folder / COPIES / f"{stem}{ending}")
            # the second copy keeps the layout of the first
            column.set_layout_engine("none")
    return texts


def figure_files(stem: str) -> tuple[str, ...]:
    """Return the files of a figure, within the folder of the results."""
    return f"{stem}.png", *copy_files(stem)


def copy_files(stem: str) -> tuple[str, ...]:
    """Return the files of the column-wide copies of a figure, within the folder of the results."""
    return tuple(f"{COPIES}/{stem}{ending}" for ending in COPY_ENDINGS)

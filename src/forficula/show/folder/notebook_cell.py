"""HTML of a result in a notebook cell: terminal output, a figure, a page in a frame."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rich.console import RenderableType

from forficula.show.page.parts.html import escaped, paragraph
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.style import PAGE_WIDTH, Drawing, description

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

_HEIGHT = 640  # pixels, height of a page
_DPI = 110


def framed(page: str, title: str) -> str:
    """Return a page in a frame of its own, which isolates its style and script."""
    return (
        f'<iframe srcdoc="{escaped(page)}" title="{escaped(title)}"'
        f' sandbox="allow-scripts allow-downloads" style="width:100%;height:{_HEIGHT}px;border:0"></iframe>'
    )


def heading(text: str) -> str:
    """Return a heading of a cell."""
    return f"<h3>{escaped(text)}</h3>"


def first_figure(drawings: dict[str, Drawing]) -> str:
    """Return the first figure of a result; empty if it has none."""
    return picture(next(iter(drawings.values()))(PAGE_WIDTH)) if drawings else ""


def picture(figure: Figure) -> str:
    """Return a figure for a cell, with its description as alternative text."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    content = io.BytesIO()
    figure.set_dpi(_DPI)
    FigureCanvasAgg(figure).print_png(content)  # type: ignore[no-untyped-call]
    packed = base64.b64encode(content.getvalue()).decode("ascii")
    return f'<p><img src="data:image/png;base64,{packed}" alt="{escaped(description(figure))}"></p>'


def printed(renderable: RenderableType) -> Iterator[str]:
    """Yield the terminal output of a result as HTML."""
    parts = printed_result(renderable)
    if parts.heading:
        yield f"<p><strong>{escaped(parts.heading)}</strong></p>"
    yield from parts.tables
    yield from map(paragraph, parts.sentences)


def printed_with_figure(renderable: RenderableType, drawings: dict[str, Drawing]) -> Iterator[str]:
    """Yield the terminal output of a result, and its first figure, as HTML."""
    yield from printed(renderable)
    yield first_figure(drawings)


def numbers(table: Dataset) -> str:
    """Return the variables of a table as xarray displays them."""
    import xarray

    return xarray.Dataset._repr_html_(table)

"""Files of a trace."""

from __future__ import annotations

from pathlib import Path

from forficula.files import replacing_all, write_text
from forficula.pattern import Trace, write_trace
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.page.results_page import write_results_page
from forficula.show.structure.trace_figure import draw_deviations, draw_trace
from forficula.show.structure.trace_table import trace_table
from forficula.show.style import Drawing, save_figures

PATTERN_FILE = "pattern.fold"
_HEADINGS = {"trace": "Lines found in the picture", "deviations": "Deviations from flat-foldability"}


def write_trace_folder(trace: Trace, folder: Path) -> None:
    """Write the pattern as FOLD file, trace.json, figures and page; all of them, or none.

    Args:
        trace: the trace.
        folder: folder, created if missing; files of an earlier trace are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_trace(trace, unfinished / PATTERN_FILE)
        write_text(unfinished / "trace.json", json_text(trace))
        texts = save_figures(trace_drawings(trace), unfinished)
        write_results_page(unfinished, "trace", trace.name or "picture", trace_table(trace), _HEADINGS, texts)


def trace_drawings(trace: Trace) -> dict[str, Drawing]:
    """Return the drawings of a trace by the stems of their files."""
    return {
        "trace": lambda width: draw_trace(trace, width),
        "deviations": lambda width: draw_deviations(trace, width),
    }


PRESENTATION = Presentation(
    drawings=trace_drawings,
    cell=lambda trace: printed_with_figure(trace_table(trace), trace_drawings(trace)),
    copied="a trace cannot be drawn again without its picture",
    write=write_trace_folder,
)

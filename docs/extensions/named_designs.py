"""Directive named-designs: a picture, a sentence and the command of every named design.

A hidden cell of the same page calls `draw_named_designs`, which runs the designs, draws their pictures and writes a
list. The directive reads the list.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from cells import folder_of
from docutils import nodes
from matplotlib.figure import Figure
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

import forficula as ff
from forficula.design import stage_drives
from forficula.show.run.state_names import states_reached
from forficula.show.structure.painted_shape import paint_shape, show_painted
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.structure.viewpoint import readable_view
from forficula.show.style import ORANGE, PAGE_WIDTH, figure_style

LIST = "named-designs.json"
# without these limits the releases of two designs, which last seconds at a timestep of 0.02 and 0.05 ms, take 14 s,
# and the hindwing 25 s
_SHORTER = {
    "binder2025-built": {
        "protocol.stages.release folded.time_limit": "0.2 s",
        "protocol.stages.release opened.time_limit": "0.2 s",
    },
    "binder2025-thick": {"protocol.stages.release folded.time_limit": "0.2 s"},
    "earwig-hindwing": {"protocol.timestep": "0.1 ms"},
}
_MOST_STATES = 4
_LAST_STAGE = {"earwig-hindwing": "close"}  # after it come only states that are not drawn
_TALLEST, _NAME, _GAP = 1.7, 0.24, 0.08  # inch: largest height of a shape, height of its name, margin
_LETTERS = 11.0  # pt, which the page shrinks to the size of its text
_RESOLUTION = 200  # dots per inch


def draw_named_designs() -> dict[str, ff.Run]:
    """Run all named designs, write their pictures and the list that the directive reads, and return the runs."""
    runs, listed = {}, []
    for name, sentence in ff.examples().items():
        run = ff.run(_shortened(ff.load_design(name, _SHORTER.get(name))), confirm=False)
        states = _states(run)
        draw_states(run, states).savefig(f"{name}.png", dpi=_RESOLUTION)
        listed.append({"name": name, "sentence": sentence, "states": list(states)})
        runs[name] = run
    Path(LIST).write_text(json.dumps(listed), "utf-8")
    return runs


def _shortened(design: ff.Design) -> ff.Design:
    """Return a design without the stages of its protocol that reach no state of the picture."""
    if design.name not in _LAST_STAGE:
        return design
    names = [stage.name for stage in design.protocol.stages]
    needed = design.protocol.stages[: names.index(_LAST_STAGE[design.name]) + 1]
    return design.with_values({"protocol.stages": [stage.si_tables() for stage in needed]})


def _states(run: ff.Run) -> dict[str, float]:
    """Return the times (s) of the first states by name; the built shape if the first stage drives the structure."""
    states = {name: state.time for name, state in states_reached(run.structure, run.outcome).items()}
    built = {"as built": 0.0} if stage_drives(run.stages[0].stage) else {}
    return dict(list((built | states).items())[:_MOST_STATES])


def draw_states(run: ff.Run, states: dict[str, float]) -> Figure:
    """Draw a structure at times (s) of a run beside one another, at one scale and from one viewpoint."""
    shape = shape_of(run.structure)
    surfaces = [surface_at(run.record, shape, time) for time in states.values()]
    view = readable_view(surfaces)
    drawn = [paint_shape(surface, view, ORANGE) for surface in surfaces]
    sizes = np.array([np.ptp(painted.corners, axis=0) for painted in drawn])
    column = PAGE_WIDTH / len(drawn)
    scale = min((column - _GAP) / sizes[:, 0].max(), _TALLEST / sizes[:, 1].max())
    size = np.array([column - _GAP, scale * sizes[:, 1].max()])  # inch, of one shape
    with figure_style():
        figure = Figure(figsize=(PAGE_WIDTH, size[1] + _NAME + 2 * _GAP))
        total = figure.get_size_inches()
        for place, (painted, name) in enumerate(zip(drawn, states, strict=True)):
            axes = figure.add_axes((*([place * column + _GAP / 2, _NAME + _GAP] / total), *(size / total)))
            window = painted.corners.mean(axis=0) + size / scale * [[-0.5], [0.5]]
            show_painted(axes, painted, window, size[0])
            figure.text((place + 0.5) / len(drawn), _GAP / total[1], name, ha="center", va="bottom", size=_LETTERS)
        return figure


class NamedDesignsDirective(SphinxDirective):
    """Show all named designs, each in a section."""

    def run(self) -> list[nodes.Node]:
        folder = folder_of(self.env.docname)
        return [self._section(design, folder) for design in json.loads((folder / LIST).read_text("utf-8"))]

    def _section(self, design: dict[str, Any], folder: Path) -> nodes.section:
        name, sentence = design["name"], design["sentence"]
        section = nodes.section(ids=[nodes.make_id(name)], names=[name])
        section += nodes.title("", "", nodes.literal("", name))
        self.state.document.note_explicit_target(section)
        section += nodes.paragraph("", f"This design shows {sentence}.")
        uri = "/" + (folder / f"{name}.png").relative_to(self.env.srcdir).as_posix()
        section += nodes.image(uri=uri, alt=f"{name} in 3-D: {', '.join(design['states'])}", classes=["drawn"])
        command = f"forficula run {name}"
        section += nodes.literal_block(command, command, language="bash")
        return section


def setup(app: Sphinx) -> dict[str, object]:
    app.add_directive("named-designs", NamedDesignsDirective)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}

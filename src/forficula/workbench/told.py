"""What a workbench tells its page of a design: its keys, its structure live, its pattern."""

from __future__ import annotations

import base64
import re
import shlex
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from forficula.design import Design, design_frames, design_pattern, design_text
from forficula.design.files.held_keys import HeldKey, held_keys
from forficula.dynamics import timestep_warnings, with_timestep
from forficula.pattern import pattern_facts, write_fold
from forficula.show.page.bench_page import at_start, bench_data
from forficula.show.page.data.live_data import live_data
from forficula.show.page.parts.design_rows import design_title, section_heading, section_title
from forficula.show.structure.sheet_figure import draw_sheet
from forficula.show.style import description, save_figure
from forficula.structure import structure_warnings
from forficula.workbench.asked import Asked, Opened, asked_design, design_source

# what a shell takes as it is between double quotes
_PLAIN = re.compile(r'[^"$`\\!]*')


def design_told(asked: Asked, opened: Opened) -> dict[str, Any]:
    """A design's keys with their values, its file, and the command that runs it, for JSON.

    Raises:
        InputError: it cannot be read.
    """
    design = asked_design(asked, opened)
    keys = held_keys(design)
    sections = dict.fromkeys(key.fact.key.partition(".")[0] for key in keys if "." in key.fact.key)
    return {
        "title": design_title(design),
        "name": design.name,
        "hash": design.hash,
        "shows": f"{design.shows[:1].upper()}{design.shows[1:]}." if design.shows else "",
        "keys": [_key(each) for each in keys],
        "sections": {name: _heading(name, design) for name in sections},
        "text": design_text(design),
        "command": command_of(asked, opened),
    }


def command_of(asked: Asked, opened: Opened) -> str:
    """The line of a shell that runs the design that a page asks for."""
    words = ["forficula", "run", shlex.quote(design_source(asked, opened))]
    unit = asked.unit if asked.files else f"{opened.unit:.9g} m" if opened.unit and not asked.design else ""
    words += ["--unit", f'"{unit}"'] if unit else []
    for key, text in asked.settings.items():
        plain = _PLAIN.fullmatch(text) is not None
        words += ["--set", f'{key}="{text}"' if plain and re.search(r"\W", text) else shlex.quote(f"{key}={text}")]
    return " ".join(words)


def model_told(asked: Asked, opened: Opened) -> dict[str, Any]:
    """A design's structure where it starts, and what the engine in the page needs of it, or why it would refuse it.

    Raises:
        InputError: it cannot be built.
    """
    given = asked_design(asked, opened)
    design = with_timestep(given)
    clip = at_start(design)
    measures = [each.measure for each in clip.readings]
    return {
        "bench": bench_data(clip),
        "live": live_data(design, measures, clip.mesh.anchors.tolist()),
        "warnings": [*structure_warnings(design, clip.structure), *timestep_warnings(given)],
    }


def pattern_told(asked: Asked, opened: Opened) -> dict[str, Any]:
    """A design's crease pattern as a drawing in SVG, in words, and as a FOLD file.

    Raises:
        InputError: it has none, or cannot be drawn.
    """
    design = asked_design(asked, opened)
    sheet = design_pattern(design)
    with TemporaryDirectory(prefix="forficula-") as folder:
        figure = draw_sheet(sheet, pattern_facts(sheet))
        save_figure(figure, Path(folder) / "pattern.svg")
        write_fold(sheet, Path(folder) / "pattern.fold", frames=design_frames(design))
        drawing = (Path(folder) / "pattern.svg").read_bytes()
        fold = (Path(folder) / "pattern.fold").read_text("utf-8")
    return {"drawing": base64.b64encode(drawing).decode("ascii"), "said": description(figure), "fold": fold}


def _key(key: HeldKey) -> dict[str, Any]:
    fact = key.fact
    return {
        "key": fact.key,
        "meaning": fact.meaning,
        "allowed": fact.allowed,
        "default": fact.default,
        "value": key.value,
        "words": list(key.words),
        "onlyWords": key.only_words,
        "chosen": key.chosen,
    }


def _heading(section: str, design: Design) -> str:
    """What a section is, in words; of one that the design lacks what its key says."""
    if getattr(design, section, None):
        return section_title(section, design)
    return type(design).model_fields[section].description or section_heading(section, (design,)) or section

"""Responses of a workbench to its page: keys of a design, its structure, its pattern."""

from __future__ import annotations

import base64
import re
import shlex
import warnings
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from forficula.design import Design, design_frames, design_pattern, design_text
from forficula.design.files.design_keys import DesignKey, design_keys
from forficula.dynamics import compile_model, timestep_warnings, why_not_portable, with_timestep
from forficula.pattern import pattern_facts, write_fold
from forficula.show.page.data.live_data import live_data
from forficula.show.page.live_page import live_page_data, start_clip
from forficula.show.page.parts.design_rows import design_title, section_heading, section_title
from forficula.show.structure.sheet_figure import draw_sheet
from forficula.show.style import description, save_figure
from forficula.structure import structure_warnings
from forficula.study.running.law_timestep import law_timestep
from forficula.workbench.requests import DesignRequest, Opened, design_source, requested_design

# text that a shell does not change between double quotes
_PLAIN = re.compile(r'[^"$`\\!]*')


def design_response(request: DesignRequest, opened: Opened) -> dict[str, Any]:
    """Return the keys of a design with their values, its file, and the command that runs it, for JSON.

    Raises:
        InputError: the design cannot be read.
    """
    design = requested_design(request, opened)
    keys = design_keys(design)
    sections = dict.fromkeys(key.fact.key.partition(".")[0] for key in keys if "." in key.fact.key)
    return {
        "title": design_title(design),
        "name": design.name,
        "hash": design.hash,
        "shows": f"{design.shows[:1].upper()}{design.shows[1:]}." if design.shows else "",
        "keys": [_key(key) for key in keys],
        "sections": {name: _heading(name, design) for name in sections},
        "text": design_text(design),
        "command": command_of(request, opened),
    }


def command_of(request: DesignRequest, opened: Opened) -> str:
    """Return the shell command that runs the design of a request."""
    words = ["forficula", "run", shlex.quote(design_source(request, opened))]
    unit = request.unit if request.files else f"{opened.unit:.9g} m" if opened.unit and not request.design else ""
    words += ["--unit", f'"{unit}"'] if unit else []
    for key, text in request.settings.items():
        plain = _PLAIN.fullmatch(text) is not None
        words += ["--set", f'{key}="{text}"' if plain and re.search(r"\W", text) else shlex.quote(f"{key}={text}")]
    return " ".join(words)


def model_response(request: DesignRequest, opened: Opened) -> dict[str, Any]:
    """Return the data for the engine in the page with the structure at its start, or the engine's reason to refuse.

    Raises:
        InputError: the design cannot be built.
    """
    with warnings.catch_warnings(record=True) as reading:
        warnings.simplefilter("always", UserWarning)
        requested, of_law = law_timestep(requested_design(request, opened))
    design = with_timestep(requested)
    model = compile_model(design)
    notes = [
        *(str(warning.message).rpartition("/")[2] for warning in reading),
        *structure_warnings(design, model.structure),
        *[of_law] * bool(of_law),
        *timestep_warnings(requested),
    ]
    if why := why_not_portable(model):
        return {"live": {"refused": why}, "warnings": notes}
    clip = start_clip(design)
    measures = [reading.measure for reading in clip.readings]
    live = live_data(design, measures, clip.mesh.anchors.tolist())
    return {"bench": live_page_data(clip), "live": live, "warnings": notes}


def pattern_response(request: DesignRequest, opened: Opened) -> dict[str, Any]:
    """Return the crease pattern of a design as an SVG drawing, as a description, and as a FOLD file.

    Raises:
        InputError: the design has no pattern, or the pattern cannot be drawn.
    """
    design = requested_design(request, opened)
    sheet = design_pattern(design)
    with TemporaryDirectory(prefix="forficula-") as folder:
        figure = draw_sheet(sheet, pattern_facts(sheet))
        save_figure(figure, Path(folder) / "pattern.svg")
        write_fold(sheet, Path(folder) / "pattern.fold", frames=design_frames(design))
        drawing = (Path(folder) / "pattern.svg").read_bytes()
        fold = (Path(folder) / "pattern.fold").read_text("utf-8")
    return {"drawing": base64.b64encode(drawing).decode("ascii"), "said": description(figure), "fold": fold}


def _key(key: DesignKey) -> dict[str, Any]:
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
    """Return the title of a section; for a section that the design lacks, the description of its key."""
    if getattr(design, section, None):
        return section_title(section, design)
    return type(design).model_fields[section].description or section_heading(section, (design,)) or section

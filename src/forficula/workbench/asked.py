"""What the page of a workbench asks: a design, and values in place of its own."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, field_validator

from forficula.design import Design, load_design, named_designs
from forficula.design.part import LENGTH
from forficula.errors import InputError
from forficula.names import one_of
from forficula.options import read_settings
from forficula.quantities import as_written, parse_quantity

# of files that a design is read from, with what it names
_ENDINGS = (".toml", ".fold", ".svg", ".dxf")
_MOST_FILES = 20
_NAME = re.compile(r"[^/\\:\x00-\x1f]{1,100}")


class SentFile(BaseModel):
    """A file that was dropped on the page.

    Attributes:
        name: without a folder.
        text: what it holds.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    name: str
    text: str

    @field_validator("name")
    @classmethod
    def _is_a_name(cls, name: str) -> str:
        if _NAME.fullmatch(name) is None:
            raise ValueError(f"need a file name of at most 100 letters, none of them / \\ or :, got {as_written(name)}")
        return name


class Asked(BaseModel):
    """A design as the page has it.

    Attributes:
        design: a named one; "" for the one that the workbench was opened with, or for that of the files.
        files: a design file with those that it names, or a FOLD file or a drawing; the design comes first.
        unit: length of the unit of a FOLD file or a drawing that names none, with its unit; "" if not given.
        settings: text by dotted key, as `--set` takes it.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    design: str = ""
    files: Annotated[tuple[SentFile, ...], Field(max_length=_MOST_FILES)] = ()
    unit: str = ""
    settings: dict[str, str] = {}


@dataclass(frozen=True, kw_only=True)
class Opened:
    """What a workbench was opened with.

    Attributes:
        design: a named design, or the path of a file.
        unit: length of the unit of a FOLD file or a drawing that names none, m.
        settings: text by dotted key, with which its page begins.
    """

    design: str
    unit: float | None = None
    settings: Mapping[str, str] = field(default_factory=dict)


def asked_design(asked: Asked, opened: Opened) -> Design:
    """Read the design that a page asks for, with its values.

    Raises:
        InputError: no such design, a file that is none, or a value that is not allowed.
    """
    settings = read_settings([f"{key}={text}" for key, text in asked.settings.items()], "key")
    if asked.files:
        return _sent_design(asked, settings)
    if not asked.design:
        return load_design(opened.design, settings, unit=opened.unit)
    # a page names no file of this machine
    if asked.design not in named_designs():
        raise InputError(f"design: need {one_of(named_designs(), asked.design)}")
    return load_design(asked.design, settings)


def design_source(asked: Asked, opened: Opened) -> str:
    """What a command names to have the design that a page asks for, before its values."""
    if not asked.files:
        return asked.design or opened.design
    name = asked.files[0].name
    # else it would be read as an option
    return f"./{name}" if name.startswith("-") else name


def _sent_design(asked: Asked, settings: Mapping[str, object]) -> Design:
    """A design of files, which lie in a folder of their own as long as it takes to read them."""
    unit = parse_quantity(asked.unit, LENGTH) if asked.unit else None
    with TemporaryDirectory(prefix="forficula-") as name:
        folder = Path(name)
        for sent in asked.files:
            if Path(sent.name).suffix.lower() not in _ENDINGS:
                raise InputError(f"need a file that ends with {', '.join(_ENDINGS)}, got {as_written(sent.name)}")
            (folder / sent.name).write_text(sent.text, "utf-8", newline="")
        try:
            return load_design(folder / asked.files[0].name, settings, unit=unit)
        except InputError as error:
            # that folder is none of its reader's business
            told = str(error).replace(f"{folder.resolve()}/", "").replace(f"{folder}/", "")
            raise InputError(told.replace(f"{folder}\\", "")) from None

"""Files of clicked points: of a fan, or of a film."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Any

from forficula.design.files.file_words import check_file_kind
from forficula.design.files.rejection import read_section
from forficula.errors import error_prefix
from forficula.files import read_text
from forficula.goals.clicks.fan_clicks import FanClicksFile, fan_clicks, fitted_fan
from forficula.goals.clicks.fan_fit import FanFit
from forficula.goals.clicks.motion import ObservedMotion, observed_motion
from forficula.toml_text import parse_toml

_PACKAGE = "forficula.goals.clicks"


def named_clicks() -> list[str]:
    """Return the names of the files of clicks that the package contains."""
    folder = resources.files(_PACKAGE) / "references"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def is_clicks(name: object) -> bool:
    """Return whether an argument is a file of clicks, by its ending or its name."""
    return Path(str(name)).suffix.lower() == ".toml" or str(name) in named_clicks()


def result_of_file(name: str) -> FanFit | ObservedMotion:
    """Fit the fan, or compute the angles over time, of a file of clicked points.

    Args:
        name: path of a TOML file, or the name of a file that the package contains.

    Raises:
        InputError: the file cannot be read, or a value that is not allowed. The message begins with the file.
    """
    path = Path(name)
    if name in named_clicks():
        text, folder = (resources.files(_PACKAGE) / "references" / f"{name}.toml").read_text("utf-8"), Path()
    else:
        text, folder = read_text(path), path.parent
    with error_prefix(f"{name}: "):
        tables = parse_toml(text, "a clicks file")
        check_file_kind(tables, "clicks file")
        return result_of_tables({"name": path.stem, **tables}, folder)


def result_of_tables(tables: Mapping[str, Any], folder: Path) -> FanFit | ObservedMotion:
    """Fit the fan of clicked points, or compute the angles over time of a film, which has a key `frame`.

    Args:
        tables: content of a file; lists of points may be arrays.
        folder: folder that paths are relative to.

    Raises:
        InputError: a value that is not allowed.
    """
    if "frame" in tables:
        return observed_motion(tables, folder)
    return fitted_fan(fan_clicks(read_section(FanClicksFile, tables), folder))

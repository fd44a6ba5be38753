"""Commands about design files and crease patterns."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import OutIfGiven, Settings, read_settings

if TYPE_CHECKING:
    from forficula.pattern import CreasePattern
    from forficula.pattern.fold_writer import Frame


def new(
    file: Annotated[Path, Parameter(help="Where to write it; must end with .toml and not exist.")],
    /,
    *,
    kind: Annotated[str, Parameter(help="What it folds: earwig-fan, pleats or fold-file.")] = "earwig-fan",
) -> None:
    """Write a commented design file to start from."""
    from forficula.design import write_new_design

    write_new_design(file, kind)
    print(f"written to {file}; run it with: forficula run {file}")


def designs() -> None:
    """List the named designs, each with its source."""
    from forficula.design import named_designs

    for name, source in named_designs().items():
        print(f"{name}\n    {source}")


def pattern(
    design: Annotated[
        str, Parameter(help="A named design, or the path of a design file (.toml) or of a FOLD file (.fold).")
    ],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="A .fold or .svg file; without it, the pattern is described.")] = None,
    settings: Settings = None,
) -> None:
    """Say what a crease pattern is and whether it folds flat, or write it as FOLD or SVG, by the ending of the file."""
    from forficula.pattern import pattern_text, write_fold, write_svg

    sheet, frames = _sheet(design, settings)
    if out is None:
        print("\n".join(pattern_text(sheet)))
        return
    match out.suffix:
        case ".fold":
            write_fold(sheet, out, frames=frames)
        case ".svg":
            write_svg(sheet, out)
        case _:
            raise InputError(f"--out: need a file that ends with .fold or .svg, got {out}")
    print(f"written to {out}")


def _sheet(name: str, settings: list[str] | None) -> tuple[CreasePattern, list[Frame]]:
    """The pattern of a design or of a FOLD file, and its folded states."""
    from forficula.design import design_frames, design_pattern, load_design
    from forficula.pattern import read_fold, read_folded_frames

    if not name.lower().endswith(".fold"):
        chosen = load_design(name, read_settings(settings))
        return design_pattern(chosen), design_frames(chosen)
    if settings:
        raise InputError(f"--set: a FOLD file has no values to replace, got {settings[0]}")
    return read_fold(name), read_folded_frames(name)

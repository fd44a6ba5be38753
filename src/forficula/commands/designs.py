"""Commands about design files and crease patterns."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import DesignName, Out, Settings, read_settings


def new(file: Annotated[Path, Parameter(help="Where to write it; must end with .toml and not exist.")], /) -> None:
    """Write a commented design file to start from."""
    from forficula.design import write_new_design

    write_new_design(file)
    print(f"written to {file}; run it with: forficula run {file}")


def designs() -> None:
    """List the named designs, each with its source."""
    from forficula.design import named_designs

    for name, source in named_designs().items():
        print(f"{name}\n    {source}")


def pattern(
    design: DesignName,
    /,
    *,
    out: Annotated[Out, Parameter(help="A .fold or .svg file.")],
    settings: Settings = None,
) -> None:
    """Write a design's crease pattern as FOLD or SVG, by the ending of the file."""
    from forficula.design import load_design
    from forficula.pattern import earwig_pattern, folded_frames, write_fold, write_svg

    fan = load_design(design, read_settings(settings)).fan
    match out.suffix:
        case ".fold":
            write_fold(earwig_pattern(fan), out, frames=folded_frames(fan))
        case ".svg":
            write_svg(earwig_pattern(fan), out)
        case _:
            raise InputError(f"--out: need a file that ends with .fold or .svg, got {out}")
    print(f"written to {out}")

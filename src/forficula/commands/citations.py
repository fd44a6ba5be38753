"""The command that lists publications to cite."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.options import DesignName, DrawingUnit, Settings, read_design

if TYPE_CHECKING:
    from forficula.analysis.citations import Citation


def cite(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    bibtex: Annotated[bool, Parameter(help="Print entries for a BibTeX file.", negative=())] = False,
) -> None:
    """List what to cite for results of a design: the program, the engine and the papers whose formulas it uses."""
    from forficula.analysis.citations import citations

    cited = citations(read_design(design, settings, unit))
    print("\n\n".join(citation.bibtex for citation in cited) if bibtex else _table(cited))


def _table(cited: tuple[Citation, ...]) -> str:
    return "\n".join(f"{citation.used_for}:\n    {citation}" for citation in cited)

"""Numbers of cells of a sheet."""

from __future__ import annotations

from typing import Any

from pydantic import Field

# along either side of a sheet: a hundred thousand facets take minutes to draw
MOST_CELLS = 300


def count(description: str, least: int = 1) -> Any:
    """Return the field of a whole number that must be given."""
    return Field(strict=True, ge=least, le=MOST_CELLS, description=description)

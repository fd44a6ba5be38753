"""Fields for numbers of cells of a sheet."""

from __future__ import annotations

from typing import Any

from pydantic import Field

# in each direction: a sheet of a hundred thousand facets takes minutes to draw
MOST_CELLS = 300


def count(description: str, least: int = 1) -> Any:
    """Define a required field that holds a whole number."""
    return Field(strict=True, ge=least, le=MOST_CELLS, description=description)

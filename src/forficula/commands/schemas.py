"""Command: what the data that commands write looks like."""

from __future__ import annotations

import json
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import InputError


def schema(
    kind: Annotated[str, Parameter(help="summary (of a run), landscape, row (of a study), or assumptions.")],
    /,
) -> None:
    """Print the JSON schema of what --json writes."""
    from forficula.analysis.json_schemas import json_schema

    try:
        print(json.dumps(json_schema(kind), indent=2))  # type: ignore[arg-type]
    except InputError as error:
        raise InputError(f"schema: {error}") from None

"""Command: what the data that commands write looks like."""

from __future__ import annotations

import json
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import error_prefix


def schema(
    kind: Annotated[str, Parameter(help="summary (of a run), row (of a study), landscape, assumptions, ...")],
    /,
) -> None:
    """Print the JSON schema of what --json writes."""
    from forficula.results import json_schema

    with error_prefix("schema: "):
        print(json.dumps(json_schema(kind), indent=2))

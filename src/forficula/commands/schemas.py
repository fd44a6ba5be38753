"""The command that prints the JSON schemas of results."""

from __future__ import annotations

import json
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import error_prefix


def schema(
    kind: Annotated[str, Parameter(help="Kind of result: summary (of a run), row (of a study), landscape, ...")],
    /,
) -> None:
    """Print the JSON schema of a result that --json writes."""
    from forficula.results import json_schema

    with error_prefix("schema: "):
        print(json.dumps(json_schema(kind), indent=2))

"""Fields of study, goal and observations files: their entries in tables of keys, and tables by design key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, ValidationInfo
from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.section import Section
from forficula.errors import InputError
from forficula.names import folder_name
from forficula.quantities import as_written

# a text in an annotation states which values are allowed
Whole = Annotated[int, Field(strict=True)]
YesOrNo = Annotated[bool, Field(strict=True)]
DesignValue = Annotated[Any, "as in a design"]


@dataclass(frozen=True, kw_only=True)
class ByKey:
    """Reader of a table whose keys are keys of a design; keys of nested tables become dotted keys.

    Attributes:
        allowed: allowed values, in words.
        entry: fields of a table that is itself a value; None where no table is a value.
        placeholder: text in place of the design's keys in tables of keys.
    """

    allowed: str
    entry: type[Section] | None = None
    placeholder: str = "KEY"

    def __call__(self, value: object, info: ValidationInfo) -> object:
        """Return the values of a table by dotted key. Validation rejects a value that is not a table later."""
        return self._dotted(value, f"{info.field_name}.", "") if isinstance(value, Mapping) else value

    def _dotted(self, table: Mapping[str, Any], header: str, prefix: str) -> dict[str, Any]:
        # a table with one of these keys is a value: a distribution, or a law that is based on another one
        value_keys = {"based_on", "distribution", *(() if self.entry is None else self.entry.model_fields)}
        flat: dict[str, Any] = {}
        for key, value in table.items():
            nested = isinstance(value, Mapping) and value and not value_keys & value.keys()
            more = self._dotted(value, header, f"{prefix}{key}.") if nested else {f"{prefix}{key}": value}
            if twice := flat.keys() & more.keys():
                raise InputError(
                    f"{header}{min(twice)}: is given twice, once with dots in its name and once in a table"
                )
            flat |= more
        return flat


def by_key(field: FieldInfo) -> ByKey | None:
    """Return the reader of a field that is a table by keys of a design; None for any other field."""
    return next(
        (rule.func for rule in field.metadata if isinstance(rule, BeforeValidator) and isinstance(rule.func, ByKey)),
        None,
    )


def entry(
    description: str,
    default: Any = None,
    *,
    left_out: str = "",
    examples: tuple[str, ...] = (),
    at_least: int | None = None,
) -> Any:
    """Define a field of a file; a field whose default is `...` is required.

    Args:
        description: meaning of the value.
        default: value if the field is left out.
        left_out: text for tables of keys about a field that is left out, where the default does not explain it;
            "needed" where a later check requires a value.
        examples: example lines of a file, in which `$name` stands for a text of the design that the file refers to.
        at_least: least value of a whole number.
    """
    return Field(
        default, description=description, examples=list(examples), ge=at_least, json_schema_extra={"left out": left_out}
    )


def left_out(field: FieldInfo) -> str:
    """Return the argument `left_out` of `entry`; "" for any other field."""
    words = field.json_schema_extra
    return str(words.get("left out", "")) if isinstance(words, dict) else ""


def _named_design(value: object) -> object:
    if not isinstance(value, str | Design):
        raise InputError(f'need the name or path of a design, such as "binder2025", got {as_written(value)}')
    return value


# fields that several kinds of files have
FolderName = Annotated[str, BeforeValidator(folder_name)]
DesignName = Annotated[Any, "text", BeforeValidator(_named_design)]
Settings = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed="as in a design"))]
DESIGN = entry("a named design, or the path of a design file", left_out="needed", examples=('design = "$design"',))
SETTINGS = entry("value that replaces the one of the design", {}, examples=('protocol.timestep = "0.1 ms"',))

"""Fields of the files of studies, goals and observations: what key tables say of them, and tables by key."""

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

# a text in an annotation says what a value may be
Whole = Annotated[int, Field(strict=True)]
YesOrNo = Annotated[bool, Field(strict=True)]
DesignValue = Annotated[Any, "as in a design"]


@dataclass(frozen=True, kw_only=True)
class ByKey:
    """How a table by keys of a design is read: keys of nested tables become dotted keys.

    Attributes:
        allowed: what its values may be.
        entry: what a table under a key may have that is a value itself; None where no table is one.
        placeholder: what stands for the keys in tables of keys.
    """

    allowed: str
    entry: type[Section] | None = None
    placeholder: str = "KEY"

    def __call__(self, value: object, info: ValidationInfo) -> object:
        """Return the values of a table by dotted key. Validation rejects a value that is not a table later."""
        return self._dotted(value, f"{info.field_name}.", "") if isinstance(value, Mapping) else value

    def _dotted(self, table: Mapping[str, Any], header: str, prefix: str) -> dict[str, Any]:
        # distributions, and laws that are based on others, are values in every table
        of_values = {"based_on", "distribution", *(() if self.entry is None else self.entry.model_fields)}
        flat: dict[str, Any] = {}
        for key, value in table.items():
            nested = isinstance(value, Mapping) and value and not of_values & value.keys()
            more = self._dotted(value, header, f"{prefix}{key}.") if nested else {f"{prefix}{key}": value}
            if twice := flat.keys() & more.keys():
                raise InputError(
                    f"{header}{min(twice)}: is given twice, once with dots in its name and once in a table"
                )
            flat |= more
        return flat


def by_key(field: FieldInfo) -> ByKey | None:
    """How a field is read that is a table by keys of a design; None of any other."""
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
    """A field of a file; one whose default is ... is required.

    Args:
        description: what its value means.
        default: its value where it is left out.
        left_out: what counts where it is left out, where its default does not say so; "needed" where something must be
            given that is checked later.
        examples: lines of a file with it, in which `$name` stands for a text of the design that the file is about.
        at_least: least value of a whole number.
    """
    return Field(
        default, description=description, examples=list(examples), ge=at_least, json_schema_extra={"left out": left_out}
    )


def left_out(field: FieldInfo) -> str:
    """Return what `entry` was given as `left_out`; "" of any other field."""
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
SETTINGS = entry("replaces the value of this key of the design", {}, examples=('protocol.timestep = "0.1 ms"',))

"""The base class of sections of a design, and fields with units: text in files, checked, SI inside."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar, get_origin

from pydantic import BaseModel, ConfigDict, Field, ValidationInfo, field_validator
from pydantic.fields import FieldInfo

from forficula.errors import InputError
from forficula.quantities import Unit, as_written, format_quantity, parse_quantity, show_quantity

LENGTH = Unit(display="cm", si="m", example="12 cm")
SMALL_LENGTH = Unit(display="mm", si="m", example="5 mm")
ANGLE = Unit(display="deg", si="rad", example="15 deg")
MASS = Unit(display="g", si="kg", example="0.5 g")
DENSITY = Unit(display="g/cm^3", si="kg/m^3", example="1.27 g/cm^3")
MODULUS = Unit(display="MPa", si="Pa", example="1 MPa")
TIME = Unit(display="s", si="s", example="0.5 s")
LONG_TIME = Unit(display="d", si="s", example="30 d")
SHORT_TIME = Unit(display="ms", si="s", example="0.2 ms")
TORQUE = Unit(display="N cm", si="N m", example="50 N cm")
STIFFNESS = Unit(display="N/cm", si="N/m", example="10 N/cm")
TENDON_DAMPING = Unit(display="N s/m", si="N s/m", example="0.1 N s/m")
HINGE_STIFFNESS = Unit(display="N m/rad", si="N m/rad", example="3 N m/rad")
HINGE_DAMPING = Unit(display="N m s/rad", si="N m s/rad", example="1e-3 N m s/rad")
INERTIA = Unit(display="kg m^2", si="kg m^2", example="1e-5 kg m^2")
ANGULAR_SPEED = Unit(display="deg/s", si="rad/s", example="1 deg/s")
ACCELERATION = Unit(display="m/s^2", si="m/s^2", example="9.81 m/s^2")


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """Reader of a field with a unit: converts text with a unit to an SI float within bounds, also SI."""

    unit: Unit
    above: float = -math.inf
    at_least: float = -math.inf
    below: float = math.inf
    at_most: float = math.inf
    words: tuple[str, ...] = ()

    def read(self, value: object, *, in_si: bool) -> float | str:
        """Read text with a unit, or, inside the package, an SI float; raise InputError where it is out of bounds."""
        if isinstance(value, str) and value in self.words:
            return value
        plain = in_si and isinstance(value, float | int) and not isinstance(value, bool)
        number = float(value) if plain else self.parse(value)  # type: ignore[arg-type]
        rule = self._broken_rule(number)
        if rule is None and math.isfinite(number):
            return number
        got = show_quantity(number, self.unit) if plain else as_written(value).strip('"')
        if rule is None or not math.isfinite(number):
            raise InputError(f"need a finite number, got {got}")
        sign, bound = rule
        raise InputError(f"need {sign} {show_quantity(bound, self.unit) if bound else 0}, got {got}")

    def _broken_rule(self, number: float) -> tuple[str, float] | None:
        """Return the first bound that a number violates, with its sign; None if it violates none."""
        if not number > self.above:
            return ">", self.above
        if not number >= self.at_least:
            return ">=", self.at_least
        if not number < self.below:
            return "<", self.below
        return None if number <= self.at_most else ("<=", self.at_most)

    def parse(self, value: object) -> float:
        """Read text with a unit, regardless of the bounds; raise InputError where it is not a quantity."""
        try:
            return parse_quantity(value, self.unit)
        except InputError as error:
            words = "".join(f'; "{word}" is allowed, too' for word in self.words)
            raise InputError(f"{error}{words}") from None

    def __call__(self, schema: dict[str, Any]) -> None:
        """Declare the field in the JSON schema as text with a unit, or a list of such text."""
        schema.pop("anyOf", None)
        if schema.get("type") == "array":
            schema["items"] = {"type": "string", "examples": [self.unit.example]}
        else:
            schema |= {"type": "string", "examples": [self.unit.example]}


def quantity(
    unit: Unit,
    description: str,
    *,
    default: Any = ...,
    words: tuple[str, ...] = (),
    examples: list[Any] | None = None,
    **bounds: float,
) -> Any:
    """Define a field that `Quantity` reads; it is required without a default, and may be absent if that is None.

    Each entry of a tuple of floats is read in the same manner. Without examples, the example of the unit is used.
    """
    read = Quantity(unit=unit, words=words, **bounds)
    return Field(default, description=description, examples=examples, json_schema_extra=read)


def field_quantity(field: FieldInfo) -> Quantity | None:
    """Return the reader of a field, or None if the field has no unit."""
    return field.json_schema_extra if isinstance(field.json_schema_extra, Quantity) else None


class _Text(str):
    """Text whose repr has no quotation marks."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


_DIGITS = 6  # of values in the repr of a section
# names that tab completion leaves out
_HIDDEN = {
    *(name for name in dir(BaseModel) if not name.startswith("_")),
    *("about", "as_tables", "hash_values", "heading", "later", "natural", "once", "si_tables"),
}


class Section(BaseModel):
    """A section of a design file: frozen, no unknown keys."""

    # cached results; a slot keeps them out of copies, comparisons and pickles
    __slots__ = ("_cache",)

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    # one line for pages and new files, equal to the docstring, which Python may omit (-OO)
    about: ClassVar[str] = ""
    # heading of tables of the section; its key if empty
    heading: ClassVar[str] = ""
    # keys that were added later: they enter the hash only if they differ from their defaults, so old hashes stay valid
    later: ClassVar[tuple[str, ...]] = ()
    # keys whose values do not scale with the size of a structure: relaxation of materials, gravity, machines
    natural: ClassVar[tuple[str, ...]] = ()

    @field_validator("*", mode="before")
    @classmethod
    def _read_quantities(cls, value: object, info: ValidationInfo) -> object:
        reader = _readers(cls)[str(info.field_name)]
        if reader is None:
            return value
        field = cls.model_fields[str(info.field_name)]
        if value is None and not field.is_required():
            return value
        in_si = bool(info.context and info.context.get("si"))
        return _read_list(reader, value, in_si=in_si) if is_list(field) else reader.read(value, in_si=in_si)

    def __setattr__(self, name: str, value: object) -> None:
        """Refuse to change a value, and say how a changed design is made.

        Raises:
            AttributeError: always.
        """
        reader = _readers(type(self)).get(name)
        example = "..." if reader is None else f'"{reader.unit.example}"'
        raise AttributeError(
            f"{name}: designs do not change; design.with_values({{{self._key_text(name)}: {example}}})"
            " returns a changed design"
        )

    def _key_text(self, name: str) -> str:
        """Return the dotted key of a value for messages; a section does not know where it is in a design."""
        return f'"<section>.{name}"'

    def __dir__(self) -> list[str]:
        """Names for users: not those of pydantic, and not those for other modules."""
        return sorted(set(super().__dir__()) - _HIDDEN)

    def __repr_args__(self) -> Iterator[tuple[str, object]]:
        """Values with units; absent ones are left out."""
        for name, reader in _readers(type(self)).items():
            value = getattr(self, name)
            if value is None:
                continue
            yield name, value if reader is None else _with_unit(value, reader.unit)

    def as_tables(self, write: Callable[[float, Unit], object] = format_quantity) -> dict[str, Any]:
        """Return the section as TOML tables without absent values; `write` formats quantities, by default exactly."""
        tables: dict[str, Any] = {}
        for name, reader in _readers(type(self)).items():
            value = getattr(self, name)
            if isinstance(value, Section):
                tables[name] = _tables(value, write)
            elif isinstance(value, tuple):
                tables[name] = [
                    _tables(item, write)
                    if isinstance(item, Section)
                    else write(item, reader.unit)
                    if reader and isinstance(item, float)
                    else item
                    for item in value
                ]
            elif value is not None:
                tables[name] = write(value, reader.unit) if reader and isinstance(value, float) else value
        return tables

    def si_tables(self) -> dict[str, Any]:
        """Return the section as tables with SI floats; the result is cached and must not be changed."""
        tables: dict[str, Any] = self.once("tables", lambda: self.as_tables(in_si))
        return tables

    def once(self, name: str, make: Callable[[], Any]) -> Any:
        """Return a cached result by its name; compute it at the first call, since a section is frozen."""
        try:
            cached: dict[str, Any] = object.__getattribute__(self, "_cache")
        except AttributeError:
            cached = {}
            object.__setattr__(self, "_cache", cached)
        if name not in cached:
            cached[name] = make()
        return cached[name]

    def hash_values(self) -> dict[str, Any]:
        """Return the values that enter the hash, SI, as plain data; absent values are left out."""
        values: dict[str, Any] = {}
        defaults = {name: type(self).model_fields[name].default for name in self.later}
        for name in _readers(type(self)):
            value = getattr(self, name)
            if name in self.later and value == defaults[name]:
                continue
            if isinstance(value, Section):
                values[name] = _hash_values(value)
            elif isinstance(value, tuple):
                values[name] = [_hash_values(item) if isinstance(item, Section) else item for item in value]
            elif value is not None:
                values[name] = value
        return values


def _with_unit(value: object, unit: Unit) -> object:
    """Return a value whose repr has its unit: a number or several; words stay."""
    if isinstance(value, tuple):
        return [_with_unit(item, unit) for item in value]
    return _Text(show_quantity(value, unit, _DIGITS)) if isinstance(value, float) else value


def kind_tag(section: object) -> str | None:
    """Return the tag of a section or of its table in a union of sections by its kind; None if the kind is not text.

    A discriminator by key would not allow validators that run before. "<" and ">" distinguish tags from keys in errors.
    """
    kind = section.get("kind") if isinstance(section, dict) else getattr(section, "kind", None)
    return f"<{kind}>" if isinstance(kind, str) else None


def in_si(value: float, _: Unit) -> float:
    """Return a value unchanged, as tables in SI have it."""
    return value


def _tables(section: Section, write: Callable[[float, Unit], object]) -> dict[str, Any]:
    return section.si_tables() if write is in_si else section.as_tables(write)


def _hash_values(section: Section) -> dict[str, Any]:
    values: dict[str, Any] = section.once("hash values", section.hash_values)
    return values


@cache  # called for every field of every section of every design that is read or changed
def _readers(section: type[Section]) -> dict[str, Quantity | None]:
    """Return the reader of each field of a section, None for a field without a unit."""
    return {name: field_quantity(field) for name, field in section.model_fields.items()}


def is_list(field: FieldInfo) -> bool:
    """Return whether a field is a list."""
    return get_origin(field.annotation) is tuple


def _read_list(reader: Quantity, values: object, *, in_si: bool) -> tuple[float | str, ...]:
    if not isinstance(values, list | tuple):
        raise InputError(f'need a list such as ["{reader.unit.example}"], got {as_written(values)}')
    read = []
    for number, value in enumerate(values):
        try:
            read.append(reader.read(value, in_si=in_si))
        except InputError as error:
            raise InputError(f"entry {number}: {error}") from None
    return tuple(read)

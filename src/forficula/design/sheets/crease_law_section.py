"""Sections for laws of creases: the values of a spring that a law file may contain, in a design."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Discriminator, Field, ModelWrapValidatorHandler, Tag, ValidationError, model_validator

from forficula.design.section import ANGLE, SMALL_LENGTH, Section, quantity
from forficula.errors import InputError
from forficula.material.law.crease_law_file import (
    CREASE_DAMPING,
    CREASE_MOMENT,
    CREASE_STIFFNESS,
    FORMS,
    CreaseLawFile,
    load_crease_law,
)

# words for a rest angle
RESTS = ("as built", "flat")


class CreaseSpring(Section):
    """The values of a crease that a law file may contain; groups have them, too."""

    about: ClassVar[str] = "The values of a crease that a law file may contain; groups have them, too"

    stiffness: float | None = quantity(
        CREASE_STIFFNESS, "stiffness of the springs per length of the crease", default=None, at_least=0
    )
    rest_angle: float | str | None = quantity(
        ANGLE, "rest angle of the springs", default=None, words=RESTS, examples=["0 deg"]
    )
    yield_moment: float | None = quantity(
        CREASE_MOMENT, "moment per length of the crease at which it begins to fold permanently", default=None, above=0
    )
    hardening: float | None = quantity(
        CREASE_STIFFNESS,
        "slope of the moment while a crease yields, per length of the crease",
        default=None,
        at_least=0,
        examples=["1e-3 N m/rad/m"],
    )
    damping: float | None = quantity(
        CREASE_DAMPING, "viscous damping per length of the crease", default=None, at_least=0
    )


class CreaseLawSection(CreaseSpring):
    """The law of creases: values per length of the crease that a law file or the name of a law gives.

    It is read from values by key, from the name of a law or the path of a law file, or from values with either of these
    under `based_on`.
    """

    about: ClassVar[str] = (
        "The law of creases: values per length of the crease that a law file or the name of a law gives"
    )

    name: Annotated[str, Field(description="name of the law")] = ""
    source: Annotated[str, Field(description="where the values of the law come from")] = ""
    thickness: float | None = quantity(
        SMALL_LENGTH, "thickness of the sheet to which the values apply", default=None, above=0
    )
    width: float | None = quantity(
        SMALL_LENGTH, "length of the crease on which the values were measured", default=None, above=0
    )
    chosen: Annotated[
        tuple[str, ...], Field(description="keys whose values are chosen, not measured", examples=[["hardening"]])
    ] = ()
    kind: Annotated[Literal["linear", "locking"], Field(description="law of the elastic part of the spring")] = "linear"

    @model_validator(mode="wrap")
    @classmethod
    def _read_by_name(cls, value: object, read: ModelWrapValidatorHandler[Self]) -> Self:
        if isinstance(value, str | CreaseLawFile):
            value = {"based_on": value}
        if not isinstance(value, dict) or not isinstance(named := value.get("based_on"), str | CreaseLawFile):
            return read(value)
        file = named if isinstance(named, CreaseLawFile) else load_crease_law(named)
        values = {key: inside for key, inside in value.items() if key != "based_on"}
        try:
            return read(file.tables | values)
        except ValidationError:
            cls._check_file(file, named if isinstance(named, str) else file.name)
            raise

    @classmethod
    def _check_file(cls, file: CreaseLawFile, name: str) -> None:
        """Refuse values of a law file that are not allowed, with the name of the file and their keys in it."""
        from forficula.design.files.rejection import rejected

        try:
            cls.model_validate(file.tables)
        except ValidationError as error:
            message = str(rejected(error, cls))
            section = "" if message.partition(":")[0] in ("name", "source", "thickness", "width") else "crease."
            raise InputError(f"{name}: {section}{message}") from None

    def hash_values(self) -> dict[str, Any]:
        """Return the values that affect a run: all but names, sources and the size of the specimen."""
        described = ("name", "source", "thickness", "width", "chosen")
        return {key: value for key, value in super().hash_values().items() if key not in described}


def _form(value: object) -> str:
    return "<word>" if isinstance(value, str) and value in FORMS else "<law>"


# the form of a spring, or a law with its values
CreaseLawValue = Annotated[
    Annotated[Literal["linear", "locking"], Tag("<word>")] | Annotated[CreaseLawSection, Tag("<law>")],
    Discriminator(_form),
]

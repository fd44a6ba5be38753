"""Design: what every one has, whatever is built: a name, a source, a protocol, bounds on what can be computed."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self, cast

from pydantic import Field, field_validator

from forficula.design.files.provenance import WORDS, check_paper
from forficula.design.make import MakeSection
from forficula.design.medium import MediumSection
from forficula.design.named_protocol import NamedProtocol
from forficula.design.protocol import Protocol
from forficula.design.section import SHORT_TIME, TIME, Section
from forficula.design.stops import StopSection
from forficula.displayed import Displayed
from forficula.errors import InputError
from forficula.names import folder_name
from forficula.quantities import show_quantity

if TYPE_CHECKING:
    from forficula.design.chosen import Choice

_MOST_STEPS = 1e9
# rows of a record times parts: some 5 GB in memory
_MOST_ROWS = 1e7


@dataclass(frozen=True, kw_only=True)
class DesignIdentity:
    """What results are of.

    Attributes:
        design: name of the design.
        design_hash: hash of all its values.
    """

    design: str
    design_hash: str


class Design(Displayed, Section):
    """The thing to build and what is done to it; every number in SI and radians."""

    # key of a value that every design of its kind has, for a study to begin with
    varied_key: ClassVar[str]
    # a named design that a new file begins with; None: `example` has the keys of a pattern to begin with
    reference: ClassVar[str | None] = None
    example: ClassVar[Mapping[str, object]] = {}
    # publications of its pattern and model, by their keys in analysis/citations.py, and what is taken from each
    papers: ClassVar[Mapping[str, str]] = {}
    # keys, or starts of keys, of what matters to where it rests, but for its tendons
    rest_keys: ClassVar[tuple[str, ...]]
    # the section that says how heavy it is, which matters to where it rests under gravity
    weight_section: ClassVar[str]

    name: Annotated[str, Field(min_length=1, description="what outputs call it")]
    source: Annotated[str, Field(description="where its values come from")]
    shows: Annotated[
        str | None, Field(description="what one would look at it for", examples=["how a sheet folds all at once"])
    ] = None
    reproduces: Annotated[
        str | None, Field(description="the paper that its figures are set beside", examples=["binder2025"])
    ] = None
    medium: Annotated[MediumSection | None, Field(description="what it moves in; without it, empty space")] = None
    stops: Annotated[StopSection, Field(description="how stops of hinges and guard tendons give way")] = StopSection()
    make: Annotated[
        MakeSection | None, Field(description="how its parts are made; without it, by the defaults of each key")
    ] = None
    protocol: Protocol

    @field_validator("medium")
    @classmethod
    def _is_there(cls, medium: MediumSection | None) -> MediumSection | None:
        """Empty space is no medium."""
        return medium if medium is not None and (medium.density or medium.viscosity) else None

    @field_validator("name")
    @classmethod
    def _names_a_folder(cls, name: str) -> str:
        return folder_name(name)

    @field_validator("reproduces")
    @classmethod
    def _names_a_paper(cls, reproduces: str | None) -> str | None:
        return reproduces if reproduces is None else check_paper(reproduces)

    def __repr__(self) -> str:
        """The design by its name; `print` writes its file, with units."""
        return f"<{type(self).__name__} {self.name}, hash {self.hash}>"

    def _key_text(self, name: str) -> str:
        return f'"{name}"'

    def __str__(self) -> str:
        """The design file."""
        from forficula.design.files.design_file import design_text

        return design_text(self)

    @property
    def has_stops_of_bodies(self) -> bool:
        """Whether its hinges have stops, or its bodies guard tendons, that go by `stops`."""
        return True

    @property
    def hash(self) -> str:
        """Sixteen hexadecimal digits that name the values, whatever the design or its material is called."""
        name: str = self.once("hash", lambda: _hash(self.hash_values()))
        return name

    @property
    def identity(self) -> DesignIdentity:
        """Its name and hash, as files of results have them."""
        return DesignIdentity(design=self.name, design_hash=self.hash)

    @property
    def named_protocol(self) -> NamedProtocol:
        """Its protocol by names, in the form that designs of every kind have."""
        raise NotImplementedError

    @property
    def chosen(self) -> tuple[Choice, ...]:
        """The values that a rule chooses, for they are not given; there are such of sheets."""
        return ()

    @property
    def idle(self) -> tuple[str, ...]:
        """What is given and does nothing, a sentence each."""
        return ()

    def with_values(self, values: Mapping[str, object]) -> Self:
        """The design with some values replaced, by dotted key: text with a unit, or a number in SI.

        Raises:
            InputError: an unknown key, or a value that is not allowed.
        """
        from forficula.design.files.design_file import with_values

        return cast(Self, with_values(self, values))

    def with_other_start(self) -> Self | None:
        """Return the design with a start that differs slightly; None where its start has no value to vary.

        A verdict that another start changes is no property of the structure.
        """
        return None

    def settled(self) -> Self:
        """The design with the values that a rule chooses."""
        return self

    def hash_values(self) -> dict[str, Any]:
        """The values but for what they are called, where they come from, and how parts are made: a run is the same."""
        return {key: value for key, value in super().hash_values().items() if key not in (*WORDS, "make")}


def _hash(values: dict[str, Any]) -> str:
    return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()[:16]


def check_duration(design: Design, parts: int, what: str) -> None:
    """Refuse a run of more steps than anyone waits for, and a record of more rows than memory holds.

    Args:
        design: with its protocol.
        parts: how many parts of the structure a row has the numbers of.
        what: what these parts are called.

    Raises:
        InputError: a timestep or sample interval that is too long or too short.
    """
    protocol, longest = design.protocol, sum(stage.time_limit for stage in design.protocol.stages)
    timestep = 0.0 if protocol.timestep == "auto" else protocol.timestep
    least = longest / _MOST_STEPS
    if timestep and not least <= timestep <= longest:
        raise InputError(
            f"protocol.timestep: need >= {show_quantity(least, SHORT_TIME)} and <= {show_quantity(longest, TIME)},"
            f" so that all stages together, {show_quantity(longest, TIME)} at most, take 1 to {_MOST_STEPS:g}"
            f" steps, got {show_quantity(timestep, SHORT_TIME)}"
        )
    shortest = shortest_sample_interval(design, parts)
    if max(timestep, protocol.sample_interval) < shortest:
        raise InputError(
            f"protocol.sample_interval: need >= {show_quantity(shortest, SHORT_TIME)}, so that the record of"
            f" {parts} {what} over {show_quantity(longest, TIME)} at most fits into memory,"
            f" got {show_quantity(protocol.sample_interval, SHORT_TIME)}"
        )


def shortest_sample_interval(design: Design, parts: int) -> float:
    """The least time between two rows, s, at which the longest record that there can be fits into memory."""
    return sum(stage.time_limit for stage in design.protocol.stages) * parts / _MOST_ROWS

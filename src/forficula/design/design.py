"""The base class of all designs: a name, a source, a protocol, and bounds on what can be computed."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self, cast

from pydantic import Field, field_validator

from forficula.design.files.provenance import DESCRIPTIVE_KEYS, check_paper
from forficula.design.make import MakeSection
from forficula.design.medium import MediumSection
from forficula.design.named_protocol import NamedProtocol
from forficula.design.protocol import Protocol
from forficula.design.section import SHORT_TIME, TIME, Section
from forficula.design.stops import StopSection
from forficula.design.table import TableSection
from forficula.displayed import Displayed
from forficula.errors import InputError
from forficula.names import folder_name
from forficula.quantities import Unit, show_quantity

if TYPE_CHECKING:
    from forficula.design.chosen import Choice

_MOST_STEPS = 1e9
# rows of a record times number of parts: about 5 GB in memory
_MOST_ROWS = 1e7

# sentence about the direction of gravity in a design without gravity and without a table, which is normal to gravity
WITHOUT_GRAVITY = (
    'protocol.gravity_direction has no effect without gravity: need protocol.gravity = "9.81 m/s^2" or a [table]'
)


@dataclass(frozen=True, kw_only=True)
class DesignIdentity:
    """The design that a result belongs to.

    Attributes:
        design: name of the design.
        design_hash: hash of all values of the design.
    """

    design: str
    design_hash: str


class Design(Displayed, Section):
    """The structure to build and the protocol that is applied to it; every number in SI units and radians."""

    # key of a value that every design of its kind has; the template of a study varies it
    varied_key: ClassVar[str]
    # named design on which a new file is based; where it is None, `example` has the first keys of a pattern
    reference: ClassVar[str | None] = None
    example: ClassVar[Mapping[str, object]] = {}
    # publications of its pattern and model, by their keys in analysis/citations.py, and what is taken from each
    papers: ClassVar[Mapping[str, str]] = {}
    # keys, or beginnings of keys, on which the rest states depend, apart from the tendons
    rest_keys: ClassVar[tuple[str, ...]]
    # sections with the masses, on which the rest states under gravity depend
    weight_sections: ClassVar[tuple[str, ...]]

    name: Annotated[str, Field(min_length=1, description="name of the design in all outputs")]
    source: Annotated[str, Field(description="where the values of the design come from")]
    shows: Annotated[
        str | None, Field(description="what the design demonstrates", examples=["how a sheet folds all at once"])
    ] = None
    reproduces: Annotated[
        str | None, Field(description="paper with which the results are compared", examples=["binder2025"])
    ] = None
    medium: Annotated[MediumSection | None, Field(description="fluid around the structure; a vacuum if not given")] = (
        None
    )
    stops: Annotated[StopSection, Field(description="compliance of hinge stops and guard tendons")] = StopSection()
    table: Annotated[
        TableSection | None, Field(description="table that the structure cannot pass through; none if not given")
    ] = None
    make: Annotated[
        MakeSection | None, Field(description="how the parts are made; by the default of each key if not given")
    ] = None
    protocol: Protocol

    @field_validator("medium")
    @classmethod
    def _not_a_vacuum(cls, medium: MediumSection | None) -> MediumSection | None:
        """Return None for a medium without density and viscosity."""
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
        """Return the class, the name and the hash; `print` writes the design file, with units."""
        return f"<{type(self).__name__} {self.name}, hash {self.hash}>"

    def _key_text(self, name: str) -> str:
        return f'"{name}"'

    def __str__(self) -> str:
        """Return the design file as text."""
        from forficula.design.files.design_file import design_text

        return design_text(self)

    @property
    def method_papers(self) -> Mapping[str, str]:
        """Publications of methods that the design chooses, as `papers`."""
        return {}

    @property
    def has_stops_of_bodies(self) -> bool:
        """Whether hinges have stops, or bodies guard tendons, to which the section `stops` applies."""
        return True

    @property
    def hash(self) -> str:
        """Sixteen hexadecimal digits that identify the values, not the names of the design and its material."""
        name: str = self.once("hash", lambda: _hash(self.hash_values()))
        return name

    @property
    def identity(self) -> DesignIdentity:
        """Name and hash of the design, as in files of results."""
        return DesignIdentity(design=self.name, design_hash=self.hash)

    @property
    def named_protocol(self) -> NamedProtocol:
        """The protocol by names, in the form that is common to all kinds of designs."""
        raise NotImplementedError

    @property
    def measure_units(self) -> dict[str, Unit]:
        """Names of measures and of roles of hinges that a bound may have, with their units."""
        raise NotImplementedError

    @property
    def chosen(self) -> tuple[Choice, ...]:
        """The values that are not given and that a rule chooses; only sheets have such values."""
        return ()

    @property
    def idle(self) -> tuple[str, ...]:
        """Sentences about given values that have no effect."""
        acts = self.protocol.gravity or self.table is not None or self.protocol.gravity_direction == "-z"
        return () if acts else (WITHOUT_GRAVITY,)

    @property
    def law_sentences(self) -> tuple[str, ...]:
        """Sentences about laws of creases with chosen values, or for a sheet of another thickness."""
        return ()

    def with_values(self, values: Mapping[str, object]) -> Self:
        """Return the design with some values replaced, by dotted key: text with a unit, or a number in SI.

        Raises:
            InputError: an unknown key, or a value that is not allowed.
        """
        from forficula.design.files.design_file import with_values

        return cast(Self, with_values(self, values))

    def with_other_start(self) -> Self | None:
        """Return the design with a start that differs slightly; None where its start has no value to vary.

        A verdict that changes with a slightly different start is not a property of the structure.
        """
        return None

    def settled(self) -> Self:
        """Return the design with the values that a rule chooses filled in."""
        return self

    def with_contact_time(self, time_constant: float) -> Self:  # noqa: ARG002
        """Return the design with a time constant of contact, s, where it is "auto"; the same design where it is not."""
        return self

    def hash_values(self) -> dict[str, Any]:
        """Return the values that affect a run: all but names, sources, and how the parts are made."""
        return {key: value for key, value in super().hash_values().items() if key not in (*DESCRIPTIVE_KEYS, "make")}


def _hash(values: dict[str, Any]) -> str:
    return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()[:16]


def check_duration(design: Design, parts: int, what: str) -> None:
    """Refuse a run of more than 1e9 steps, and a record that does not fit into memory.

    Args:
        design: design with its protocol.
        parts: number of parts of the structure in a row of the record.
        what: name of these parts, for messages.

    Raises:
        InputError: the timestep or the sample interval is too long or too short.
    """
    protocol, longest = design.protocol, _longest_motion(design.protocol)
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
    """Return the shortest time between two rows, s, at which the longest possible record fits into memory."""
    return _longest_motion(design.protocol) * parts / _MOST_ROWS


def _longest_motion(protocol: Protocol) -> float:
    """Return the longest time that is simulated in steps, s; quasi-static stages, which take few steps, do not count.

    If all stages are quasi-static, it is the longest duration of all of them, so that the timestep has a bound.
    """
    moving = [stage.time_limit for stage in protocol.stages if not stage.quasi_static]
    return sum(moving or [stage.time_limit for stage in protocol.stages])

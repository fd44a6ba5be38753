"""Designs of assemblies: parts, each a design of any kind, the joints between them, and one protocol for all."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, create_model, model_validator

from forficula.design.assembly.joints import (
    CouplingJoint,
    HingeDrive,
    HingeJoint,
    Joint,
    JointDrive,
    PlacingJoint,
    drive_targets,
)
from forficula.design.chosen import Choice
from forficula.design.design import WITHOUT_GRAVITY, Design
from forficula.design.named_protocol import Action, Drive, NamedProtocol
from forficula.design.protocol import CommonProtocol, check_stages, read_goal
from forficula.design.section import ANGLE
from forficula.design.stage_protocol import is_bound, rest_states, stage_transitions
from forficula.errors import InputError
from forficula.names import listed, one_of
from forficula.quantities import Unit, as_written

# names of parts begin dotted keys, bounds and names in the structure
_NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")
# keys of the protocol that parts take from the assembly
_SURROUNDINGS = ("gravity", "gravity_direction", "contact")


class AssemblyDesign(Design):
    """Parts, each a design of any kind, the joints between them, and one protocol for all.

    A class that `assembly_class` creates has a further field for every part. Medium, stops, gravity and contact are
    those of the assembly. Of the protocol of a part, only the values that its drives, its goals and its initial shape
    use have an effect.
    """

    # parts of the class by name
    part_classes: ClassVar[Mapping[str, type[Design]]] = {}

    source: Annotated[str, Field(description="where the values of the design come from")] = ""
    parts: Annotated[
        tuple[str, ...],
        Field(min_length=1, description="names of the parts, in order; their tables [part.NAME] set it"),
    ]
    joint: Annotated[
        tuple[Joint, ...],
        Field(description="joints between the parts; what a part fixes to the ground stays there without a joint"),
    ] = ()
    drive: Annotated[
        tuple[JointDrive, ...], Field(description="drives of the assembly, in addition to those of its parts")
    ] = ()
    protocol: CommonProtocol

    def __reduce__(self) -> Any:
        """Pickle without the class, which exists only in this process."""
        return _restored, (_recipe(type(self)), self.__getstate__())

    @model_validator(mode="before")
    @classmethod
    def _named_parts(cls, tables: Any) -> Any:
        """Give parts without a name or a source those of the assembly."""
        if not isinstance(tables, dict):
            return tables
        missing = {
            name: {"name": name, "source": tables.get("source", ""), **tables[name]}
            for name in cls.part_classes
            if isinstance(tables.get(name), dict)
        }
        return {**tables, **missing}

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        self._check_joints()
        self._check_drives()
        named = self.named_protocol
        goals = [name for name in self._part_goals if name]
        check_stages(self.protocol, [drive.name for drive in named.drives], goals, self.measure_units)
        return self

    @property
    def designs(self) -> dict[str, Design]:
        """The designs of the parts by name, with medium, stops, gravity and contact of the assembly."""
        made: dict[str, Design] = self.once("designs", lambda: {name: self._surrounded(name) for name in self.parts})
        return made

    def _surrounded(self, name: str) -> Design:
        """Return the design of a part in the surroundings of the assembly."""
        part: Design = getattr(self, name)
        protocol = part.protocol.model_copy(update={key: getattr(self.protocol, key) for key in _SURROUNDINGS})
        # a part without stops of bodies refuses a compliance of stops
        stops = self.stops if part.has_stops_of_bodies else part.stops
        return part.model_copy(update={"medium": self.medium, "stops": stops, "protocol": protocol})

    @property
    def placing(self) -> dict[str, PlacingJoint]:
        """The joints that carry parts, by part."""
        return {joint.part: joint for joint in self.joint if isinstance(joint, PlacingJoint)}

    @property
    def order(self) -> tuple[str, ...]:
        """Names of the parts, each after the part that carries it."""
        ordered: list[str] = []
        for name in self.parts:
            chain = [name]
            while (below := self._carrier(chain[-1])) is not None:
                chain.append(below)
            ordered += [part for part in reversed(chain) if part not in ordered]
        return tuple(ordered)

    def _carrier(self, name: str) -> str | None:
        """Return the name of the part with the body that carries a part; None for the ground."""
        joint = self.placing.get(name)
        carrier = "" if joint is None else joint.to.partition(".")[0]
        return carrier if carrier in self.parts else None

    def _check_joints(self) -> None:
        """Refuse parts and joints that do not exist, parts that two joints carry, and parts that carry themselves."""
        names: list[str] = []
        carried: dict[str, str] = {}
        coupled: dict[frozenset[str], str] = {}
        for number, joint in enumerate(self.joint):
            key = f"joint.{number}"
            if joint.name in (*names, *self.parts):
                raise InputError(f"{key}.name: need a name that no part and no other joint has, got {joint.name}")
            names.append(joint.name)
            if isinstance(joint, CouplingJoint):
                if joint.hinges[0] == joint.hinges[1]:
                    raise InputError(f"{key}.hinges: need two different hinges, got twice {joint.hinges[0]}")
                pair = frozenset(joint.hinges)
                if pair in coupled:
                    raise InputError(f"{key}.hinges: need hinges that joint {coupled[pair]} does not couple already")
                coupled[pair] = joint.name
            if not isinstance(joint, PlacingJoint):
                continue
            if joint.part not in self.parts:
                raise InputError(f"{key}.part: need {one_of(self.parts, joint.part)}")
            if joint.part in carried:
                raise InputError(f"{key}.part: need a part that joint {carried[joint.part]} does not carry already")
            carried[joint.part] = joint.name
            part, _, body = joint.to.partition(".")
            if joint.to != "ground" and (part not in self.parts or not body):
                raise InputError(
                    f'{key}.to: need "ground" or a body of a part, such as "{self.parts[0]}.NAME", got'
                    f" {as_written(joint.to)}"
                )
        for name in self.parts:
            chain = [name]
            while (below := self._carrier(chain[-1])) is not None:
                if below in chain:
                    raise InputError(f"joint.{carried[name]}.to: need a body that {name} does not carry itself")
                chain.append(below)

    def _check_drives(self) -> None:
        """Refuse two drives with one name, and drives that act on nothing or twice on the same."""
        names = [drive.name for drive in self.drive]
        for number, name in enumerate(names):
            if name in names[:number]:
                raise InputError(f"drive.{number}.name: need a name that no other drive has, got {as_written(name)}")
            targets = drive_targets(self.drive[number])
            if not targets or len(set(targets)) < len(targets):
                raise InputError(f"drive.{number}.of: need names that differ, at least one, got {as_written(targets)}")

    @property
    def measure_units(self) -> dict[str, Unit]:
        """Names that a bound may have, with the part's name before each, and their units."""
        units = {
            f"{name}.{measure}": unit
            for name, part in self.designs.items()
            for measure, unit in part.measure_units.items()
        }
        return units | {joint.name: ANGLE for joint in self.joint if isinstance(joint, HingeJoint)}

    @property
    def _part_goals(self) -> dict[str, str]:
        """Goals of the parts by name, as bounds."""
        return {
            f"{name}.{goal}": with_part(name, text)
            for name, part in self.designs.items()
            for goal, text in part.named_protocol.goals.items()
            if read_goal(goal) is None
        }

    @property
    def named_protocol(self) -> NamedProtocol:
        """The drives of all parts and of the assembly, and the states and transitions of its stages."""
        stages, goals = self.protocol.stages, self._part_goals
        used = [stage.until for stage in stages if is_bound(stage)]
        distances = [name for name, unit in self.measure_units.items() if unit is not ANGLE]
        return NamedProtocol(
            drives=(*self._part_drives, *map(self._added_drive, self.drive)),
            goals={goal: goals.get(goal, goal) for goal in dict.fromkeys([*goals, *used])},
            states=rest_states(stages),
            stage_states=tuple(stage.state or "" for stage in stages),
            transitions=stage_transitions(stages, distances, lambda text: read_goal(goals.get(text, text))),
        )

    @property
    def _part_drives(self) -> Iterator[Drive]:
        """The drives of the parts, whose actions name hinges and places of the part alone."""
        for name, part in self.designs.items():
            for drive in part.named_protocol.drives:
                yield replace(
                    drive, name=f"{name}.{drive.name}", key=f"{name}.{drive.key}", where=f"{drive.where} of {name}"
                )

    def _added_drive(self, drive: Any) -> Drive:
        """Return a drive of the assembly with its one action."""
        hinged = isinstance(drive, HingeDrive)
        targets = drive_targets(drive)
        return Drive(
            name=drive.name,
            actions=(
                Action(
                    motor=drive.name,
                    kind=drive.kind,
                    hinges=targets if hinged else (),
                    places=() if hinged else targets,
                    direction=None if hinged else drive.direction,
                    **({"no_load_speed": drive.no_load_speed} if hinged and drive.no_load_speed else {}),
                ),
            ),
            rise=self.protocol.rise if drive.rise is None else drive.rise,
            key=f"drive.{drive.name}.{drive.strength_key}",
            strength=getattr(drive, drive.strength_key),
            where=f"on {listed(targets)}",
        )

    @property
    def chosen(self) -> tuple[Choice, ...]:
        """The values that are not given and that a rule chooses, with the part's name before their sections."""
        return tuple(
            replace(choice, section=f"{name}.{choice.section}")
            for name, part in self.designs.items()
            for choice in part.chosen
        )

    @property
    def idle(self) -> tuple[str, ...]:
        """Sentences about values of the assembly and of its parts that have no effect."""
        of_parts = ((name, sentence) for name, part in self.designs.items() for sentence in part.idle)
        inside = (f"{name}: {sentence}" for name, sentence in of_parts if sentence != WITHOUT_GRAVITY)
        return (*super().idle, *self._replaced, *inside)

    @property
    def _replaced(self) -> Iterator[str]:
        """Sentences about surroundings that parts give and that those of the assembly replace."""
        for name in self.parts:
            part = getattr(self, name)
            sections = {key: (getattr(part, key), None) for key in ("medium", "table")}
            values = {
                f"protocol.{key}": (getattr(part.protocol, key), CommonProtocol.model_fields[key].default)
                for key in _SURROUNDINGS
            }
            for key, (value, default) in (sections | values).items():
                common: Any = self.protocol if key.startswith("protocol.") else self
                if value not in (default, getattr(common, key.removeprefix("protocol."))):
                    yield f"{name}.{key} has no effect in a part; set {key} of the assembly"

    @property
    def method_papers(self) -> Mapping[str, str]:
        """Publications of methods that parts choose."""
        return {key: use for part in self.designs.values() for key, use in part.method_papers.items()}

    @property
    def law_sentences(self) -> tuple[str, ...]:
        """Sentences about laws of creases of parts."""
        return tuple(f"{name}: {sentence}" for name, part in self.designs.items() for sentence in part.law_sentences)

    @property
    def has_stops_of_bodies(self) -> bool:
        """Whether a part, or a hinge between parts, has stops."""
        return any(part.has_stops_of_bodies for part in self.designs.values()) or any(
            isinstance(joint, HingeJoint) for joint in self.joint
        )

    def with_other_start(self) -> Self | None:
        """Return the design with a slightly different start of its parts; None where no start has a value to vary."""
        changed = {name: getattr(self, name).with_other_start() for name in self.parts}
        changed = {name: part for name, part in changed.items() if part is not None}
        return self.model_copy(update=changed) if changed else None

    def settled(self) -> Self:
        """Return the design with the values that a rule chooses filled in, in the surroundings of the assembly."""
        return self.model_copy(update={name: part.settled() for name, part in self.designs.items()})

    def with_contact_time(self, time_constant: float) -> Self:
        """Return the design with a time constant of contact, s, where it is "auto"; the same design where it is not."""
        parts = {name: (part, part.with_contact_time(time_constant)) for name, part in self.designs.items()}
        changes = {name: changed for name, (part, changed) in parts.items() if changed is not part}
        return self.model_copy(update=changes) if changes else self

    def hash_values(self) -> dict[str, Any]:
        """Return the values that affect a run, including those that a rule chooses."""
        return super(AssemblyDesign, self.settled()).hash_values()


def with_part(part: str, text: str) -> str:
    """Return a bound of a part as text, with the part's name before the measure."""
    written = read_goal(text)
    return text if written is None else f"{part}.{written.name} {written.relation} {written.value}"


def part_names(tables: Mapping[str, object]) -> tuple[str, ...]:
    """Return the names of the parts in the unchecked tables of an assembly; none for another design."""
    names = tables.get("parts")
    return tuple(name for name in names if isinstance(name, str)) if isinstance(names, list | tuple) else ()


def check_part_name(name: str) -> str:
    """Return the name of a part, if it is allowed.

    Raises:
        InputError: the name cannot begin a key, or an assembly has a key of this name.
    """
    if not _NAME.fullmatch(name):
        raise InputError(
            "part: need a name of at most 40 small letters, digits and _ that begins with a letter, got"
            f" {as_written(name)}"
        )
    if name in (*AssemblyDesign.model_fields, "part", "tendon", "ground") or hasattr(AssemblyDesign, name):
        raise InputError(f"part.{name}: need a name that is not a key of an assembly")
    return name


@lru_cache(maxsize=64)
def assembly_class(parts: tuple[tuple[str, type[Design]], ...]) -> type[AssemblyDesign]:
    """Return the class of assemblies of parts with these names and classes."""
    fields: dict[str, Any] = {
        name: (model, Field(description=f"the part {name}, a design of its own")) for name, model in parts
    }
    created = create_model("AssemblyDesign", __base__=AssemblyDesign, **fields)
    created.part_classes = dict(parts)
    created.varied_key = next((f"{name}.{model.varied_key}" for name, model in parts), "")
    created.papers = {key: text for _, model in parts for key, text in model.papers.items()}
    created.rest_keys = (
        "joint",
        "protocol.gravity",
        "protocol.gravity_direction",
        *(f"{name}.{key}" for name, model in parts for key in model.rest_keys if not key.startswith("protocol.stages")),
    )
    created.weight_sections = tuple(f"{name}.{section}" for name, model in parts for section in model.weight_sections)
    return created


def _recipe(model: type[Design]) -> Any:
    """Return what `assembly_class` needs to create a class again: pairs of names and classes, or of further pairs."""
    if not issubclass(model, AssemblyDesign):
        return model
    return tuple((name, _recipe(part)) for name, part in model.part_classes.items())


def _class_of(recipe: Any) -> type[Design]:
    if isinstance(recipe, type):
        return recipe
    return assembly_class(tuple((name, _class_of(part)) for name, part in recipe))


def _restored(recipe: Any, state: Any) -> Design:
    """Create an assembly from its class, as `_recipe` returns it, and its state."""
    design = _class_of(recipe).__new__(_class_of(recipe))
    design.__setstate__(state)
    return design

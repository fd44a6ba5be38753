"""Quantities that goals are set by: what there is of a design, of its statics and of its runs, by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from forficula.design import Design, key_quantity, key_value
from forficula.design.section import LENGTH, MASS, TIME, TORQUE
from forficula.errors import InputError
from forficula.names import near_name
from forficula.quantities import Unit
from forficula.serial import unit_suffix
from forficula.structure import Structure, Transition, distances_of, drive_of, drive_unit, first_state, structure_of
from forficula.study.files.search_file import read_search

ENERGY = Unit(display="mJ", si="J", example="5 mJ")
FORCE = Unit(display="N", si="N", example="5 N")
ANGLE = Unit(display="deg", si="rad", example="150 deg")
SHARE = Unit(display="%", si="", example="95 %")
_DRIVE_UNITS = {"N m": TORQUE, "N": FORCE, "m": LENGTH, "rad": ANGLE}

# what it takes to know one: nothing but the design; its parts; closed forms of hinges that tendons cross, in ms;
# the energy along its fold, 0.2 s; slowly growing drives, up to seconds; a run; a run with all of its rows; some runs
# that look for the least value; runs of many neighbours
Source = Literal["design", "parts", "hinges", "fold", "slow", "run", "record", "search", "neighbours"]
SOURCES: tuple[Source, ...] = ("design", "parts", "hinges", "fold", "slow", "run", "record", "search", "neighbours")
STATIC: tuple[Source, ...] = ("parts", "hinges", "fold", "slow")

PROBABILITY = "probability"


@dataclass(frozen=True, kw_only=True)
class OutcomeQuantity:
    """A number that limits and objectives are about.

    Attributes:
        name: as goal files have it; of one that a design gives, its key.
        told_as: what rows call it, without its unit: the same but for spaces in names of states.
        unit: in which it is shown, and its SI unit.
        meaning: in words.
        source: what it takes to know it.
    """

    name: str
    told_as: str
    unit: Unit
    meaning: str
    source: Source

    @property
    def dimension(self) -> str:
        """Its name in tables."""
        return self.name.replace(".", "_")

    @property
    def column(self) -> str:
        """What rows call it: its name with its SI unit."""
        return self.told_as + unit_suffix(self.unit.si)


def quantities_of(design: Design) -> Mapping[str, OutcomeQuantity]:
    """All quantities that goals of a design may be about, by name; keys of the design come on top of these."""
    structure = structure_of(design)
    found = [_quantity("mass", MASS, "mass of everything that moves or is held", "parts")]
    if any(tendon.crossing is not None for tendon in structure.tendons):
        found += [
            _quantity("hinge_barrier", ENERGY, "least barrier of a hinge that a tendon crosses, alone", "hinges"),
            _quantity("hinge_holding_torque", TORQUE, "least torque that holds such a hinge on its stop", "hinges"),
            _quantity("hinge_opening_torque", TORQUE, "largest moment of such a hinge against opening", "hinges"),
        ]
    if structure.rigid_fold is not None:
        found += [
            _quantity("barrier", ENERGY, "energy to climb along the fold from its first state", "fold"),
            _quantity("opening_barrier", ENERGY, "energy to climb back along the fold", "fold"),
            _quantity("holding_torque", TORQUE, "torque on every hinge that turns that holds the first state", "fold"),
        ]
    for transition in structure.transitions:
        found += _of_transition(structure, transition)
    found += _of_states(structure)
    found.append(_quantity("residual", SHARE, "largest share of the energy that is missing in the run", "run"))
    found.append(_quantity("package_area", SHARE, "least outline of a named state by that at the start", "record"))
    found.append(_quantity("package_height", LENGTH, "height of the state with the least outline", "record"))
    if structure.transitions and drive_unit(structure, drive_of(structure, structure.transitions[0].drive)) == "N m":
        for step in read_search("least-torques", {}, design).steps:
            meaning = f"least torque that makes {step.transition}, of those tried"
            found.append(_quantity(step.least_name, step.unit, meaning, "search"))
    found.append(_quantity(PROBABILITY, SHARE, "share of designs within the tolerances that work", "neighbours"))
    return {each.name: each for each in found}


def quantity_of(design: Design, name: str) -> OutcomeQuantity:
    """A quantity of a design by name, or by a key of the design whose value has a unit.

    Raises:
        InputError: there is none, and which is near.
    """
    known = quantities_of(design)
    if name in known:
        return known[name]
    if "." in name:
        read = key_quantity(name, type(design))
        key_value(design, name)
        if read is None:
            raise InputError(f"{name}: need a key whose value has a unit")
        meaning = f"the design's {name}"
        return OutcomeQuantity(name=name, told_as=name, unit=read.unit, meaning=meaning, source="design")
    raise InputError(f"{name}: need a key of the design, or one of {', '.join(known)}{near_name(name, known)}")


def _quantity(name: str, unit: Unit, meaning: str, source: Source) -> OutcomeQuantity:
    return OutcomeQuantity(name=name.replace(" ", "_"), told_as=name, unit=unit, meaning=meaning, source=source)


def _of_transition(structure: Structure, transition: Transition) -> list[OutcomeQuantity]:
    """What a run and slowly growing drives tell of a transition."""
    name, wording = transition.name, transition.wording
    unit = drive_unit(structure, drive_of(structure, transition.drive))
    found = [
        _quantity(f"{name}_time", TIME, wording.time, "run"),
        _quantity(f"{name}_work", ENERGY, f"work of {wording.noun}", "run"),
    ]
    if unit in _DRIVE_UNITS:
        what = "least slowly growing drive" if unit != "N m" else "least slowly growing torque"
        found.append(_quantity(f"slow_{name}", _DRIVE_UNITS[unit], f"{what} that makes it {wording.verb}", "slow"))
    if unit == "m":
        found.append(_quantity(f"slow_{name}_force", FORCE, f"largest force of slow {wording.noun}", "slow"))
        found.append(_quantity(f"{name}_force", FORCE, f"largest force of {wording.noun}", "record"))
    return found


def _of_states(structure: Structure) -> list[OutcomeQuantity]:
    """What a run tells of the states that its protocol names: what is stored, and every distance that is watched."""
    names = [first_state(structure, structure.stage_states), *(each.state for each in structure.transitions)]
    watched = [measure.name for measure in distances_of(structure)]
    return [
        quantity
        for state in dict.fromkeys(name for name in names if name)
        for quantity in (
            *_energies_of(structure, state),
            *(_quantity(f"{state}_{name}", LENGTH, f"{name}, {state}", "run") for name in watched),
        )
    ]


def _energies_of(structure: Structure, state: str) -> list[OutcomeQuantity]:
    """All that is stored in a state, and what the tendons store of that; that of membranes takes all rows of a run."""
    stored = _quantity(f"{state}_energy", ENERGY, f"all stored energy, {state}", "run")
    if not structure.tendons:
        return [stored]
    # rows of studies have the tendons' energy under the first of these names
    column = f"{state}_stored_energy"
    return [
        replace(stored, told_as=column, source="record" if structure.membranes else "run"),
        replace(
            stored,
            name=f"{state}_tendon_energy".replace(" ", "_"),
            told_as=f"{state}_energy",
            meaning=f"energy of the tendons, {state}",
        ),
    ]

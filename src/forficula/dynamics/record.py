"""Record of a run: time series with units, and start and end of each stage of the protocol."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Protocol, TypeAlias

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import Design, StageSection
from forficula.displayed import Displayed
from forficula.dynamics.engine.contact_geometry import overlap_doubt
from forficula.dynamics.engine.membrane import joined_mesh
from forficula.errors import InputError
from forficula.quantities import show_duration
from forficula.serial import Seconds, Written
from forficula.structure import Structure, distances_of, hinges_of, measure_of, read_angles

if TYPE_CHECKING:
    import xarray


# name: (dimensions after time, unit, meaning)
VARIABLES: dict[str, tuple[tuple[str, ...], str, str]] = {
    "hinge_angle": (("hinge",), "rad", "angle of the hinge in its own sense, 0 as built"),
    "tendon_length": (("tendon",), "m", "length of the tendon"),
    "tendon_energy": (("tendon",), "J", "energy of the tendon's spring"),
    "membrane_energy": ((), "J", "stretch energy of the membrane"),
    "kinetic_energy": ((), "J", "kinetic energy of bodies and hinges"),
    "gravitational_energy": ((), "J", "gravitational energy of the bodies, weight times height"),
    "motor_power": (("motor",), "W", "power of the motor"),
    "motor_work": (("motor",), "J", "work of the motor since the start"),
    "hinge_damping_work": ((), "J", "work of the hinges' damping since the start"),
    "elastic_damping_work": ((), "J", "work of the tendons' and the membrane's damping since the start"),
    "stop_work": ((), "J", "work of the hinges' stops, length limits and rigid couplings since the start"),
    "point_position": (("point", "axis"), "m", "position of the named point on a body"),
    "membrane_position": (("node", "axis"), "m", "position of the membrane's node"),
}
# variables of records with dry friction, contacts, springs in hinges, displacements, elastic couplings, measured
# distances, Maxwell branches, tendons that yield or are clamped, quasi-static stages, and in air or water
OPTIONAL_VARIABLES: dict[str, tuple[tuple[str, ...], str, str]] = {
    "friction_work": ((), "J", "work of the hinges' dry friction since the start"),
    "contact_work": (
        (),
        "J",
        "work of contacts, their friction and rigid couplings since the start, except that stored in friction springs",
    ),
    "friction_spring_energy": ((), "J", "energy of the springs by which friction holds facets and plates that touch"),
    "hinge_energy": (("hinge",), "J", "energy of the hinge's spring"),
    "hinge_rest_angle": (("hinge",), "rad", "rest angle of the hinge's spring, which a drive changes"),
    "motor_force": (("motor",), "N", "total force on the points that the motor displaces, in its direction"),
    "spring_force": (("spring",), "N", "force of the spring, pulling positive"),
    "spring_energy": (("spring",), "J", "energy of the spring"),
    "coupling_energy": (("coupling",), "J", "energy of the spring between the joints; 0 for a rigid coupling"),
    "distance": (("measure",), "m", "measured distance"),
    "branch_energy": (("tendon",), "J", "energy of the tendon's Maxwell branches"),
    "branch_damping_work": ((), "J", "work of the dampers in the tendons' Maxwell branches since the start"),
    "tendon_rest_length": (("tendon",), "m", "resting length of the tendon, which grows when it yields"),
    "hinge_set": (("hinge",), "rad", "permanent fold: rest angle of the part of a crease's spring that yields"),
    "crease_yield_work": ((), "J", "work of the creases' yielding since the start"),
    "crease_branch_work": ((), "J", "work of the dampers in the creases' Maxwell branches since the start"),
    "crease_damage_work": ((), "J", "work that wear dissipated in creases since the start"),
    "hinge_remaining": (("hinge",), "dimensionless", "share of the moment of the crease that wear has left"),
    "yield_work": ((), "J", "work of the tendons' yielding since the start"),
    "closure_work": ((), "J", "work of closures of loops of bodies since the start, ideally 0"),
    "closure_gap": ((), "m", "widest gap of the creases that close loops since the start"),
    "contact_overlap": (
        (),
        "1",
        "largest overlap of facets, plates and bars that touch since the start, as a share of their thickness",
    ),
    "drag_work": ((), "J", "work of the drag of air or water since the start"),
    "letting_go_work": (
        (),
        "J",
        "work saved by clamping tendons whose branches would push or act while slack",
    ),
    "tendon_pull": (("tendon",), "N", "pull of the tendon's spring and Maxwell branches"),
    "settling_work": (
        (),
        "J",
        "energy gained since the start where statics takes over from a motion in a quasi-static stage, ideally 0",
    ),
    "waited": ((), "s", "time at rest since the start that was skipped without stepping, not part of time"),
}
# dimensions, values and attributes of a variable
Variable: TypeAlias = tuple[tuple[str, ...], Array, dict[str, str]]


@dataclass(frozen=True, kw_only=True)
class StageEnd:
    """Result of a stage.

    Attributes:
        stage: section of the protocol.
        start: s.
        end: s.
        goal_time: when the goal was reached, s; None if it was not reached, or if the goal was a time.
        at_rest: whether every hinge was slower at the end than the speed that counts as rest.
        at_goal: whether the goal was met at the end, even for a short time.
        met: whether the goal was met at any moment of a stage that missed it; None if it was reached, or if this is
            unknown, because files of records do not contain it.
        waited: time at rest that was skipped without stepping, s, not part of the time from start to end.
        share: share at the end to which the drive of a quasi-static stage has grown; None for other stages.
        lost: shares at which the stage lost its equilibrium, so that the structure moved to the next one.
    """

    stage: StageSection
    start: float
    end: float
    goal_time: float | None
    at_rest: bool
    at_goal: bool = False
    waited: float = 0.0
    share: float | None = None
    lost: tuple[float, ...] = ()
    # a record that was read equals the one that was written
    met: bool | None = field(default=None, compare=False)


@dataclass(frozen=True, kw_only=True)
class NumericalCheck:
    """Outcome of a second run of the same design that differs only numerically.

    Attributes:
        name: the difference, such as "half the timestep".
        timestep: of that run, s.
        verdict: of that run, in a word.
        goal: name of the transition that decided the verdict, or "none".
        status: the verdict in a few words.
        holds: by state, whether that run reached it and kept it when released; None if it is not known.
        values: times and works of transitions and numbers of states of that run by name, in SI, (number,) each.
    """

    name: str
    timestep: Seconds
    verdict: str
    goal: Annotated[str, Written.NEVER]
    status: str
    holds: Annotated[Mapping[str, bool | None], Written.NEVER]
    values: Annotated[Mapping[str, tuple[float, ...]], Written.NEVER]


@dataclass(frozen=True, kw_only=True)
class ContactRun:
    """A run of a design whose contact.time_constant is "auto".

    Attributes:
        time_constant: of contact, s.
        timestep: s.
        overlap: largest overlap in any step of parts that touch, as a share of their thickness; None if the engine
            computes all contacts, because it does not report overlaps.
    """

    time_constant: Seconds
    timestep: Seconds
    overlap: float | None


@dataclass(frozen=True, kw_only=True, eq=False)
class Record(Displayed):
    """Record of a run.

    Attributes:
        design: the simulated design.
        structure: structure of the design, SI.
        time: s, (time,): at the sample interval and at the end of every stage.
        series: an array for every name of `VARIABLES`, SI, (time, ...), and for some of `OPTIONAL_VARIABLES`.
        stages: the stages that took place, in order.
        diverged_at: when the run diverged, s, or None.
        doubt: why the run is unreliable apart from its energy balance; mostly empty.
        kinetic_peak: time, s, and value, J, of the largest kinetic energy of all steps, not only those of `time`; None
            if not every step was recorded.
        checks: second runs of the same design, with which the verdict and the numbers are compared.
        contact_runs: runs by which the time constant of contact was derived, in order; the last one is this run. Empty
            if the design gives the time constant.
        strain_rates: highest rates at which taut tendons lengthen or shorten from one step to the next, relative to the
            gauge length of the law, 1/s, (tendon,); nan for a tendon that is never taut; None if no law has a highest
            measured rate.
    """

    design: Design
    structure: Structure
    time: Array
    series: Mapping[str, Array]
    stages: tuple[StageEnd, ...]
    diverged_at: float | None
    doubt: str = ""
    kinetic_peak: tuple[float, float] | None = None
    checks: tuple[NumericalCheck, ...] = ()
    contact_runs: tuple[ContactRun, ...] = ()
    strain_rates: Array | None = None

    def __repr__(self) -> str:
        """Return the design, the duration and the stages."""
        names = ", ".join(end.stage.name for end in self.stages)
        return f"<Record of {self.design.name}: {len(self.time)} rows over {show_duration(self.time[-1])}: {names}>"

    @property
    def overlaps(self) -> bool:
        """Whether parts that touch overlap so deeply that they may have passed through each other."""
        contact, overlaps = self.structure.contact, self.series.get("contact_overlap")
        return overlaps is not None and contact is not None and bool(overlap_doubt(contact, float(overlaps[-1])))

    def angles(self, role: str) -> Array:
        """Return the angles of the hinges of a role, in their own senses, rad, (time, hinge)."""
        return self.series["hinge_angle"][:, list(hinges_of(self.structure, role))]

    def measured(self, name: str) -> Array:
        """Return the readings of a measure: angles, rad, (time, reading), or a distance, m, (time, 1).

        Raises:
            InputError: there is neither a measure nor a role of hinges of that name.
        """
        measure = measure_of(self.structure, name)
        if measure is None:
            known = ", ".join(measure.name for measure in self.structure.measures)
            raise InputError(f"{self.design.name}: measure: need one of {known}, got {name}")
        if measure.points is not None:
            place = [distance.name for distance in distances_of(self.structure)].index(name)
            return self.series["distance"][:, place : place + 1]
        return read_angles(measure, self.series["hinge_angle"])

    @property
    def work(self) -> Array:
        """Return the work of all motors since the start, J, (time,)."""
        motors = self.series["motor_work"]
        # summed in order, as in the energy balance
        return sum((motors[:, motor] for motor in range(motors.shape[1])), np.zeros(len(self.time)))

    @cached_property
    def triangles(self) -> Indices:
        """Return the mesh of all membranes, (triangle, 3), as indices of nodes."""
        return joined_mesh(self.structure.membranes).triangles

    @cached_property
    def data(self) -> xarray.Dataset:
        """Return the series with dimensions, coordinates and units, without those of parts that the structure lacks."""
        every = self.dataset
        return every.drop_dims([dimension for dimension, size in every.sizes.items() if size == 0])

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the record as netCDF; see `save_record`."""
        from forficula.dynamics.record_file import save_record

        save_record(self, path)

    @property
    def dataset(self) -> xarray.Dataset:
        """Return all series, also those whose dimension has size zero, as a file has them."""
        import xarray

        return xarray.Dataset(series_variables(self), coordinates(self))


def series_variables(record: Record) -> dict[str, Variable]:
    """Return the variables of all series, by their names."""
    known = {name: meaning for name, meaning in (VARIABLES | OPTIONAL_VARIABLES).items() if name in record.series}
    return {
        name: (("time", *dimensions), record.series[name], {"units": unit, "long_name": meaning})
        for name, (dimensions, unit, meaning) in known.items()
    }


def coordinates(record: Record) -> dict[str, Variable]:
    """Return the coordinates of all series, by their names."""
    built = record.structure
    names: dict[str, Sequence[str]] = {
        "hinge": [hinge.name for hinge in built.hinges],
        "hinge_role": [hinge.role for hinge in built.hinges],
        "tendon": [tendon.name for tendon in built.tendons],
        "tendon_role": [tendon.role for tendon in built.tendons],
        "spring": [spring.name for spring in built.springs],
        "spring_role": [spring.role for spring in built.springs],
    }
    if "coupling_energy" in record.series:
        names["coupling"] = [coupling.name for coupling in built.couplings]
    names |= {"motor": [motor.name for motor in built.motors], "point": [point.name for point in built.points]}
    names |= {"point_role": [point.role for point in built.points], "axis": ["x", "y", "z"]}
    if "distance" in record.series:
        names["measure"] = [measure.name for measure in distances_of(built)]
    time: dict[str, Variable] = {"time": (("time",), record.time, {"units": "s", "long_name": "time"})}
    return time | {name: ((name.removesuffix("_role"),), np.asarray(texts), {}) for name, texts in names.items()}


class HasRecord(Protocol):
    """Run, which is of a layer above."""

    @property
    def record(self) -> Record:
        """Return its record."""


# a run, its record, or the path of its folder or file
AnyRun = Record | HasRecord | str | os.PathLike[str]

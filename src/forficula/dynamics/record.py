"""Record of a run: time series with units, and start and end of each stage of the protocol."""

from __future__ import annotations

import hashlib
import io
import json
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cache, cached_property
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Protocol, TypeAlias

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import Design, StageSection, design_from_text, design_text
from forficula.displayed import Displayed
from forficula.dynamics.engine.contact_geometry import overlap_doubt
from forficula.dynamics.engine.membrane import joined_mesh
from forficula.errors import InputError
from forficula.files import as_path, read_bytes, shown_path, write_bytes
from forficula.quantities import show_duration
from forficula.serial import Seconds, Written
from forficula.structure import Structure, distances_of, hinges_of, measure_of, read_angles, structure_of

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
    "contact_work": ((), "J", "work of contacts, their friction and rigid couplings since the start"),
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
_Variable: TypeAlias = tuple[tuple[str, ...], Array, dict[str, str]]
# of the file; other formats are rejected
_FORMAT = 2
# netCDF's name of the scale of a dimension without coordinates
_NOT_A_VARIABLE = "This is a netCDF dimension but not a netCDF variable. {:10d}"
# precedes the checksum at the end of a record; readers of HDF5 ignore bytes after its end
_SEAL = b"\nforficula sha256 "


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
        save_record(self, path)

    @property
    def dataset(self) -> xarray.Dataset:
        """Return all series, also those whose dimension has size zero, as a file has them."""
        import xarray

        return xarray.Dataset(_series_variables(self), _coordinates(self))


def _series_variables(record: Record) -> dict[str, _Variable]:
    """Return the variables of all series, by their names."""
    known = {name: meaning for name, meaning in (VARIABLES | OPTIONAL_VARIABLES).items() if name in record.series}
    return {
        name: (("time", *dimensions), record.series[name], {"units": unit, "long_name": meaning})
        for name, (dimensions, unit, meaning) in known.items()
    }


def _coordinates(record: Record) -> dict[str, _Variable]:
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
    time: dict[str, _Variable] = {"time": (("time",), record.time, {"units": "s", "long_name": "time"})}
    return time | {name: ((name.removesuffix("_role"),), np.asarray(texts), {}) for name, texts in names.items()}


class HasRecord(Protocol):
    """Run, which is of a layer above."""

    @property
    def record(self) -> Record:
        """Return its record."""


# a run, its record, or the path of its folder or file
AnyRun = Record | HasRecord | str | os.PathLike[str]


def save_record(record: Record, path: str | os.PathLike[str]) -> None:
    """Write a record as netCDF, with its design, its stages and a checksum at the end.

    Raises:
        InputError: the file cannot be written.
    """
    nothing = float("nan")
    ends, seconds = record.stages, {"units": "s"}
    goal_times = [nothing if end.goal_time is None else end.goal_time for end in ends]
    reached = "when the stage's goal was reached, nan if it was not"
    stages: dict[str, tuple[Any, dict[str, str]]] = {
        "stage_name": ([end.stage.name for end in ends], {}),
        "stage_start": ([end.start for end in ends], seconds),
        "stage_end": ([end.end for end in ends], seconds),
        "stage_goal_time": (goal_times, {"units": "s", "long_name": reached}),
        "stage_at_goal": (np.array([end.at_goal for end in ends], dtype=np.int8), {}),
        "stage_at_rest": (np.array([end.at_rest for end in ends], dtype=np.int8), {}),
        "stage_waited": ([end.waited for end in ends], seconds),
    }
    mesh = {"long_name": "membrane mesh: nodes of each triangle"}
    variables = {
        **_series_variables(record),
        **_coordinates(record),
        "triangle": (("face", "corner"), record.triangles, mesh),
        **{name: (("stage",), np.asarray(values), notes) for name, (values, notes) in stages.items()},
    }
    attributes = {
        "format": _FORMAT,
        "title": f"forficula run of {record.design.name}",
        "design": design_text(record.design),
        "design_hash": record.design.hash,
        "diverged_at": nothing if record.diverged_at is None else record.diverged_at,
        "doubt": record.doubt,
        **({"checks": json.dumps([asdict(check) for check in record.checks])} if record.checks else {}),
        **({"contact_runs": json.dumps([asdict(run) for run in record.contact_runs])} if record.contact_runs else {}),
        **_quasi_static(record.stages),
        **({} if record.kinetic_peak is None else {"kinetic_peak": np.array(record.kinetic_peak)}),
        **({} if record.strain_rates is None else {"strain_rates": record.strain_rates}),
        **{f"version_{name}": version for name, version in versions(record.design.protocol.device).items()},
    }
    content = _netcdf(variables, attributes)
    write_bytes(Path(path), content + _seal(content))


def _quasi_static(stages: Sequence[StageEnd]) -> dict[str, str]:
    """Return the shares of quasi-static stages as text; nothing without such stages."""
    shares = [(end.share, end.lost) for end in stages]
    return {"quasi_static": json.dumps(shares)} if any(share is not None for share, _ in shares) else {}


def _seal(content: bytes) -> bytes:
    """Return the end of a record: the SHA-256 of every byte before it.

    The checksum is of the file and not of its arrays, because HDF5 cannot handle damaged files. It takes 1 ms.
    """
    return _SEAL + hashlib.sha256(content).hexdigest().encode() + b"\n"


def _netcdf(variables: Mapping[str, _Variable], attributes: Mapping[str, Any]) -> bytes:
    """Return variables as netCDF-4: HDF5 with dimension scales (netCDF file format specification, appendix C).

    h5py is five times as fast as xarray, whose import alone takes 0.6 s, and a study writes a hundred records. The file
    is written in memory, because HDF5 on a full disk fails in ways that cannot be caught, including a crash.
    """
    import h5py

    sizes: dict[str, int] = {}
    for dimensions, values, _ in variables.values():
        sizes |= dict(zip(dimensions, values.shape, strict=True))
    with h5py.File("record.nc", "w", driver="core", backing_store=False, track_order=True) as file:
        file.attrs.update(attributes)
        for name, (_, values, notes) in variables.items():
            kind = h5py.string_dtype() if values.dtype.kind in "UO" else values.dtype
            file.create_dataset(name, data=values.astype(kind)).attrs.update(notes)
        for dimension, size in sizes.items():
            if dimension in variables:
                file[dimension].make_scale(dimension)
            else:
                file.create_dataset(dimension, shape=size, dtype=">f4").make_scale(_NOT_A_VARIABLE.format(size))
        for name, (dimensions, _, _) in variables.items():
            for place, dimension in enumerate(dimensions):
                if dimension != name:
                    file[name].dims[place].attach_scale(file[dimension])
        file.flush()
        return bytes(file.id.get_file_image())


def load_record(path: str | os.PathLike[str]) -> Record:
    """Read a record that `save_record` wrote.

    Args:
        path: of its file, or of the folder of a run.

    Raises:
        InputError: there is no such file, it is not a record, or it is damaged.
    """
    import h5py

    path = as_path(path, "the folder of a run, or its record.nc")
    path = path / "record.nc" if path.is_dir() else path
    try:
        content = read_bytes(path, math.inf)  # its size grows with the duration of the run
    except InputError as error:
        raise InputError(f"{shown_path(path)}: {error}") from None
    whole, seal, checksum = content.rpartition(_SEAL)
    if not seal:
        why = "no checksum ends it: it is cut off, or not of this version"
        raise InputError(f"{path}: not a record of forficula: {why}; run its design again")
    if _seal(whole) != seal + checksum:
        raise InputError(
            f"{path}: not a record of forficula any more: damaged since it was written; run its design again"
        )
    try:
        # h5py is ten times as fast as xarray, and a study reads a hundred records
        with h5py.File(io.BytesIO(whole)) as file:
            written = int(np.squeeze(file.attrs.get("format", 1)))
            if written == _FORMAT:
                return _read(file)
    except (OSError, LookupError, ValueError, TypeError, RuntimeError) as error:
        raise InputError(f"{path}: not a record of forficula: {' '.join(str(error).split())}") from None
    age, design = "an earlier" if written < _FORMAT else "a later", path.parent / "design.toml"
    raise InputError(
        f"{path}: written by {age} state of forficula (format {written}, this one reads {_FORMAT}): run"
        f" `forficula run {design}`"
    )


def as_record(run: object) -> Record:
    """Return a record, the record of a run, or that of a run's folder or file.

    Raises:
        InputError: the argument is not a record, or it cannot be read.
    """
    run = getattr(run, "record", run)  # `Run` is of a layer above
    if isinstance(run, Record):
        return run
    if isinstance(run, str | os.PathLike):
        return load_record(run)
    raise InputError(f"need the record of a run, or its folder, got a {type(run).__name__}")


def _read(file: Any) -> Record:
    """Return the record in an open file."""
    design = design_from_text(file.attrs["design"])
    ends = [file[f"stage_{name}"][()] for name in ("start", "end", "goal_time", "at_rest", "at_goal")]
    waits = file["stage_waited"][()] if "stage_waited" in file else np.zeros(len(ends[0]))
    diverged_at = float(np.squeeze(file.attrs["diverged_at"]))
    shares = json.loads(file.attrs["quasi_static"]) if "quasi_static" in file.attrs else [(None, ())] * len(ends[0])
    stages = tuple(
        StageEnd(
            stage=stage,
            start=float(start),
            end=float(end),
            goal_time=None if np.isnan(goal) else float(goal),
            at_rest=bool(at_rest),
            at_goal=bool(at_goal),
            waited=float(waited),
            share=share,
            lost=tuple(lost),
        )
        for stage, start, end, goal, at_rest, at_goal, waited, (share, lost) in zip(
            design.protocol.stages, *ends, waits, shares, strict=False
        )
    )
    return Record(
        design=design,
        structure=structure_of(design),
        time=file["time"][()],
        series={name: file[name][()] for name in (*VARIABLES, *(name for name in OPTIONAL_VARIABLES if name in file))},
        stages=stages,
        diverged_at=None if np.isnan(diverged_at) else diverged_at,
        doubt=str(file.attrs["doubt"]),
        checks=tuple(map(_check, json.loads(file.attrs.get("checks", "[]")))),
        contact_runs=tuple(ContactRun(**run) for run in json.loads(file.attrs.get("contact_runs", "[]"))),
        kinetic_peak=(float(peak[0]), float(peak[1])) if (peak := file.attrs.get("kinetic_peak")) is not None else None,
        strain_rates=None if (rates := file.attrs.get("strain_rates")) is None else np.atleast_1d(rates),
    )


def _check(written: Mapping[str, Any]) -> NumericalCheck:
    return NumericalCheck(**{**written, "values": {name: tuple(values) for name, values in written["values"].items()}})


def versions(device: str | None = None) -> dict[str, str]:
    """Return the versions of the packages that numbers of runs on a device depend on; None for the processor."""
    names = ("forficula", "mujoco", "numpy", *(() if device is None else ("mujoco-warp", "warp-lang")))
    return {name: _version(name) for name in names}


@cache  # a look-up takes milliseconds
def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:  # an extra, with which another computer wrote the results
        return "not installed"

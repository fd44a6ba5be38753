"""Compilation of a structure into the engine's model, with the indices of its parts and its units."""

from __future__ import annotations

import itertools
import warnings
from dataclasses import dataclass

import mujoco
import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.design import Design
from forficula.dynamics.energies.creases import (
    EngineCreases,
    add_creases,
    clear_rows,
    creases_of,
    followed_hinges,
    is_followed_joint,
)
from forficula.dynamics.engine.bodies import add_bodies, add_hardening
from forficula.dynamics.engine.closures import add_closures, add_holds, gaps_of, weigh_holds
from forficula.dynamics.engine.contact import add_panels, add_stop_sensors, check_apart, has_engine_contact
from forficula.dynamics.engine.contact_geometry import check_start
from forficula.dynamics.engine.couplings import add_couplings
from forficula.dynamics.engine.drag import CONSTANT_STEPS, Drag, add_medium, drag_of
from forficula.dynamics.engine.membrane import MembraneMesh, add_membranes, first_node, joined_mesh
from forficula.dynamics.engine.motors import (
    add_motors,
    brakes_of,
    followed_motors,
    force_displacements,
    pushed_bodies,
    servos_of,
)
from forficula.dynamics.engine.parts import carriers_of, hinge_creep, part_indices, sites_of
from forficula.dynamics.engine.placement import Placement
from forficula.dynamics.engine.table import add_table, check_above_table
from forficula.dynamics.engine.tendons import add_distance, add_limit, add_pulls, add_spring, add_tendon
from forficula.dynamics.engine.units import ModelUnits, design_in_model_units, model_units
from forficula.dynamics.stepping.folds import Folds, folds_of
from forficula.dynamics.stepping.node_modes import AT_JOINTS, followed_steps
from forficula.errors import InputError
from forficula.material.law.tendon_law import ElasticLaw, stacked_laws
from forficula.structure import Measure, Structure, structure_of

# a step of more bodies takes tens of milliseconds and gigabytes
_MOST_BODIES = 2002
# number of steps at a time without contact
_BETWEEN_CONTACTS = 100
# [chosen] most iterations by which the engine finds forces of friction that hold touching parts without a creep; 6
# points on a table need no more than 5
_NO_SLIP_ITERATIONS = 10


@dataclass(frozen=True, kw_only=True)
class Model:
    """A compiled structure and the indices of its parts.

    Attributes:
        design: the design, SI.
        structure: structure of the design, SI.
        units: of the compiled model.
        in_units: the structure in the model's units.
        timestep: in the model's units.
        engine: the compiled model; copy it before changing it.
        spec: the source that compiles to it.
        mesh: its membranes, in the model's units.
        first_node: index of the first node of the membranes among the vertices of the engine's flexes.
        folds: computes the hinges' angles from the engine's positions.
        creases: hinges whose numbers in the engine are computed every few steps; None if there are none.
        drag: of the medium; None for empty space.
        followed: steps over which the engine's rows of creases and the drag are constant.
        pushed: displacement of a force's points along the force per shift of each coordinate, (motor, dof); 0 for other
            motors, and for plates, where it varies.
        pushed_bodies: the bodies that turn, from which displacements of a force's points follow; None without such
            forces.
        springs: index of each spring among the engine's tendons, (spring,).
        tendons: index of each tendon, (tendon,).
        distances: index of the tendon that measures each distance, (distance,).
        gaps: index of the tendons that measure the gaps of closures and of supports of points, (gap,).
        gap_lengths: lengths of these tendons without a gap, in the unit of length, (gap,).
        branches: index into activations of the forces of the tendons' Maxwell branches, (tendon, branch); -1 for absent
            branches.
        hinge_creep: index into plastic states of the rest angle of each joint that yields, (hinge,); -1 for others.
        creep: index into plastic states of the tendons' resting lengths, (tendon,); -1 for tendons that do not yield.
        motors: number of the structure's motor that each control follows, (control,); -1 for none.
        holds: number of the motor whose servo each control switches on, (control,), next to the control that sets its
            target; -1 for other controls.
        brakes: number of the motor whose magnitude each control follows to reduce its torque with the speed of a joint,
            (control,); -1 for other controls.
        jacobian: displacement of a servo's point, or turn of a brake's joint, per shift of each coordinate,
            (control, dof); 0 for other controls.
        sites: index of the site of each point, (point,); -1 if it is the origin of its body.
        carriers: index of the body of each point, (point,).
        elastic: the springs of the tendons, as one law of arrays (tendon,), in the model's units.
        lets_go: whether each tendon is clamped so that its damper and branches cannot push, (tendon,).
    """

    design: Design
    structure: Structure
    units: ModelUnits
    in_units: Structure
    timestep: float
    engine: mujoco.MjModel
    spec: mujoco.MjSpec
    mesh: MembraneMesh
    first_node: int
    folds: Folds
    creases: EngineCreases | None
    drag: Drag | None
    followed: int
    pushed: Array
    pushed_bodies: Placement | None
    springs: Indices
    tendons: Indices
    distances: Indices
    gaps: Indices
    gap_lengths: Array
    branches: Indices
    hinge_creep: Indices
    creep: Indices
    motors: Indices
    holds: Indices
    brakes: Indices
    jacobian: Array
    sites: Indices
    carriers: Indices
    elastic: ElasticLaw
    lets_go: Flags

    @property
    def explicit(self) -> bool:
        """Return whether steps are those of Runge and Kutta instead of semi-implicit Euler."""
        return bool(self.engine.opt.integrator == mujoco.mjtIntegrator.mjINT_RK4)

    @property
    def followed_hinges(self) -> Indices:
        """Return the numbers of the hinges in `creases`, (crease,)."""
        return self.folds.creases if self.creases is None else self.creases.hinges

    def settings(self, efforts: Array) -> tuple[Array, Array]:
        """Return the effect of motors on creases: changes of rest angles, rad, and torques, (..., crease).

        Args:
            efforts: of all motors, in the model's units, (..., motor).
        """
        rests, torques = (np.zeros((*efforts.shape[:-1], len(self.structure.hinges))) for _ in range(2))
        for number, motor in enumerate(self.structure.motors):
            acting = efforts[..., number, None] * np.array(motor.gains or (1.0,) * len(motor.hinges))
            if motor.kind == "rest-angle":
                rests[..., list(motor.hinges)] += acting
            elif motor.kind == "torque":
                torques[..., list(motor.hinges)] += acting
        # motors of joints are actuators of the engine
        torques[..., self.folds.joints >= 0] = 0.0
        return rests[..., self.followed_hinges], torques[..., self.followed_hinges]

    def braking(self, sizes: Array) -> Array:
        """Return the damping of creases by motors, (..., crease), for magnitudes of their settings, (..., motor)."""
        damping = np.zeros((*sizes.shape[:-1], len(self.structure.hinges)))
        for number, motor in enumerate(self.in_units.motors):
            gains = np.array(motor.gains or (1.0,) * len(motor.hinges))
            damping[..., list(motor.hinges)] += sizes[..., number, None] * gains / motor.no_load_speed
        damping[..., self.folds.joints >= 0] = 0.0
        return damping[..., self.followed_hinges]

    def levers(self, tendon: int) -> tuple[slice, Indices]:
        """Return the entries of the engine's ten_J for the derivatives of a tendon's length, and their joints."""
        first = int(self.engine.ten_J_rowadr[tendon])
        entries = slice(first, first + int(self.engine.ten_J_rownnz[tendon]))
        return entries, np.asarray(self.engine.ten_J_colind[entries], dtype=np.int64)

    @property
    def xml(self) -> str:
        """Return the source as text, for any MuJoCo viewer; lengths have six digits."""
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*has no.*passive forces")
            return str(self.spec.to_xml())


def compile_model(design: Design) -> Model:
    """Compile a design.

    Args:
        design: with a timestep in seconds; see `with_timestep` for "auto".

    Raises:
        InputError: the design cannot be built, or MuJoCo rejects the model; the message gives the reason.
    """
    structure = structure_of(design)
    _check_size(design, structure)
    units = model_units(structure)
    model = compile_structure(design, structure, structure_of(design_in_model_units(design, units)), units)
    check_apart(model.engine, model.in_units, units.length)
    check_start(model)
    return model


def compile_structure(design: Design, structure: Structure, in_units: Structure, units: ModelUnits) -> Model:
    """Compile a structure.

    Args:
        design: the design with the timestep.
        structure: SI.
        in_units: the same structure in the model's units, built from the design in these units instead of rescaled,
            which keeps all digits.
        units: of the model.

    Raises:
        InputError: as for `compile_model`.
    """
    _check_size(design, structure)
    _check_pushes(design, structure)
    timestep = float(design.protocol.timestep) / units.time
    mesh = joined_mesh(in_units.membranes)
    distances = [measure for measure in in_units.measures if measure.points is not None]
    spec = _spec_of(in_units, timestep, mesh, distances)
    spec.add_text(
        name="units", data=f"length {units.length:g} m, mass {units.mass:g} kg, time {units.time:g} s, angle rad"
    )
    spec.add_text(name="viewers", data=_viewers(in_units))
    engine = _compiled(spec, design.name)
    clear_rows(engine)
    weigh_holds(engine, in_units)
    folds, drag = folds_of(engine, in_units), drag_of(engine, in_units)
    check_above_table(engine, in_units, folds, units.length)
    tendons = part_indices(engine, mujoco.mjtObj.mjOBJ_TENDON, [tendon.name for tendon in in_units.tendons])
    plastic = engine.tendon_plasticadr[tendons]
    (holds, servo_jacobian), (brakes, brake_jacobian) = servos_of(engine, in_units), brakes_of(engine, in_units)
    gaps, gap_lengths = gaps_of(in_units)
    return Model(
        design=design,
        structure=structure,
        units=units,
        in_units=in_units,
        timestep=timestep,
        engine=engine,
        spec=spec,
        mesh=mesh,
        first_node=first_node(engine),
        folds=folds,
        creases=creases_of(engine, in_units, folds),
        drag=drag,
        followed=_followed_steps(in_units),
        pushed=force_displacements(engine, in_units),
        pushed_bodies=pushed_bodies(in_units),
        springs=part_indices(engine, mujoco.mjtObj.mjOBJ_TENDON, [spring.name for spring in in_units.springs]),
        tendons=tendons,
        distances=part_indices(
            engine, mujoco.mjtObj.mjOBJ_TENDON, [f"distance_{measure.name}" for measure in distances]
        ),
        gaps=part_indices(engine, mujoco.mjtObj.mjOBJ_TENDON, gaps),
        gap_lengths=np.array(gap_lengths),
        branches=_branches([len(tendon.law.branches) for tendon in in_units.tendons]),
        hinge_creep=hinge_creep(engine, in_units),
        # upper end of the dead band, the second of both numbers of a tendon
        creep=np.where(plastic >= 0, plastic + 1, -1),
        motors=followed_motors(engine, in_units),
        holds=holds,
        brakes=brakes,
        jacobian=servo_jacobian + brake_jacobian,
        sites=sites_of(engine, in_units),
        carriers=carriers_of(engine, in_units),
        elastic=stacked_laws([tendon.law.elastic for tendon in in_units.tendons]),
        lets_go=np.array([tendon.law.lets_go for tendon in in_units.tendons], dtype=bool),
    )


def _check_size(design: Design, structure: Structure) -> None:
    if (count := len(structure.bodies)) > _MOST_BODIES:
        pattern = getattr(design, "pattern", ())
        counts = [f"pattern.{key} = {value}" for key, value in pattern if type(value) is int and value > 1]
        follows = [text for text in (structure.appearance.bodies, *counts) if text]
        reason = f" ({', '.join(follows)})" if follows else ""
        raise InputError(f"{design.name}: need at most {_MOST_BODIES} bodies to simulate it{reason}, got {count}")


def _check_pushes(design: Design, structure: Structure) -> None:
    for tendon in structure.tendons:
        if tendon.law.must_push and not tendon.law.pushes:
            raise InputError(
                f"{design.name}: {tendon.key}.pushes_when_slack: need true to simulate a law that has a yield_strain or"
                " a nonlinear viscosity beside damping or branches, because nothing keeps such a tendon from pushing"
                " when it is slack; a law without these only pulls"
            )


def joint_ranges(model: Model) -> tuple[Array, Array]:
    """Return the positions of the lower and upper stops of hinges, (position,) each, infinite without a stop."""
    engine = model.engine
    limited = np.array(engine.jnt_limited, dtype=bool)
    ends = np.full((2, engine.nq), [[-np.inf], [np.inf]])
    ends[:, np.array(engine.jnt_qposadr)[limited]] = np.array(engine.jnt_range)[limited].T
    return ends[0], ends[1]


def _spec_of(structure: Structure, timestep: float, mesh: MembraneMesh, distances: list[Measure]) -> mujoco.MjSpec:
    """Return the specification of all parts of a structure, not yet compiled."""
    spec = _empty_spec(structure, timestep)
    add_bodies(spec, structure)
    add_motors(spec, structure)
    add_medium(spec, structure)
    add_creases(spec, structure)
    add_couplings(spec, structure, timestep)
    add_closures(spec, structure, timestep)
    add_holds(spec, structure, timestep)
    add_hardening(spec, structure)
    for spring in structure.springs:
        add_spring(spec, spring, structure)
    for tendon in structure.tendons:
        add_tendon(spec, tendon, structure)
    # after all motors, so that a motor and its control have the same index, because branches have no control
    for tendon in structure.tendons:
        add_pulls(spec, tendon, structure)
    for limit in structure.limits:
        add_limit(spec, limit, structure)
    for measure in distances:
        if measure.points is not None:
            add_distance(spec, f"distance_{measure.name}", measure.points, structure)
    add_membranes(spec, mesh, structure)
    add_panels(spec, structure)
    add_stop_sensors(spec, structure)
    add_table(spec, structure)
    return spec


def _empty_spec(structure: Structure, timestep: float) -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.modelname = structure.name
    spec.compiler.degree = False
    option = spec.option
    option.timestep = timestep
    option.gravity = structure.gravity * np.array(structure.down)
    # where loops are closed, Euler loses 5 to 9 % of the energy in a second of swinging: measured
    constrained = bool(structure.closures or structure.holds)
    option.integrator = mujoco.mjtIntegrator.mjINT_RK4 if constrained else mujoco.mjtIntegrator.mjINT_EULER
    # with the default, 1e-8, the solver's result would depend on the model's units
    option.tolerance = 1e-12
    # The sparse Cholesky factorisation of 4.0.0 is wrong where bars touch, and not faster for fewer than fifteen veins.
    # It is used for sliding nodes, which have no constraints and are many, and for closed loops: with 16 x 16 plates it
    # is 4 times as fast, and its accelerations equal the dense ones.
    sparse = constrained or any(body.slides for body in structure.bodies)
    sparse = sparse and not structure.limits and not has_engine_contact(structure)
    option.jacobian = mujoco.mjtJacobian.mjJAC_SPARSE if sparse else mujoco.mjtJacobian.mjJAC_DENSE
    option.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    # a diverged simulation must not be reset
    option.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET
    if not has_engine_contact(structure):
        option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        return spec
    # the default would locate contacts of panels to 1e-6 of the length unit, which depends on the structure
    option.ccd_tolerance = 1e-10
    if any(touched.friction for touched in (structure.contact, structure.table) if touched is not None):
        # friction in a pyramidal cone would depend on the direction
        option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
        # without these iterations, parts creep below the limit of friction
        option.noslip_iterations = _NO_SLIP_ITERATIONS
    return spec


def _viewers(structure: Structure) -> str:
    """Return a note on the viewers that show the same motion as this simulation."""
    if len(followed_hinges(structure)) or structure.medium is not None:
        return "layout only: creases or drag are updated outside the engine between steps"
    if structure.membranes:
        return "MuJoCo 4.0 or later: earlier versions stretch membranes differently"
    if any(hinge.yield_angle < np.inf for hinge in structure.hinges):
        return "MuJoCo 4.0 or later: in earlier versions no joint yields"
    if any(tendon.law.yield_extension is not None for tendon in structure.tendons):
        return "MuJoCo 4.0 or later: in earlier versions no tendon yields"
    return "MuJoCo 3.9 or later"


def _compiled(spec: mujoco.MjSpec, name: str) -> mujoco.MjModel:
    """Return the engine's model; raise InputError if MuJoCo rejects the specification."""
    try:
        with warnings.catch_warnings():
            # a wrong warning about membranes without damping, which do have elastic forces
            warnings.filterwarnings("ignore", message=".*has no.*passive forces")
            return spec.compile()
    except (ValueError, MemoryError, RuntimeError, mujoco.FatalError) as error:
        raise InputError(f"{name}: MuJoCo cannot build it: {' '.join(str(error).split())}") from None


def _followed_steps(structure: Structure) -> int:
    """Return the number of steps over which creases and drag are constant; 1 without both."""
    most = [] if structure.medium is None else [CONSTANT_STEPS]
    if any(hinge.flaps for hinge in structure.hinges):
        most.append(followed_steps(structure))
    if structure.contact is not None and (structure.plates or structure.facets):
        most.append(_BETWEEN_CONTACTS)
    joints = [hinge for hinge in structure.hinges if is_followed_joint(hinge, structure)]
    if joints:
        most.append(1 if any(hinge.quadratic or hinge.cubic for hinge in joints) else AT_JOINTS)
    return min(most, default=1)


def _branches(counts: list[int]) -> Indices:
    """Return the numbers of branches, counted tendon after tendon, by tendon; -1 for absent branches."""
    first = np.cumsum([0, *counts])
    rows = [[*range(low, high)] for low, high in itertools.pairwise(first)]
    most = max(counts, default=0)
    return np.array([[*row, *[-1] * (most - len(row))] for row in rows], dtype=np.int64).reshape(len(counts), most)

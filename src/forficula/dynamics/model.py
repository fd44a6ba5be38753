"""Design -> compiled model, where its parts are, and its scale."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.design import Design, tendon_law
from forficula.dynamics.membrane import Membrane, add_membrane, panel_membrane
from forficula.dynamics.tendons import add_branches, add_guard, add_tendon
from forficula.dynamics.units import ModelUnits, design_in_model_units, model_units
from forficula.dynamics.veins import Vein, add_vein, fan_veins
from forficula.errors import InputError
from forficula.material.law.tendon_law import TendonLaw

# a step of more takes tens of milliseconds and gigabytes
_MOST_VEINS = 1001


@dataclass(frozen=True, kw_only=True)
class WingModel:
    """A compiled wing and where its parts are.

    Attributes:
        design: the design, SI.
        units: of the compiled model.
        in_units: the design in the model's units.
        engine: the compiled model; copy it before changing anything.
        spec: the source that compiles to it.
        membrane: its mesh, in the model's units.
        senses: +1 or -1 by vein, (vein,).
        tendons: index of the tendon by vein, (vein,).
        branches: index into activations of the tendons' Maxwell branches, (vein, branch).
        creep: index into plastic states of the tendons' resting lengths, (vein,), or (0,) where they do not yield.
        joints: index into positions and velocities of sweep, lift, turn and fold by vein, (vein, 4); -1 for none.
        motors: index of the motor of turn and fold by vein, and of its control, (vein, 2); -1 for none.
        bodies: index of the proximal and the distal bar by vein, (vein, 2).
        tips: index of the site at the tip by vein, (vein,).
    """

    design: Design
    units: ModelUnits
    in_units: Design
    engine: mujoco.MjModel
    spec: mujoco.MjSpec
    membrane: Membrane
    senses: NDArray[np.int64]
    tendons: NDArray[np.int64]
    branches: NDArray[np.int64]
    creep: NDArray[np.int64]
    joints: NDArray[np.int64]
    motors: NDArray[np.int64]
    bodies: NDArray[np.int64]
    tips: NDArray[np.int64]

    @cached_property
    def tendon_law(self) -> TendonLaw:
        """The law of the tendons, in the model's units."""
        return tendon_law(self.in_units)

    def levers(self, tendon: int) -> tuple[slice, NDArray[np.int64]]:
        """Where in the engine's ten_J the change of a tendon's length by joint is, and the joints."""
        first = int(self.engine.ten_J_rowadr[tendon])
        entries = slice(first, first + int(self.engine.ten_J_rownnz[tendon]))
        return entries, np.asarray(self.engine.ten_J_colind[entries], dtype=np.int64)

    @property
    def xml(self) -> str:
        """The source as text, for any MuJoCo viewer; lengths to six digits."""
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*has no.*passive forces")
            return str(self.spec.to_xml())


def compile_wing(design: Design) -> WingModel:
    """Compile a design.

    Args:
        design: with a timestep in seconds; see `with_timestep` for "auto".

    Raises:
        InputError: MuJoCo refuses the model, and why.
    """
    units = model_units(design)
    return compile_veins(design, fan_veins(design_in_model_units(design, units).fan), units)


def compile_veins(design: Design, veins: tuple[Vein, ...], units: ModelUnits) -> WingModel:
    """Compile veins of any layout, neighbours joined by panels and guards, with the design's properties."""
    if len(veins) > _MOST_VEINS:
        most, got = _MOST_VEINS // 2, design.pattern.units
        raise InputError(f"{design.name}: pattern.units: need at most {most} to simulate a wing, got {got}")
    in_units = design_in_model_units(design, units)
    membrane = panel_membrane(veins, in_units)
    spec = _empty_spec(in_units)
    for index, vein in enumerate(veins):
        add_vein(spec, index, vein, in_units)
        add_tendon(spec, index, in_units)
    # after all motors, so that a motor and its control have the same index: branches have no control
    for index in range(len(veins)):
        add_branches(spec, index, in_units)
    for index in range(len(veins) - 1):
        add_guard(spec, index, veins, in_units)
    add_membrane(spec, membrane, veins, in_units)
    spec.add_text(
        name="units", data=f"length {units.length:g} m, mass {units.mass:g} kg, time {units.time:g} s, angle rad"
    )
    try:
        with warnings.catch_warnings():
            # said of a membrane without damping, although its elasticity is there
            warnings.filterwarnings("ignore", message=".*has no.*passive forces")
            engine = spec.compile()
    except (ValueError, MemoryError, mujoco.FatalError) as error:
        raise InputError(f"{design.name}: MuJoCo cannot build the wing: {' '.join(str(error).split())}") from None
    tendons = _indices(engine, mujoco.mjtObj.mjOBJ_TENDON, ("tendon",), len(veins))[:, 0]
    plastic = engine.tendon_plasticadr[tendons]
    return WingModel(
        design=design,
        units=units,
        in_units=in_units,
        engine=engine,
        spec=spec,
        membrane=membrane,
        senses=np.array([vein.sense for vein in veins]),
        tendons=tendons,
        branches=np.arange(engine.na).reshape(len(veins), -1),
        # of the two numbers of a tendon the dead band's upper end
        creep=plastic[plastic >= 0] + 1,
        joints=_indices(engine, mujoco.mjtObj.mjOBJ_JOINT, ("sweep", "lift", "turn", "fold"), len(veins)),
        motors=_indices(engine, mujoco.mjtObj.mjOBJ_ACTUATOR, ("turn", "fold"), len(veins)),
        bodies=_indices(engine, mujoco.mjtObj.mjOBJ_BODY, ("proximal", "distal"), len(veins)),
        tips=_indices(engine, mujoco.mjtObj.mjOBJ_SITE, ("tip",), len(veins))[:, 0],
    )


def _empty_spec(design: Design) -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.modelname = design.name
    spec.compiler.degree = False
    option = spec.option
    option.timestep = float(design.protocol.timestep)
    option.gravity = [0, 0, -design.protocol.gravity]
    option.integrator = mujoco.mjtIntegrator.mjINT_EULER
    # the default, 1e-8, would end the solver at a place that depends on the model's units
    option.tolerance = 1e-12
    # the sparse Cholesky factorisation of 4.0.0 is wrong where bars touch, and no faster for fewer than fifteen veins
    option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    option.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    # a diverged wing must stay diverged, not start again
    option.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET
    if not design.protocol.contact:
        option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return spec


def _indices(engine: mujoco.MjModel, kind: mujoco.mjtObj, names: tuple[str, ...], count: int) -> NDArray[np.int64]:
    """Ids by vein and name, (vein, name); every joint is a hinge, so a joint's id is its place in the state."""
    return np.array([[mujoco.mj_name2id(engine, kind, f"{name}{vein}") for name in names] for vein in range(count)])

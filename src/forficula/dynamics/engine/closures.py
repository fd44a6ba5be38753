"""Constraints in the engine: copies of bodies welded to their originals, points that supports hold, and their gaps."""

from __future__ import annotations

import mujoco
import numpy as np

from forficula.structure import Closure, Structure, built_points

# the engine's hardest; measured on swinging sheets of 8 x 8 and 16 x 16 facets: 0.999 misses ten times the energy
_IMPEDANCE = (0.9999, 0.9999, 1e-3, 0.5, 2.0)
# Time constant, in timesteps. Measured: twice of it leaves four times the gap and misses four times the energy, half of
# it makes welds vibrate. Runge and Kutta are stable down to 0.4 of it.
_TIME_CONSTANT = 1.0
# share of the structure's size; the gaps of a swinging sheet of 8 x 8 facets stay below 1e-4 of it at a quarter of the
# longest stable timestep
LARGEST_GAP = 1e-3
# Length of a rod that holds a point along an axis, as a share of the structure's size [chosen]: the point leaves its
# plane by 5e-7 of the size where it moves by the size, and rounding of the length is 1e-10 of the size.
_ROD = 1e6
# why a run with larger gaps is unreliable; pages fill in the same field
APART_TEXT = "loops or supported points come apart by {share} of its size: a shorter timestep closes them"


def add_closures(spec: mujoco.MjSpec, structure: Structure, timestep: float) -> None:
    """Weld the copies of bodies to their originals, in the model's units, and add tendons that measure the gaps.

    A weld weighs an angle with the length of its crease, so that angles and distances have the same weight.
    """
    for closure in structure.closures:
        body, copy = (structure.bodies[number] for number in closure.bodies)
        length, middle = _crease(structure, closure)
        turned = np.zeros(4)
        mujoco.mju_mat2Quat(turned, np.ascontiguousarray(closure.frame).ravel())
        weld = spec.add_equality(
            name=closure.name,
            type=mujoco.mjtEq.mjEQ_WELD,
            objtype=mujoco.mjtObj.mjOBJ_BODY,
            name1=body.name,
            name2=copy.name,
            solref=_direct_reference(_TIME_CONSTANT * timestep),
            solimp=_IMPEDANCE,
        )
        # position of the crease's middle on the copy and on the body
        data = np.zeros_like(np.asarray(weld.data))
        data[0:3] = closure.frame.T @ (middle - closure.position)
        data[3:6], data[6:10], data[10] = middle, turned, length
        weld.data = data
        for end, pair in enumerate(closure.points):
            gap = spec.add_tendon(name=gap_name(closure, end))
            for point in pair:
                gap.wrap_site(structure.points[point].name)


def add_holds(spec: mujoco.MjSpec, structure: Structure, timestep: float) -> None:
    """Hold points of bodies along axes by long rigid rods from the ground, in the model's units.

    A point that moves by s normal to a rod of length R moves by s^2 / (2 R) along it.
    """
    places = built_points(structure)
    for hold in structure.holds:
        anchor = places[hold.point] - rod_length(structure) * hold.axis
        spec.worldbody.add_site(name=f"{hold.name}_anchor", pos=anchor)
        rod = spec.add_tendon(name=hold.name)
        rod.wrap_site(f"{hold.name}_anchor")
        rod.wrap_site(structure.points[hold.point].name)
        spec.add_equality(
            name=hold.name,
            type=mujoco.mjtEq.mjEQ_TENDON,
            objtype=mujoco.mjtObj.mjOBJ_TENDON,
            name1=hold.name,
            solref=_direct_reference(_TIME_CONSTANT * timestep),
            solimp=_IMPEDANCE,
        )


def weigh_holds(engine: mujoco.MjModel, structure: Structure) -> None:
    """Give the constraints of rods the compliance that the engine gives to welds of their bodies.

    The engine's own is that of the motion along a rod in the built shape. It is 0 for a rod that no motion lengthens
    there, such as one of two rods with the same effect, and both then lock the structure.
    """
    for hold in structure.holds:
        body = structure.bodies[structure.points[hold.point].body].name
        weight = engine.body_invweight0[engine.body(body).id, 0]
        rod = engine.tendon(hold.name).id
        engine.tendon_invweight0[rod] = max(engine.tendon_invweight0[rod], weight)


def rod_length(structure: Structure) -> float:
    """Return the length of the rods that hold points along axes."""
    return _ROD * structure.span


def gaps_of(structure: Structure) -> tuple[list[str], list[float]]:
    """Return the engine's names of the tendons that measure gaps of closures and of supports, and their lengths."""
    closing = [gap_name(closure, end) for closure in structure.closures for end in range(len(closure.points))]
    held = [hold.name for hold in structure.holds]
    return [*closing, *held], [0.0] * len(closing) + [rod_length(structure)] * len(held)


def _direct_reference(time_constant: float) -> list[float]:
    """Return the engine's `solref` of a critically damped weld as stiffness and damping per mass, both negative.

    As a time constant, the engine would replace less than two timesteps by two timesteps.
    """
    return [-1 / time_constant**2, -2 / time_constant]


def gap_name(closure: Closure, end: int) -> str:
    """Return the engine's name of the gap at one end of a closure's crease."""
    return f"{closure.name}_gap{end}"


def _crease(structure: Structure, closure: Closure) -> tuple[float, np.ndarray]:
    """Return the length of a closure's crease, and the position of its middle in the axes of the body."""
    ends = np.array([structure.points[pair[1]].place for pair in closure.points])
    return float(np.linalg.norm(ends[1] - ends[0])), ends.mean(axis=0)

"""Creases that close loops in the engine: copies of bodies welded to them, and the gaps that the welds leave."""

from __future__ import annotations

import mujoco
import numpy as np

from forficula.structure import Closure, Structure

# measured: softer welds leave gaps of a hundredth of an edge, harder ones gain energy near the flat state
_IMPEDANCE = (0.999, 0.999, 1e-3, 0.5, 2.0)
# of the structure's size; a sheet of 8 x 8 facets that swings keeps its gaps below 1e-4 of it at a quarter of the
# longest stable timestep
LARGEST_GAP = 1e-3
# why such a run is not to be trusted; pages fill in the same field
APART_TEXT = "creases that close loops come apart by {share} of its size: a shorter timestep closes them"


def add_closures(spec: mujoco.MjSpec, structure: Structure, timestep: float) -> None:
    """Weld the copies of a structure in a model's units to what they are copies of, and measure the gaps.

    A weld counts an angle as that times its crease's length, and the ends of the crease as far apart as it is long.
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
            solref=[2 * timestep, 1.0],
            solimp=_IMPEDANCE,
        )
        # where the crease's middle is on the copy and on the body
        data = np.zeros_like(np.asarray(weld.data))
        data[0:3] = closure.frame.T @ (middle - closure.position)
        data[3:6], data[6:10], data[10] = middle, turned, length
        weld.data = data
        for end, pair in enumerate(closure.points):
            gap = spec.add_tendon(name=gap_name(closure, end))
            for point in pair:
                gap.wrap_site(structure.points[point].name)


def gap_name(closure: Closure, end: int) -> str:
    """What the engine calls the gap at one end of a closure's crease."""
    return f"{closure.name}_gap{end}"


def _crease(structure: Structure, closure: Closure) -> tuple[float, np.ndarray]:
    """The length of a closure's crease, and where its middle is in the axes of the body."""
    ends = np.array([structure.points[pair[1]].place for pair in closure.points])
    return float(np.linalg.norm(ends[1] - ends[0])), ends.mean(axis=0)

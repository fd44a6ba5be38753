"""Kernels: functions that Warp compiles for a device and calls for every structure side by side.

Arrays of steps begin with the step, so that one step of all structures is one piece of memory.
"""
# Warp reads the annotations of kernels as objects: no `from __future__ import annotations`

import warp as wp

# derivatives are not needed, and compiling them takes time
wp.set_module_options({"enable_backward": False})


@wp.kernel
def set_controls(step: wp.array[int], controls: wp.array3d[float], ctrl: wp.array2d[float]):
    """Set the engine's controls of the present step."""
    world, control = wp.tid()
    ctrl[world, control] = controls[step[0], world, control]


@wp.kernel
def keep_values(step: wp.array[int], values: wp.array2d[float], first: int, kept: wp.array3d[float]):
    """Keep values of the present step, from a column on."""
    world, column = wp.tid()
    kept[step[0], world, first + column] = values[world, column]


@wp.kernel
def next_step(step: wp.array[int]):
    """Count the step."""
    step[0] = step[0] + 1


@wp.kernel
def gather(
    kept: wp.array3d[float],
    steps: wp.array[int],
    worlds: wp.array[int],
    first: int,
    values: wp.array2d[float],
):
    """Gather values of some structures after some of their steps."""
    row, column = wp.tid()
    values[row, column] = kept[steps[row], worlds[row], first + column]


@wp.struct
class MotionBounds:
    """Bounds of positions, speeds and watched coordinates; see `stepping.passage.Conditions`."""

    lowest: wp.array2d[wp.float64]
    highest: wp.array2d[wp.float64]
    rest_speed: wp.array2d[wp.float64]
    senses: wp.array2d[wp.float64]
    least: wp.array2d[wp.float64]
    most: wp.array2d[wp.float64]
    least_hold: wp.array[wp.float64]


@wp.struct
class StageNumbers:
    """Numbers of steps and flags of the present stages; see `stepping.passage.Conditions`."""

    has_bounds: wp.array[int]
    ends_at_rest: wp.array[int]
    may_stick: wp.array[int]
    hold: wp.array[wp.int64]
    window: wp.array[wp.int64]
    taken: wp.array[wp.int64]
    start: wp.array[wp.int64]
    risen: wp.array[wp.int64]
    limit: wp.array[wp.int64]
    goal_since: wp.array[wp.int64]
    rest_since: wp.array[wp.int64]


@wp.func
def diverged(state: wp.array[float], bounds: MotionBounds, world: int, positions: int, dof: int):
    """Return whether positions or velocities are not finite, or a hinge is far beyond its stop."""
    for place in range(positions):
        position = wp.float64(state[1 + place])
        if not wp.isfinite(position):
            return True
        if position < bounds.lowest[world, place] or position > bounds.highest[world, place]:
            return True
    for place in range(dof):
        if not wp.isfinite(state[1 + positions + place]):
            return True
    return False


@wp.func
def rests(state: wp.array[float], bounds: MotionBounds, world: int, positions: int, dof: int):
    """Return whether every coordinate is at rest."""
    for place in range(dof):
        speed = wp.abs(wp.float64(state[1 + positions + place]))
        if not speed <= bounds.rest_speed[world, place]:
            return False
    return True


@wp.func
def within(
    state: wp.array[float],
    lengths: wp.array[float],
    bounds: MotionBounds,
    weights: wp.array2d[wp.float64],
    tendons: wp.array[int],
    world: int,
):
    """Return whether every watched coordinate is within its bounds: a sum of angles, or the length of a tendon."""
    for coordinate in range(tendons.shape[0]):
        value = wp.float64(0.0)
        if tendons[coordinate] >= 0:
            value = wp.float64(lengths[tendons[coordinate]])
        else:
            for hinge in range(weights.shape[1]):
                weight = weights[coordinate, hinge]
                if weight != wp.float64(0.0):
                    value += weight * bounds.senses[world, hinge] * wp.float64(state[1 + hinge])
        if not (value >= bounds.least[world, coordinate] and value <= bounds.most[world, coordinate]):
            return False
    return True


@wp.kernel
def find_ends(
    count: int,
    positions: int,
    dof: int,
    states: wp.array3d[float],
    lengths: wp.array3d[float],
    weights: wp.array2d[wp.float64],
    tendons: wp.array[int],
    bounds: MotionBounds,
    stage: StageNumbers,
    passage: wp.array2d[wp.int64],
):
    """Find the end of the present stage of each structure, or the step before it diverges."""
    world = wp.tid()
    taken = stage.taken[world]
    goal_since = stage.goal_since[world]
    if goal_since < wp.int64(0):
        goal_since = taken + wp.int64(1)
    rest_since = stage.rest_since[world]
    if rest_since < wp.int64(0):
        rest_since = taken + wp.int64(1)
    sound = count
    end = count + 1
    resting = bool(False)
    reached = bool(False)
    held = bool(False)
    met = bool(False)
    for step in range(count):
        state = states[step, world]
        if diverged(state, bounds, world, positions, dof):
            sound = step
            break
        number = taken + wp.int64(step + 1)
        resting = rests(state, bounds, world, positions, dof)
        reached = stage.ends_at_rest[world] != 0 and resting and number > stage.risen[world]
        if stage.has_bounds[world] != 0:
            reached = within(state, lengths[step, world], bounds, weights, tendons, world)
        met = met or reached
        if not reached:
            goal_since = number + wp.int64(1)
        if not resting:
            rest_since = number + wp.int64(1)
        hold = wp.float64(stage.hold[world])
        if stage.has_bounds[world] != 0:
            hold = wp.max(hold, bounds.least_hold[world] * wp.float64(goal_since - stage.start[world]))
        held = reached and wp.float64(number - goal_since) >= hold
        since = wp.max(rest_since, stage.risen[world])
        stuck = resting and not reached and stage.may_stick[world] != 0 and number - since >= stage.window[world]
        if held or stuck or number >= stage.limit[world]:
            end = step + 1
            break
    passage[world, 0] = wp.int64(sound)
    passage[world, 1] = wp.int64(end)
    passage[world, 2] = wp.where(reached, goal_since, wp.int64(-1))
    passage[world, 3] = wp.where(resting, rest_since, wp.int64(-1))
    passage[world, 4] = goal_since
    passage[world, 5] = wp.where(held, wp.int64(1), wp.int64(0))
    passage[world, 6] = wp.where(resting, wp.int64(1), wp.int64(0))
    passage[world, 7] = wp.where(reached, wp.int64(1), wp.int64(0))
    passage[world, 8] = wp.where(met, wp.int64(1), wp.int64(0))

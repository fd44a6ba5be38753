"""Springs, tendons and length limits in the engine."""

from __future__ import annotations

import math
from collections.abc import Iterator

import mujoco
import numpy as np

from forficula.dynamics.engine.stops import stop_reference
from forficula.material.law.tendon_law import TendonLaw
from forficula.structure import LengthLimit, Spring, Structure, Tendon

# By default MuJoCo hardens a limit over 0.001 of its length unit, a different share of every structure. The other
# numbers are its defaults.
_SOFT_SHARE = 0.001
_PARTS = 1e6  # the onset of a spring made of muscles takes the longest length divided by this number
_FAR = 3.0  # spans of a structure: longer than its tendons become
_HARD = 1e6  # in the model's units of force: larger than the push of damper and branches of any tendon
_QUADRATIC = 1e3  # extension, in resting lengths, up to which a quadratic spring is exact
_CUBIC_MISS = 1e-4  # allowed deviation of a cubic spring made of muscles, as a share of the largest force
_SLOW = 1e9  # lengths per unit of time: velocities of a muscle count as shares of this


def add_spring(spec: mujoco.MjSpec, spring: Spring, structure: Structure) -> None:
    """Add a spring, which pulls and pushes."""
    line = spec.add_tendon(name=spring.name)
    line.stiffness, line.damping = [spring.stiffness, 0.0, 0.0], [spring.damping, 0.0, 0.0]
    line.springlength = [spring.rest_length, spring.rest_length]
    for point in spring.points:
        line.wrap_site(structure.points[point].name)


def add_tendon(spec: mujoco.MjSpec, tendon: Tendon, structure: Structure) -> None:
    """Add a tendon, whose spring pulls beyond its resting length and never pushes.

    If it is stretched beyond its yield extension, its resting length grows at the end of the step. MuJoCo's own damper
    of a tendon acts at any length and can push. A tendon that must not push therefore has neither spring nor damper
    here: both are actuators, see `add_pulls`, because MuJoCo can clamp the sum of actuators.
    """
    law = tendon.law
    spring = spec.add_tendon(name=tendon.name)
    spring.springlength = [0, law.rest_length]
    if law.lets_go:
        spring.actfrclimited = mujoco.mjtLimited.mjLIMITED_TRUE
        spring.actfrcrange = [-1e30, 0]
    else:
        spring.stiffness = law.stiffness
        spring.damping = law.damping or (0.0, 0.0, 0.0)
        spring.springyield = law.yield_extension or 0.0
    for point in tendon.points:
        spring.wrap_site(structure.points[point].name)


def add_pulls(spec: mujoco.MjSpec, tendon: Tendon, structure: Structure) -> None:
    """Add the Maxwell branches of a tendon, which start relaxed, and spring and damper if the tendon must not push.

    Each branch is a DC motor without input (MuJoCo manual, actuator/dcmotor). Its current, the force of the branch,
    positive for pushing, obeys L di/dt = -R i - K dl/dt. With K = 1, R = 1 / (stiffness time) and L / R = time this is
    a Maxwell branch. The engine integrates it exactly for the velocity before the step, and uses the force after it.
    """
    law, name = tendon.law, tendon.name
    for number, branch in enumerate(law.branches):
        _add_motor(spec, f"{name}_branch{number}", name, 1 / (branch.stiffness * branch.time), branch.time)
    if not law.lets_go:
        return
    # tendons of a sheet have no largest length
    longest = tendon.longest if math.isfinite(tendon.longest) else _FAR * structure.span
    width = longest / _PARTS
    viscous = (law.damping or (0.0,))[0]
    for part, (begins, reach, stiffer) in enumerate(_stiffening(law, longest, width)):
        muscle = _add_muscle(spec, f"{name}_spring{part}", name, (begins, longest), reach, stiffer)
        if part == 0 and viscous:
            muscle.gaintype, muscle.gainprm[:3] = mujoco.mjtGain.mjGAIN_AFFINE, [0, 0, -viscous]
            muscle.ctrllimited, muscle.ctrlrange = mujoco.mjtLimited.mjLIMITED_TRUE, [1, 2]
    if law.stiffness[1] < 0:
        _add_softening(spec, name, law, longest)
    _add_slack_clamp(spec, name, law.rest_length, longest)


def _add_motor(spec: mujoco.MjSpec, name: str, tendon: str, resistance: float, time: float) -> None:
    motor = spec.add_actuator(name=name, target=tendon, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    motor.set_to_dcmotor(
        motorconst=[1, 0],
        resistance=resistance,
        inductance=[0, time],
        ctrlspec=mujoco.mjtCtrlInput.mjINPUT_NONE.value,
    )


def _stiffening(law: TendonLaw, longest: float, sets_in: float) -> Iterator[tuple[float, float, float]]:
    """Yield the parts of a tendon's spring: length at which the stiffness starts to grow, width, and increase.

    The stiffness grows linearly over each part, so the force is quadratic. A quadratic spring needs one part. A cubic
    spring needs enough parts to deviate by at most about 1e-4 of its largest force: with the exact force at both ends
    of a part of width h, the force deviates by at most c h^3 sqrt(3) / 36. If the linear term k is so small that the
    stiffness would start below 0, the first part has the width sqrt(k / c + h^2 / 2), at whose end a stiffness that
    starts at 0 gives the exact force.
    """
    (linear, quadratic, cubic), rest = law.stiffness, law.rest_length
    count, width = 1, _QUADRATIC * rest
    if cubic:
        reach = longest - rest if longest > rest else rest
        allowed = _CUBIC_MISS * float(law.elastic.force(rest + reach * np.linspace(0, 1, 101)).max())
        count = math.ceil(reach * (cubic * math.sqrt(3) / 36 / allowed) ** (1 / 3))
        width = reach / count
    ends = width * np.arange(count + 1)
    if cubic and linear < cubic * width**2 / 2:
        first = math.sqrt(linear / cubic + width**2 / 2)
        ends = np.append(0.0, first + ends)
    # linear interpolation overestimates the slope of a cubic by c h^2 / 2 on average
    slopes = linear + 2 * max(quadratic, 0.0) * ends
    if cubic:
        slopes += 3 * cubic * ends**2 - cubic * width**2 / 2
    slopes[0] = max(slopes[0], 0.0)
    # the onset begins half its width early, so that the spring is exact from half its width late
    parts = [(rest - sets_in / 2, sets_in, float(slopes[0]))]
    parts += zip((rest + ends[:-1]).tolist(), np.diff(ends).tolist(), np.diff(slopes).tolist(), strict=True)
    if quadratic < 0:
        # up to the resting length this compensates the force of `_add_softening`
        parts.append((0.0, rest, -2 * quadratic * rest))
    # without any stiffness one part remains, because it also has the damper
    return iter([part for part in parts if part[2]] or parts[:1])


def _add_muscle(
    spec: mujoco.MjSpec, name: str, tendon: str, lengths: tuple[float, float], width: float, stiffness: float
) -> mujoco.MjsActuator:
    """Add the passive force of a stretched muscle alone (MuJoCo's mju_muscleBias).

    The force is zero up to the first of both lengths. From there on the stiffness grows linearly over a width to the
    given value and is then constant. The second length is the longest one.
    """
    begins, longest = lengths
    muscle = spec.add_actuator(name=name, target=tendon, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    muscle.gaintype, muscle.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_MUSCLE
    muscle.gainprm = np.zeros(10)
    # the unit of the muscle's own length is the width, and it is 1 at the onset; ranges of equal width for all resting
    # lengths are only shifted
    own_range, muscle.lengthrange = [1 - longest / width, 1], [begins - longest, begins]
    # range, force, scale, lmin, lmax, vmax, fpmax, fvmax
    muscle.biasprm = [*own_range, stiffness * width, 1, 0, 3, 1, 1, 1, 0]
    return muscle


def _add_slack_clamp(spec: mujoco.MjSpec, tendon: str, rest: float, longest: float) -> None:
    """Add a push that exceeds damper and branches while the tendon is slack, so that the engine clamps the sum to 0.

    An active muscle cancels the push while the tendon is taut. Its unit of length is 1000 times the longest length, so
    that it is almost independent of length and speed beyond the resting length: the error is 2e-16 of the push, and
    the effect of speed is a damper of 2e-7 of the model's units (mju_muscleGainLength and mju_muscleGainVelocity). A
    file cannot keep numbers of more different magnitudes. Models of wings of different sizes have different units: with
    a damper of 2e-5 their angles differed by 1e-6 rad, now by 1e-8 rad.
    """
    push = spec.add_actuator(name=f"{tendon}_silence", target=tendon, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    push.gaintype, push.biastype = mujoco.mjtGain.mjGAIN_MUSCLE, mujoco.mjtBias.mjBIAS_AFFINE
    # 1 at the resting length
    push.lengthrange = [rest - longest, rest]
    # range, force, scale, lmin, lmax, vmax, fpmax, fvmax
    push.gainprm = [0.999, 1, _HARD, 1, 1 - 1 / _PARTS, 1e6, 1e10, 1, 1, 0]
    push.biasprm = [_HARD, *np.zeros(9)]
    # the engine clamps its control to 1, because no motor sets it
    push.ctrllimited, push.ctrlrange = mujoco.mjtLimited.mjLIMITED_TRUE, [1, 2]


def _add_softening(spec: mujoco.MjSpec, tendon: str, law: TendonLaw, longest: float) -> None:
    """Add the quadratic term b x^2 of a softening spring, b < 0, because passive muscles can only stiffen.

    An active muscle with its control fixed at 1 pulls F - |b| x^2 while F > |b| x^2 / 2 (mju_muscleGain; the effect of
    velocity is negligible for its large unit). On a slack tendon, the sum of this force and of the passive muscle from
    length 0 to the resting length is a straight line, which is subtracted.
    """
    bend, rest = -law.stiffness[1], law.rest_length
    furthest = 1.1 * max(rest, longest - rest)
    force = 2 * bend * furthest**2
    arc = spec.add_actuator(name=f"{tendon}_softening", target=tendon, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    arc.gaintype, arc.biastype = mujoco.mjtGain.mjGAIN_MUSCLE, mujoco.mjtBias.mjBIAS_NONE
    # the muscle's own length is 1 at the resting length, and 0 and 2 at the largest distances from it
    arc.lengthrange = [rest - furthest, rest]
    # range, force, scale, lmin, lmax, vmax, fpmax, fvmax
    arc.gainprm = [0, 1, force, 1, -1, 3, _SLOW, 1, 1, 0]
    arc.ctrllimited, arc.ctrlrange = mujoco.mjtLimited.mjLIMITED_TRUE, [1, 2]
    line = spec.add_actuator(name=f"{tendon}_line", target=tendon, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    line.gaintype, line.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_AFFINE
    line.gainprm, line.biasprm = np.zeros(10), [force - bend * rest**2, 2 * bend * rest, *np.zeros(8)]


def add_limit(spec: mujoco.MjSpec, limit: LengthLimit, structure: Structure) -> None:
    """Add a limit on the distance of two points."""
    line = spec.add_tendon(
        name=limit.name,
        limited=True,
        range=[0, limit.most],
        solref_limit=stop_reference(structure.stops),
        solimp_limit=[0.9, 0.95, _SOFT_SHARE * limit.built_length, 0.5, 2],
    )
    for point in limit.points:
        line.wrap_site(structure.points[point].name)


def add_distance(spec: mujoco.MjSpec, name: str, points: tuple[int, int], structure: Structure) -> None:
    """Add a tendon that only measures the distance of two points."""
    line = spec.add_tendon(name=name)
    for point in points:
        line.wrap_site(structure.points[point].name)

"""Loads of a joint at one of its stops: moments of the tendon and of drives about the pin."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.hinge.strap_shape import StrapPlace
from forficula.structure import Structure

Stop = Literal["overbend", "fold"]


@dataclass(frozen=True, kw_only=True)
class StopLoad:
    """Loads at a stop.

    Attributes:
        stop: "overbend" or "fold".
        pull: pull of the tendon, N.
        by_tendon: moment of the tendon that presses on the stop, N m; < 0 if it pulls away from it.
        by_drive: the same for the drive with the largest moment, N m, >= 0.
        drive: its name; "" without one.
        couple: moment of the tendon across the hinge's axis, which loads the pin, N m.
        force: on the faces of the stop, N, >= 0.
        area: area of the faces, m^2; 0 if nothing is left of them.
    """

    stop: Stop
    pull: float
    by_tendon: float
    by_drive: float
    drive: str
    couple: float
    force: float
    area: float

    @property
    def on_pin(self) -> float:
        """Force on the pin, N. At the overbend stop it is the difference of pull and stop force, which are opposed."""
        return abs(self.pull - self.force) if self.stop == "overbend" else self.pull + self.force


def stop_load(structure: Structure, joint: JointLayout, place: StrapPlace, stop: Stop) -> StopLoad:
    """Return the static loads of a joint at a stop, from the moments about its pin.

    The force is assumed to be distributed evenly over the faces.
    """
    angle, sense = (joint.upper, 1.0) if stop == "overbend" else (joint.lower, -1.0)
    ends = turned(joint, angle).of(place.ends[:, 1])
    strap_vectors = place.ends[:, 0] - ends
    lengths = np.linalg.norm(strap_vectors, axis=1)
    pulls = structure.tendons[place.tendon].law.elastic.force(lengths) / place.strap.count
    moment = np.cross(ends - joint.origin, (pulls / lengths)[:, None] * strap_vectors).sum(axis=0)
    along = float(moment @ joint.frame[:, 1])
    by_drive, drive = _driven(structure, joint, sense)
    # hinges turn about -y
    by_tendon = -sense * along
    low, high = _faces(joint, stop)
    torque = max(0.0, by_tendon + by_drive)
    return StopLoad(
        stop=stop,
        pull=float(pulls.sum()),
        by_tendon=by_tendon,
        by_drive=by_drive,
        drive=drive,
        couple=float(np.linalg.norm(moment - along * joint.frame[:, 1])),
        force=torque / ((low + high) / 2),
        area=max(0.0, high - low) * joint.width,
    )


def _driven(structure: Structure, joint: JointLayout, sense: float) -> tuple[float, str]:
    """Return the largest torque of a drive on a hinge in a sense, N m, and the drive's name."""
    most, name = 0.0, ""
    for drive in structure.drives:
        torque = 0.0
        for motor, strength in zip(structure.motors, drive.strengths, strict=True):
            if motor.kind == "torque" and joint.hinge in motor.hinges:
                gain = motor.gains[motor.hinges.index(joint.hinge)] if motor.gains else 1.0
                torque += sense * strength * gain
        if torque > most:
            most, name = torque, drive.name
    return most, name


def _faces(joint: JointLayout, stop: Stop) -> tuple[float, float]:
    """Return the inner and outer distance of the faces of a stop from the hinge's axis, m."""
    low = joint.knuckle_diameter / 2 + joint.make.clearance
    if stop == "overbend":
        return low, joint.top / math.cos(joint.upper / 2)
    # a face extends to the end of the lug, or down to its lower edge
    slope = max(0.0, (math.pi + joint.lower) / 2)
    reach = joint.lug / math.cos(slope)
    return low, reach if slope == 0 else min(reach, joint.knuckle_diameter / 2 / math.sin(slope))

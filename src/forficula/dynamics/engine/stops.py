"""Compliance of stops and length limits in the engine."""

from __future__ import annotations

from forficula.structure import Stops

# The engine's impedance, constant over the depth: the share of a force into the stop that the stop balances at once.
# Under a moment M on an inertia I, a stop yields by (1 - 0.99) (M / I) T^2 zeta^2 at rest.
STOP_IMPEDANCE = (0.99, 0.99, 1e-3, 0.5, 2.0)
# The largest impedance that the engine accepts: under a torque M below its dry friction, a joint of inertia I creeps at
# (1 - 0.9999) (M / I) T / 2.
FRICTION_IMPEDANCE = (0.9999, 0.9999, 1e-3, 0.5, 2.0)


def stop_reference(stops: Stops) -> list[float]:
    """Return the engine's `solref` of a stop: its time constant, in the model's units, and damping ratio."""
    return [stops.time_constant, stops.damping_ratio]

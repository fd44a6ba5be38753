"""Check that the timestep resolves the stops, guard tendons and contacts that a run met."""

from __future__ import annotations

import numpy as np

from forficula.dynamics import STEPS_TO_CONTACT, STEPS_TO_TIME_CONSTANT, Record, contact_timestep
from forficula.quantities import show_value


def unresolved_stops(record: Record) -> str:
    """Return why the timestep is too long for the stops or contacts that a run met; empty if it is short enough."""
    structure, timestep = record.structure, float(record.design.protocol.timestep)
    stops = structure.stops
    met = [("stop_work", "stops.time_constant", stops, stops.time_constant / STEPS_TO_TIME_CONSTANT)]
    if structure.contact is not None:
        met.append(("contact_work", "contact.time_constant", structure.contact.stops, contact_timestep(structure)))
    if structure.table is not None:
        table = structure.table.stops
        met.append(("contact_work", "table.time_constant", table, table.time_constant / STEPS_TO_CONTACT))
    for series, key, stops, longest in met:
        # tolerate rounding, because a timestep of exactly this value is allowed
        if np.any(record.series[series]) and timestep > (1 + 1e-9) * longest:
            return (
                f"protocol.timestep of {show_value(timestep, 's')} does not resolve {key} of"
                f" {show_value(stops.time_constant, 's')}; need <= {show_value(longest, 's')}"
            )
    return ""

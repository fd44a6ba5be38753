"""What a person should know of a run that only the run itself tells."""

from __future__ import annotations

import numpy as np

from forficula.design.tendon import tendon_law
from forficula.dynamics import Record

_FAR_FASTER = 100.0  # than the tests of a material: two decades, over which a polymer's modulus can change much


def run_warnings(record: Record) -> list[str]:
    """What a person should know of a run that only the run itself tells, one sentence each."""
    law = record.design.tendon.law
    if law is None or law.highest_strain_rate is None:
        return []
    rate = highest_strain_rate(record)
    if rate is None or rate <= _FAR_FASTER * law.highest_strain_rate:
        return []
    return [
        f"taut tendons move at up to {rate:.3g} 1/s, {_rounded(rate / law.highest_strain_rate)} times the"
        f" {law.highest_strain_rate:.3g} 1/s up to which {law.name or 'their law'} was measured: what it says of losses"
        " and stiffness so fast is extrapolated"
    ]


def highest_strain_rate(record: Record) -> float | None:
    """The highest rate at which a taut tendon is strained or lets go, from one kept row to the next, 1/s.

    By the resting length of the design, as a law counts strain. Rows further apart than a move show less of it.

    Returns:
        None where no tendon is taut over two rows, and of a run that diverged.
    """
    if record.diverged_at is not None:
        return None
    length = record.series["tendon_length"]
    slack = record.series.get("tendon_rest_length", tendon_law(record.design).rest_length)
    taut = length > slack
    spans = np.diff(record.time)
    both = taut[1:] & taut[:-1] & (spans > 0)[:, None]
    if not both.any():
        return None
    rates = np.abs(np.diff(length, axis=0))[both] / np.broadcast_to(spans[:, None], both.shape)[both]
    return float(rates.max() / record.design.tendon.rest_length)


def _rounded(ratio: float) -> str:
    """To two digits, without an exponent."""
    return f"{float(f'{ratio:.2g}'):.0f}"

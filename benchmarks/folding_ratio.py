"""Largest folding ratio of a fan with equal veins, by number of units and thickness of its bars.

The proximal and the distal veins are 11 cm long, and the hub has a radius of 2 mm: with a vein of 22 cm and a hub of at
least 2 mm, a search over all three lengths has its optimum there. The sector angle is varied between the one at which
the bars touch at the ring fold and the one at which the fan spreads over 180 deg.

    python benchmarks/folding_ratio.py [--units N]
"""

from __future__ import annotations

import argparse
import math

import numpy as np

from forficula import load_design, structure_of
from forficula.analysis.package import FlatPackage, flat_package
from forficula.errors import InputError

_DIAMETERS = (0.1, 1.0, 5.0)  # mm
_SECTORS = 40  # number of sector angles


def largest(units: int, diameter: float) -> FlatPackage:
    """Return the flat-folded fan with the largest folding ratio, for a diameter in mm."""
    sizes = []
    narrowest = math.degrees(1.1e-3 * diameter / 0.11)
    for sector in np.linspace(max(narrowest, 1.0), min(90 / units, 60.0), _SECTORS):
        values = {
            "pattern.proximal_length": "11 cm",
            "pattern.distal_length": "11 cm",
            "pattern.hub_radius": "2 mm",
            "pattern.sector_angle": f"{sector} deg",
            "pattern.units": units,
            "vein.diameter": f"{diameter} mm",
            "membrane.margin": "0.1 mm",
            # tips of narrow panels that start bent would be too far apart for the guard tendons
            "protocol.initial_overbend": "0.1 deg",
        }
        try:
            size = flat_package(structure_of(load_design("binder2025", values)))
        except InputError:
            continue
        if size is not None:
            sizes.append(size)
    return max(sizes, key=lambda size: size.folding_ratio)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--units", type=int, default=10, help="largest number of fan units")
    most = parser.parse_args().units
    print("| units | veins | " + " | ".join(f"bars of {diameter:g} mm" for diameter in _DIAMETERS) + " |")
    for units in range(1, most + 1):
        cells = [largest(units, diameter) for diameter in _DIAMETERS]
        texts = [f"{size.folding_ratio:.2f}, {1e3 * size.height:g} mm" for size in cells]
        print(f"| {units} | {2 * units + 1} | " + " | ".join(texts) + " |")


if __name__ == "__main__":
    main()

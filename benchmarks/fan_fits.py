"""Count how often the intervals of fitted fans contain the planted numbers.

Fans of 3 to 9 veins with random dimensions, position, turn and side are clicked with random errors. Of fans with more
than 3 veins, one tip is not clicked.

    python benchmarks/fan_fits.py [--fans N] [--json FILE]
"""

import argparse
import json
import math
from pathlib import Path

import numpy as np

from forficula.goals.clicks.fan_fit import fit_fan
from forficula.goals.clicks.fan_least_squares import FanClicks
from forficula.pattern import EarwigFan, hub_points, ring_vertices, tips

NUMBERS = ("proximal_length", "distal_length", "hub_radius", "sector_angle")
ERRORS = (0.002, 0.005, 0.02)  # of a coordinate, divided by the proximal length


def clicked(random: np.random.Generator, error: float) -> tuple[EarwigFan, FanClicks]:
    """Return a random fan and its clicked points."""
    length = random.uniform(0.5, 1.5)
    fan = EarwigFan(
        proximal_length=length,
        distal_length=length * random.uniform(0.5, 1.5),
        hub_radius=length * random.uniform(0.08, 0.3),
        sector_angle=math.radians(random.uniform(8, 22)),
        units=int(random.integers(1, 5)),
    )
    parts = [part[:, 0] + 1j * part[:, 1] for part in (hub_points(fan), ring_vertices(fan), tips(fan))]
    places = np.stack(parts, axis=1)
    places = (places.conj() if random.random() < 0.5 else places)[:: random.choice([-1, 1])]
    places = places * np.exp(1j * random.uniform(0, 7)) + complex(*random.normal(0, 3, 2))
    points = np.stack([places.real, places.imag], axis=-1) + random.normal(0, error * length, (*places.shape, 2))
    points[:, 0] = np.nan
    if len(points) > 3:
        points[random.integers(len(points)), 2] = np.nan
    return fan, FanClicks(points=points, numbers=tuple(range(len(points))))


def main() -> None:
    """Run and report."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--fans", type=int, default=500, help="fans for each error of a click")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    rows = []
    for error in ERRORS:
        random, inside, certain = np.random.default_rng(0), np.zeros(4), 0
        for _ in range(arguments.fans):
            fan, clicks = clicked(random, error)
            fit = fit_fan(clicks)
            ranges = [(getattr(fit, name), getattr(fan, name)) for name in NUMBERS]
            inside += [fitted.low <= planted <= fitted.high for fitted, planted in ranges]
            certain += fit.tangent_certain
        shares = dict(zip(NUMBERS, (inside / arguments.fans).tolist(), strict=True))
        rows.append({"error": error, "fans": arguments.fans, **shares, "side certain": certain / arguments.fans})
        print(f"error {100 * error:g} %:", *(f"{name} {100 * share:.1f} %" for name, share in shares.items()), end="; ")
        print(f"side certain {100 * certain / arguments.fans:.1f} %")
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()

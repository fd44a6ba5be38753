"""Folding tests of strips with a planted law, from a loop over the rows instead of the package's clips."""

import numpy as np

from forficula.material import FoldingTest

LAW = {"stiffness": 0.25, "rest_angle": 0.1, "yield_moment": 0.1, "hardening": 0.04}
PEAKS = (1.2, -0.2, 1.6, 0.3)
WIDTH = 0.02


def folded_strip(seed=0, *, peaks=PEAKS, speeds=(0.01,), damping=0.0, rows=60, noise=2e-3, **law):
    """Return the test of a strip that is folded from rest to angles, rad, one after another."""
    value = LAW | law
    stiffness, hardening = value["stiffness"], value["hardening"]
    yield_angle = value["yield_moment"] / stiffness
    angles, times, moments = [], [], []
    at, now, fold = value["rest_angle"], 0.0, 0.0
    for number, peak in enumerate(peaks):
        speed = speeds[number % len(speeds)]
        for angle in np.linspace(at, peak, rows, endpoint=False):
            turned = angle - value["rest_angle"]
            fold = min(max(fold, turned - yield_angle), turned + yield_angle)
            spring = hardening * turned + (stiffness - hardening) * (turned - fold)
            angles.append(angle)
            times.append(now)
            moments.append(spring + damping * np.sign(peak - at) * speed)
            now += abs(peak - at) / rows / speed
        at = peak
    scatter = noise * np.random.default_rng(seed).standard_normal(len(moments))
    return FoldingTest(
        name=f"strip-{seed}",
        time=np.array(times),
        angle=np.array(angles),
        moment=WIDTH * (np.array(moments) + scatter),
        width=WIDTH,
        thickness=1e-4,
    )

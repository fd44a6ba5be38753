"""
When is a hinge bistable?
=========================

A hinge with a tendon across it is bistable if it has a stop beyond straight: the tendon holds the hinge open on this
stop, and a push past straight lets it fold. The height of the barrier, and the angle at which the tendon becomes slack,
follow from the energy of the tendon alone, without a simulation.
"""

# %%
# Compute the landscape of one hinge of the reference wing, with tendons of three lengths.

import matplotlib.pyplot as plt
import numpy as np

import forficula as ff

figure, axes = plt.subplots(figsize=(6, 3.4), layout="constrained")
for rest_length in ("3 cm", "6 cm", "9 cm"):
    design = ff.load_design("binder2025", {"tendon.rest_length": rest_length})
    hinge = ff.landscape(design).hinge
    axes.plot(np.degrees(hinge.angle), hinge.energy, label=f"resting length {rest_length}")
    print(f"{rest_length}: barrier {1e3 * hinge.barrier:.2f} mJ, held open by {100 * hinge.holding_torque:.1f} N cm")
axes.set(xlabel="angle of the hinge (deg)", ylabel="energy of its tendon (J)")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(frameon=False)
plt.show()

# %%
# On the right the hinge rests on its stop, 3 deg past straight. On the left the tendon is slack, and no moment acts.
# Short tendons store more energy, and pull until the hinge is almost completely folded. The barrier is the small step
# between the stop and straight. It grows with the stretch, and with the square of the angle of the stop.

# %%
# The landscape is computed numerically along the angle of the hinge, for any law and any spring. One tendon between
# equal arms *a*, with a linear law of stiffness *k* and with bars square to the axis, has closed forms (see
# :doc:`/model/theory`). ``hinge`` is this ideal hinge, so both must agree.

from scipy.special import ellipk

arm, stiffness, stop, start = 0.055, 1000, np.radians(3), np.radians(1)
free = ff.landscape(ff.load_design("binder2025", {"tendon.rest_length": "0 cm"})).hinge
scale = np.sqrt(free.hinge.inertia / (stiffness * arm**2))
ratio = 9 / 11  # resting length by length at straight of the last hinge above
comparisons = {
    "barrier without a resting length (mJ)": (
        1e3 * free.barrier,
        1e3 * stiffness / 2 * (2 * arm) ** 2 * np.sin(stop / 2) ** 2,
    ),
    "time to fold without a resting length (ms)": (1e3 * free.fold_time, 1e3 * scale * ellipk(np.cos(start / 2) ** 2)),
    "growth rate at straight (1/s)": (hinge.growth_rate, np.sqrt(1 - ratio) / hinge.time_scale),
    "holding torque (N cm)": (
        100 * hinge.holding_torque,
        100 * stiffness * arm**2 * 2 * np.sin(stop / 2) * (np.cos(stop / 2) - ratio),
    ),
    "slack beyond (deg)": (np.degrees(hinge.slack_angle), np.degrees(-2 * np.arccos(ratio))),
}
for name, (numerical, closed) in comparisons.items():
    print(f"{name}: {numerical:.9g} along the angle, {closed:.9g} in closed form")

# %%
# The hinges of the wing differ from the ideal one, because a ring crease is not square to the veins. Their landscapes
# are in ``tendons``. A hinge with a spring, or with a tendon that is attached above the bars, is computed in the same
# manner, without closed forms.

wing = ff.landscape("binder2025")
for name, hinge in (("ideal hinge", wing.hinge), ("second hinge of the wing", wing.tendons[1])):
    print(f"{name}: barrier {1e3 * hinge.barrier:.4f} mJ, held open by {100 * hinge.holding_torque:.3f} N cm")

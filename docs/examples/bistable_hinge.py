"""
When is a hinge bistable?
=========================

A tendon across a hinge holds it open, until a push carries the hinge past straight. How high the barrier is, and where
the tendon goes slack, follows from its energy alone: nothing is simulated here.
"""

# %%
# Survey one hinge of the reference wing, with tendons of three lengths.

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
# On the right the hinge rests on its stop, 3 deg past straight; on the left the tendon is slack, and nothing moves it.
# Short tendons store more and pull until the hinge is folded nearly all the way. The barrier is the small step between
# the stop and straight: it grows with the stretch, and with the square of the angle of the stop.

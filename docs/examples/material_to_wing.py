"""
From a material to a wing
=========================

How thick must a tendon of printed TPU be for a given stiffness, and how does the wing fold with it?
"""

# %%
# Every named material states its source. TPU 82A is the material of the paper. The list gives the cross-section of a
# tendon for three stiffnesses.

import forficula as ff

law = ff.material.load_law("tpu-82a")
print(law.source)
wing = ff.load_design("binder2025")
for sizing in ff.material.size_tendons(wing, law, [1000.0, 2000.0, 3000.0]):
    print(f"{100 * sizing.length:.0f} cm long, {sizing.why}:")
    for size in sizing.sizes:
        area, across = 1e6 * size.area, 1e3 * size.diameter
        print(f"    {size.stiffness / 100:.0f} N/cm: {area:.1f} mm2, {across:.1f} mm if round")

# %%
# Run the wing twice: with a linear tendon, and with a tendon that has the law of the material, which includes damping.

linear = wing
printed = linear.with_values({"tendon.law": "tpu-82a", "tendon.area": "18.75 mm^2"})
records = {"10 N/cm, linear": ff.run(linear), "TPU 82A": ff.run(printed)}
for name, record in records.items():
    outcome = ff.measure(record)
    print(f"{name}: {outcome.status}, in {1e3 * outcome.transitions['fold'].time:.1f} ms")

# %%
# Compare the angle of the middle hinge while the wing folds.

import matplotlib.pyplot as plt
import numpy as np

figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
for name, record in records.items():
    time = 1e3 * (record.time - record.stages[1].start)
    axes.plot(time, np.degrees(record.angles("ring")[:, 1]), label=name)
axes.set(xlim=(0, 100), xlabel="time since the torque began (ms)", ylabel="hinge (deg)")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(frameon=False)
plt.show()

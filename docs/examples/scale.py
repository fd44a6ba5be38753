"""
A wing of the size of an earwig's
=================================

The reference wing is 22 cm long, that of an earwig 1 cm. A scaled wing with equal dimensionless groups has the same
motion. A wing of the same materials under the same gravity cannot keep all of these groups.
"""

# %%
# Keep all groups: torques are proportional to the cube of the length, times to the length.

import forficula as ff

large = ff.load_design("binder2025")
small = ff.scale_design(large, 1 / 22)
records = {"22 cm": ff.run(large), "1 cm": ff.run(small)}
folds = {name: ff.measure(record).transitions["fold"] for name, record in records.items()}
for name, fold in folds.items():
    print(f"{name}: folds in {1e3 * fold.time:.3g} ms, with {fold.work:.3g} J")

# %%
# Relative to the fold time, both motions are the same.

import matplotlib.pyplot as plt
import numpy as np

figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
for (name, record), line in zip(records.items(), ("-", "--"), strict=True):
    time = (record.time - record.stages[1].start) / folds[name].time
    axes.plot(time, np.degrees(record.angles("ring")[:, 1]), line, label=name)
axes.set(xlim=(0, 1.5), xlabel="time / fold time", ylabel="hinge (deg)")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(frameon=False)
plt.show()

# %%
# With `natural=True` gravity and the properties of the materials stay unchanged.

natural = ff.scale_design(large, 1 / 22, natural=True)
for name, design in {"22 cm": large, "all groups": small, "same material": natural}.items():
    print(f"{name}: the membrane relaxes in {1e3 * design.membrane.damping:.2g} ms")
print(ff.measure(ff.run(natural)).status)

"""
An earwig's size
================

The reference wing is 22 cm long, an earwig's 1 cm. Scaled in every dimensionless group it moves alike; of the same
materials under the same gravity it cannot keep all of them.
"""

# %%
# All groups kept: torques go with the cube of the length, times with the length.

import forficula as ff

large = ff.load_design("binder2025")
small = ff.scale_design(large, 1 / 22)
for name, design in {"22 cm": large, "1 cm": small}.items():
    fold = ff.measure(ff.run(design)).transitions["fold"]
    print(f"{name}: folds in {1e3 * fold.time:.3g} ms, with {fold.work:.3g} J")

# %%
# With `natural=True` gravity and what belongs to the materials stay as they are.

natural = ff.scale_design(large, 1 / 22, natural=True)
print(
    f"damping of the membrane: {large.membrane.damping} s, {small.membrane.damping:.2g} s, {natural.membrane.damping} s"
)
print(ff.measure(ff.run(natural)).status)

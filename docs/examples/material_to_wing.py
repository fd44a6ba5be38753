"""
From a material to a wing
=========================

How thick must tendons of a printed TPU be, and what does the wing do with them?
"""

# %%
# The named materials have their sources with them. TPU 82A is the one of the paper.

import forficula as ff

law = ff.load_law("tpu-82a")
print(law.source)
wing = ff.load_design("binder2025")
for facts in ff.size_tendons(wing, law, [1000.0, 2000.0, 3000.0]):
    print(f"{100 * facts.length:.0f} cm long, {facts.why}:")
    for size in facts.sizes:
        area, across = 1e6 * size.area, 1e3 * size.diameter
        print(f"    {size.stiffness / 100:.0f} N/cm takes {area:.1f} mm2, {across:.1f} mm if round")

# %%
# A tendon with a law instead of a stiffness. The law's damping comes with it.

linear = wing
printed = linear.with_values({"tendon.law": "tpu-82a", "tendon.area": "18.75 mm^2"})
for name, design in {"10 N/cm, linear": linear, "TPU 82A": printed}.items():
    outcome = ff.measure(ff.run(design))
    fold = outcome.transitions["fold"]
    print(f"{name}: {outcome.status}, in {1e3 * fold.time:.1f} ms")

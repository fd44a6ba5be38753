"""
Any crease pattern: a letter that holds itself shut
===================================================

Three rigid panels, two creases, two tendons: a sheet of A4 that stays open until it is folded, and then stays folded.
"""

# %%
# What is it? The pattern says how free it is.

import forficula as ff

design = ff.load_design("letter-fold")
facts = ff.pattern_facts(design)
print(facts.title)

# %%
# Does it fold, and open again?

record = ff.run(design)
outcome = ff.measure(record)
print(outcome.status)
for name, move in outcome.transitions.items():
    print(f"{name}: {move.time:.2f} s, {1e3 * move.work:.0f} mJ")

# %%
# How it looks on its way.

ff.figure(record, "folding", width="page")

# %%
# Stiffer tendons want a stronger hand. Values are replaced by their keys, in any unit.

for stiffness in ("0.4 N/cm", "0.8 N/cm", "1.6 N/cm"):
    values = {f"tendon.{side}.stiffness": stiffness for side in ("left", "right")}
    print(stiffness, "-", ff.measure(ff.run(design.with_values(values), confirm=False)).status)

"""
A letter that holds itself shut
===============================

A sheet of A4 with three rigid panels, two creases and two tendons is bistable: it stays open until it is folded, and
then stays folded. The same calls work for any crease pattern.
"""

# %%
# The facts about the pattern include its degrees of freedom.

import forficula as ff

design = ff.load_design("letter-fold")
facts = ff.pattern_facts(design)
print(facts.title)

# %%
# Run the design: it folds and opens again.

record = ff.run(design)
outcome = ff.measure(record)
print(outcome.status)
for name, move in outcome.transitions.items():
    print(f"{name}: {move.time:.2f} s, {1e3 * move.work:.0f} mJ")

# %%
# Draw the shapes during folding.

ff.figure(record, "folding", width="page")

# %%
# Stiffer tendons need a stronger drive. Values are replaced by their keys, in any unit of the kind.

for stiffness in ("0.4 N/cm", "0.8 N/cm", "1.6 N/cm"):
    values = {f"tendon.{side}.stiffness": stiffness for side in ("left", "right")}
    print(stiffness, "-", ff.measure(ff.run(design.with_values(values), confirm=False)).status)

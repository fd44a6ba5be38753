"""
A map of what folds, in Python
==============================

A study without a file: which of twelve tendons let the wing fold with 20 N cm?
"""

# %%
# Factors are keys of the design, with a range or a list each.

import matplotlib.pyplot as plt

import forficula as ff

design = ff.load_design("binder2025", {"protocol.fold_torque": "20 N cm"})
study = ff.new_study(
    design,
    {
        "tendon.stiffness": "10..40 N/cm step 10",
        "tendon.rest_length": ["5 cm", "7 cm", "9 cm"],
    },
    name="twenty",
)

# %%
# The table is an xarray Dataset. It lies in the folder, too, and a study that was stopped goes on there.

import tempfile

table = ff.run_study(study, out=tempfile.mkdtemp())
print(table["status"].to_pandas().to_string())

# %%
# Every figure that the command would draw is one call; this one is the map of what each run came to.

ff.figure(table, "status", width=6)

# %%
# Or draw your own.

folds = table["fold_time"]
figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
for column in folds.transpose("tendon_rest_length", ...):
    length = f"{100 * float(column.tendon_rest_length):.0f} cm"
    axes.plot(table["tendon_stiffness"] / 100, 1e3 * column, "o-", label=length)
axes.set(xlabel="stiffness (N/cm)", ylabel="time to fold (ms)")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(title="resting length", frameon=False)
plt.show()

"""
A map of the tendons that fold
==============================

A study in Python, without a file: with which of twelve tendons does the wing fold with 20 N cm?
"""

# %%
# Factors are keys of the design. Each has a range or a list of values.

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
# The table is an xarray Dataset. The folder contains it, too, and a study that was stopped continues in this folder.

import tempfile

table = ff.run_study(study, out=tempfile.mkdtemp())
print(table["status"].to_pandas().to_string())

# %%
# Each figure that the command draws is one call. This figure maps the outcome of each run.

ff.figure(table, "status", width=6)

# %%
# Draw a figure of your own from the table.

folds = table["fold_time"]
figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
for column in folds.transpose("tendon_rest_length", ...):
    length = f"{100 * float(column.tendon_rest_length):.0f} cm"
    axes.plot(table["tendon_stiffness"] / 100, 1e3 * column, "o-", label=length)
axes.set(xlabel="stiffness (N/cm)", ylabel="time to fold (ms)")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(title="resting length", frameon=False)
plt.show()

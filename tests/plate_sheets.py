"""Designs of sheets with rigid facets, for tests."""

import math

from forficula.design import design_from_text, load_design, with_values

LENGTH, WIDTH, THICK, DENSITY = 0.1, 0.06, 0.001, 1200.0
MASS = DENSITY * LENGTH * WIDTH * THICK
# of a box about the middle of an end face: m L^2 / 3 + m t^2 / 12
INERTIA = MASS * (LENGTH**2 / 3 + THICK**2 / 12)
_REST = """
rest_speed = "0.01 deg/s"
window = "0.1 s"
least_hold = 0
residual_limit = 0.005
contact = false
rise = "0 s"
"""
SWING = [{"name": "swing", "limit": "0.2 s"}]


def plates(
    pattern, *, crease="", facet='kind = "rigid"', more="", step="0.2 ms", sample="1 ms", gravity=0.0, stages=SWING
):
    """Plates of 0.5 mm and 1.2 g/cm^3 on a pattern, written as in a file."""
    facet = f'{facet}\nthickness = "0.5 mm"\ndensity = "1.2 g/cm^3"'
    protocol = f'timestep = "{step}"\nsample_interval = "{sample}"\ngravity = "{gravity} m/s^2"{_REST}'
    text = f'name = "a"\nsource = "a test"\n[pattern]\n{pattern}\n[facet]\n{facet}\n[crease]\n{crease}\n{more}\n'
    text += f"[protocol]\n{protocol}"
    for stage in stages:
        text += f"""
[[protocol.stages]]
name = "{stage["name"]}"
drive = "{stage.get("drive", "none")}"
until = "{stage.get("until", "time")}"
hold = "0 s"
time_limit = "{stage["limit"]}"
"""
    return design_from_text(text)


def stage(until="time", drive="none", limit=1.0, **more):
    return {"name": f"{drive} {until}", "drive": drive, "until": until, "hold": 0.0, "time_limit": limit} | more


def strip(panels=2, *, letters="V", stages=None, **values):
    """Panels of 10 cm by 6 cm without damping, facet 0 held, nothing else."""
    changes = {
        "pattern.panels": panels,
        "pattern.panel_lengths": [LENGTH],
        "pattern.width": WIDTH,
        "pattern.assignment": letters,
        "facet.thickness": THICK,
        "facet.density": DENSITY,
        "crease.stiffness": 0.0,
        "crease.damping": 0.0,
        "crease.fold_limit": math.pi,
        "crease.back_limit": math.pi,
        "crease.start": 0.0,
        "support": [],
        "tendon": [],
        "drive": [],
        "measure": [],
        "protocol.timestep": 1e-4,
        "protocol.least_hold": 0.0,
        "protocol.sample_interval": 1e-4,
        "protocol.stages": [stage()] if stages is None else stages,
    }
    return with_values(load_design("letter-fold"), changes | values)


def pushed(torque, stages, **values):
    """One panel that a torque on its crease drives, N m."""
    push = {"name": "push", "kind": "torque", "of": "creases", "value": f"{torque} N m"}
    return strip(stages=stages, drive=[push], **values)


def miura(size=4, fold="30 deg"):
    """Squares of 2 cm, sheared to 60 deg."""
    return f"""kind = "miura-ori"
columns = {size}
rows = {size}
long_side = "2 cm"
short_side = "2 cm"
acute_angle = "60 deg"
fold = "{fold}"
"""


def vertex(sectors, letters="", fold=None, length="2 cm"):
    """One vertex."""
    written = ", ".join(f'"{sector:.15g} deg"' for sector in sectors)
    text = f'kind = "vertex"\nsectors = [{written}]\nlengths = ["{length}"]\n'
    text += f'assignment = "{letters}"\n' if letters else ""
    return text + (f'fold = "{fold}"\n' if fold else "")


def pleats(panels, letters, width="6 cm", length="10 cm"):
    """A strip."""
    return f"""kind = "pleats"
panels = {panels}
panel_lengths = ["{length}"]
width = "{width}"
assignment = "{letters}"
"""

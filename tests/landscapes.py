"""Designs whose landscapes several test modules examine, draw, write and print, by name."""

from pathlib import Path

from forficula.design import Design, load_design, scale_design

SETTINGS = {
    "reference": {},
    "without rest length": {"tendon.rest_length": "0 cm"},
    "without hub": {"pattern.hub_radius": "0 cm"},
    "without overbend": {"hinge.overbend": "0 deg", "protocol.initial_overbend": "0 deg"},
    "slack": {"tendon.rest_length": "12 cm"},
    "without stiffness": {"tendon.stiffness": "0 N/cm"},
    # attachments above the bars: docs/model/theory.md, section "Tendon off the hinge axis"
    "off the bars": {"tendon.proximal_offset": "2 mm", "tendon.distal_offset": "2 mm"},
    "beyond the stop": {"tendon.proximal_offset": "-2 mm", "tendon.distal_offset": "-2 mm"},
    "folds by itself": {"tendon.proximal_offset": "-6 cm", "tendon.distal_offset": "-6 cm"},
}
PLATES = {"plates": {}, "soft plates": {"crease.stiffness": "0 N m/rad/m"}, "plates without tendons": {"tendon": []}}
# two veins with tendons of their own, and one between them without
OWN = """
based_on = "binder2025"
name = "own"
[[tendon]]
vein = 0
[[tendon]]
vein = 2
stiffness = "15 N/cm"
rest_length = "9.5 cm"
"""


def design_of(name: str, folder: Path) -> Design:
    """Return the design of a name.

    "small" is the reference scaled to 10 mm; "own tendons" has no tendon on one vein; "plates" are rigid and have
    hinges with springs, "soft plates" have hinges without springs.

    Args:
        name: of the design.
        folder: for a design file, where the design needs one.
    """
    if name in PLATES:
        return load_design("letter-fold", PLATES[name])
    if name == "own tendons":
        path = folder / "own.toml"
        path.write_text(OWN, "utf-8")
        return load_design(path)
    design = load_design("binder2025", SETTINGS.get(name, {}))
    return scale_design(design, 1 / 22) if name == "small" else design

from forficula.design.crease_pattern import design_frames, design_pattern
from forficula.design.design import Design, shortest_sample_interval
from forficula.design.design_file import (
    design_from_text,
    design_text,
    load_design,
    named_designs,
    save_design,
    with_values,
    write_new_design,
)
from forficula.design.design_warnings import design_warnings
from forficula.design.fan import FanDesign, FanProtocol
from forficula.design.keys import key_quantity, key_value, put
from forficula.design.law_tables import law_from_folder, with_law_read
from forficula.design.part import LENGTH, TORQUE
from forficula.design.plates import PlatesDesign
from forficula.design.protocol import Protocol, Stage, stage_drives
from forficula.design.similarity import in_units, scale_design
from forficula.design.tendon import flat_strain, tendon_law

__all__ = [
    "LENGTH",
    "TORQUE",
    "Design",
    "FanDesign",
    "FanProtocol",
    "PlatesDesign",
    "Protocol",
    "Stage",
    "design_frames",
    "design_from_text",
    "design_pattern",
    "design_text",
    "design_warnings",
    "flat_strain",
    "in_units",
    "key_quantity",
    "key_value",
    "law_from_folder",
    "load_design",
    "named_designs",
    "put",
    "save_design",
    "scale_design",
    "shortest_sample_interval",
    "stage_drives",
    "tendon_law",
    "with_law_read",
    "with_values",
    "write_new_design",
]

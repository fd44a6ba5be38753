from forficula.design.crease_pattern import design_frames, design_pattern
from forficula.design.design import Design, shortest_sample_interval
from forficula.design.design_file import (
    AnyDesign,
    as_design,
    design_from_text,
    design_text,
    load_design,
    named_designs,
    save_design,
    with_values,
)
from forficula.design.fan import FanDesign, FanProtocol
from forficula.design.joint import JointDesign, JointProtocol
from forficula.design.keys import check_keys_once, key_quantity, key_value, names_law, numbered_key, put
from forficula.design.law import LawSection, tendon_material
from forficula.design.make import MakeSection
from forficula.design.medium import MediumSection
from forficula.design.new_design import write_new_design
from forficula.design.part import LENGTH, TORQUE
from forficula.design.protocol import Protocol, Stage, stage_drives
from forficula.design.provenance import differing_keys
from forficula.design.sheet import SheetDesign
from forficula.design.sheet_parts import Imperfection
from forficula.design.similarity import in_units, scale_design
from forficula.design.tendon import TendonSection, tendon_law
from forficula.design.tendon_tables import NO_LAW, value_from_folder

__all__ = [
    "LENGTH",
    "NO_LAW",
    "TORQUE",
    "AnyDesign",
    "Design",
    "FanDesign",
    "FanProtocol",
    "Imperfection",
    "JointDesign",
    "JointProtocol",
    "LawSection",
    "MakeSection",
    "MediumSection",
    "Protocol",
    "SheetDesign",
    "Stage",
    "TendonSection",
    "as_design",
    "check_keys_once",
    "design_frames",
    "design_from_text",
    "design_pattern",
    "design_text",
    "differing_keys",
    "in_units",
    "key_quantity",
    "key_value",
    "load_design",
    "named_designs",
    "names_law",
    "numbered_key",
    "put",
    "save_design",
    "scale_design",
    "shortest_sample_interval",
    "stage_drives",
    "tendon_law",
    "tendon_material",
    "value_from_folder",
    "with_values",
    "write_new_design",
]

from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.design import Design, shortest_sample_interval
from forficula.design.fans.fan import FanDesign, FanProtocol
from forficula.design.fans.joint import JointDesign, JointProtocol
from forficula.design.files.design_file import (
    AnyDesign,
    as_design,
    design_from_text,
    design_text,
    is_timestep_set,
    load_design,
    named_designs,
    save_design,
    with_values,
)
from forficula.design.files.keys import check_keys_once, key_quantity, key_value, names_law, numbered_key, put
from forficula.design.files.new_design import write_new_design
from forficula.design.files.provenance import differing_keys
from forficula.design.files.tendon_tables import NO_LAW, value_from_folder
from forficula.design.law import LawSection, tendon_material
from forficula.design.make import MakeSection
from forficula.design.medium import MediumSection
from forficula.design.protocol import Protocol, StageSection, stage_drives
from forficula.design.section import LENGTH, TORQUE
from forficula.design.sheets.crease_law_section import CreaseLawSection
from forficula.design.sheets.crease_pattern import design_frames, design_pattern, part_patterns
from forficula.design.sheets.sheet import SheetDesign
from forficula.design.sheets.sheet_sections import Imperfection
from forficula.design.similarity import in_units, scale_design
from forficula.design.tendon import TendonSection, tendon_law

__all__ = [
    "LENGTH",
    "NO_LAW",
    "TORQUE",
    "AnyDesign",
    "AssemblyDesign",
    "CreaseLawSection",
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
    "StageSection",
    "TendonSection",
    "as_design",
    "check_keys_once",
    "design_frames",
    "design_from_text",
    "design_pattern",
    "design_text",
    "differing_keys",
    "in_units",
    "is_timestep_set",
    "key_quantity",
    "key_value",
    "load_design",
    "named_designs",
    "names_law",
    "numbered_key",
    "part_patterns",
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

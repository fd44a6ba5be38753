"""Names of version 0.1 that still work and warn; they will be removed in the next minor version."""

from forficula.public_names import OldName

_DESIGNS, _STATICS, _STUDY = "forficula.design", "forficula.statics", "forficula.study"

OLD_NAMES: dict[str, OldName] = {
    # runs
    "load_record": OldName("forficula.dynamics:load_record", "ff.load_run(path), or its .record"),
    "save_record": OldName("forficula.dynamics:save_record", "run.save(folder), or run.record.save(path)"),
    "Record": OldName("forficula.dynamics:Record", "ff.results.Record"),
    "AssumptionRun": OldName("forficula.results:AssumptionRun", "ff.results.AssumptionRun"),
    "Assumptions": OldName("forficula.results:Assumptions", "ff.results.Assumptions"),
    "Convergence": OldName("forficula.results:Convergence", "ff.results.Convergence"),
    "Cycling": OldName("forficula.results:Cycling", "ff.results.Cycling"),
    "json_schema": OldName("forficula.results:json_schema", "ff.results.json_schema"),
    # designs and structures
    "named_designs": OldName(f"{_DESIGNS}:named_designs", 'ff.examples("designs")'),
    "Structure": OldName("forficula.structure:Structure", "ff.results.Structure"),
    "structure_warnings": OldName("forficula.structure:structure_warnings", "ff.check_design(design)"),
    "timestep_warnings": OldName("forficula.dynamics:timestep_warnings", "ff.check_design(design)"),
    # energy landscapes
    "energy_landscape": OldName(f"{_STATICS}:energy_landscape", "ff.landscape(design)"),
    "StableState": OldName(f"{_STATICS}:StableState", "ff.results.StableState"),
    "barrier": OldName(f"{_STATICS}:barrier", "landscape.barrier(start, end)"),
    "stable_states": OldName(f"{_STATICS}:stable_states", "landscape.states"),
    # studies
    "named_studies": OldName(f"{_STUDY}:named_studies", 'ff.examples("studies")'),
    "collect": OldName("forficula.calls:collect", "study.collect(folder)"),
    "estimate": OldName("forficula.calls:estimate", "study.estimate(folder)"),
    # parts
    "make_parts": OldName("forficula.make.make_parts:make_parts", "ff.make.parts(design)"),
    "check_parts": OldName("forficula.make:check_parts", "ff.make.check_parts"),
    "Part": OldName("forficula.make:Part", "ff.make.Part"),
    "PartSet": OldName("forficula.make:PartSet", "ff.make.PartSet"),
    "Check": OldName("forficula.make:Check", "ff.make.Check"),
    # The next two lists contain what was public at the top of 0.1. They do not follow the public names of ff.pattern
    # and ff.material, which change from now on.
    **{
        name: OldName(f"forficula.pattern:{name}", f"ff.pattern.{name}")
        for name in (
            "CreasePattern",
            "EarwigFan",
            "earwig_pattern",
            "read_fold",
            "read_folded_frames",
            "write_fold",
        )
    },
    **{
        name: OldName(f"forficula.material:{name}", f"ff.material.{name}")
        for name in (
            "Characterisation",
            "LawFit",
            "MaterialLaw",
            "StrainHistory",
            "TendonSizes",
            "TensileTest",
            "area_for",
            "characterise",
            "find_cycles",
            "fit_law",
            "load_law",
            "moduli_by_strain",
            "named_laws",
            "read_tensile_test",
            "read_tensile_tests",
            "save_law",
            "size_tendons",
        )
    },
}

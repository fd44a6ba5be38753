"""Export of runs to files of other programs: animations, meshes, series for ParaView, FOLD frames and tables."""

from forficula.show.export.export import FORMATS, default_path, export_run, format_of

__all__ = ["FORMATS", "default_path", "export_run", "format_of"]

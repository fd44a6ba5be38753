"""Export of runs to files of other programs: animations, meshes, series for ParaView, FOLD frames and tables."""

from forficula.show.export.export import check_format, default_path, export_times, format_of, write_export

__all__ = ["check_format", "default_path", "export_times", "format_of", "write_export"]

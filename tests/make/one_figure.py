"""Parts in a folder with only the figure of their sheet, for tests of files: figures are all saved the same way."""

from unittest.mock import patch

from forficula.show.folder import parts_folder


def write_with_one_figure(parts, folder):
    drawings = parts_folder.parts_drawings
    with patch.object(parts_folder, "parts_drawings", lambda *arguments: {"sheet": drawings(*arguments)["sheet"]}):
        parts_folder.write_parts(parts, (), folder)

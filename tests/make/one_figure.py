"""Parts in a folder with the figure of their sheet alone, for tests of files: figures are all saved alike."""

from unittest.mock import patch

from forficula.show.folder import parts_folder


def write_with_one_figure(parts, folder):
    drawings = parts_folder.parts_drawings
    with patch.object(parts_folder, "parts_drawings", lambda *given: {"sheet": drawings(*given)["sheet"]}):
        parts_folder.write_parts(parts, (), folder)

"""Configuration of the documentation; docs/contributing.md explains how its pages are written."""

import logging
import sys
from importlib import metadata
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "extensions"))

# pint warns that Nm replaces its own definition
logging.getLogger("pint.util").setLevel(logging.ERROR)

project = "forficula"
version = release = metadata.version("forficula")
author = copyright = "the forficula developers"

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
    "executed",
    "formulas",
    "measured",
    "named_designs",
    "reference",
    "validation",
]
exclude_patterns = ["_build", "examples", "gallery/*.ipynb", "gallery/*.py", "gallery/*.zip"]
suppress_warnings = ["config.cache"]  # the settings of the gallery contain functions

myst_enable_extensions = ["attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "forficula"
html_static_path = ["static"]
html_css_files = ["forficula.css"]
html_show_sphinx = False
html_copy_source = False
html_math_renderer = "mathml"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#8a4b08", "color-brand-content": "#8a4b08"},
    "dark_css_variables": {"color-brand-primary": "#e8a55a", "color-brand-content": "#e8a55a"},
}

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
default_role = "code"
smartquotes = False  # options such as --set keep their dashes
napoleon_numpy_docstring = False
napoleon_use_ivar = True
napoleon_attr_annotations = False
add_module_names = False
maximum_signature_line_length = 80

copybutton_exclude = ".printed, .linenos, .gp"
copybutton_selector = "div:not(.printed) > div.highlight > pre"

sphinx_gallery_conf = {
    "examples_dirs": "examples",
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py",
    "abort_on_example_error": True,
    "write_computation_times": False,
    "show_memory": False,
    "show_signature": False,
    "min_reported_time": 1e9,
    "capture_repr": ("_repr_html_",),
    "within_subsection_order": "FileNameSortKey",
    "download_all_examples": False,
    "image_srcset": ["2x"],
    "image_scrapers": ("matplotlib", "gallery_figures.save_figure"),
    "reset_modules": ("matplotlib",),
    "remove_config_comments": True,
}

linkcheck_timeout = 20
linkcheck_ignore = [r"https?://localhost.*"]

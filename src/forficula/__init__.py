"""Predict and design bistable folding structures.

import forficula as ff

run = ff.run("binder2025")
run.outcome
"""

from importlib import metadata

from forficula.old_names import OLD_NAMES
from forficula.public_names import public_names

# the public names are in __init__.pyi
__getattr__, __dir__, __all__ = public_names(__name__, __file__, old=OLD_NAMES)

__version__ = metadata.version("forficula")

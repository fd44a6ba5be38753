"""Predict and design bistable folding structures.

import forficula as ff

record = ff.run("binder2025")
outcome = ff.measure(record)
"""

from importlib import metadata

import lazy_loader

# the public names stand in __init__.pyi, once
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

__version__ = metadata.version("forficula")

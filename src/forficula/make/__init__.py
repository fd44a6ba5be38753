"""Parts to print and cut: solids and sheets, and checks of both."""

from forficula.public_names import public_names

# the public names are in __init__.pyi
__getattr__, __dir__, __all__ = public_names(__name__, __file__)

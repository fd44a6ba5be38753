from forficula.workbench.open import open_workbench

__all__ = ["open_workbench"]
